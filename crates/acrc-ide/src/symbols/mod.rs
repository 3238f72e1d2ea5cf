//! What a file and a project declare, for outlines and look-ups.

mod document;
mod fuzzy;
mod workspace;

pub use document::{Symbol, document_symbols};
pub use workspace::{WorkspaceSymbol, workspace_symbols};

/// Kinds of symbols.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SymbolKind {
    /// What is typed at the prompt of a level.
    Prompt,
    /// The stored text of a program.
    Program,
    /// A label that `GOSUB` calls.
    Subroutine,
    /// Another label.
    Label,
    /// An alias.
    Alias,
    /// The name of an axis.
    Axis,
    /// What a `DIM` makes room for.
    Variable,
}
