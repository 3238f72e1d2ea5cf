//! The flag words P4096..P6143 and the bits in them: one memory, two views (guide, "System Parameters and Flags").

use acrc_catalog::{FIRST_FLAG_WORD, FLAG_WORD_COUNT, FLAGS_PER_WORD, Law};

/// First parameter that is a flag word.
pub(crate) const FIRST_WORD: u32 = FIRST_FLAG_WORD;
/// All flags of the controller.
#[derive(Clone, Debug)]
pub(crate) struct Flags {
    words: Box<[u32; Flags::WORDS as usize]>,
}

impl Flags {
    /// Number of flag words.
    pub(crate) const WORDS: u32 = FLAG_WORD_COUNT;

    /// Power-up: every flag is clear.
    pub(crate) fn new() -> Self {
        Self { words: Box::new([0; Self::WORDS as usize]) }
    }

    /// Whether a bit number lies in the flag space.
    pub(crate) fn contains(bit: u32) -> bool {
        bit / FLAGS_PER_WORD < Self::WORDS
    }

    /// State of a bit; bits outside the space are clear.
    pub(crate) fn get(&self, bit: u32) -> bool {
        self.words.get(bit as usize / 32).is_some_and(|word| word >> (bit % 32) & 1 == 1)
    }

    /// Changes a bit; bits outside the space are left out.
    pub(crate) fn set(&mut self, bit: u32, state: bool) {
        if let Some(word) = self.words.get_mut(bit as usize / 32) {
            let mask = 1 << (bit % 32);
            *word = if state { *word | mask } else { *word & !mask };
        }
    }

    /// Changes the flag of an object; objects that have no such flag are left out.
    pub(crate) fn set_law(&mut self, law: Law, object: u32, state: bool) {
        if let Some(bit) = law.get(object) {
            self.set(bit, state);
        }
    }

    /// A flag word by its parameter number.
    pub(crate) fn word(&self, parameter: u32) -> Option<u32> {
        self.words.get(parameter.checked_sub(FIRST_WORD)? as usize).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bit_and_its_word_are_one_memory() {
        let mut flags = Flags::new();
        flags.set(34, true);
        assert_eq!(flags.word(4097), Some(4));
        flags.set(63, true);
        assert_eq!(flags.word(4097), Some(0x8000_0004));
        flags.set(34, false);
        assert!(!flags.get(34) && flags.get(63));
        assert!(Flags::contains(65_535) && !Flags::contains(65_536));
        assert_eq!(flags.word(6144), None);
        assert_eq!(flags.word(4095), None);
    }
}
