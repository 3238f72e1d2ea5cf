//! Sets of axes.

/// A set of axes, of which some may not be known.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AxisSet {
    known: u64,
    open: bool,
}

impl AxisSet {
    /// Adds an axis. One beyond those of any controller is a mistake that is reported elsewhere; it leaves the set
    /// open.
    pub fn add(&mut self, axis: u32) {
        match 1_u64.checked_shl(axis) {
            Some(bit) => self.known |= bit,
            None => self.open = true,
        }
    }

    /// Lets any axis be in the set.
    pub fn open(&mut self) {
        self.open = true;
    }

    /// Whether the axis is in the set.
    pub fn has(&self, axis: u32) -> bool {
        1_u64.checked_shl(axis).is_some_and(|bit| self.known & bit != 0)
    }

    /// Whether the axis is in the set or may be.
    pub fn may_have(&self, axis: u32) -> bool {
        self.open || self.has(axis)
    }

    /// Whether nothing is in the set.
    pub fn is_empty(&self) -> bool {
        !self.open && self.known == 0
    }
}
