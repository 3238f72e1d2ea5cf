//! Strings as the controller keeps them: one byte a character (Latin-1), because memory is counted a byte a character.

use std::fmt;

/// A string value.
#[derive(Clone, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Text(Box<[u8]>);

impl Text {
    /// The characters, one byte each.
    pub fn as_bytes(&self) -> &[u8] {
        &self.0
    }

    /// Number of characters.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// True when there is no character.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The first `length` characters; all of them when there are fewer.
    #[must_use]
    pub fn truncated(self, length: usize) -> Self {
        if self.0.len() <= length {
            return self;
        }
        let mut bytes = self.0.into_vec();
        bytes.truncate(length);
        Self(bytes.into())
    }

    /// This string followed by another.
    #[must_use]
    pub fn joined(&self, other: &Self) -> Self {
        Self([&*self.0, &*other.0].concat().into())
    }
}

impl From<Vec<u8>> for Text {
    fn from(bytes: Vec<u8>) -> Self {
        Self(bytes.into())
    }
}

impl From<&[u8]> for Text {
    fn from(bytes: &[u8]) -> Self {
        Self(bytes.into())
    }
}

/// Characters outside Latin-1 become `?`.
impl From<&str> for Text {
    fn from(text: &str) -> Self {
        Self(text.chars().map(|character| u8::try_from(character).unwrap_or(b'?')).collect())
    }
}

impl fmt::Display for Text {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text: String = self.0.iter().copied().map(char::from).collect();
        formatter.pad(&text)
    }
}

impl fmt::Debug for Text {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(&self.to_string(), formatter)
    }
}
