//! The moves that wait.

use alloc::boxed::Box;

use super::moves::{Move, MoveSettings, Override};
use super::path::Path;

/// A move that was accepted: its path is laid and its settings are captured.
#[derive(Clone, Copy, Debug)]
pub(super) struct Queued {
    pub(super) path: Path,
    pub(super) settings: MoveSettings,
    pub(super) override_by: Override,
    /// What it waits for before it begins.
    pub(super) gate: Option<u32>,
    /// What may cut it short.
    pub(super) interrupt: Option<u32>,
    /// The angle at its start, degrees.
    pub(super) corner: f64,
    /// How fast it may begin, u/s, by what comes behind.
    pub(super) entry: f64,
    /// How fast it may end, u/s, if not as its settings say.
    pub(super) exit: Option<f64>,
}

impl Queued {
    pub(super) fn new(path: &Path, command: &Move) -> Self {
        let &Move { mut settings, override_by, gate, interrupt, .. } = command;
        if path.is_joined() {
            settings.stop = 0.0;
        }
        Self { path: *path, settings, override_by, gate, interrupt, corner: 0.0, entry: f64::INFINITY, exit: None }
    }
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

    /// The move that is next.
    pub(super) fn first(&self) -> Option<&Queued> {
        self.get(0)
    }

    /// The move that was queued last.
    pub(super) fn last(&self) -> Option<&Queued> {
        self.get(self.used.checked_sub(1)?)
    }

    /// A move that waits, counted from the next.
    pub(super) fn get(&self, index: usize) -> Option<&Queued> {
        if index < self.used { self.places.get(self.wrapped(index))?.as_ref() } else { None }
    }

    /// Sets how fast a move may begin and end.
    pub(super) fn limit(&mut self, index: usize, entry: f64, exit: Option<f64>) {
        let place = self.wrapped(index);
        if let Some(Some(queued)) = self.places.get_mut(place) {
            queued.entry = entry;
            queued.exit = exit;
        }
    }

    /// Takes the gate from the move that is next.
    pub(super) fn open_first(&mut self) {
        if let Some(Some(next)) = self.places.get_mut(self.first) {
            next.gate = None;
        }
    }

    pub(super) fn clear(&mut self) {
        while self.pop().is_some() {}
    }

    fn wrapped(&self, index: usize) -> usize {
        (self.first + index) % self.capacity().max(1)
    }
}
