//! What an alias may be called (guide, "Aliases"): the linter, and a controller at its prompt, refuse the same names.

use std::fmt;

use crate::{Model, word};

/// The longest name in letters.
const LONGEST: usize = 24;

/// Why a name cannot be that of an alias.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AliasNameError {
    /// Something else than a letter.
    Character(char),
    /// Too many letters: how many there are.
    Letters(usize),
    /// It reads as a word of the language.
    Word,
}

impl fmt::Display for AliasNameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Character(odd) => write!(f, "has a `{odd}`; only letters may be in it"),
            Self::Letters(letters) => write!(f, "has {letters} letters; at most {LONGEST} are possible"),
            Self::Word => f.write_str("is a word of the language"),
        }
    }
}

impl std::error::Error for AliasNameError {}

/// Whether an alias of a model may have a name. The message of an error follows the name.
///
/// # Errors
/// When it may not, with the first reason.
pub fn check_alias_name(name: &str, model: &Model) -> Result<(), AliasNameError> {
    let letters = |odd: &char| !(odd.is_ascii_alphabetic() || (odd.is_ascii_digit() && takes_digits(model)));
    if let Some(odd) = name.chars().find(letters) {
        return Err(AliasNameError::Character(odd));
    }
    if name.len() > LONGEST {
        return Err(AliasNameError::Letters(name.len()));
    }
    if word(name).is_some_and(|word| word.stands_alone()) { Err(AliasNameError::Word) } else { Ok(()) }
}

/// A later operating system of the ACR7000 and IPA takes digits.
fn takes_digits(model: &Model) -> bool {
    model.name.starts_with("ACR7") || model.name.starts_with("IPA")
}
