//! What stands at an address, and what a packet makes of it.

use acrc_vm::{Reference, Value};

use super::number;

/// What a packet takes a number in memory for. In the packet it is a long integer for the first, and an IEEE single for the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Conversion {
    /// A long integer: the 32 bits as they stand, whatever they mean.
    Long,
    /// A 64-bit number. It takes two addresses.
    Double,
    /// A 32-bit number.
    Single,
}

impl Conversion {
    /// By how many addresses two numbers that follow each other are apart.
    pub(super) const fn stride(self) -> u32 {
        match self {
            Self::Double => 2,
            Self::Long | Self::Single => 1,
        }
    }

    /// What has to stand at an address.
    pub(super) const fn expects(self) -> &'static str {
        match self {
            Self::Long => "32 bits",
            Self::Double => "a 64-bit number",
            Self::Single => "a 32-bit floating point number",
        }
    }
}

/// A place that holds a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Home {
    Parameter(u32),
    /// A variable or an element of a program.
    Local(u8, Reference),
}

/// What a word of memory belongs to.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Cell {
    /// A count or an address, which only `DIM` changes.
    Fixed(u32),
    /// A number of 32 bits.
    Word(Home, Value),
    /// A number of 32 bits that is what is written: no document gives its form.
    Either(Home, Value),
    /// The lower or upper half of a 64-bit number.
    Half { home: Home, value: f64, upper: bool },
    /// The length of a string.
    Length { program: u8, text: Reference, length: u32 },
    /// Four characters of a string, the first one in the lowest byte.
    Characters { program: u8, text: Reference, word: u32, bits: u32 },
}

impl Cell {
    /// What goes into a packet. `None` where the conversion takes it for what it is not.
    pub(super) fn read(&self, conversion: Conversion) -> Option<u32> {
        match (self, conversion) {
            (
                Self::Fixed(bits) | Self::Length { length: bits, .. } | Self::Characters { bits, .. },
                Conversion::Long,
            ) => Some(*bits),
            (Self::Word(_, value), Conversion::Long)
            | (Self::Word(_, value @ Value::Single(_)), Conversion::Single) => number::bits(value),
            (Self::Either(_, value), Conversion::Long) => number::long(value).map(i32::cast_unsigned),
            (Self::Either(_, value), Conversion::Single) => number::single(value).map(f32::to_bits),
            (Self::Half { value, upper, .. }, Conversion::Long) => Some(halves(*value)[usize::from(*upper)]),
            (Self::Half { value, upper: false, .. }, Conversion::Double) => Some(number::narrowed(*value).to_bits()),
            _ => None,
        }
    }

    /// The number that a field of a packet makes of what stands there, and where it goes. `None` where the conversion takes it for
    /// what it is not. Strings are not numbers.
    pub(super) fn converted(&self, conversion: Conversion, field: u32) -> Option<(Home, Value)> {
        let single = Value::Single(f32::from_bits(field));
        match (self, conversion) {
            (Self::Word(home, Value::Long(_)) | Self::Either(home, _), Conversion::Long) => {
                Some((*home, Value::Long(field.cast_signed())))
            }
            (Self::Word(home, Value::Single(_)), Conversion::Long | Conversion::Single)
            | (Self::Either(home, _), Conversion::Single) => Some((*home, single)),
            (Self::Half { home, value, upper }, Conversion::Long) => {
                let mut halves = halves(*value);
                halves[usize::from(*upper)] = field;
                let [lower, upper] = halves.map(u64::from);
                Some((*home, Value::Double(f64::from_bits(upper << u32::BITS | lower))))
            }
            (Self::Half { home, upper: false, .. }, Conversion::Double) => {
                Some((*home, Value::Double(f64::from(f32::from_bits(field)))))
            }
            _ => None,
        }
    }

    /// The long integer that stands there.
    pub(super) fn long(&self) -> Option<u32> {
        match self {
            Self::Word(_, Value::Long(long)) | Self::Either(_, Value::Long(long)) => Some(long.cast_unsigned()),
            _ => None,
        }
    }
}

/// The two words of a 64-bit number, the lower one first.
fn halves(value: f64) -> [u32; 2] {
    let bits = value.to_bits();
    [bits as u32, (bits >> u32::BITS) as u32]
}
