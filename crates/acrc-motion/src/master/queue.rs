//! The moves that wait.

use alloc::boxed::Box;

use super::moves::MoveSettings;
use super::path::Path;

/// A move that was accepted: its path is laid and its settings are captured.
#[derive(Clone, Copy, Debug)]
pub(super) struct Queued {
    pub(super) path: Path,
    pub(super) settings: MoveSettings,
}

/// A ring of fixed size. Its storage is a boxed slice, which cannot grow: nothing but [`Queue::new`] allocates.
#[derive(Clone, Debug)]
pub(super) struct Queue {
    places: Box<[Option<Queued>]>,
    first: usize,
    used: usize,
}

impl Queue {
    pub(super) fn new(capacity: usize) -> Self {
        Self { places: (0..capacity).map(|_| None).collect(), first: 0, used: 0 }
    }

    /// A ring of another size with the same moves waiting, if they fit.
    pub(super) fn resized(&self, capacity: usize) -> Option<Self> {
        let mut resized = Self::new(capacity);
        for index in 0..self.used {
            let queued = (*self.places.get(self.wrapped(index))?)?;
            if !resized.push(&queued) {
                return None;
            }
        }
        Some(resized)
    }

    pub(super) fn len(&self) -> usize {
        self.used
    }

    pub(super) fn capacity(&self) -> usize {
        self.places.len()
    }

    /// Appends a move; false if there is no place for it.
    pub(super) fn push(&mut self, queued: &Queued) -> bool {
        if self.used == self.capacity() {
            return false;
        }
        let last = self.wrapped(self.used);
        if let Some(place) = self.places.get_mut(last) {
            *place = Some(*queued);
            self.used += 1;
        }
        true
    }

    pub(super) fn pop(&mut self) -> Option<Queued> {
        let queued = self.places.get_mut(self.first)?.take()?;
        self.first = self.wrapped(1);
        self.used -= 1;
        Some(queued)
    }

    pub(super) fn clear(&mut self) {
        while self.pop().is_some() {}
    }

    fn wrapped(&self, index: usize) -> usize {
        (self.first + index) % self.capacity().max(1)
    }
}
