//! The CRC of configuration file and operating system (Ethernet specification, "Download Termination Request").
//!
//! The specification gives the polynomial, the first remainder, and that the algorithm is that of Ethernet.

use crate::{ByteOrder, CrcRule};

/// Length in bytes of the configuration file with its CRC, and of a block of an operating system.
pub const FILE_LEN: usize = 1024;

const POLYNOMIAL: u32 = 0x04C1_1DB7;
const FIRST_REMAINDER: u32 = 0xFFFF_FFFF;

const HIGH_FIRST: [u32; 256] = table(false);
const LOW_FIRST: [u32; 256] = table(true);

/// What each value of a byte does to the remainder.
const fn table(low_bit_first: bool) -> [u32; 256] {
    let mut table = [0; 256];
    let mut byte = 0_usize;
    while byte < 256 {
        let mut remainder = if low_bit_first { byte as u32 } else { (byte as u32) << 24 };
        let mut bit = 0;
        while bit < 8 {
            remainder = match low_bit_first {
                true if remainder & 1 != 0 => (remainder >> 1) ^ POLYNOMIAL.reverse_bits(),
                true => remainder >> 1,
                false if remainder >> 31 != 0 => (remainder << 1) ^ POLYNOMIAL,
                false => remainder << 1,
            };
            bit += 1;
        }
        table[byte] = remainder;
        byte += 1;
    }
    table
}

/// A CRC in the making.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crc {
    rule: CrcRule,
    remainder: u32,
}

impl Crc {
    /// The CRC of nothing.
    pub const fn new(rule: CrcRule) -> Self {
        Self { rule, remainder: FIRST_REMAINDER }
    }

    /// Adds bytes.
    pub fn update(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.remainder = match self.rule {
                CrcRule::Ethernet => {
                    let [low, ..] = self.remainder.to_le_bytes();
                    (self.remainder >> 8) ^ entry(&LOW_FIRST, low ^ byte)
                }
                CrcRule::HighBitFirst => {
                    let [high, ..] = self.remainder.to_be_bytes();
                    (self.remainder << 8) ^ entry(&HIGH_FIRST, high ^ byte)
                }
            };
        }
    }

    /// The CRC of the bytes so far.
    pub const fn value(&self) -> u32 {
        match self.rule {
            CrcRule::Ethernet => !self.remainder,
            CrcRule::HighBitFirst => self.remainder,
        }
    }

    fn of(bytes: &[u8], rule: CrcRule) -> u32 {
        let mut crc = Self::new(rule);
        crc.update(bytes);
        crc.value()
    }
}

fn entry(table: &[u32; 256], byte: u8) -> u32 {
    table.get(usize::from(byte)).copied().unwrap_or_default()
}

/// Whether the last four bytes of a file are the CRC of those before them.
pub fn is_intact(file: &[u8], rule: CrcRule, order: ByteOrder) -> bool {
    file.split_last_chunk().is_some_and(|(bytes, crc)| order.read(*crc) == Crc::of(bytes, rule))
}

/// Makes the last four bytes of a file the CRC of those before them. A file shorter than that stays as it is.
pub fn seal(file: &mut [u8], rule: CrcRule, order: ByteOrder) {
    if let Some((bytes, crc)) = file.split_last_chunk_mut() {
        *crc = order.write(Crc::of(bytes, rule));
    }
}
