//! Checks of incoming numbers, apart from the computation that uses them.

use core::fmt;

/// What a refused number was meant to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Quantity {
    /// Length of a path, u.
    Length,
    /// Velocity at the start of a profile, u/s.
    StartVelocity,
    /// Target velocity, u/s.
    Velocity,
    /// Ramp to a higher velocity, u/s².
    Acceleration,
    /// Ramp to a lower velocity between moves, u/s².
    Deceleration,
    /// Ramp at the end of a move, u/s².
    Stop,
    /// Velocity at the end of a move, u/s.
    FinalVelocity,
    /// Velocity at which a move begins, u/s.
    InitialVelocity,
    /// Slope of acceleration, u/s³.
    Jerk,
    /// Time a move is to take, s.
    Time,
    /// Factor on the target velocity.
    FeedrateOverride,
    /// Weight of an axis in the length of the path.
    Weight,
    /// Length of a path all of whose axes weigh nothing, u.
    Vector,
    /// Target of an axis, u.
    Target,
    /// Position of an axis, u.
    Position,
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Length => "path length",
            Self::StartVelocity => "start velocity",
            Self::Velocity => "velocity",
            Self::Acceleration => "acceleration ramp",
            Self::Deceleration => "deceleration ramp",
            Self::Stop => "stop ramp",
            Self::FinalVelocity => "final velocity",
            Self::InitialVelocity => "initial velocity",
            Self::Jerk => "jerk",
            Self::Time => "move time",
            Self::FeedrateOverride => "feedrate override",
            Self::Weight => "vector weight",
            Self::Vector => "vector length",
            Self::Target => "target",
            Self::Position => "position",
        })
    }
}

/// A number that cannot be what it was given for: not a number, infinite, or negative where that has no meaning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InvalidValue {
    /// What the number was meant to be.
    pub quantity: Quantity,
    /// The number itself.
    pub value: f64,
}

impl fmt::Display for InvalidValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { quantity, value } = self;
        let reason = if value.is_nan() {
            "not a number"
        } else if value.is_infinite() {
            "infinite"
        } else {
            "negative"
        };
        write!(f, "{quantity} is {reason} ({value})")
    }
}

impl core::error::Error for InvalidValue {}

/// Accepts any finite number.
pub(crate) fn finite(quantity: Quantity, value: f64) -> Result<f64, InvalidValue> {
    if value.is_finite() { Ok(value) } else { Err(InvalidValue { quantity, value }) }
}

/// Accepts any finite number that is not below zero.
pub(crate) fn not_negative(quantity: Quantity, value: f64) -> Result<f64, InvalidValue> {
    if value < 0.0 { Err(InvalidValue { quantity, value }) } else { finite(quantity, value) }
}
