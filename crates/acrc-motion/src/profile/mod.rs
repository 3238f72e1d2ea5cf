//! The motion along one path, in closed form (the guide's "What are Motion Profiles?" and "Velocity Profile Commands").
//!
//! # Promises
//!
//! For every request that is accepted, with `L` its length and `v` the highest velocity it touches, and as far as
//! numbers can tell times apart (a billionth of a profile is far from that limit):
//!
//! - the path ends at exactly `L`, with the end velocity within `1e-9 v` of the one reported, and never lies outside
//!   `0..=L` on the way; the velocity is never negative;
//! - position is continuous to `1e-9 L`, velocity to `1e-9 v` apart from ramps that are switched off, and with a jerk
//!   the acceleration too, to `1e-6` of the ramp's limit;
//! - velocity, acceleration and jerk keep their limits to `1e-9` of each;
//! - a search, where one is needed, places the peak so that the ramps fill the length to `1e-12 L`.
//!
//! Property tests hold the planner to these numbers on random requests.

mod moving;
mod plan;
mod ramp;
mod request;
pub(crate) mod segment;
mod timed;

pub(crate) use moving::Moving;
pub(crate) use plan::reachable;
pub use request::{ProfileError, ProfileRequest};

use segment::Segments;

/// Where a profile is at one time, along its path.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State {
    /// Length covered, u.
    pub position: f64,
    /// Velocity, u/s.
    pub velocity: f64,
    /// Acceleration, u/s²; negative while slowing down.
    pub acceleration: f64,
}

/// A planned motion along one path: a few stretches of constant jerk, sampled at any time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Profile {
    segments: Segments,
    length: f64,
    end_velocity: f64,
    /// Time at which the ramp to the end velocity begins, s.
    end_ramp: f64,
    /// Whether it comes to rest before the end of the path.
    stands: bool,
}

impl Profile {
    /// Plans the shortest profile that keeps every rule of the request.
    ///
    /// - It starts at the start velocity and goes to the velocity with the acceleration ramp, or with the deceleration
    ///   ramp when it starts faster.
    /// - With a stop ramp it comes down to the final velocity exactly at the end of the path. Without one it ends at
    ///   the velocity it has.
    /// - On a path too short for that, the peak is lower (or, when it starts faster, the slow-down ends earlier), so
    ///   that both ramps just fit.
    /// - On a path too short even to come down from the start velocity it brakes with the stop ramp all the way and
    ///   ends faster than asked: see [`Profile::end_velocity`]. (Starting above the velocity with a deceleration ramp
    ///   stronger than the stop ramp, it first brakes down to the velocity with that.)
    ///
    /// ```
    /// use acrc_motion::{Profile, ProfileRequest};
    ///
    /// let profile = Profile::plan(&ProfileRequest {
    ///     length: 5.0,
    ///     velocity: 10.0,
    ///     acceleration: 20.0,
    ///     stop: 20.0,
    ///     ..ProfileRequest::default()
    /// })?;
    /// assert_eq!(profile.duration(), 1.0);
    /// assert_eq!(profile.sample(0.5).velocity, 10.0);
    /// # Ok::<(), acrc_motion::ProfileError>(())
    /// ```
    pub fn plan(request: &ProfileRequest) -> Result<Self, ProfileError> {
        request.validate()?;
        if request.velocity == 0.0 && request.length > 0.0 {
            return Err(ProfileError::ZeroVelocity);
        }
        plan::plan(request).finite()
    }

    /// Plans a stop on the way: from the start velocity to rest with the deceleration ramp.
    ///
    /// The request's velocity is not used. If the path is too short for the stop, the profile ends like any other: with
    /// the stop ramp, at the end of the path, at the final velocity or above. Otherwise [`Profile::length`] is where it
    /// comes to rest.
    pub fn plan_hold(request: &ProfileRequest) -> Result<Self, ProfileError> {
        request.validate()?;
        plan::plan(&ProfileRequest { velocity: 0.0, ..*request }).finite()
    }

    /// Refuses a profile that did not fit into numbers.
    fn finite(self) -> Result<Self, ProfileError> {
        let numbers = [self.duration(), self.end_velocity, self.length];
        if numbers.into_iter().all(f64::is_finite) { Ok(self) } else { Err(ProfileError::OutOfRange) }
    }

    /// A profile of no length and no duration.
    pub(crate) fn at_rest() -> Self {
        Self { segments: Segments::new(), length: 0.0, end_velocity: 0.0, end_ramp: 0.0, stands: true }
    }

    /// Whether it comes to rest before the end of the path.
    pub(crate) fn stands(&self) -> bool {
        self.stands
    }

    /// Time the profile takes, s.
    pub fn duration(&self) -> f64 {
        self.segments.duration()
    }

    /// Length it covers, u.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Velocity at its end, u/s: what a following move begins with.
    pub fn end_velocity(&self) -> f64 {
        self.end_velocity
    }

    /// Time at which the last ramp down begins, s; the duration if there is none.
    pub(crate) fn end_ramp_start(&self) -> f64 {
        self.end_ramp
    }

    /// The state `time` seconds after the start.
    ///
    /// A time before the start counts as the start; at the duration and after, the state is the end: exactly the length,
    /// the end velocity, no acceleration.
    pub fn sample(&self, time: f64) -> State {
        let time = time.max(0.0);
        match self.segments.at(time) {
            Some(segment) if time < self.duration() => {
                let t = time - segment.start;
                State {
                    position: segment.position_after(t).clamp(0.0, self.length),
                    velocity: segment.velocity_after(t).max(0.0),
                    acceleration: segment.acceleration_after(t),
                }
            }
            _ => State { position: self.length, velocity: self.end_velocity, acceleration: 0.0 },
        }
    }

    /// The highest velocity, u/s.
    pub fn peak_velocity(&self) -> f64 {
        // Within a ramp the velocity only rises or only falls, so its ends hold the extremes.
        self.segments.iter().fold(self.end_velocity, |peak, segment| peak.max(segment.velocity))
    }

    /// The greatest acceleration or deceleration, u/s², without a sign.
    pub fn peak_acceleration(&self) -> f64 {
        // An S-curve's greatest acceleration ends its first stretch, which is where another one begins.
        self.segments.iter().fold(0.0, |peak: f64, segment| peak.max(segment.acceleration.abs()))
    }
}
