//! What a jog is made with.

use core::fmt;

use crate::axis::Window;
use crate::value::{InvalidValue, Quantity, not_negative};

/// The values of an axis' jog profile. They act at once, also on a jog that is running.
///
/// All are finite and not negative; zero switches a ramp off. The default is all zeros, with which nothing moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct JogSettings {
    /// Velocity, u/s (JOG VEL).
    pub velocity: f64,
    /// Ramp to a higher speed, u/s² (JOG ACC).
    pub acceleration: f64,
    /// Ramp to a lower speed, u/s² (JOG DEC).
    pub deceleration: f64,
    /// Slope of the acceleration, u/s³ (JOG JRK).
    pub jerk: f64,
    /// Velocity of the last approach to home, u/s (JOG HOMVF).
    pub home_velocity: f64,
    /// Jog offsets at which a jog ends, u (JLM). Both zero: none.
    pub limits: Window,
}

impl JogSettings {
    pub(super) fn validate(&self) -> Result<(), InvalidValue> {
        for (quantity, value) in [
            (Quantity::Velocity, self.velocity),
            (Quantity::Acceleration, self.acceleration),
            (Quantity::Deceleration, self.deceleration),
            (Quantity::Jerk, self.jerk),
            (Quantity::HomeVelocity, self.home_velocity),
        ] {
            not_negative(quantity, value)?;
        }
        self.limits.validate()
    }
}

/// Why a jog was not accepted. Nothing has changed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum JogError {
    /// A value is not a number, infinite, or negative where that has no meaning.
    Invalid(InvalidValue),
    /// The axis is jogging, and this is possible at rest only.
    InMotion,
}

impl From<InvalidValue> for JogError {
    fn from(error: InvalidValue) -> Self {
        Self::Invalid(error)
    }
}

impl fmt::Display for JogError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Invalid(error) => error.fmt(f),
            Self::InMotion => f.write_str("the axis is jogging"),
        }
    }
}

impl core::error::Error for JogError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Invalid(error) => Some(error),
            Self::InMotion => None,
        }
    }
}
