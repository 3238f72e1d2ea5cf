//! The way of an axis from the state it is in to a velocity or to rest at a target.

use super::ramp::{AxisState, Change, Curve, Limits};
use crate::profile::{Profile, ProfileRequest};
use crate::solve::{Point, crossing};

/// Two distances count as equal when they differ by less than this part of the longer one: the way to the target and
/// the way a stop takes, while that stop is what the axis is doing already.
const SAME: f64 = 1e-9;

/// Part of the way by which a stop may miss the target where the velocity to stop from was searched for.
const FOUND: f64 = 1e-13;

/// A planned motion, sampled at any time since it was planned: a curve, and then a profile to the target, or on with the
/// velocity the curve ended with.
#[derive(Clone, Copy, Debug)]
pub(super) struct Track {
    curve: Curve,
    /// From the end of the curve to the target; of no length without a target.
    profile: Profile,
    /// Direction of the profile.
    sign: f64,
    target: Option<f64>,
    /// Time at which the curve begins to bring the axis to rest, s; infinite if it does not.
    brakes: f64,
}

impl Track {
    /// Rest at a position.
    pub(super) fn resting(position: f64) -> Self {
        let curve = Curve::at(AxisState { position, ..AxisState::default() });
        Self::of_curve(&curve, None, f64::INFINITY)
    }

    fn of_curve(curve: &Curve, target: Option<f64>, brakes: f64) -> Self {
        Self { curve: *curve, profile: Profile::at_rest(), sign: 1.0, target, brakes }
    }

    /// Changes to a velocity and keeps it. If that is in the other direction, the axis first comes to rest.
    pub(super) fn to_velocity(from: AxisState, velocity: f64, limits: &Limits) -> Self {
        let mut curve = Curve::at(from);
        if from.velocity * velocity < 0.0 {
            curve.ramp_to(0.0, limits);
        }
        curve.ramp_to(velocity, limits);
        Self::of_curve(&curve, None, if velocity == 0.0 { 0.0 } else { f64::INFINITY })
    }

    /// Goes to a target and comes to rest there, no faster than `velocity`.
    ///
    /// If the axis cannot stop before the target, it stops behind it and comes back. `None` if it would never get there.
    pub(super) fn to_position(from: AxisState, target: f64, velocity: f64, limits: &Limits) -> Option<Self> {
        let mut stop = Curve::at(from);
        stop.ramp_to(0.0, limits);
        let heading = [from.velocity, from.acceleration, target - from.position].into_iter().find(|d| *d != 0.0);
        let sign = if heading.unwrap_or(0.0) < 0.0 { -1.0 } else { 1.0 };
        let way = sign * (target - from.position);
        let braking = sign * (stop.end().position - from.position);
        let from_rest = from.velocity == 0.0 && (from.acceleration == 0.0 || limits.jerk == 0.0);
        if !from_rest && (way - braking).abs() <= SAME * way.abs().max(braking.abs()) {
            return Some(Self::of_curve(&stop, Some(target), 0.0));
        }
        if way < braking {
            return Self::onward(&stop, target, velocity, limits, 0.0);
        }
        let curved = limits.jerk > 0.0 && from.acceleration != 0.0;
        if !curved {
            return Self::onward(&Curve::at(from), target, velocity, limits, f64::INFINITY);
        }
        Self::through_peak(from, sign, target, velocity, limits)
    }

