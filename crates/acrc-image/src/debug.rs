//! Where the words of a unit come from. The debug section of an image can be stripped.

/// Byte range in the decoded text of a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Span {
    /// First byte.
    pub start: u32,
    /// Behind the last byte.
    pub end: u32,
}

/// A place in the source.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Location {
    /// Index into the files of the image.
    pub file: u32,
    /// The statement.
    pub span: Span,
    /// The line it begins on, from 1.
    pub line: u32,
}

/// The place of one instruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DebugEntry {
    /// The address of the instruction.
    pub address: u32,
    /// Where its statement stands.
    pub location: Location,
}

/// Instruction addresses and where their statements stand, in the order of addresses.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct DebugMap {
    entries: Vec<DebugEntry>,
}

impl DebugMap {
    /// From entries with rising addresses. `None` when they do not rise.
    pub fn from_entries(entries: Vec<DebugEntry>) -> Option<Self> {
        let rising = entries.iter().zip(entries.iter().skip(1)).all(|(a, b)| a.address < b.address);
        rising.then_some(Self { entries })
    }

    /// The entries in the order of addresses.
    pub fn entries(&self) -> &[DebugEntry] {
        &self.entries
    }

    /// The place of the instruction that contains the word at `address`.
    pub fn locate(&self, address: u32) -> Option<Location> {
        let behind = self.entries.partition_point(|entry| entry.address <= address);
        behind.checked_sub(1).and_then(|index| self.entries.get(index)).map(|entry| entry.location)
    }

    /// Adds the place of an instruction; addresses that do not rise are ignored.
    pub(crate) fn push(&mut self, address: u32, location: Location) {
        if self.entries.last().is_none_or(|last| last.address < address) {
            self.entries.push(DebugEntry { address, location });
        }
    }
}
