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

    /// All of them, in the order of their numbers, with what there is to know.
    pub const ALL: &[(Code, &str)] = &[
        (
            NOT_SENDABLE,
            "A line that `acrc download` cannot send: one that is longer than a controller takes, one that never gives\n\
             the prompt back (LRUN, LISTEN, TALK TO), one that ends the connection (REBOOT), one that begins a block outside\n\
             of a program which does not end there, or a NEW, CLEAR or DIM behind a condition, so that nobody can tell\n\
             before what it will erase. Nothing is sent then.\n",
        ),
        (
            REFUSED,
            "A controller answered a line of the project with a text where it should have answered nothing. No document\n\
             lists the error texts of a controller, so whatever comes counts as a refusal, unless the line is one that\n\
             reports. The download ends at this line; `acrc download` says which programs are old, new and erased.\n",
        ),
        (
            NOT_EQUAL,
            "A program was sent, and the controller lists something else. The two are compared as they are stored, so\n\
             blanks and the case of words are not the reason. The first line that differs is shown.\n",
        ),
    ];

    /// What is known of a code, by its number or its name.
    pub fn explain(topic: &str) -> Option<String> {
        let is_meant = |code: &Code| code.id.eq_ignore_ascii_case(topic) || code.name.eq_ignore_ascii_case(topic);
        let (code, text) = ALL.iter().find(|(code, _)| is_meant(code))?;
        Some(format!("{} {}\n\n{text}", code.id, code.name))
    }
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
