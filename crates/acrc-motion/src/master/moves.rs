//! What a master is asked to do: moves, their settings, and why one may be refused.

use core::fmt;

use super::AXES;
use super::curve::{Arc, Curve, Sine, SpaceArc};
use crate::value::{InvalidValue, Quantity, finite, not_negative};

/// Where an axis is to go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// To this position, u.
    Absolute(f64),
    /// This far from the target of the move before, u.
    Relative(f64),
    /// Along a sinusoid.
    Sine(Sine),
}

impl Target {
    /// The position aimed at, u, when the move before ends at `previous`.
    pub(super) fn position_after(self, previous: f64) -> Result<f64, InvalidValue> {
        let end = match self {
            Self::Absolute(position) => position,
            Self::Relative(distance) => previous + distance,
            Self::Sine(sine) => sine.target,
        };
        finite(Quantity::Target, end)
    }
}

/// The values of the velocity profile that are captured when a move is queued.
///
/// All are along the path, finite and not negative; zero switches each of them off. The default is all zeros.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MoveSettings {
    /// Target velocity, u/s (VEL). A move without one stands at its start.
    pub velocity: f64,
    /// Ramp to a higher velocity, u/s² (ACC).
    pub acceleration: f64,
    /// Ramp to a lower velocity between moves, and of holds and stops, u/s² (DEC).
    pub deceleration: f64,
    /// Ramp at the end of the move, u/s² (STP); zero hands the velocity over to the next move.
    pub stop: f64,
    /// Velocity the stop ramp ends with, u/s (FVEL).
    pub final_velocity: f64,
    /// Velocity a move from rest begins with, u/s (IVEL); never above the target velocity.
    pub initial_velocity: f64,
    /// Slope of acceleration, u/s³ (JRK).
    pub jerk: f64,
    /// Time the move is to take, s (TMOV).
    pub time: f64,
}

impl MoveSettings {
    pub(super) fn validate(&self) -> Result<(), InvalidValue> {
        for (quantity, value) in [
            (Quantity::Velocity, self.velocity),
            (Quantity::Acceleration, self.acceleration),
            (Quantity::Deceleration, self.deceleration),
            (Quantity::Stop, self.stop),
            (Quantity::FinalVelocity, self.final_velocity),
            (Quantity::InitialVelocity, self.initial_velocity),
            (Quantity::Jerk, self.jerk),
            (Quantity::Time, self.time),
        ] {
            not_negative(quantity, value)?;
        }
        Ok(())
    }
}

/// Which factor acts on the target velocity of a move.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Override {
    /// The feedrate override (FOV).
    #[default]
    Feedrate,
    /// The rapid feedrate override (ROV), for rapid moves.
    Rapid,
    /// None: the move has the override locked out.
    Locked,
}

/// One coordinated move: all its axes start and finish together.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Move {
    /// The profile of the move.
    pub settings: MoveSettings,
    /// Where each slot goes; `None` stays where it is, unless an arc takes it along.
    pub targets: [Option<Target>; AXES],
    /// Which override acts on it.
    pub override_by: Override,
    /// What the move waits for before it begins (TRG), by a number of the caller's. See [`Master::gate`](super::Master::gate).
    pub gate: Option<u32>,
    /// What may cut the move short (INT, HSINT), by a number of the caller's. See
    /// [`Master::interruptible`](super::Master::interruptible). The next move is accepted when this one has ended.
    pub interrupt: Option<u32>,
    pub(super) curves: [Option<Curve>; CURVES],
    /// Whether there were more curves than places.
    pub(super) crowded: bool,
}

/// As many as can share the axes.
const CURVES: usize = AXES / 2;

impl Move {
    /// A move of no axis yet.
    #[must_use]
    pub fn new(settings: MoveSettings) -> Self {
        Self { settings, ..Self::default() }
    }

    /// The same move with a target for `slot`. There is nothing at a slot of [`AXES`] or above, so it is left out.
    #[must_use]
    pub fn to(mut self, slot: usize, target: Target) -> Self {
        if let Some(place) = self.targets.get_mut(slot) {
            *place = Some(target);
        }
        self
    }

