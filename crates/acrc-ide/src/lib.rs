//! What an editor asks about `AcroBASIC`, answered as plain data.
//!
//! Each feature is a file with one function over a database and a place: byte offsets go in, byte offsets and texts come
//! out. What stands at a place is an [`Occurrence`] of an [`Entity`]; navigation, references, renaming and hover all
//! begin with it.
//!
//! **Invariants.** Nothing here knows the language server protocol, lines and columns, or files on disk. A function reads
//! the database and changes nothing, so it may run on a snapshot in any thread. Every function takes any offset, also one
//! outside of the text or within a character, and never panics.

mod actions;
mod calls;
mod code_lenses;
mod completion;
mod definition;
mod edits;
mod folding;
mod format;
mod hover;
mod inlay_hints;
mod inline_values;
mod links;
mod occurrence;
mod place;
mod references;
mod remark;
mod rename;
mod routine;
mod selection;
mod semantic_tokens;
mod signature_help;
mod symbols;
mod target;
mod typed;
mod usage;

pub use actions::{ActionKind, CodeAction, code_actions, fix_all};
pub use calls::{Calls, Routine, incoming_calls, outgoing_calls, routine_at};
pub use code_lenses::{CodeLens, LensAction, code_lenses};
pub use completion::{Completion, CompletionKind, Completions, completions};
pub use definition::definition;
pub use edits::FileEdits;
pub use folding::{Fold, FoldKind, folds};
pub use format::{TYPED, format_file, format_options, format_range, format_typed};
pub use hover::{Hover, hover, page};
pub use inlay_hints::{HintOptions, InlayHint, inlay_hints};
pub use inline_values::{InlineValue, inline_values};
pub use links::{Link, LinkTarget, links, project_links};
pub use occurrence::{Entity, Name, Occurrence, Role, at, everywhere, in_file};
pub use place::{FilePosition, FileRange, level_of, statement_at};
pub use references::{Access, highlights, references};
pub use rename::{RenameError, prepare_rename, rename};
pub use selection::selection_ranges;
pub use semantic_tokens::{SemanticToken, TokenClass, semantic_tokens};
pub use signature_help::{ArgumentHelp, SignatureHelp, signature_help};
pub use symbols::{Symbol, SymbolKind, WorkspaceSymbol, document_symbols, workspace_symbols};
pub use target::Target;
pub use usage::{ProgramUsage, programs};
