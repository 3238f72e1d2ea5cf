//! The conversions of binary transfers on serial and FIFO channels (`MODE`; guide, "Binary Data Transfer").
//!
//! They follow Kermit: `#` announces a control character, `&` a byte whose high bit is set. The header byte of a
//! transfer is never converted, and text never is.

/// Announces a control character.
const PREFIX: u8 = b'#';
/// Announces a byte whose high bit was taken away.
const HIGH: u8 = b'&';
const HIGH_BIT: u8 = 0x80;
/// What a control character and its printed form differ in.
const CONTROL_BIT: u8 = 0x40;

/// How the bytes of a binary transfer are converted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Mode {
    /// Not at all: `MODE 0` and `MODE 2`, and what a FIFO channel begins with.
    #[default]
    Plain,
    /// Control characters are prefixed: `MODE 1`, and what a serial channel begins with.
    Prefixed,
    /// Control characters are prefixed and high bits stripped, for seven-bit lines: `MODE 3`.
    Stripped,
}

impl Mode {
    /// What `MODE number` chooses.
    pub const fn from_number(number: u8) -> Option<Self> {
        match number {
            0 | 2 => Some(Self::Plain),
            1 => Some(Self::Prefixed),
            3 => Some(Self::Stripped),
            _ => None,
        }
    }

    /// A byte as it goes over the line.
    pub fn escape(self, byte: u8) -> Escaped {
        let mut escaped = Escaped::default();
        let mut rest = byte;
        if self == Self::Stripped && rest & HIGH_BIT != 0 {
            escaped.push(HIGH);
            rest &= !HIGH_BIT;
        }
        match rest {
            0x00..=0x1F | 0x7F if self != Self::Plain => escaped.push_two(PREFIX, rest ^ CONTROL_BIT),
            PREFIX if self != Self::Plain => escaped.push_two(PREFIX, rest),
            HIGH if self == Self::Stripped => escaped.push_two(PREFIX, rest),
            _ => escaped.push(rest),
        }
        escaped
    }
}

/// One byte in its form on the line: one to three bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Escaped {
    bytes: [u8; 3],
    len: u8,
}

impl Escaped {
    fn push(&mut self, byte: u8) {
        if let Some(place) = self.bytes.get_mut(usize::from(self.len)) {
            *place = byte;
            self.len += 1;
        }
    }

    fn push_two(&mut self, first: u8, second: u8) {
        self.push(first);
        self.push(second);
    }
}

impl IntoIterator for Escaped {
    type Item = u8;
    type IntoIter = core::iter::Take<core::array::IntoIter<u8, 3>>;

    fn into_iter(self) -> Self::IntoIter {
        self.bytes.into_iter().take(usize::from(self.len))
    }
}

/// Takes conversions back, byte by byte.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Unescape {
    prefix: bool,
    high: bool,
}

impl Unescape {
    /// Takes a byte of the line, and gives the byte that it completes.
    pub fn push(&mut self, mode: Mode, byte: u8) -> Option<u8> {
        match byte {
            _ if mode == Mode::Plain => return Some(byte),
            PREFIX if !self.prefix => self.prefix = true,
            HIGH if mode == Mode::Stripped && !self.prefix && !self.high => self.high = true,
            _ => {
                let prefixed = self.prefix && matches!(byte, 0x3F..=0x5F);
                let decoded = if prefixed { byte ^ CONTROL_BIT } else { byte };
                let decoded = if self.high { decoded | HIGH_BIT } else { decoded };
                *self = Self::default();
                return Some(decoded);
            }
        }
        None
    }
}
