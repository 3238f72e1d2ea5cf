//! What a program has done to, and wanted to know of, the rest of the controller.
//!
//! A program that changed nothing, read nothing that changes by itself and came back to where it was will do the same
//! again until somebody changes something that it reads ([`crate::watch`]). What is read and written is kept by the
//! [`Places`] that flags and user parameters fall into: several share a place, so some changes wake a program in vain,
//! but none is missed.

/// A set of places: 32 for words of flags, 32 for user parameters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Places(u64);

impl Places {
    /// Everything: what a command does, what moves, what happens in the world.
    pub(crate) const ALL: Self = Self(u64::MAX);
    /// Everything but user parameters: what a command may wait for.
    pub(crate) const MACHINE: Self = Self(u32::MAX as u64);

    /// The place of a flag.
    #[inline]
    pub(crate) fn flag(number: i64) -> Self {
        Self(1 << (number >> 5 & 31))
    }

    /// The place of a user parameter.
    #[inline]
    pub(crate) fn user(number: i64) -> Self {
        Self(1 << (32 + (number & 31)))
    }

    /// Whether user parameters are among them.
    pub(crate) fn any_user(self) -> bool {
        self.0 >> 32 != 0
    }

    fn indices(self) -> impl Iterator<Item = usize> {
        (0..64).filter(move |place| self.0 >> place & 1 == 1)
    }
}

impl std::ops::BitOrAssign for Places {
    #[inline]
    fn bitor_assign(&mut self, other: Self) {
        self.0 |= other.0;
    }
}

/// Counts changes, and knows which was the latest at each place.
#[derive(Clone, Debug)]
pub(crate) struct Changes {
    count: u64,
    latest: [u64; 64],
}

impl Changes {
    pub(crate) fn new() -> Self {
        Self { count: 1, latest: [0; 64] }
    }

    /// Changes so far.
    pub(crate) fn count(&self) -> u64 {
        self.count
    }

    /// Something has changed at these places.
    pub(crate) fn at(&mut self, places: Places) {
        self.count += 1;
        if places == Places::ALL {
            self.latest = [self.count; 64];
        } else {
            places.indices().for_each(|place| self.latest[place] = self.count);
        }
    }

    /// Anything may have changed.
    pub(crate) fn everywhere(&mut self) {
        self.at(Places::ALL);
    }

    /// Whether anything has changed at these places since there were `count` changes.
    pub(crate) fn any_since(&self, places: Places, count: u64) -> bool {
        self.count != count && places.indices().any(|place| self.latest[place] > count)
    }
}

/// What some lines of a program have touched.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Footprint {
    /// Something beside the program's own variables is, or may be, no longer what it was.
    pub(crate) changed: bool,
    /// Where somebody else could see that.
    pub(crate) writes: Places,
    /// What it depends on.
    pub(crate) reads: Places,
    /// It read something that follows time.
    pub(crate) timed: bool,
}

impl Footprint {
    /// Takes note of a change that anybody may see at these places.
    #[inline]
    pub(crate) fn write(&mut self, places: Places) {
        self.changed = true;
        self.writes |= places;
    }

    /// Adds another one.
    pub(crate) fn add(&mut self, other: Self) {
        self.changed |= other.changed;
        self.timed |= other.timed;
        self.writes |= other.writes;
        self.reads |= other.reads;
    }
}
