//! What things cost in memory (guide, "How Much Memory?"), and what a controller with factory settings has (guide,
//! "Memory Allocations").
//!
//! ```
//! use acrc_catalog::memory::{ALIASES, LocalBlock};
//! use acrc_catalog::OperandClass;
//!
//! assert_eq!(ALIASES.bytes(50, 0), 2416);
//! assert_eq!(LocalBlock::Variables(OperandClass::StringV).bytes(10, 80), 840);
//! ```

#![allow(
    clippy::unreadable_literal,
    clippy::doc_markdown,
    reason = "the constants are generated with numbers and names as the guide writes them"
)]

use std::error::Error;
use std::fmt;
use std::str::FromStr;

use crate::{Confidence, OperandClass};

/// What a kind of thing costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cost {
    /// What it is, in the plural: `LV variables`.
    pub name: &'static str,
    /// What is counted: `variable`, `element`, `level`.
    pub unit: &'static str,
    /// Bytes of each unit.
    pub each: u32,
    /// Bytes beside the units.
    pub once: u32,
    /// Bytes of each character of a unit.
    pub character: u32,
    /// How many units there can be; `None` when only the memory bounds them.
    pub most: Option<u32>,
    /// Where it is paid: `sys` from system memory, `prog` from a program's, `text` as a part of a stored text.
    pub level: &'static str,
    /// What is worth knowing.
    pub note: &'static str,
    /// Where the row comes from (`data/README.md`).
    pub source: &'static str,
    /// How well it is attested.
    pub confidence: Confidence,
}

impl Cost {
    /// Bytes of `count` units with `length` characters each.
    pub const fn bytes(&self, count: u64, length: u64) -> u64 {
        let each = (self.each as u64).saturating_add((self.character as u64).saturating_mul(length));
        (self.once as u64).saturating_add(count.saturating_mul(each))
    }
}

/// A block of system memory: what a `DIM` at the system prompt allocates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SystemBlock {
    /// Text and variables of a program.
    Program(u8),
    /// Text and variables of a PLC program.
    Plc(u8),
    /// User parameters.
    Parameters,
    /// The alias table.
    Aliases,
    /// A communication stream buffer.
    Stream(Stream),
}

/// A communication stream.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Stream {
    /// `COM1`, `COM2`
    Com(u8),
    /// `FIFO`
    Fifo,
    /// `DPCB`
    Dpcb,
    /// `STREAM1` ...
    Numbered(u8),
}

impl SystemBlock {
    /// Bytes of a block whose `DIM` names this size: bytes of spaces and buffers, a count of parameters and aliases.
    pub const fn bytes(self, size: u64) -> u64 {
        match self {
            Self::Parameters => PARAMETERS.bytes(size, 0),
            Self::Aliases => ALIASES.bytes(size, 0),
            Self::Program(_) | Self::Plc(_) | Self::Stream(_) => size,
        }
    }

    /// The size of a block of so many bytes, as its `DIM` names it.
    pub const fn size(self, bytes: u32) -> u32 {
        match self {
            Self::Parameters => bytes.saturating_sub(PARAMETERS.once) / PARAMETERS.each,
            Self::Aliases => bytes.saturating_sub(ALIASES.once) / ALIASES.each,
            Self::Program(_) | Self::Plc(_) | Self::Stream(_) => bytes,
        }
    }
}

/// A name that no block of system memory has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownBlock(String);

impl fmt::Display for UnknownBlock {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}` is no block of memory: they are PROGn, PLCn, COMn, STREAMn, FIFO, DPCB, P and DEF", self.0)
    }
}

impl Error for UnknownBlock {}

/// The name that [`SystemBlock`] shows.
impl FromStr for SystemBlock {
    type Err = UnknownBlock;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        let digits = name.trim_start_matches(|character: char| character.is_ascii_uppercase());
        let word = name.strip_suffix(digits).unwrap_or(name);
        let block = match (word, digits.parse()) {
            ("PROG", Ok(number)) => Self::Program(number),
            ("PLC", Ok(number)) => Self::Plc(number),
            ("COM", Ok(number)) => Self::Stream(Stream::Com(number)),
            ("STREAM", Ok(number)) => Self::Stream(Stream::Numbered(number)),
            _ if name == "FIFO" => Self::Stream(Stream::Fifo),
            _ if name == "DPCB" => Self::Stream(Stream::Dpcb),
            _ if name == "P" => Self::Parameters,
            _ if name == "DEF" => Self::Aliases,
            _ => return Err(UnknownBlock(name.to_owned())),
        };
        Ok(block)
    }
}

impl fmt::Display for SystemBlock {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Program(number) => write!(f, "PROG{number}"),
            Self::Plc(number) => write!(f, "PLC{number}"),
            Self::Parameters => f.write_str("P"),
            Self::Aliases => f.write_str("DEF"),
            Self::Stream(Stream::Com(number)) => write!(f, "COM{number}"),
            Self::Stream(Stream::Fifo) => f.write_str("FIFO"),
            Self::Stream(Stream::Dpcb) => f.write_str("DPCB"),
            Self::Stream(Stream::Numbered(number)) => write!(f, "STREAM{number}"),
        }
    }
}

/// What a `DIM` at a program prompt allocates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum LocalBlock {
    /// `DIM LV(count)`, `DIM $V(count, length)`
    Variables(OperandClass),
    /// `DIM LA(count)`
    References(OperandClass),
    /// `DIM LA0(size)`, `DIM $A0(size, length)`
    Array(OperandClass),
    /// `DIM MBUF(count)`
    Moves,
}

impl LocalBlock {
    /// What it costs.
    pub const fn cost(self) -> Cost {
        match self {
            Self::References(_) => REFERENCES,
            Self::Moves => MOVES,
            Self::Variables(class) | Self::Array(class) => match class {
                OperandClass::Sv => SV,
                OperandClass::Dv => DV,
                OperandClass::StringV => STRING_V,
                OperandClass::La => LA,
                OperandClass::Sa => SA,
                OperandClass::Da => DA,
                OperandClass::StringA => STRING_A,
                OperandClass::Lv | OperandClass::Parameter | OperandClass::Bit => LV,
            },
        }
    }

    /// Bytes of `count` variables, references or elements; strings have `length` characters.
    pub const fn bytes(self, count: u64, length: u64) -> u64 {
        let length = match self {
            // An element without characters would be free; it counts one, so that memory bounds their number.
            Self::Array(OperandClass::StringA) if length == 0 => 1,
            _ => length,
        };
        self.cost().bytes(count, length)
    }

    /// The word of its `DIM`: `LV`, `MBUF`.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Variables(class) | Self::References(class) | Self::Array(class) => class.name(),
            Self::Moves => "MBUF",
        }
    }

    /// Whether its `DIM` also says how long each string is.
    pub const fn has_length(self) -> bool {
        matches!(self, Self::Variables(OperandClass::StringV) | Self::Array(OperandClass::StringA))
    }
}

/// Bytes that each of the first programs has with factory settings.
pub const FACTORY_SHARE: u32 = FACTORY_PROGRAM_BYTES / FACTORY_PROGRAMS as u32;

/// How many user parameters there can be: P0 to P4095.
pub const USER_PARAMETERS: u32 = match PARAMETERS.most {
    Some(most) => most,
    None => u32::MAX,
};

include!(concat!(env!("OUT_DIR"), "/memory.rs"));
