//! The prompt levels (guide, "Programs and Commands").

/// The levels at which a command is accepted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Levels(u8);

impl Levels {
    /// The spellings in data files and reports, in the order of the bits.
    pub const NAMES: [&'static str; 3] = ["sys", "prog", "plc"];

    /// A set from its bits: 1 system, 2 program, 4 PLC. Other bits are dropped.
    pub const fn from_bits(bits: u8) -> Self {
        Self(bits & 0b111)
    }

    /// The bits of the set, as in [`Levels::from_bits`].
    pub const fn bits(self) -> u8 {
        self.0
    }

    /// Accepted at the system prompt.
    pub const fn sys(self) -> bool {
        self.0 & 1 != 0
    }

    /// Accepted at a program prompt and in a program.
    pub const fn prog(self) -> bool {
        self.0 & 2 != 0
    }

    /// Accepted at a PLC prompt and in a PLC program.
    pub const fn plc(self) -> bool {
        self.0 & 4 != 0
    }

    /// The names of the levels in the set.
    pub fn names(self) -> impl Iterator<Item = &'static str> {
        Self::NAMES.into_iter().enumerate().filter(move |(bit, _)| self.0 & (1 << bit) != 0).map(|(_, name)| name)
    }
}
