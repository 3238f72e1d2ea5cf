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

/// What a `DIM` at a program prompt allocates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum LocalBlock {
    /// `DIM LV(count)`, `DIM $V(count, length)`
    Variables(OperandClass),
    /// `DIM LA(count)`
    References(OperandClass),
    /// `DIM LA0(size)`, `DIM $A0(size, length)`
    Array(OperandClass),
}

impl LocalBlock {
    /// What it costs.
    pub const fn cost(self) -> Cost {
        match self {
            Self::References(_) => REFERENCES,
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

    /// The class of what is allocated.
    pub const fn class(self) -> OperandClass {
        let (Self::Variables(class) | Self::References(class) | Self::Array(class)) = self;
        class
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
