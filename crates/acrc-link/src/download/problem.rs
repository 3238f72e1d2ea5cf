//! What keeps a project from being sent, with its place in the source.

use acrc_diagnostics::{Code, Diagnostic};

use super::script::{LONGEST_LINE, Place};

/// The codes of this crate.
pub mod codes {
    use acrc_diagnostics::Code;

    /// A statement or line that a download cannot send.
    pub const NOT_SENDABLE: Code = Code { id: "ACR040", name: "not-sendable" };
    /// A line that the controller did not take.
    pub const REFUSED: Code = Code { id: "ACR041", name: "refused-by-controller" };
    /// The controller has something else than what was sent.
    pub const NOT_EQUAL: Code = Code { id: "ACR042", name: "differs-on-controller" };
    /// All of them, in the order of their numbers.
    pub const ALL: &[Code] = &[NOT_SENDABLE, REFUSED, NOT_EQUAL];
}

/// What keeps a project from being sent.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// The file, an index of those of the project.
    pub file: usize,
    /// What it is.
    pub diagnostic: Diagnostic,
}

impl Problem {
    /// Something at a place.
    pub(super) fn new(code: Code, place: Place, message: impl Into<String>, label: impl Into<String>) -> Self {
        Self { file: place.file, diagnostic: Diagnostic::error(code, place.span, message).with_label(label) }
    }

    /// With what to do about it.
    pub(super) fn with_help(mut self, help: impl Into<String>) -> Self {
        self.diagnostic = self.diagnostic.with_help(help);
        self
    }

    pub(super) fn too_long(place: Place, characters: usize) -> Self {
        let message = format!("the line has {characters} characters, and a controller takes {LONGEST_LINE}");
        Self::new(codes::NOT_SENDABLE, place, message, "too long").with_help("write it as several lines")
    }

    pub(super) fn conditional(place: Place) -> Self {
        let message = "what this erases cannot be told before the download, since a condition stands before it";
        Self::new(codes::NOT_SENDABLE, place, message, "behind a condition").with_help("write it without the condition")
    }
}