    /// To a target ahead of where a stop would end, from the middle of a curved ramp.
    ///
    /// `sign` is the direction. If the velocity cannot be reached, the axis changes to the one from which a stop ends at
    /// the target.
    fn through_peak(from: AxisState, sign: f64, target: f64, velocity: f64, limits: &Limits) -> Option<Self> {
        let way = sign * (target - from.position);
        let at = |peak: f64| {
            let mut curve = Curve::at(from);
            curve.ramp_to(sign * peak, limits);
            curve
        };
        let stopped = |peak: f64| {
            let mut curve = at(peak);
            curve.ramp_to(0.0, limits);
            curve
        };
        // What a stop from a peak takes more than the way, without laying it.
        let excess = |peak: f64| {
            let top = AxisState { velocity: sign * peak, ..AxisState::default() };
            let distance =
                Change::new(&from, top.velocity, limits).distance() + Change::new(&top, 0.0, limits).distance();
            sign * distance - way
        };
        let above = Point { x: velocity, y: excess(velocity) };
        if above.y < -SAME * way {
            return Self::onward(&at(velocity), target, velocity, limits, f64::INFINITY);
        }
        let peak = if above.y <= SAME * way {
            velocity
        } else {
            // A velocity below the one the ramp settles at takes a ramp of its own, and may take more way than it saves.
            let settled = (sign * from.settled_velocity(limits.jerk)).clamp(0.0, velocity);
            let below = [settled, 0.0].map(|x| Point { x, y: excess(x) }).into_iter().find(|point| point.y <= 0.0);
            below.map_or(0.0, |below| crossing(below, above, FOUND * way, excess))
        };
        let curve = stopped(peak);
        if sign * (target - curve.end().position) > SAME * way {
            // Nothing faster fits: on from rest.
            return Self::onward(&curve, target, velocity, limits, at(peak).duration());
        }
        Some(Self::of_curve(&curve, Some(target), at(peak).duration()))
    }

    /// From the end of a curve, which is without acceleration or may be taken so, to the target ahead of it.
    fn onward(curve: &Curve, target: f64, velocity: f64, limits: &Limits, brakes: f64) -> Option<Self> {
        let from = curve.end();
        let distance = target - from.position;
        let profile = Profile::plan(&ProfileRequest {
            length: distance.abs(),
            start_velocity: from.velocity.abs(),
            velocity,
            acceleration: limits.acceleration,
            deceleration: limits.deceleration,
            stop: limits.deceleration,
            final_velocity: 0.0,
            jerk: limits.jerk,
        })
        .ok()?;
        let sign = if distance < 0.0 { -1.0 } else { 1.0 };
        Some(Self { curve: *curve, profile, sign, target: Some(target), brakes })
    }

    /// The state `time` seconds after the start.
    pub(super) fn sample(&self, time: f64) -> AxisState {
        let later = time - self.curve.duration();
        if later < 0.0 {
            return self.curve.sample(time);
        }
        let end = self.curve.end();
        match self.target {
            None => AxisState { position: end.position + end.velocity * later, ..end },
            Some(target) if later >= self.profile.duration() => AxisState { position: target, ..AxisState::default() },
            Some(_) => {
                let state = self.profile.sample(later);
                AxisState {
                    position: end.position + self.sign * state.position,
                    velocity: self.sign * state.velocity,
                    acceleration: self.sign * state.acceleration,
                }
            }
        }
    }

    /// When, in seconds since the start, and where the axis comes to rest; `None` if it does not.
    pub(super) fn rest(&self) -> Option<(f64, f64)> {
        let end = self.curve.end();
        match self.target {
            Some(target) => Some((self.curve.duration() + self.profile.duration(), target)),
            None if end.velocity == 0.0 => Some((self.curve.duration(), end.position)),
            None => None,
        }
    }

    /// Whether all of it fits into numbers.
    pub(super) fn is_finite(&self) -> bool {
        let end = self.curve.end();
        [self.curve.duration(), end.position, end.velocity].into_iter().all(f64::is_finite)
    }

    /// Whether it ends at a target.
    pub(super) fn arrives(&self) -> bool {
        self.target.is_some()
    }

    /// Whether the ramp to rest has begun at `time`.
    pub(super) fn stopping(&self, time: f64) -> bool {
        let later = time - self.curve.duration();
        if later < 0.0 || self.target.is_none() { time >= self.brakes } else { later >= self.profile.end_ramp_start() }
    }
}
