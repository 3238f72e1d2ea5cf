//! Turns the tree of `AcroBASIC` texts into a stored-program image.
//!
//! [`compile`] takes the files of a project in their order and gives an [`acrc_image::Image`]: a stored text for each `PROGRAM` .. `ENDP` and each
//! run of numbered lines, and the immediate statements around them as the boot unit. Names are resolved through [`Scope`], so that
//! [`encode_statements`] serves a terminal as well, where aliases and labels come from a running controller.
//!
//! Choices between several possible encodings are made here and nowhere else; `docs/image-format.md` lists them.

mod aliases;
mod argument;
mod assemble;
mod diagnostics;
mod encoder;
mod error;
mod expression;
mod labels;
mod plan;
mod project;
mod scope;
mod statement;
mod stored;
mod text;

pub use aliases::read_alias;
pub use diagnostics::codes;
pub use error::{CompileError, CompileErrorKind, LINE_NUMBERS};
pub use project::{SourceUnit, compile, compile_stored};
pub use scope::{NoNames, Scope, Tables};
pub use statement::{encode_statement, encode_statements, stored_bytes};
pub use text::typed_text;
