//! What an axis may be called (guide, "Attachments").

use std::fmt;

use crate::word;

/// The longest name in letters.
const LONGEST: usize = 4;

/// Why a name cannot be that of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AxisNameError {
    /// Nothing at all.
    Empty,
    /// Something else than a letter.
    Character(char),
    /// Too many letters: how many there are.
    Letters(usize),
    /// `P`, which is a parameter.
    Parameter,
    /// `F`, which is the feedrate.
    Feedrate,
    /// It reads as a word of the language. No document says that the controller refuses it.
    Word,
}

/// The message follows the name.
impl fmt::Display for AxisNameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => f.write_str("is empty"),
            Self::Character(odd) => write!(f, "has a `{odd}`; only letters may be in it"),
            Self::Letters(letters) => write!(f, "has {letters} letters; at most {LONGEST} are possible"),
            Self::Parameter => f.write_str("is a parameter"),
            Self::Feedrate => f.write_str("is the feedrate"),
            Self::Word => f.write_str("is a word of the language"),
        }
    }
}

impl std::error::Error for AxisNameError {}

/// Whether an axis may have a name.
///
/// # Errors
/// When it may not, with the first reason.
pub fn check_axis_name(name: &str) -> Result<(), AxisNameError> {
    if name.is_empty() {
        return Err(AxisNameError::Empty);
    }
    if let Some(odd) = name.chars().find(|c| !c.is_ascii_alphabetic()) {
        return Err(AxisNameError::Character(odd));
    }
    if name.len() > LONGEST {
        return Err(AxisNameError::Letters(name.len()));
    }
    match name.to_ascii_uppercase().as_str() {
        "P" => Err(AxisNameError::Parameter),
        "F" => Err(AxisNameError::Feedrate),
        upper if word(upper).is_some_and(|word| word.names_something()) => Err(AxisNameError::Word),
        _ => Ok(()),
    }
}
