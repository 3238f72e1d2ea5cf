//! Four-byte values, whose type is known only to those who asked for them.

use core::fmt;

/// Four bytes of a packet: a long integer or an IEEE single, depending on what was asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Field(pub u32);

impl Field {
    /// The bytes as a long integer.
    pub const fn long(self) -> i32 {
        self.0.cast_signed()
    }

    /// The bytes as an IEEE single.
    pub const fn single(self) -> f32 {
        f32::from_bits(self.0)
    }
}

impl From<i32> for Field {
    fn from(value: i32) -> Self {
        Self(value.cast_unsigned())
    }
}

impl From<u32> for Field {
    fn from(value: u32) -> Self {
        Self(value)
    }
}

impl From<f32> for Field {
    fn from(value: f32) -> Self {
        Self(value.to_bits())
    }
}

/// The fields that a packet carries, borrowed from its bytes or from the values to be sent.
#[derive(Clone, Copy)]
pub struct Fields<'a>(Source<'a>);

#[derive(Clone, Copy)]
enum Source<'a> {
    /// As they came, the low byte of each first.
    Bytes(&'a [[u8; 4]]),
    Values(&'a [Field]),
}

impl<'a> Fields<'a> {
    /// Fields that came in as bytes, the low byte of each first. What does not fill a field is left out.
    pub(crate) fn from_bytes(bytes: &'a [u8]) -> Self {
        Self(Source::Bytes(bytes.as_chunks().0))
    }

    /// How many there are.
    pub const fn len(&self) -> usize {
        match self.0 {
            Source::Bytes(bytes) => bytes.len(),
            Source::Values(values) => values.len(),
        }
    }

    /// Whether there are none.
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The field at a place.
    pub fn get(&self, place: usize) -> Option<Field> {
        match self.0 {
            Source::Bytes(bytes) => bytes.get(place).map(|bytes| Field(u32::from_le_bytes(*bytes))),
            Source::Values(values) => values.get(place).copied(),
        }
    }

    /// The fields, in the order of the line.
    pub fn iter(&self) -> impl Iterator<Item = Field> + use<'a> {
        let (bytes, values): (&[[u8; 4]], &[Field]) = match self.0 {
            Source::Bytes(bytes) => (bytes, &[]),
            Source::Values(values) => (&[], values),
        };
        bytes.iter().map(|bytes| Field(u32::from_le_bytes(*bytes))).chain(values.iter().copied())
    }

    pub(crate) fn put(&self, out: &mut impl Extend<u8>) {
        match self.0 {
            Source::Bytes(bytes) => out.extend(bytes.as_flattened().iter().copied()),
            Source::Values(values) => out.extend(values.iter().flat_map(|field| field.0.to_le_bytes())),
        }
    }
}

impl<'a> From<&'a [Field]> for Fields<'a> {
    fn from(values: &'a [Field]) -> Self {
        Self(Source::Values(values))
    }
}

impl<'a, const N: usize> From<&'a [Field; N]> for Fields<'a> {
    fn from(values: &'a [Field; N]) -> Self {
        Self(Source::Values(values))
    }
}

impl PartialEq for Fields<'_> {
    fn eq(&self, other: &Self) -> bool {
        self.iter().eq(other.iter())
    }
}

impl Eq for Fields<'_> {}

impl fmt::Debug for Fields<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_list().entries(self.iter().map(|field| field.0)).finish()
    }
}
