//! Programs that go round in a circle: `WHILE (BIT10=0) : WEND`.
//!
//! A program whose lines changed nothing and read nothing that changes by itself, and that came back to a state that it
//! was in before, does the same again until somebody changes something. Then its slices need not be executed: what
//! they would have done is known. States are compared at the ends of slices, with a snapshot that is renewed after
//! twice as many slices each time, so that a circle of any length is found (Brent's method).

use acrc_vm::{Frame, Locals, Snapshot};

use crate::footprint::{Changes, Footprint, Places};

/// Slices that a lone program executes between two looks. The later counts are multiples of many small numbers, so that
/// most circles end where somebody looks.
const STRIDES: [u64; 8] = [1, 1, 2, 12, 60, 840, 5040, 55_440];

/// What some slices of a program were.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lap {
    pub(crate) slices: u64,
    pub(crate) statements: u64,
    pub(crate) footprint: Footprint,
    /// All lines of all slices were executed.
    pub(crate) whole: bool,
}

/// Slices after which a program is back where it was.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Circle {
    pub(crate) slices: u64,
    pub(crate) statements: u64,
    /// What it depends on.
    pub(crate) reads: Places,
}

/// Watches a program for circles.
#[derive(Debug, Default)]
pub(crate) struct Watch {
    snapshot: Option<Snapshot>,
    /// What was done since the snapshot was taken.
    since: Circle,
    /// Slices since the snapshot after which it is renewed.
    renew: u64,
    circle: Option<Circle>,
    /// The count of changes when the snapshot was taken.
    changes: u64,
    stride: usize,
}

impl Watch {
    /// The circle that the program goes round in, as long as nothing has changed since.
    pub(crate) fn circle(&self, changes: &Changes) -> Option<Circle> {
        self.circle.filter(|circle| !changes.any_since(circle.reads, self.changes))
    }

    /// Slices that may be executed before the next look.
    pub(crate) fn stride(&self) -> u64 {
        STRIDES[self.stride]
    }

    /// Takes note of what the program has just done.
    pub(crate) fn observe(&mut self, changes: &Changes, lap: Lap, frame: &Frame, locals: &Locals) {
        let own = lap.footprint.changed || lap.footprint.timed || !lap.whole;
        let mut reads = lap.footprint.reads;
        reads |= self.since.reads;
        if own || changes.any_since(reads, self.changes) {
            // After a change by somebody else the program may soon wait for the next one.
            self.stride = if own { self.next_stride() } else { 0 };
            *self = Self { changes: changes.count(), stride: self.stride, ..Self::default() };
            return;
        }
        self.stride = self.next_stride();
        if self.circle.is_some() {
            return;
        }
        self.since.slices += lap.slices;
        self.since.statements += lap.statements;
        self.since.reads = reads;
        match &self.snapshot {
            Some(snapshot) if snapshot.matches(frame, locals) => self.circle = Some(self.since),
            Some(_) if self.since.slices < self.renew => {}
            _ => {
                self.snapshot = Snapshot::take(frame, locals);
                self.changes = changes.count();
                self.renew = 2 * self.since.slices.max(self.renew);
                self.since = Circle::default();
            }
        }
    }

    fn next_stride(&self) -> usize {
        (self.stride + 1).min(STRIDES.len() - 1)
    }
}
