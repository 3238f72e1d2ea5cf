//! Planning: which velocities a profile passes through so that its ramps fit into the length.
//!
//! A profile goes from the start velocity to a peak, with the acceleration or the deceleration ramp, and from the peak
//! to the end velocity with the stop ramp. The peak is the requested velocity when both ramps fit; otherwise it is the
//! velocity between the start and the requested one at which they take exactly the length. With straight ramps that is
//! a formula; S-curves need a bracketed search. The unknown is the change of velocity, not the velocity: a small change
//! of a large velocity would otherwise be lost in rounding.

use super::Profile;
use super::ramp::Ramp;
use super::request::ProfileRequest;
use super::segment::Segments;
use crate::root::sqrt;
use crate::solve::{Point, crossing};

/// Length left over, as a part of the whole, that does not deserve a stretch of its own.
const NEGLIGIBLE: f64 = 1e-13;

/// Plans a request whose values have been checked. The result is not finite if they are too far apart in size.
///
/// With a velocity of zero the profile comes to rest before the end of the path, unless the path is too short for that.
pub(super) fn plan(request: &ProfileRequest) -> Profile {
    plan_after(&Segments::new(), request)
}

/// Plans a request whose start lies behind some stretches, which end with its start velocity and no acceleration.
pub(super) fn plan_after(before: &Segments, request: &ProfileRequest) -> Profile {
    if request.length == 0.0 {
        return Profile {
            segments: *before,
            end_velocity: request.start_velocity,
            length: before.length(),
            end_ramp: before.duration(),
            stands: false,
        };
    }
    let wanted = Shape::at(request, request.velocity, 0.0);
    if wanted.distance() <= request.length {
        return wanted.emit(before, request);
    }
    let earliest_stop = Shape::at(request, request.start_velocity, 0.0);
    if earliest_stop.distance() <= request.length {
        peak_that_fits(request, &wanted).emit(before, request)
    } else {
        too_short(request).emit(before, request)
    }
}

/// The velocity from which a ramp comes down to `velocity` in exactly `length`. Infinite if the ramp is a step.
pub(crate) fn reachable(velocity: f64, length: f64, limit: f64, jerk: f64) -> f64 {
    if limit == 0.0 {
        return f64::INFINITY;
    }
    let gained = 2.0 * limit * length;
    let sum = velocity + sqrt(velocity * velocity + gained);
    let straight = if sum > 0.0 { gained / sum } else { 0.0 };
    if jerk == 0.0 || straight == 0.0 {
        return velocity + straight;
    }
    let excess =
        |drop: f64| Ramp { from: velocity + drop, to: velocity, change: -drop, limit, jerk }.distance() - length;
    let below = Point { x: 0.0, y: -length };
    let above = Point { x: straight, y: excess(straight) };
    // An S-curve takes more way than a straight ramp.
    velocity + if above.y > 0.0 { crossing(below, above, NEGLIGIBLE * length, excess) } else { straight }
}

/// Two ramps with a stretch of constant velocity between them.
struct Shape {
    first: Ramp,
    second: Ramp,
}

impl Shape {
    /// The shape whose peak is `offset` above `anchor`.
    ///
    /// Both changes of velocity are taken from the anchor, so with the start or the final velocity as the anchor a small
    /// offset is that change, to the bit.
    fn at(request: &ProfileRequest, anchor: f64, offset: f64) -> Self {
        let peak = (anchor + offset).max(0.0);
        let change = (anchor - request.start_velocity) + offset;
        let limit = if change < 0.0 { request.deceleration } else { request.acceleration };
        let first = Ramp { from: request.start_velocity, to: peak, change, limit, jerk: request.jerk };
        let drop = (anchor - request.final_velocity) + offset;
        let (to, drop) = if request.stop != 0.0 && drop > 0.0 { (request.final_velocity, drop) } else { (peak, 0.0) };
        let second = Ramp { from: peak, to, change: -drop, limit: request.stop, jerk: request.jerk };
        Self { first, second }
    }

    fn distance(&self) -> f64 {
        self.first.distance() + self.second.distance()
    }

    /// Lays the shape along `length`, filling what the ramps leave with constant velocity.
    fn emit(&self, before: &Segments, request: &ProfileRequest) -> Profile {
        let length = request.length;
        let mut segments = *before;
        self.first.append_to(&mut segments);
        let peak = self.second.from;
        let spare = length - self.distance();
        if peak > 0.0 && spare > NEGLIGIBLE * length {
            segments.push(spare / peak, peak, 0.0, 0.0);
        }
        let end_ramp = segments.duration();
        self.second.append_to(&mut segments);
        let stands = request.velocity == 0.0 && peak == 0.0 && self.distance() < length;
        Profile {
            segments,
            end_velocity: self.second.to,
            length: before.length() + if stands { self.distance() } else { length },
            end_ramp,
            stands,
        }
    }
}

