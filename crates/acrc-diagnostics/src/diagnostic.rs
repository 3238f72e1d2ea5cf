//! The one type in which every finding is told.

use std::fmt;

use crate::{Fix, Severity, Span};

/// The stable name of a kind of finding. Codes are never used again for something else.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Code {
    /// Short form, for configuration and search: `ACR101`.
    pub id: &'static str,
    /// Readable form: `undefined-label`.
    pub name: &'static str,
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.id)
    }
}

/// A second place that explains the finding, in the same file.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Label {
    /// The place.
    pub span: Span,
    /// What is there, in a few words.
    pub message: String,
}

/// One finding in one file.
///
/// The message names the thing, the limit and the value; labels say what is at a place; the help says what to do.
/// Messages are sentences without a final period.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Diagnostic {
    /// Which kind of finding this is.
    pub code: Code,
    /// How much it matters.
    pub severity: Severity,
    /// What is wrong, in one sentence.
    pub message: String,
    /// Where it is.
    pub span: Span,
    /// What is at `span`, in a few words.
    pub label: Option<String>,
    /// Other places that explain it.
    pub labels: Vec<Label>,
    /// What to do about it.
    pub help: Option<String>,
    /// What else is good to know.
    pub note: Option<String>,
    /// Ways to repair it, the best first.
    pub fixes: Vec<Fix>,
    /// Whether the finding rests on a fact about the controller that no document settles. Such a finding is at most a
    /// warning.
    pub unconfirmed: bool,
}

impl Diagnostic {
    /// A finding with no more than its message and place.
    #[must_use]
    pub fn new(severity: Severity, code: Code, span: Span, message: impl Into<String>) -> Self {
        Self {
            code,
            severity,
            message: message.into(),
            span,
            label: None,
            labels: Vec::new(),
            help: None,
            note: None,
            fixes: Vec::new(),
            unconfirmed: false,
        }
    }

    /// A finding that the controller would refuse or stop at.
    #[must_use]
    pub fn error(code: Code, span: Span, message: impl Into<String>) -> Self {
        Self::new(Severity::Error, code, span, message)
    }

    /// A finding that probably is not what was meant.
    #[must_use]
    pub fn warning(code: Code, span: Span, message: impl Into<String>) -> Self {
        Self::new(Severity::Warning, code, span, message)
    }

    /// A finding about something that works but could be better.
    #[must_use]
    pub fn advice(code: Code, span: Span, message: impl Into<String>) -> Self {
        Self::new(Severity::Advice, code, span, message)
    }

    /// Says what is at the primary span.
    #[must_use]
    pub fn with_label(mut self, text: impl Into<String>) -> Self {
        self.label = Some(text.into());
        self
    }

    /// Adds a second place, with what is there.
    #[must_use]
    pub fn with_related(mut self, span: Span, message: impl Into<String>) -> Self {
        self.labels.push(Label { span, message: message.into() });
        self
    }

    /// Says what to do.
    #[must_use]
    pub fn with_help(mut self, text: impl Into<String>) -> Self {
        self.help = Some(text.into());
        self
    }

    /// Says what else is good to know.
    #[must_use]
    pub fn with_note(mut self, text: impl Into<String>) -> Self {
        self.note = Some(text.into());
        self
    }

    /// Adds a way to repair it; the first one added is the preferred one.
    #[must_use]
    pub fn with_fix(mut self, fix: Fix) -> Self {
        self.fixes.push(fix);
        self
    }

    /// Marks the finding as resting on an unsettled fact, and lowers an error to a warning: what is not known to be
    /// refused must not stop a build.
    #[must_use]
    pub fn unconfirmed(mut self) -> Self {
        self.unconfirmed = true;
        self.severity = self.severity.min(Severity::Warning);
        self
    }
}
