//! What the tools say about a program: one diagnostic type, the fixes it may carry, and the ways it is shown.
//!
//! Every crate that finds something wrong builds a [`Diagnostic`]; nothing else in the project prints findings. A
//! diagnostic knows byte offsets only. Lines and columns appear when it is shown, from a [`LineIndex`] that is built
//! once for a file:
//!
//! - [`text`] draws the source with the finding marked, for a person at a terminal;
//! - [`concise`] is one line a finding, for editors and `grep`;
//! - [`json`] is the stable machine-readable form.
//!
//! **Invariants.** The crate knows nothing of the language, of files on disk or of process exit codes. The same
//! diagnostics always give the same bytes.

pub mod concise;
mod diagnostic;
mod edit;
pub mod json;
mod line_index;
mod plain;
mod report;
mod severity;
mod span;
pub mod text;

pub use diagnostic::{Code, Diagnostic, Label};
pub use edit::{Applicability, ApplyError, Edit, Fix, apply, compatible};
pub use line_index::{LineIndex, Position};
pub use report::{FileReport, SourceFile, Summary};
pub use severity::Severity;
pub use span::Span;
