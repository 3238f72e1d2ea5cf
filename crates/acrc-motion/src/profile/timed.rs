//! Timed moves: lowering a profile until it takes a given time (the guide's TMOV).

use super::{Profile, ProfileError, ProfileRequest};
use crate::solve::{Point, crossing};
use crate::value::{Quantity, not_negative};

/// How often the velocity is halved in search of one that is slow enough.
const MAX_HALVINGS: u32 = 64;

/// Agreement of the time with the one asked for, as a part of it.
const SLACK: f64 = 1e-13;

impl ProfileRequest {
    /// Lowers the values so that the profile takes `seconds`. They never rise, so a time that is too short leaves
    /// the request as it is; so does a time of zero.
    ///
    /// From rest every value the profile uses is lowered, which stretches it in time and keeps its shape: velocities by
    /// the factor `k`, accelerations by `k²`, the jerk by `k³`. A moving start cannot be stretched, so there only the
    /// velocity is lowered and the ramps stay. If it cannot slow down enough for the time asked for, it goes at the
    /// mean velocity of the move and is early. (An S-curve from a moving start, on a path hardly long enough to stop,
    /// can pass over some times altogether; it then takes the next longer time it can.)
    pub fn lowered_to(&self, seconds: f64) -> Result<Self, ProfileError> {
        not_negative(Quantity::Time, seconds)?;
        let shortest = Profile::plan(self)?.duration();
        if seconds <= shortest || self.length == 0.0 {
            return Ok(*self);
        }
        if self.start_velocity == 0.0 && shortest > 0.0 {
            return Ok(self.stretched(shortest / seconds));
        }
        Ok(Self { velocity: self.velocity_for(seconds, shortest)?, ..*self })
    }

    /// The same profile, slower by `factor` (below one) throughout.
    fn stretched(&self, factor: f64) -> Self {
        let square = factor * factor;
        Self {
            velocity: self.velocity * factor,
            acceleration: self.acceleration * square,
            stop: self.stop * square,
            final_velocity: self.final_velocity * factor,
            jerk: self.jerk * (square * factor),
            ..*self
        }
    }

    /// The velocity at which the profile takes `seconds`, more than the `shortest` time it can take.
    fn velocity_for(&self, seconds: f64, shortest: f64) -> Result<f64, ProfileError> {
        // How early the profile is at a velocity; below zero it is late.
        let early = |velocity: f64| {
            let duration = Profile::plan(&Self { velocity, ..*self }).map(|p| p.duration());
            duration.map(|duration| seconds - duration)
        };
        let mut above = Point { x: self.velocity, y: seconds - shortest };
        for _ in 0..MAX_HALVINGS {
            let x = above.x / 2.0;
            let below = Point { x, y: early(x)? };
            if below.y <= 0.0 {
                // A velocity inside the bracket plans whenever both of its ends do.
                let at = |x| early(x).unwrap_or(f64::NEG_INFINITY);
                return Ok(crossing(below, above, SLACK * seconds, at));
            }
            above = below;
        }
        Ok(self.velocity.min(self.length / seconds))
    }
}

impl Profile {
    /// Plans a profile that takes `seconds`, lowered as [`ProfileRequest::lowered_to`] says, or the shortest one within
    /// the request if that takes longer.
    ///
    /// ```
    /// use acrc_motion::{Profile, ProfileRequest};
    ///
    /// let request = ProfileRequest { length: 5.0, velocity: 10.0, acceleration: 20.0, stop: 20.0, ..Default::default() };
    /// assert_eq!(Profile::plan_timed(&request, 2.0)?.duration(), 2.0);
    /// assert_eq!(Profile::plan_timed(&request, 0.1)?.duration(), 1.0); // as fast as the limits let it
    /// # Ok::<(), acrc_motion::ProfileError>(())
    /// ```
    pub fn plan_timed(request: &ProfileRequest, seconds: f64) -> Result<Self, ProfileError> {
        Self::plan(&request.lowered_to(seconds)?)
    }
}
