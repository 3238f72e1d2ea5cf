//! The pieces of a profile: stretches of constant jerk.

/// A stretch of constant jerk, from its start until the next one begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Segment {
    /// Time at which it begins, s. Infinite in a place that is not used.
    pub(crate) start: f64,
    pub(crate) position: f64,
    pub(crate) velocity: f64,
    pub(crate) acceleration: f64,
    pub(crate) jerk: f64,
}

impl Segment {
    const UNUSED: Self = Self { start: f64::INFINITY, position: 0.0, velocity: 0.0, acceleration: 0.0, jerk: 0.0 };

    pub(crate) fn position_after(&self, t: f64) -> f64 {
        self.position + t * (self.velocity + t * (self.acceleration / 2.0 + t * (self.jerk / 6.0)))
    }

    pub(crate) fn velocity_after(&self, t: f64) -> f64 {
        self.velocity + t * (self.acceleration + t * (self.jerk / 2.0))
    }

    pub(crate) fn acceleration_after(&self, t: f64) -> f64 {
        self.acceleration + t * self.jerk
    }
}

/// Two ramps of three stretches each, a constant velocity between them, and one in front that ends an acceleration.
const CAPACITY: usize = 8;

/// The stretches of a profile in order, joined end to end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Segments {
    items: [Segment; CAPACITY],
    used: usize,
    duration: f64,
    position: f64,
}

impl Segments {
    pub(crate) fn new() -> Self {
        Self { items: [Segment::UNUSED; CAPACITY], used: 0, duration: 0.0, position: 0.0 }
    }

    /// Appends a stretch that begins where the one before it ends. One of no duration is left out.
    pub(crate) fn push(&mut self, duration: f64, velocity: f64, acceleration: f64, jerk: f64) {
        if duration == 0.0 {
            return;
        }
        let segment = Segment { start: self.duration, position: self.position, velocity, acceleration, jerk };
        if let Some(place) = self.items.get_mut(self.used) {
            *place = segment;
            self.used += 1;
            self.position = segment.position_after(duration);
            self.duration += duration;
        }
    }

    /// Sum of all durations, s.
    pub(crate) fn duration(&self) -> f64 {
        self.duration
    }

    /// Length of all stretches, u.
    pub(crate) fn length(&self) -> f64 {
        self.position
    }

    /// The stretch that is running at `time`, if there is any.
    pub(crate) fn at(&self, time: f64) -> Option<&Segment> {
        // Unused places begin at infinity, so no count is needed and the loop unrolls.
        self.items.iter().rev().find(|segment| segment.start <= time)
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = &Segment> {
        self.items.iter().take(self.used)
    }
}
