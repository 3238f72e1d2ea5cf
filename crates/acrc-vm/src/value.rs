//! Values at run time and their conversions (guide, "Parametric Evaluation" and "Variable Memory Allocation").
//!
//! The language has 32-bit integers, 32-bit and 64-bit floating point numbers and strings. Numbers convert into each
//! other; a string never does by itself, only through `VAL`, `STR$` and their like.

use crate::fault::FaultKind;
use crate::text::Text;

/// A value of the language.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A 32-bit integer: `LV`, `LA`, flags (-1 and 0), the results of relations and logical operators.
    Long(i32),
    /// A 32-bit floating point number: `SV`, `SA`, many system parameters.
    Single(f32),
    /// A 64-bit floating point number: `DV`, `DA`, the user parameters, quotients, functions.
    Double(f64),
    /// A string: `$V`, `$A`.
    Text(Text),
}

impl Value {
    /// What the language calls true (-1) or false (0).
    pub const fn truth_value(state: bool) -> Self {
        Self::Long(-(state as i32))
    }

    /// The number as an integer: the fraction is dropped, see [`double_to_long`].
    pub fn to_long(&self) -> Result<i32, FaultKind> {
        match self {
            Self::Long(value) => Ok(*value),
            _ => self.to_f64().map(double_to_long),
        }
    }

    /// The number with 64 bits.
    pub fn to_f64(&self) -> Result<f64, FaultKind> {
        match self {
            Self::Long(value) => Ok(f64::from(*value)),
            Self::Single(value) => Ok(f64::from(*value)),
            Self::Double(value) => Ok(*value),
            Self::Text(_) => Err(FaultKind::NumberExpected),
        }
    }

    /// True for every number but zero.
    pub fn truth(&self) -> Result<bool, FaultKind> {
        self.to_f64().map(|value| value != 0.0)
    }

    /// The string.
    pub fn as_text(&self) -> Result<&Text, FaultKind> {
        match self {
            Self::Text(text) => Ok(text),
            _ => Err(FaultKind::TextExpected),
        }
    }
}

impl Default for Value {
    fn default() -> Self {
        Self::Long(0)
    }
}

/// A floating point number as a 32-bit integer: the fraction is dropped.
///
/// Numbers from 2^31 up to 2^32 keep their bit pattern, because programs write such patterns into words of outputs
/// (`RND(4294967295)` goes to an output word in the guide). What lies outside of that ends at the nearest bound of a
/// signed integer.
#[inline]
pub fn double_to_long(value: f64) -> i32 {
    let whole = value as i64;
    if (i64::from(i32::MIN)..=i64::from(u32::MAX)).contains(&whole) {
        whole as i32
    } else if whole < 0 {
        i32::MIN
    } else {
        i32::MAX
    }
}
