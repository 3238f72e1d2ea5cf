//! Programs and PLC programs as things that run.

use acrc_catalog::memory::SystemBlock;
use acrc_image::UnitName;
use acrc_syntax::units::Level;

/// Something with a text of its own that can run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Task {
    Program(u8),
    Plc(u8),
}

impl Task {
    /// What the prompt of a level belongs to.
    pub(crate) fn at(level: Level) -> Option<Self> {
        match level {
            Level::System => None,
            Level::Program(number) => Some(Self::Program(number)),
            Level::Plc(number) => Some(Self::Plc(number)),
        }
    }

    /// What executes a text; `None` for setup code.
    pub(crate) fn of(name: UnitName) -> Option<Self> {
        match name {
            UnitName::Boot => None,
            UnitName::Program(number) => Some(Self::Program(number)),
            UnitName::Plc(number) => Some(Self::Plc(number)),
        }
    }

    /// Its prompt level.
    pub(crate) fn level(self) -> Level {
        match self {
            Self::Program(number) => Level::Program(number),
            Self::Plc(number) => Level::Plc(number),
        }
    }

    /// The text of the image that it executes.
    pub(crate) fn unit(self) -> UnitName {
        match self {
            Self::Program(number) => UnitName::Program(number),
            Self::Plc(number) => UnitName::Plc(number),
        }
    }

    /// The memory of its text and variables.
    pub(crate) fn space(self) -> SystemBlock {
        match self {
            Self::Program(number) => SystemBlock::Program(number),
            Self::Plc(number) => SystemBlock::Plc(number),
        }
    }
}
