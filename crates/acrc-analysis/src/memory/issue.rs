//! What does not fit, and where.

use acrc_catalog::OperandClass;
use acrc_catalog::memory::SystemBlock;
use acrc_syntax::units::Level;

use super::calls::Calls;
use super::events::Block;

/// Something that does not fit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Issue {
    /// Where.
    pub site: Site,
    /// What.
    pub kind: IssueKind,
}

/// A place, so named that it stays the same while text moves about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Site {
    /// An event of the file ([`super::MemoryEvents::events`]).
    Event(u32),
    /// A definition of an alias ([`crate::FileIndex::defines`]).
    Define(u32),
    /// A statement of a section, counted from the section's first.
    Text {
        /// The section.
        section: u32,
        /// The statement.
        statement: u32,
    },
}

/// What does not fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum IssueKind {
    /// A program needs more than its space.
    TooLarge {
        /// The program.
        level: Level,
        /// Bytes of its text.
        text: u64,
        /// Bytes of its variables and its move buffer.
        variables: u64,
        /// How deep its subroutines call each other. Without these bytes it fits when `certain` is false.
        calls: Calls,
        /// It does not fit whatever the program does.
        certain: bool,
        /// What it has.
        space: Space,
    },
    /// A block that has memory is given memory again.
    Redimensioned {
        /// The block.
        block: Block,
        /// Where its memory comes from.
        space: Option<Space>,
    },
    /// More system memory than there is.
    SystemExceeded {
        /// The block that does not fit.
        block: SystemBlock,
        /// Bytes that it wants.
        needed: u64,
        /// Bytes that are left.
        free: u64,
    },
    /// An array is given elements that has no reference.
    NoReference {
        /// Its class.
        class: OperandClass,
        /// Its number.
        array: u32,
        /// How many references there are; `None` without a `DIM` of them before it.
        references: Option<u64>,
    },
    /// More aliases than there is room for.
    TooManyAliases {
        /// How many the project defines.
        aliases: u64,
        /// How many there is room for; `None` without a `DIM DEF`.
        room: Option<u64>,
    },
    /// A stored text dimensions its variables without clearing them.
    NotCleared(Block),
}

/// A `DIM` of much more than is needed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spare {
    /// The `DIM`.
    pub site: Site,
    /// What it gives memory to.
    pub block: SystemBlock,
    /// Bytes, or how many aliases, it gives.
    pub given: u64,
    /// Bytes that are needed at most, or how many aliases there are.
    pub needed: u64,
}

/// The memory that a block has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// A share of the factory settings, in bytes.
    Factory(u64),
    /// From a `DIM`, in bytes.
    Dim(u64),
    /// Nothing gives it any.
    None,
}

impl Space {
    /// In bytes.
    pub fn bytes(self) -> u64 {
        match self {
            Self::Factory(bytes) | Self::Dim(bytes) => bytes,
            Self::None => 0,
        }
    }
}
