//! What a profile is asked to do, and why it may be refused.

use core::fmt;

use crate::value::{InvalidValue, Quantity, not_negative};

/// One motion along a path.
///
/// All values are along the path and must be finite and not negative. `ProfileRequest::default()` is all zeros, which
/// switches every ramp off.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ProfileRequest {
    /// Length of the path, u.
    pub length: f64,
    /// Velocity at the start of the path, u/s: handed over by the move before, or the initial velocity.
    pub start_velocity: f64,
    /// Velocity to reach, u/s: the target velocity times the feedrate override.
    pub velocity: f64,
    /// Ramp from a lower to a higher velocity, u/s²; zero is a step.
    pub acceleration: f64,
    /// Ramp down to `velocity` when the start is faster, u/s²; zero is a step.
    pub deceleration: f64,
    /// Ramp at the end of the path, u/s²; zero is no ramp: the path ends at the velocity it has.
    pub stop: f64,
    /// Velocity the stop ramp ends with, u/s. It only slows down: a slower move keeps its velocity.
    pub final_velocity: f64,
    /// Slope of acceleration of every ramp, u/s³; zero makes straight ramps.
    pub jerk: f64,
}

impl ProfileRequest {
    /// Checks every value.
    pub(super) fn validate(&self) -> Result<(), InvalidValue> {
        for (quantity, value) in [
            (Quantity::Length, self.length),
            (Quantity::StartVelocity, self.start_velocity),
            (Quantity::Velocity, self.velocity),
            (Quantity::Acceleration, self.acceleration),
            (Quantity::Deceleration, self.deceleration),
            (Quantity::Stop, self.stop),
            (Quantity::FinalVelocity, self.final_velocity),
            (Quantity::Jerk, self.jerk),
        ] {
            not_negative(quantity, value)?;
        }
        Ok(())
    }
}

/// Why no profile can be planned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ProfileError {
    /// A value is not a number, infinite or negative.
    Invalid(InvalidValue),
    /// The path has a length but the velocity is zero, so it would never end.
    ZeroVelocity,
    /// The values are so far apart in size that the profile does not fit into numbers.
    OutOfRange,
}

impl From<InvalidValue> for ProfileError {
    fn from(error: InvalidValue) -> Self {
        Self::Invalid(error)
    }
}

impl fmt::Display for ProfileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Invalid(error) => error.fmt(f),
            Self::ZeroVelocity => f.write_str("velocity is zero, so the path would never end"),
            Self::OutOfRange => f.write_str("the values are too far apart in size to plan with"),
        }
    }
}

impl core::error::Error for ProfileError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Invalid(error) => Some(error),
            Self::ZeroVelocity | Self::OutOfRange => None,
        }
    }
}
