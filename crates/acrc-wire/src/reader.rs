//! Reading the parts of one packet.

use crate::{ByteOrder, Fields, Malformed};

/// What is left of a packet's bytes. A packet that is shorter than its header says is [`Malformed::Short`]; decoders
/// wait for the whole packet, so that is for callers that cut packets themselves.
pub(crate) struct Reader<'a>(&'a [u8]);

impl<'a> Reader<'a> {
    pub(crate) const fn new(bytes: &'a [u8]) -> Self {
        Self(bytes)
    }

    pub(crate) fn bytes<const N: usize>(&mut self) -> Result<&'a [u8; N], Malformed> {
        let (first, rest) = self.0.split_first_chunk().ok_or(Malformed::Short)?;
        self.0 = rest;
        Ok(first)
    }

    pub(crate) fn word(&mut self) -> Result<u16, Malformed> {
        self.bytes().map(|bytes| u16::from_le_bytes(*bytes))
    }

    pub(crate) fn long(&mut self) -> Result<u32, Malformed> {
        self.bytes().map(|bytes| u32::from_le_bytes(*bytes))
    }

    pub(crate) fn long_in(&mut self, order: ByteOrder) -> Result<u32, Malformed> {
        self.bytes().map(|bytes| order.read(*bytes))
    }

    /// The next `count` fields.
    pub(crate) fn fields(&mut self, count: usize) -> Result<Fields<'a>, Malformed> {
        let (fields, rest) = self.0.split_at_checked(4 * count).ok_or(Malformed::Short)?;
        self.0 = rest;
        Ok(Fields::from_bytes(fields))
    }
}
