//! Strings in memory, whose form no document gives.
//!
//! A block of strings is a count, then the addresses of the strings. A string is its length, then its characters, four to a word, the
//! first one in the lowest byte. It has words for all characters that `DIM` gives it; those behind its length are zero.

use acrc_vm::{Locals, Reference, Text};

use super::cell::Cell;
use super::memory::counted;

/// Characters in a word.
const PER_WORD: u32 = 4;

/// A block of strings of a program.
pub(super) struct Block<'a> {
    /// Its address.
    pub(super) start: u32,
    /// The words that it has room for.
    pub(super) room: u32,
    pub(super) count: u32,
    pub(super) locals: &'a Locals,
    pub(super) program: u8,
    pub(super) text: &'a dyn Fn(u32) -> Reference,
}

impl Block<'_> {
    /// What a word of the block is.
    pub(super) fn cell(&self, word: u32) -> Option<Cell> {
        let Some(behind) = word.checked_sub(1) else { return counted(self.count) };
        if behind < self.count {
            return Some(Cell::Fixed(self.address(behind)?));
        }
        let behind = behind - self.count;
        let words = self.words()?;
        let reference = (self.text)(behind / words);
        let (text, _) = self.locals.text(reference)?;
        Some(match (behind % words).checked_sub(1) {
            None => Cell::Length { program: self.program, text: reference, length: text.len() as u32 },
            Some(word) => Cell::Characters { program: self.program, text: reference, word, bits: packed(text, word) },
        })
    }

    /// Words of a string, with its length.
    fn words(&self) -> Option<u32> {
        let (_, most) = self.locals.text((self.text)(0))?;
        most.div_ceil(PER_WORD).checked_add(1)
    }

    /// Where a string stands; 0 when it has no room among the addresses of its block.
    fn address(&self, index: u32) -> Option<u32> {
        let words = u64::from(self.words()?);
        let offset = 1 + u64::from(self.count) + u64::from(index) * words;
        let fits = offset + words <= u64::from(self.room);
        Some(if fits { self.start + offset as u32 } else { 0 })
    }
}

/// Four characters of a string; zeros behind its end.
fn packed(text: &Text, word: u32) -> u32 {
    let start = (word * PER_WORD) as usize;
    let mut bytes = [0; PER_WORD as usize];
    for (place, character) in bytes.iter_mut().zip(text.as_bytes().get(start..).unwrap_or_default()) {
        *place = *character;
    }
    u32::from_le_bytes(bytes)
}

/// A string with another length: cut, or with zeros behind it.
pub(super) fn resized(text: &Text, length: u32) -> Text {
    let mut bytes = text.as_bytes().to_vec();
    bytes.resize(length as usize, 0);
    bytes.into()
}

/// A string with four other characters. Those behind its end are left out.
pub(super) fn replaced(text: &Text, word: u32, bits: u32) -> Text {
    let mut bytes = text.as_bytes().to_vec();
    let start = (word * PER_WORD) as usize;
    for (place, character) in bytes.iter_mut().skip(start).zip(bits.to_le_bytes()) {
        *place = character;
    }
    bytes.into()
}
