//! `PRINT USING`: a picture of digits for the numbers of a line.
//!
//! The guide shows the picture `##` only. Read here: each `#` is a place for a digit, a point among them starts the
//! decimals, the number stands at the right and blanks fill the places in front of it. A number that needs more places
//! than the picture has is printed in full, so that no digit is ever lost.

use crate::value::Value;

/// A picture, taken apart.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    before: Vec<u8>,
    width: usize,
    decimals: usize,
    behind: Vec<u8>,
}

impl Picture {
    /// Takes a picture apart. Text without any `#` has no place for a number; the number is then printed behind it as
    /// without a picture.
    pub fn new(picture: &[u8]) -> Self {
        let is_place = |byte: &u8| matches!(byte, b'#' | b'.');
        let start = picture.iter().position(is_place).unwrap_or(picture.len());
        let (before, rest) = picture.split_at(start);
        let end = rest.iter().position(|byte| !is_place(byte)).unwrap_or(rest.len());
        let (places, behind) = rest.split_at(end);
        let decimals = places.iter().position(|byte| *byte == b'.').map_or(0, |point| places.len() - point - 1);
        Self { before: before.to_vec(), width: places.len(), decimals, behind: behind.to_vec() }
    }

    /// The number in this picture; a string as it is.
    pub fn apply(&self, value: &Value) -> Vec<u8> {
        let number = match value {
            Value::Text(text) => return text.as_bytes().to_vec(),
            Value::Long(value) => f64::from(*value),
            Value::Single(value) => f64::from(*value),
            Value::Double(value) => *value,
        };
        let digits = match self.width {
            0 => super::number(value),
            width => format!("{number:>width$.decimals$}", decimals = self.decimals),
        };
        [&*self.before, digits.as_bytes(), &*self.behind].concat()
    }
}