/// The shape that takes exactly the length: `wanted` takes more, and ramping down at once takes less.
fn peak_that_fits(request: &ProfileRequest, wanted: &Shape) -> Shape {
    let &ProfileRequest { length, start_velocity: start, velocity, jerk, .. } = request;
    let excess = |shape: &Shape| shape.distance() - length;
    let anchor = anchor(request);
    let sign = if velocity < start { -1.0 } else { 1.0 };
    let straight = straight_offset(request, anchor);
    if jerk == 0.0 {
        return Shape::at(request, anchor, straight);
    }
    let above = if velocity < start {
        Point { x: start - velocity, y: excess(wanted) }
    } else {
        // An S-curve takes more way than a straight ramp, so it fits at a lower peak than straight ramps do.
        Point { x: straight, y: excess(&Shape::at(request, anchor, straight)) }
    };
    let below = Point { x: 0.0, y: excess(&Shape::at(request, anchor, 0.0)) };
    let x = if above.y > 0.0 {
        let at = |x: f64| excess(&Shape::at(request, anchor, sign * x));
        crossing(below, above, NEGLIGIBLE * length, at)
    } else {
        above.x
    };
    Shape::at(request, anchor, sign * x)
}

/// The velocity that the peak is measured from: the final velocity where the peak is known to lie above it and the start
/// below it, the start velocity otherwise.
fn anchor(request: &ProfileRequest) -> f64 {
    let &ProfileRequest { start_velocity: start, final_velocity: last, .. } = request;
    let between = request.stop != 0.0 && start < last && last < request.velocity;
    if between && Shape::at(request, last, 0.0).distance() < request.length { last } else { start }
}

/// How far above the anchor the peak lies when all ramps are straight.
fn straight_offset(request: &ProfileRequest, anchor: f64) -> f64 {
    let &ProfileRequest { length, start_velocity: start, velocity, final_velocity: last, stop, .. } = request;
    let slows = velocity < start;
    let slope = if slows { -request.deceleration } else { request.acceleration };
    let one_ramp = start * start + 2.0 * slope * length;
    let one_ramp_will_do =
        if slows { one_ramp >= velocity * velocity && one_ramp <= last * last } else { start < last };
    // The difference of the squares of the peak and the anchor. A slope of zero is a step, which takes no length.
    let gained = if anchor > start {
        if slope == 0.0 {
            2.0 * stop * length
        } else {
            stop / (slope + stop) * (2.0 * slope * length - (last - start) * (last + start))
        }
    } else if stop == 0.0 || one_ramp_will_do {
        2.0 * slope * length
    } else if slows && stop <= request.deceleration {
        // Both ramps fit as they are but for rounding: a weaker stop ramp would gain nothing from beginning earlier.
        return velocity - anchor;
    } else {
        let share = if slope == 0.0 { 1.0 } else { slope / (slope + stop) };
        share * (2.0 * stop * length - (start - last) * (start + last))
    };
    let sum = sqrt((anchor * anchor + gained).max(0.0)) + anchor;
    let offset = if sum > 0.0 { gained / sum } else { 0.0 };
    let most = velocity - anchor;
    if slows { offset.clamp(most, 0.0) } else { offset.clamp(0.0, most) }
}

/// The way is too short to come down to the final velocity: braking all the way, and ending faster.
///
/// The stop ramp brakes. Only where the start is faster than the requested velocity and the deceleration ramp is the
/// stronger one, that ramp comes first, down to the requested velocity.
fn too_short(request: &ProfileRequest) -> Shape {
    let &ProfileRequest { length, start_velocity, velocity, deceleration, stop, .. } = request;
    let stronger = deceleration == 0.0 || deceleration > stop;
    if start_velocity <= velocity || !stronger {
        let second = brake(start_velocity, request.final_velocity, length, stop, request.jerk);
        return Shape { first: no_ramp(start_velocity), second };
    }
    let first = Ramp {
        from: start_velocity,
        to: velocity,
        change: velocity - start_velocity,
        limit: deceleration,
        jerk: request.jerk,
    };
    let rest = length - first.distance();
    if rest >= 0.0 {
        let second = brake(velocity, request.final_velocity, rest, stop, request.jerk);
        Shape { first, second }
    } else {
        let second = brake(start_velocity, velocity, length, deceleration, request.jerk);
        Shape { first: no_ramp(start_velocity), second }
    }
}

fn no_ramp(velocity: f64) -> Ramp {
    Ramp { from: velocity, to: velocity, change: 0.0, limit: 0.0, jerk: 0.0 }
}

/// The ramp down from `from` that takes exactly `length`, which is too short to come down to `lowest`.
fn brake(from: f64, lowest: f64, length: f64, limit: f64, jerk: f64) -> Ramp {
    let down_by = |drop: f64| Ramp { from, to: (from - drop).max(0.0), change: -drop, limit, jerk };
    let most = (from - lowest).max(0.0);
    let drop = if jerk == 0.0 {
        let lost = 2.0 * limit * length;
        let sum = from + sqrt((from * from - lost).max(0.0));
        if sum > 0.0 { (lost / sum).min(most) } else { 0.0 }
    } else {
        // The distance first grows with the drop, so the crossing nearest to no drop at all is the only one.
        let below = Point { x: 0.0, y: -length };
        let above = Point { x: most, y: down_by(most).distance() - length };
        crossing(below, above, NEGLIGIBLE * length, |drop| down_by(drop).distance() - length)
    };
    down_by(drop)
}
