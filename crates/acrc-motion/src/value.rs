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
    /// Factor on the target velocity of rapid moves.
    RapidOverride,
    /// Weight of an axis in the length of the path.
    Weight,
    /// Length of a path all of whose axes weigh nothing, u.
    Vector,
    /// Target of an axis, u.
    Target,
    /// Position of an axis, u.
    Position,
    /// Centre of an arc, of a scaling or of a rotation, u.
    Center,
    /// Point that an arc in space goes through, u.
    Via,
    /// Phase at which a sinusoid begins, degrees.
    Phase,
    /// Change of phase along a sinusoid, degrees.
    Sweep,
    /// Amplitude of a sinusoid, u.
    Amplitude,
    /// Length of a turn of a rotary axis, u.
    RotaryLength,
    /// Factor on programmed paths.
    ScaleFactor,
    /// Angle by which programmed paths are rotated, degrees.
    RotationAngle,
    /// Shift of programmed paths, u.
    PathShift,
    /// Knot of a curve.
    Knot,
    /// Control point of a curve, u.
    ControlPoint,
    /// Weight of a control point of a curve.
    ControlWeight,
    /// Angle of a corner between moves, degrees.
    CornerAngle,
    /// Velocity of the last approach to home, u/s.
    HomeVelocity,
    /// An end of a window.
    Limit,
    /// Units of an axis per count of its source.
    GearRatio,
    /// Factor on the points of a cam.
    CamScale,
    /// A gain of the servo loop.
    Gain,
    /// Frequency of a filter, Hz.
    Frequency,
    /// Lines of an encoder.
    EncoderLines,
    /// Multiplier of an encoder.
    Multiplier,
    /// Inertia of a motor and its load, kg m².
    Inertia,
    /// Friction, N m or N m per rad/s.
    Friction,
    /// Torque, N m or N m/V.
    Torque,
    /// Greatest rate of steps, pulses/s.
    StepRate,
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
            Self::RapidOverride => "rapid feedrate override",
            Self::Weight => "vector weight",
            Self::Vector => "vector length",
            Self::Target => "target",
            Self::Position => "position",
            Self::Center => "centre",
            Self::Via => "point of the arc",
            Self::Phase => "phase",
            Self::Sweep => "sweep",
            Self::Amplitude => "amplitude",
            Self::RotaryLength => "rotary length",
            Self::ScaleFactor => "scale factor",
            Self::RotationAngle => "angle of rotation",
            Self::PathShift => "path shift",
            Self::Knot => "knot",
            Self::ControlPoint => "control point",
            Self::ControlWeight => "weight of a control point",
            Self::CornerAngle => "corner angle",
            Self::HomeVelocity => "final home velocity",
            Self::Limit => "limit",
            Self::GearRatio => "gear ratio",
            Self::CamScale => "cam scale",
            Self::Gain => "gain",
            Self::Frequency => "frequency",
            Self::EncoderLines => "encoder resolution",
            Self::Multiplier => "encoder multiplier",
            Self::Inertia => "inertia",
            Self::Friction => "friction",
            Self::Torque => "torque",
            Self::StepRate => "step rate",
        })
    }
}

/// A number that cannot be what it was given for: not a number, infinite, negative or zero where that has no meaning, or
/// none of those it may be.
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
        if *quantity == Quantity::Multiplier {
            return write!(f, "{quantity} is {value}, but has to be -4, -2, -1, 0, 1, 2 or 4");
        }
        let reason = if value.is_nan() {
            "not a number"
        } else if value.is_infinite() {
            "infinite"
        } else if *value < 0.0 {
            "negative"
        } else {
            "zero"
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
