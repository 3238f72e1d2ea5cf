//! One change of velocity that may begin in the middle of another: with an acceleration to start from.

use crate::profile::segment::{Segment, Segments};
use crate::root::sqrt;

/// Position, velocity and acceleration of one axis at one time; positive and negative.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AxisState {
    /// Position, u.
    pub position: f64,
    /// Velocity, u/s.
    pub velocity: f64,
    /// Acceleration, u/s².
    pub acceleration: f64,
}

impl AxisState {
    /// The velocity it ends up with when the acceleration is let down to zero at once.
    pub(super) fn settled_velocity(&self, jerk: f64) -> f64 {
        if self.acceleration == 0.0 || jerk == 0.0 {
            self.velocity
        } else {
            self.velocity + self.acceleration * self.acceleration.abs() / (2.0 * jerk)
        }
    }
}

/// What shapes a change of velocity.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// Greatest acceleration of a change to a higher speed, u/s²; zero makes it a step.
    pub(super) acceleration: f64,
    /// The same for a change to a lower speed.
    pub(super) deceleration: f64,
    /// Slope of the acceleration, u/s³; zero makes straight ramps.
    pub(super) jerk: f64,
}

/// The shortest change from a state to a velocity, which ends without acceleration: up to three stretches of constant
/// jerk. Everything but the velocities is seen along the change, which is then upwards.
#[derive(Clone, Copy, Debug)]
pub(super) struct Change {
    from: f64,
    to: f64,
    /// The direction of the change: 1 or -1.
    sign: f64,
    /// Acceleration at the start.
    start: f64,
    /// Acceleration in the middle.
    peak: f64,
    /// Jerk of the first stretch.
    slope: f64,
    /// Jerk of the last one, downwards.
    jerk: f64,
    /// Durations of the three stretches.
    times: [f64; 3],
}

impl Change {
    /// The change within the limits. A ramp that is switched off takes no time.
    pub(super) fn new(from: &AxisState, to: f64, limits: &Limits) -> Self {
        let settled = from.settled_velocity(limits.jerk);
        let limit = if to.abs() > settled.abs() { limits.acceleration } else { limits.deceleration };
        let sign = if to < settled { -1.0 } else { 1.0 };
        let start = if limits.jerk == 0.0 { 0.0 } else { sign * from.acceleration };
        let rise = sign * (to - from.velocity);
        let none = Self { from: to, to, sign, start: 0.0, peak: 0.0, slope: 0.0, jerk: 0.0, times: [0.0; 3] };
        if limit == 0.0 || (rise == 0.0 && start == 0.0) {
            return none;
        }
        let from = from.velocity;
        if limits.jerk == 0.0 {
            return Self { from, start: limit, peak: limit, times: [0.0, rise / limit, 0.0], ..none };
        }
        let jerk = limits.jerk;
        let peak = sqrt((start * start / 2.0 + jerk * rise).max(0.0)).min(limit);
        // The acceleration may begin above its limit, when that was lowered meanwhile: then it first goes down.
        let slope = if start > peak { -jerk } else { jerk };
        let (first, last) = ((peak - start) / slope, peak / jerk);
        let rest = rise - first * (start + peak) / 2.0 - peak * last / 2.0;
        let straight = if peak > 0.0 { (rest / peak).max(0.0) } else { 0.0 };
        Self { from, start, peak, slope, jerk, times: [first, straight, last], ..none }
    }

    /// Velocities at the beginnings of the three stretches.
    fn velocities(&self) -> [f64; 3] {
        let [first, _, last] = self.times;
        let gained = first * (self.start + self.peak) / 2.0;
        [self.from, self.from + self.sign * gained, self.to - self.sign * (self.peak * last / 2.0)]
    }

    /// Acceleration and jerk of the three stretches.
    fn bends(&self) -> [(f64, f64); 3] {
        let Self { sign, start, peak, slope, jerk, .. } = *self;
        [(sign * start, sign * slope), (sign * peak, 0.0), (sign * peak, -sign * jerk)]
    }

    /// Way the change takes, u; negative towards smaller positions.
    pub(super) fn distance(&self) -> f64 {
        let stretches = self.times.into_iter().zip(self.velocities()).zip(self.bends());
        stretches
            .map(|((t, velocity), (acceleration, jerk))| t * (velocity + t * (acceleration / 2.0 + t * (jerk / 6.0))))
            .sum()
    }
}

/// Stretches of constant jerk along an axis, beginning at any place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Curve {
    origin: f64,
    segments: Segments,
    end: AxisState,
}

impl Curve {
    /// A curve of no duration.
    pub(super) fn at(state: AxisState) -> Self {
        Self { origin: state.position, segments: Segments::new(), end: state }
    }

    /// Where it ends. The acceleration is zero there once a ramp was appended.
    pub(super) fn end(&self) -> AxisState {
        self.end
    }

    /// Time it takes, s.
    pub(super) fn duration(&self) -> f64 {
        self.segments.duration()
    }

    /// Where the axis is `time` seconds after the start; the end from the duration on.
    pub(super) fn sample(&self, time: f64) -> AxisState {
        match self.segments.at(time) {
            Some(segment) if time < self.duration() => self.placed(segment, time - segment.start),
            _ => self.end,
        }
    }

    fn placed(&self, segment: &Segment, t: f64) -> AxisState {
        AxisState {
            position: self.origin + segment.position_after(t),
            velocity: segment.velocity_after(t),
            acceleration: segment.acceleration_after(t),
        }
    }

    /// Appends the shortest change to `velocity` within the limits. At most two fit.
    pub(super) fn ramp_to(&mut self, velocity: f64, limits: &Limits) {
        let change = Change::new(&self.end, velocity, limits);
        let stretches = change.times.into_iter().zip(change.velocities()).zip(change.bends());
        for ((time, velocity), (acceleration, jerk)) in stretches {
            self.segments.push(time, velocity, acceleration, jerk);
        }
        let position = self.origin + self.segments.length();
        self.end = AxisState { position, velocity, acceleration: 0.0 };
    }
}
