//! What a master is asked to do: moves, their settings, and why one may be refused.

use core::fmt;

use super::AXES;
use crate::value::{InvalidValue, Quantity, finite, not_negative};

/// Where an axis is to go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// To this position, u.
    Absolute(f64),
    /// This far from the target of the move before, u.
    Relative(f64),
}

impl Target {
    /// The position aimed at, u, when the move before ends at `previous`.
    pub(super) fn position_after(self, previous: f64) -> Result<f64, InvalidValue> {
        let end = match self {
            Self::Absolute(position) => position,
            Self::Relative(distance) => previous + distance,
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

/// One coordinated move: all its axes start and finish together.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Move {
    /// The profile of the move.
    pub settings: MoveSettings,
    /// Where each slot goes; `None` stays where it is.
    pub targets: [Option<Target>; AXES],
}

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
}

/// Why a move was not queued. The master is unchanged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PushError {
    /// As many moves are waiting as the queue holds.
    Full,
    /// A stop is under way, which will drop every move.
    Stopping,
    /// A value is not a number, infinite or negative.
    Invalid(InvalidValue),
    /// Only axes of no weight move, and no vector length was set for them.
    NoVectorLength,
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
            Self::Invalid(error) => error.fmt(f),
            Self::NoVectorLength => f.write_str("every axis of the move has weight zero and the vector length is zero"),
        }
    }
}

impl core::error::Error for PushError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Invalid(error) => Some(error),
            Self::Full | Self::Stopping | Self::NoVectorLength => None,
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
        }
    }
}

impl core::error::Error for SettingError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Invalid(error) => Some(error),
            Self::NoSuchSlot(_) | Self::InMotion => None,
        }
    }
}
