//! Fast status on UDP port 5003 (Ethernet specification, "Fast Status").

use crate::{ByteOrder, Field, Malformed};

/// What a client asks for: that status is sent to it at an interval, or no longer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Subscription {
    /// Zero ends a subscription, everything else begins one.
    pub mode: u32,
    /// The interval in milliseconds.
    pub interval_milliseconds: u32,
}

impl Subscription {
    /// Length of its datagram in bytes.
    pub const LEN: usize = 8;

    /// Asks for status at an interval.
    pub const fn every(interval_milliseconds: u32) -> Self {
        Self { mode: 1, interval_milliseconds }
    }

    /// Asks for no more.
    pub const fn end() -> Self {
        Self { mode: 0, interval_milliseconds: 0 }
    }

    /// Whether it ends a subscription.
    pub const fn is_end(&self) -> bool {
        self.mode == 0
    }

    /// Its datagram.
    pub fn encode(&self) -> [u8; Self::LEN] {
        let mut bytes = [0; Self::LEN];
        let values = [self.mode, self.interval_milliseconds];
        for (place, value) in bytes.as_chunks_mut().0.iter_mut().zip(values) {
            *place = ByteOrder::BigEndian.write(value);
        }
        bytes
    }

    /// Reads a datagram. Bytes behind the eighth are ignored.
    pub fn decode(bytes: &[u8]) -> Result<Self, Malformed> {
        let (values, _) = bytes.as_chunks();
        let [mode, interval] = values.first_chunk().ok_or(Malformed::Short)?;
        let [mode, interval_milliseconds] = [mode, interval].map(|value| ByteOrder::BigEndian.read(*value));
        Ok(Self { mode, interval_milliseconds })
    }
}

/// What the controller sends: ten groups of eight fields, chosen with `FSTAT0` to `FSTAT9`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FastStatus(pub [[Field; Self::GROUP]; Self::GROUPS]);

impl FastStatus {
    /// Number of groups.
    pub const GROUPS: usize = 10;
    /// Number of fields in a group.
    pub const GROUP: usize = 8;
    /// Length of its datagram in bytes.
    pub const LEN: usize = 4 * Self::GROUP * Self::GROUPS;

    /// Its datagram.
    pub fn encode(&self) -> [u8; Self::LEN] {
        let mut bytes = [0; Self::LEN];
        for (place, field) in bytes.as_chunks_mut().0.iter_mut().zip(self.0.as_flattened()) {
            *place = ByteOrder::BigEndian.write(field.0);
        }
        bytes
    }

    /// Reads a datagram. Bytes behind the last field are ignored.
    pub fn decode(bytes: &[u8]) -> Result<Self, Malformed> {
        let bytes = bytes.first_chunk::<{ Self::LEN }>().ok_or(Malformed::Short)?;
        let mut status = Self::default();
        for (field, value) in status.0.as_flattened_mut().iter_mut().zip(bytes.as_chunks().0) {
            *field = Field(ByteOrder::BigEndian.read(*value));
        }
        Ok(status)
    }
}

impl Default for FastStatus {
    fn default() -> Self {
        Self([[Field(0); Self::GROUP]; Self::GROUPS])
    }
}
