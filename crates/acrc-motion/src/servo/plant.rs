//! The machines that a servo loop can drive.
//!
//! # Assumptions
//!
//! - A stepper does every whole step of its setpoint, up to its greatest rate; steps beyond that are lost, as they are for
//!   a motor that stalls.
//! - A drive that is off gives no torque and makes no steps; an ideal axis follows all the same.

use super::motor::Motor;
use crate::value::{InvalidValue, Quantity, not_negative};

/// What a machine is given in one period.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Drive {
    /// Voltage at the drive, V.
    pub volts: f64,
    /// Secondary setpoint, pulses: what a stepper and an ideal axis follow.
    pub setpoint: f64,
    /// The drive is on.
    pub enabled: bool,
}

/// A machine, as far as its feedback shows it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Plant {
    /// The actual position is the setpoint of the period before.
    Ideal {
        /// Actual position, pulses.
        position: f64,
    },
    /// A motor with an encoder.
    Motor(Motor),
    /// A stepper motor.
    Stepper(Stepper),
}

impl Default for Plant {
    fn default() -> Self {
        Self::Ideal { position: 0.0 }
    }
}

impl Plant {
    /// Lets a period of `seconds` pass.
    pub fn advance(&mut self, drive: &Drive, seconds: f64) {
        match self {
            Self::Ideal { position } => *position = drive.setpoint,
            Self::Motor(motor) => motor.advance(drive.enabled.then_some(drive.volts), seconds),
            Self::Stepper(stepper) => stepper.advance(drive.setpoint, drive.enabled, seconds),
        }
    }

    /// Lets a period pass in which something from outside holds the machine.
    pub fn jam(&mut self, drive: &Drive) {
        match self {
            Self::Ideal { .. } => {}
            Self::Motor(motor) => motor.halt(),
            // The steps that it is told are lost.
            Self::Stepper(stepper) => stepper.commanded = whole(drive.setpoint),
        }
    }

    /// Takes a setpoint for the place where the machine is, as REN does: a stepper makes no steps to get there.
    pub fn match_setpoint(&mut self, setpoint: f64) {
        if let Self::Stepper(stepper) = self {
            stepper.commanded = whole(setpoint);
        }
    }

    /// What the feedback device has counted, pulses.
    pub fn counted(&self) -> f64 {
        match self {
            Self::Ideal { position } => *position,
            Self::Motor(motor) => motor.counted(),
            Self::Stepper(stepper) => stepper.position,
        }
    }
}

/// A stepper motor, which is told its steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stepper {
    greatest_rate: f64,
    commanded: f64,
    position: f64,
}

impl Stepper {
    /// A motor at zero that keeps its steps up to a rate, pulses/s; zero is no limit.
    pub fn new(greatest_rate: f64) -> Result<Self, InvalidValue> {
        not_negative(Quantity::StepRate, greatest_rate)?;
        Ok(Self { greatest_rate, commanded: 0.0, position: 0.0 })
    }

    fn advance(&mut self, setpoint: f64, enabled: bool, seconds: f64) {
        let commanded = whole(setpoint);
        let steps = commanded - self.commanded;
        self.commanded = commanded;
        if !enabled {
            return;
        }
        let most = (self.greatest_rate * seconds) as i64 as f64;
        self.position += if self.greatest_rate == 0.0 { steps } else { steps.clamp(-most, most) };
    }
}

/// The whole steps of a setpoint.
fn whole(setpoint: f64) -> f64 {
    (setpoint + if setpoint < 0.0 { -0.5 } else { 0.5 }) as i64 as f64
}
