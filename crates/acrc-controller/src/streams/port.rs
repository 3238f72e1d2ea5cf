//! Where characters are typed and shown: a stream, or the terminal that listens to a program.

use std::fmt;
use std::str::FromStr;

use acrc_catalog::Model;

use crate::terminal::{StreamError, StreamName};

/// A place where somebody may type and read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Port {
    /// A communication stream.
    Stream(StreamName),
    /// Device 0 of a program that has not opened it: whoever listens to the program (`LRUN`, `LISTEN`).
    Listener(u8),
}

impl Port {
    /// Whether a model has it.
    ///
    /// # Errors
    /// When it has not.
    pub fn check(self, model: &'static Model) -> Result<(), StreamError> {
        match self {
            Self::Stream(stream) => stream.check(model),
            Self::Listener(program) if program < model.programs => Ok(()),
            Self::Listener(_) => Err(StreamError::Unknown(self.to_string())),
        }
    }
}

impl fmt::Display for Port {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Stream(stream) => stream.fmt(f),
            Self::Listener(program) => write!(f, "PROG{program}"),
        }
    }
}

/// `COM1`, `STREAM2`, and `PROG0` for the terminal that listens to program 0; in any case.
impl FromStr for Port {
    type Err = StreamError;

    fn from_str(text: &str) -> Result<Self, StreamError> {
        let name = text.trim();
        let word = name.get(..4).filter(|word| word.eq_ignore_ascii_case("PROG"));
        match word.and_then(|word| name.get(word.len()..)?.parse().ok()) {
            Some(program) => Ok(Self::Listener(program)),
            None => text.parse().map(Self::Stream),
        }
    }
}