    /// The same move with another override, or none.
    #[must_use]
    pub fn overridden_by(self, override_by: Override) -> Self {
        Self { override_by, ..self }
    }

    /// The same move waiting at a gate.
    #[must_use]
    pub fn gated(self, gate: u32) -> Self {
        Self { gate: Some(gate), ..self }
    }

    /// The same move, which may be cut short.
    #[must_use]
    pub fn interruptible(self, interrupt: u32) -> Self {
        Self { interrupt: Some(interrupt), ..self }
    }

    /// The same move with an arc of two of its axes.
    #[must_use]
    pub fn arc(self, arc: Arc) -> Self {
        self.curve(Curve::Arc(arc))
    }

    /// The same move with an arc of three of its axes.
    #[must_use]
    pub fn space_arc(self, arc: SpaceArc) -> Self {
        self.curve(Curve::SpaceArc(arc))
    }

    fn curve(mut self, curve: Curve) -> Self {
        match self.curves.iter_mut().find(|place| place.is_none()) {
            Some(place) => *place = Some(curve),
            None => self.crowded = true,
        }
        self
    }
}

/// Why a move was not queued. The master is unchanged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PushError {
    /// As many moves are waiting as the queue holds.
    Full,
    /// A stop is under way, which will drop every move.
    Stopping,
    /// The last move may yet be cut short, so that it is not known where the next begins.
    OpenEnd,
    /// A value is not a number, infinite or negative.
    Invalid(InvalidValue),
    /// Only axes of no weight move, and no vector length was set for them.
    NoVectorLength,
    /// A master has [`AXES`] slots, counted from zero.
    NoSuchSlot(usize),
    /// Two parts of the move give the slot a target.
    SlotTwice(usize),
    /// An arc has its start or its end in its centre, or the three points of one in space lie on a line.
    NoRadius,
}

impl From<InvalidValue> for PushError {
    fn from(error: InvalidValue) -> Self {
        Self::Invalid(error)
    }
}

impl fmt::Display for PushError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Full => f.write_str("the move queue is full"),
            Self::Stopping => f.write_str("the master is stopping"),
            Self::OpenEnd => f.write_str("the move before may yet be cut short"),
            Self::Invalid(error) => error.fmt(f),
            Self::NoVectorLength => f.write_str("every axis of the move has weight zero and the vector length is zero"),
            Self::NoSuchSlot(slot) => write!(f, "slot {slot} does not exist: a master has {AXES}"),
            Self::SlotTwice(slot) => write!(f, "slot {slot} has two targets"),
            Self::NoRadius => f.write_str("the points of the arc do not make a circle"),
        }
    }
}

impl core::error::Error for PushError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Invalid(error) => Some(error),
            _ => None,
        }
    }
}

/// Why a setting of a master was refused. The master is unchanged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SettingError {
    /// A master has [`AXES`] slots, counted from zero.
    NoSuchSlot(usize),
    /// A value is not a number, infinite, or negative where that has no meaning.
    Invalid(InvalidValue),
    /// Positions can only be set while no move is running or waiting.
    InMotion,
    /// A scale factor of zero makes every path a point.
    ZeroScale,
    /// A rotation takes two axes, an axis that points along a path a third.
    SameSlot(usize),
    /// A turn of an axis has no length.
    ZeroTurn,
}

impl From<InvalidValue> for SettingError {
    fn from(error: InvalidValue) -> Self {
        Self::Invalid(error)
    }
}

impl fmt::Display for SettingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchSlot(slot) => write!(f, "slot {slot} does not exist: a master has {AXES}"),
            Self::Invalid(error) => error.fmt(f),
            Self::InMotion => f.write_str("the master is in motion"),
            Self::ZeroScale => f.write_str("a scale factor of zero makes every path a point"),
            Self::SameSlot(slot) => write!(f, "slot {slot} is given twice, where different axes are needed"),
            Self::ZeroTurn => f.write_str("a turn of the axis has no length"),
        }
    }
}

impl core::error::Error for SettingError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Invalid(error) => Some(error),
            _ => None,
        }
    }
}
