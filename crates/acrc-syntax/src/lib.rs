//! Text to a lossless tree of `AcroBASIC` (guide, "Programming Basics").
//!
//! - [`SourceText`] decodes the bytes of a file and writes them back;
//! - [`lexer`] cuts text into tokens;
//! - [`parse`] makes a [`Tree`] of lines and statements, whose nodes are in [`ast`];
//! - [`blocks`] matches `IF` with `ENDIF`, `FOR` with `NEXT`, `WHILE` with `WEND`;
//! - [`units`] tells which statements belong to the system, to a program or to a PLC.
//!
//! **Invariants.** Parsing never fails and never panics: whatever a text holds, the result is a tree and a list of
//! diagnostics, and the tree prints back to the same text. A statement that can't be read costs one diagnostic and
//! leaves its neighbours alone. No list of words lives here; what a word is comes from `acrc_catalog`. Whether the
//! number, kind and range of arguments are right is not judged here.

pub mod ast;
pub mod blocks;
pub mod codes;
mod dump;
pub mod lexer;
mod reader;
mod source;
mod tree;
pub mod units;

use acrc_diagnostics::Diagnostic;
pub use dump::debug_tree;
pub use source::{DecodeError, Encoding, MAX_BYTES, SourceText};
pub use tree::Tree;

/// Reads a text.
#[must_use]
pub fn parse(text: &str) -> Tree {
    reader::read(text, lexer::tokenize(text))
}

/// Reads one expression, as the right side of an assignment. What can't be read is [`ast::ExprKind::Error`], and the
/// diagnostics say why.
#[must_use]
pub fn parse_expression(text: &str) -> (ast::Expr, Vec<Diagnostic>) {
    reader::read_expression(text, &lexer::tokenize(text))
}
