//! Axis names.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

/// The name that `ATTACH SLAVE` gives an axis: one to four letters, in any case (guide, "Attachments").
///
/// Packed as in the stream: five bits a letter, the first letter lowest, `A` = 1, unused places 0.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct AxisName(u32);

/// A text that is no axis name.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("an axis name has one to four letters, `{0}` has not")]
pub struct InvalidAxisName(pub String);

impl AxisName {
    /// Bits of the packed form.
    pub const BITS: u32 = 20;
    const LETTERS: usize = 4;

    /// The packed form.
    pub fn packed(self) -> u32 {
        self.0
    }

    /// From the packed form. `None` unless it is one to four letters without a gap.
    pub fn from_packed(packed: u32) -> Option<Self> {
        let letters = (0..Self::LETTERS).map(|place| (packed >> (5 * place)) & 31);
        let used = letters.clone().take_while(|&letter| letter != 0).count();
        let valid = packed >> Self::BITS == 0
            && used > 0
            && packed >> (5 * used) == 0
            && letters.max().is_some_and(|letter| letter <= 26);
        valid.then_some(Self(packed))
    }
}

impl FromStr for AxisName {
    type Err = InvalidAxisName;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let valid = (1..=Self::LETTERS).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_alphabetic());
        if !valid {
            return Err(InvalidAxisName(text.to_owned()));
        }
        let letters = text.bytes().map(|byte| u32::from(byte.to_ascii_uppercase() - b'A') + 1);
        Ok(Self(letters.enumerate().fold(0, |packed, (place, letter)| packed | letter << (5 * place))))
    }
}

impl fmt::Display for AxisName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let letters = (0..Self::LETTERS).map(|place| (self.0 >> (5 * place)) & 31).take_while(|&letter| letter != 0);
        let name: String = letters.map(|letter| char::from(b'@' + letter as u8)).collect();
        f.pad(&name)
    }
}

impl fmt::Debug for AxisName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "AxisName({self})")
    }
}
