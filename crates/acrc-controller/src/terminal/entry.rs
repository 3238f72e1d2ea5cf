//! Lines that are entered between `PROGRAM` and `ENDP` (guide, "Program Flow").

use acrc_syntax::units::Level;

use super::StoredText;

/// A text that is being entered.
#[derive(Debug)]
pub(crate) struct Entry {
    /// Whose text it is.
    pub(crate) level: Level,
    /// Its lines.
    pub(crate) text: StoredText,
    /// It was refused at its beginning and is read only to its end: executed one by one its lines would move the machine.
    pub(crate) discarded: bool,
}

impl Entry {
    /// An empty text.
    pub(crate) fn new(level: Level, discarded: bool) -> Self {
        Self { level, text: StoredText::default(), discarded }
    }
}
