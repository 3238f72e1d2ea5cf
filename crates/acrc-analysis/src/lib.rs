//! The semantic layer: files and projects, program sections, symbols, and the facts that checks and editors ask for.
//!
//! [`project::load`] reads a project from disk, [`Database`] holds it together with what was derived from it, the
//! functions of [`query`] and [`facts`] answer questions, and [`diagnostics`] runs a [`Checker`] on a file and
//! remembers what it found until something that the file depends on changes.
//!
//! **Invariants.** No other crate knows salsa. Nothing here reads a disk except through [`project::Files`] and
//! [`project::search`]. What one file sees of another never holds a place in its text.

mod attachments;
mod cancel;
mod checker;
mod db;
pub mod deed;
mod environment;
pub mod facts;
pub mod index;
mod input;
mod machine;
pub mod memory;
mod near;
pub mod parallel;
pub mod project;
pub mod query;
pub mod references;
mod role;
mod symbols;
mod usage;
pub mod walk;

/// The codes of what [`project::LoadedProject::compile`] reports.
pub use acrc_compile::codes as compile_codes;
pub use attachments::{Conflict, Contradiction, Taken};
pub use cancel::{Cancelled, Canceller, unless_cancelled};
pub use checker::{Checker, FileContext, Questions};
pub use db::{Database, Db};
pub use deed::Deed;
pub use environment::{AliasFact, DefinedIn, Environment, OwnAlias};
pub use index::{Exports, FileIndex, SectionIndex};
pub use input::{Project, SourceFile};
pub use machine::{AxisSet, Machine};
pub use near::nearest;
pub use query::{diagnostics, parse};
pub use role::FileRole;
pub use symbols::{AliasSymbol, AxisTable, Symbols};
pub use usage::{Usage, is_wizards, is_wizards_program};
