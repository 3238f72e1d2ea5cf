//! Planning from the midst of an S-curve, where the start has an acceleration already.
//!
//! Where the motion goes on as it is under way, up to a velocity or down to one, the start lies within the first ramp
//! of a profile that began a little earlier: that profile is planned, and entered where it is. Otherwise the
//! acceleration ends first, and a profile is planned behind that.

use super::segment::Segments;
use super::{Profile, ProfileError, ProfileRequest, plan};
use crate::solve::{Point, crossing};

/// Agreement of the state in which an earlier profile is entered, as a part of each value.
const SAME: f64 = 1e-9;

/// Part of the length that may be missed.
const SLACK: f64 = 1e-13;

/// A profile that is entered on its way.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moving {
    pub(crate) profile: Profile,
    /// Time of the profile that has passed, s.
    pub(crate) elapsed: f64,
    /// Length of it that is covered, u.
    pub(crate) covered: f64,
}

impl Moving {
    /// Plans a request that starts with an acceleration, u/s², negative while slowing down. With a velocity of zero
    /// it comes to rest on the way, as [`Profile::plan_hold`] does.
    ///
    /// An acceleration that the jerk cannot end before the velocity is below zero is not one that this jerk has led to:
    /// it ends at once. So does every acceleration of straight ramps.
    pub(crate) fn plan(request: &ProfileRequest, acceleration: f64) -> Result<Self, ProfileError> {
        let drop = if acceleration < 0.0 { acceleration / request.jerk * acceleration / 2.0 } else { 0.0 };
        let ends_below_zero = drop > request.start_velocity * (1.0 + SAME);
        if acceleration == 0.0 || request.jerk == 0.0 || ends_below_zero {
            return planned(request).map(Self::from);
        }
        if let Some(earlier) = Self::earlier(request, acceleration) {
            return Ok(earlier);
        }
        eased(request, acceleration).finite().map(Self::from)
    }

    /// A profile that would have begun without acceleration and is now in the first bend of its first ramp.
    fn earlier(request: &ProfileRequest, acceleration: f64) -> Option<Self> {
        let elapsed = acceleration.abs() / request.jerk;
        let start_velocity = request.start_velocity - acceleration * elapsed / 2.0;
        if start_velocity < 0.0 {
            return None;
        }
        let covered = elapsed * (start_velocity + elapsed * acceleration / 6.0);
        let profile = planned(&ProfileRequest { start_velocity, length: request.length + covered, ..*request }).ok()?;
        let state = profile.sample(elapsed);
        let same = (state.acceleration - acceleration).abs() <= SAME * acceleration.abs()
            && (state.velocity - request.start_velocity).abs() <= SAME * request.start_velocity;
        same.then_some(Self { profile, elapsed, covered })
    }
}

/// A profile that is entered at its start.
impl From<Profile> for Moving {
    fn from(profile: Profile) -> Self {
        Self { profile, elapsed: 0.0, covered: 0.0 }
    }
}

fn planned(request: &ProfileRequest) -> Result<Profile, ProfileError> {
    if request.velocity == 0.0 { Profile::plan_hold(request) } else { Profile::plan(request) }
}

/// A profile that first brings its acceleration to an end.
fn eased(request: &ProfileRequest, acceleration: f64) -> Profile {
    let &ProfileRequest { length, start_velocity, jerk, .. } = request;
    let slope = if acceleration > 0.0 { -jerk } else { jerk };
    let velocity = |t: f64| start_velocity + t * (acceleration + t * slope / 2.0);
    let distance = |t: f64| t * (start_velocity + t * (acceleration / 2.0 + t * (slope / 6.0)));
    let ease = acceleration.abs() / jerk;
    let mut segments = Segments::new();
    if distance(ease) < length {
        segments.push(ease, start_velocity, acceleration, slope);
        let rest =
            ProfileRequest { length: length - distance(ease), start_velocity: velocity(ease).max(0.0), ..*request };
        return plan::plan_after(&segments, &rest);
    }
    // The path ends before that. Its velocity does not fall below zero, so the distance grows with time.
    let below = Point { x: 0.0, y: -length };
    let above = Point { x: ease, y: distance(ease) - length };
    let time = if above.y > 0.0 { crossing(below, above, SLACK * length, |t| distance(t) - length) } else { ease };
    segments.push(time, start_velocity, acceleration, slope);
    let end_velocity = velocity(time).max(0.0);
    Profile { end_ramp: segments.duration(), segments, length, end_velocity, stands: false }
}
