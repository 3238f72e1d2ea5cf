//! The header of a move: which bits mean what.

use super::Slot;
use crate::{SplineFields, WireOptions};

/// A bit of the header: header code and bit of it.
#[derive(Clone, Copy)]
pub(super) struct Bit(usize, u8);

pub(super) const FVEL_LOCKOUT: Bit = Bit(0, 0);
pub(super) const FOV_LOCKOUT: Bit = Bit(0, 1);
pub(super) const STP_RAMP: Bit = Bit(0, 2);
const CODE_3: Bit = Bit(0, 3);
pub(super) const VELOCITY: Bit = Bit(0, 4);
pub(super) const ACCELERATION: Bit = Bit(0, 5);
pub(super) const COUNT_DOWN: Bit = Bit(0, 6);
pub(super) const COUNTER: Bit = Bit(0, 7);
pub(super) const INTERRUPT: Bit = Bit(1, 3);
pub(super) const COUNTERCLOCKWISE: Bit = Bit(1, 4);
pub(super) const ARC_OR_KNOT: Bit = Bit(1, 5);
pub(super) const NURB: Bit = Bit(1, 6);
pub(super) const SPLINE: Bit = Bit(1, 7);
pub(super) const INCREMENTAL_TARGET: Bit = Bit(3, 0);
pub(super) const INCREMENTAL_CENTER: Bit = Bit(3, 1);
pub(super) const FLOATING_POINT: Bit = Bit(3, 2);
pub(super) const SCALING: Bit = Bit(3, 3);
pub(super) const FINAL_VELOCITY: Bit = Bit(3, 4);
pub(super) const BLOCK_SKIP: Bit = Bit(3, 5);
pub(super) const CURVE: Bit = Bit(3, 6);
const EXTENDED: Bit = Bit(3, 7);
const MASTER_8: Bit = Bit(4, 3);
/// The bits of header code 1 that hold the master.
const MASTER_LOW: u8 = 0x07;

/// The header codes 0 to 7 of a move. Those that its header leaves out are zero.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Codes([u8; 8]);

impl Codes {
    /// The codes, 0 to 7.
    pub const fn bytes(self) -> [u8; 8] {
        self.0
    }

    /// The master that moves.
    pub fn master(self) -> Slot {
        let high = if self.has(MASTER_8) { MASTER_LOW + 1 } else { 0 };
        Slot((self.code(1) & MASTER_LOW) | high)
    }

    pub(super) fn set_master(&mut self, master: Slot) {
        self.or(1, master.0 & MASTER_LOW);
        if master.0 > MASTER_LOW {
            self.set(MASTER_8);
        }
    }

    pub(super) fn has(self, Bit(code, bit): Bit) -> bool {
        self.code(code) & (1 << bit) != 0
    }

    /// Sets a bit, and those that say that its code is there.
    pub(super) fn set(&mut self, Bit(code, bit): Bit) {
        self.or(code, 1 << bit);
    }

    pub(super) fn set_if(&mut self, bit: Bit, condition: bool) {
        if condition {
            self.set(bit);
        }
    }

    /// Notes that there is a target of a slave.
    pub(super) fn set_target(&mut self, slave: Slot) {
        let code = if slave.0 < 8 { 2 } else { 6 };
        self.set(Bit(code, slave.0 % 8));
    }

    /// The number of the plane that an arc lies in.
    pub(super) fn plane(self) -> u8 {
        self.code(1) >> 6
    }

    pub(super) fn set_plane(&mut self, plane: u8) {
        self.or(1, plane << 6);
    }

    /// Makes the header nine bytes long.
    pub(super) fn extend(&mut self) {
        self.set(EXTENDED);
    }

    fn code(self, code: usize) -> u8 {
        self.0.get(code).copied().unwrap_or_default()
    }

    fn or(&mut self, code: usize, bits: u8) {
        let before = match code {
            0..=2 => None,
            3 => Some(CODE_3),
            _ => Some(EXTENDED),
        };
        if let Some(before) = before {
            self.set(before);
        }
        if let Some(code) = self.0.get_mut(code) {
            *code |= bits;
        }
    }

    /// Length of the header in bytes, with the one that says that it is a move.
    pub(super) fn header_len(self) -> usize {
        match (self.has(CODE_3), self.has(EXTENDED)) {
            (false, _) => 4,
            (true, false) => 5,
            (true, true) => 9,
        }
    }

    /// The fields that the header announces, one bit each by number.
    pub(super) fn fields(self, options: &WireOptions) -> u32 {
        let bit = |bit: Bit, fields: u32| if self.has(bit) { fields } else { 0 };
        let master = bit(VELOCITY, 1) | bit(FINAL_VELOCITY, 1 << 1) | bit(ACCELERATION, 1 << 2);
        let targets = u32::from(self.code(2)) << 3 | u32::from(self.code(6)) << 11;
        let (knot, both, centers) = (1 << 21, 0b11 << 21, 0b11 << 19);
        let others = match (self.has(CURVE), self.has(NURB)) {
            (false, _) => bit(ARC_OR_KNOT, centers) | bit(SCALING, both),
            (true, false) if options.spline_fields == SplineFields::KnotByCode1 => bit(ARC_OR_KNOT, knot),
            (true, _) => bit(SCALING, both),
        };
        master | targets | others
    }

    /// Reads the codes of a header behind its first byte, if it is complete.
    pub(super) fn read(head: &[u8]) -> Option<Self> {
        let len = Self::header_wanted(head);
        let mut codes = Self::default();
        for (code, byte) in codes.0.iter_mut().zip(head.get(1..len)?) {
            *code = *byte;
        }
        Some(codes)
    }

    /// The length of the header, as far as its bytes say it.
    pub(super) fn header_wanted(head: &[u8]) -> usize {
        let mut codes = Self::default();
        for (code, byte) in codes.0.iter_mut().zip(head.iter().skip(1)).take(4) {
            *code = *byte;
        }
        // What stands in the place of header code 3 is data when the header has no such code.
        codes.header_len()
    }
}
