//! A perfect hash over the words of the language, case-insensitive: the build script finds the displacements, look-ups use them.

/// Hash of a word in any case. The salt keeps the daughters of different parents apart.
pub(crate) const fn hash(salt: u16, word: &[u8]) -> u64 {
    let mut state = 0xcbf2_9ce4_8422_2325 ^ ((salt as u64) << 17);
    let mut index = 0;
    while index < word.len() {
        state = (state ^ word[index].to_ascii_uppercase() as u64).wrapping_mul(0x0000_0100_0000_01b3);
        index += 1;
    }
    state ^ (state >> 29)
}

/// The slot of a hash under a displacement, in a table of `1 << bits` slots.
pub(crate) const fn slot(hash: u64, displacement: u16, bits: u32) -> usize {
    let mixed = ((hash >> 16) ^ displacement as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    (mixed >> (64 - bits)) as usize
}

/// The tables of one perfect hash.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PerfectHash<'a> {
    /// One displacement a bucket.
    pub(crate) displacements: &'a [u16],
    /// Indexes of entries; [`PerfectHash::EMPTY`] where there is none.
    pub(crate) slots: &'a [u16],
    /// Binary logarithm of the number of slots.
    pub(crate) bits: u32,
}

impl PerfectHash<'_> {
    /// An unused slot.
    pub(crate) const EMPTY: u16 = u16::MAX;

    /// Index of the only entry that can be this word. The caller compares the text.
    pub(crate) fn find(&self, salt: u16, word: &[u8]) -> Option<usize> {
        let hash = hash(salt, word);
        let bucket = usize::try_from(hash % (self.displacements.len() as u64)).ok()?;
        let displacement = *self.displacements.get(bucket)?;
        self.slots
            .get(slot(hash, displacement, self.bits))
            .filter(|index| **index != Self::EMPTY)
            .map(|index| usize::from(*index))
    }
}
