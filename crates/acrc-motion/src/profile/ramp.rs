//! One change of velocity: a straight ramp, or an S-curve when the jerk is limited.

use super::segment::Segments;
use crate::root::sqrt;

/// A change from one velocity to another that begins and ends without acceleration.
///
/// The ramp is symmetric in time, so it covers the mean of both velocities times its duration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ramp {
    /// Velocity at the start, u/s.
    pub(super) from: f64,
    /// Velocity at the end, u/s.
    pub(super) to: f64,
    /// `to - from`, kept apart because the subtraction loses a small change of a large velocity.
    pub(super) change: f64,
    /// Greatest acceleration, u/s²; zero makes the change a step.
    pub(super) limit: f64,
    /// Slope of the acceleration, u/s³; zero makes the ramp straight.
    pub(super) jerk: f64,
}

impl Ramp {
    /// Time the ramp takes, s.
    pub(super) fn duration(&self) -> f64 {
        let change = self.change.abs();
        if change == 0.0 || self.limit == 0.0 {
            0.0
        } else if self.jerk == 0.0 {
            change / self.limit
        } else if self.reaches_limit() {
            change / self.limit + self.limit / self.jerk
        } else {
            2.0 * sqrt(change / self.jerk)
        }
    }

    /// Length of path the ramp takes, u.
    pub(super) fn distance(&self) -> f64 {
        (self.from + self.change / 2.0) * self.duration()
    }

    /// Whether an S-curve has a stretch of constant acceleration.
    fn reaches_limit(&self) -> bool {
        self.change.abs() * self.jerk >= self.limit * self.limit
    }

    /// Appends the ramp's stretches.
    pub(super) fn append_to(&self, segments: &mut Segments) {
        let sign = if self.change < 0.0 { -1.0 } else { 1.0 };
        if self.duration() == 0.0 {
            return;
        }
        if self.jerk == 0.0 {
            segments.push(self.duration(), self.from, sign * self.limit, 0.0);
            return;
        }
        let (bend, straight) = if self.reaches_limit() {
            let bend = self.limit / self.jerk;
            (bend, (self.change.abs() / self.limit - bend).max(0.0))
        } else {
            (sqrt(self.change.abs() / self.jerk), 0.0)
        };
        let jerk = sign * self.jerk;
        let peak = jerk * bend;
        let gained = peak * bend / 2.0;
        segments.push(bend, self.from, 0.0, jerk);
        segments.push(straight, self.from + gained, peak, 0.0);
        segments.push(bend, self.to - gained, peak, -jerk);
    }
}
