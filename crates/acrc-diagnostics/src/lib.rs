//! What the tools say about a program: one diagnostic type, the fixes it may carry, and the ways it is shown.
//!
//! Every crate that finds something wrong builds a [`Diagnostic`]; nothing else in the project prints findings. A
//! diagnostic knows byte offsets only. Lines and columns appear when it is shown, from a [`LineIndex`] that is built
//! once for a file:
//!
//! - [`text`] draws the source with the finding marked, for a person at a terminal;
//! - [`concise`] is one line a finding, for editors and `grep`;
//! - [`json`] is the stable machine-readable form, [`jsonl`] the same with a line a finding;
//! - [`sarif`] is the interchange format of static analysis, for code scanning;
//! - [`github`] and [`gitlab`] are what these services show beside changed lines;
//! - [`junit`] and [`checkstyle`] are the XML forms that nearly every build service can read.
//!
//! The forms for other programs also say what could not be checked, [`Unchecked`]; for people that is said elsewhere.
//!
//! [`unified_diff`] shows what fixes or a formatter would change.
//!
//! **Invariants.** The crate knows nothing of the language, of files on disk or of process exit codes. The same
//! diagnostics always give the same bytes. Machine-readable forms are valid whatever messages, names and sources
//! contain, have LF line ends, and are also valid without findings.

pub mod checkstyle;
pub mod concise;
mod diagnostic;
mod diff;
mod edit;
mod fingerprint;
pub mod github;
pub mod gitlab;
pub mod json;
pub mod jsonl;
pub mod junit;
mod line_index;
mod path;
mod plain;
mod remarks;
mod report;
pub mod sarif;
mod severity;
mod span;
pub mod text;
mod unchecked;
mod xml;

pub use diagnostic::{Code, Diagnostic, Label};
pub use diff::unified_diff;
pub use edit::{Applicability, ApplyError, Edit, Fix, apply, compatible};
pub use line_index::{LineIndex, Position};
pub use report::{FileReport, SourceFile, Summary};
pub use severity::Severity;
pub use span::Span;
pub use unchecked::Unchecked;
