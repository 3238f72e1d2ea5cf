//! How much a finding matters.

use std::fmt;

/// How much a finding matters, from the least to the most: `Advice < Warning < Error`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// The program works; it could be clearer, faster or safer.
    Advice,
    /// The program runs, and probably does something that was not meant.
    Warning,
    /// The controller refuses the program, or stops in it.
    Error,
}

impl Severity {
    /// The lower-case word used in every output.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Advice => "advice",
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }
}

impl fmt::Display for Severity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.as_str())
    }
}
