//! A place that an editor goes to.

use acrc_analysis::SourceFile;
use acrc_diagnostics::Span;

/// A place that an editor goes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Target {
    /// The file.
    pub file: SourceFile,
    /// All of it: the statement, or a subroutine from its label to its `RETURN`.
    pub whole: Span,
    /// The part that says what it is, within the whole: its name or number.
    pub name: Span,
}
