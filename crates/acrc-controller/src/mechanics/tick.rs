//! A servo period of the mechanics.

use acrc_catalog::{Law, law};
use acrc_motion::axis::Registers;
use acrc_motion::servo::{Drive, Plant, ServoInputs};
use acrc_vm::Value;

use super::{Mechanism, STANDING};
use crate::machine::Machine;
use crate::registers::map::Form;

/// What the controller gives a mechanism in a tick.
struct Given {
    /// Secondary setpoint, pulses.
    setpoint: f64,
    /// A profiler moves the axis.
    moving: bool,
    enabled: bool,
    /// Length of the tick, s.
    dt: f64,
}

impl Mechanism {
    /// Lets a tick pass in which the last output drives the machine; the loop sees where that has brought it, and makes the next output.
    fn advance(&mut self, given: &Given) {
        let place = self.place;
        let steady = match self.plant {
            Plant::Ideal { .. } => {
                if self.is_led() {
                    self.place = given.setpoint + self.origin + self.missed;
                }
                given.setpoint == self.setpoint
            }
            Plant::Motor(_) | Plant::Stepper(_) => self.drive(given),
        };
        let counts = self.place != place && !self.blind;
        self.quiet = if counts { 0 } else { self.quiet.saturating_add(1) };
        self.setpoint = given.setpoint;
        self.steady = steady && !given.moving;
    }

    /// Drives a motor. Whether neither it nor its loop has changed.
    fn drive(&mut self, given: &Given) -> bool {
        let before = self.plant;
        let volts = self.volts;
        let drive = Drive { volts, setpoint: given.setpoint + self.origin, enabled: given.enabled };
        if self.jammed {
            self.plant.jam(&drive);
        } else {
            self.plant.advance(&drive, given.dt);
        }
        self.count();
        let still = self.setpoint == given.setpoint && self.driven == given.enabled;
        if !std::mem::replace(&mut self.driven, given.enabled) {
            self.forget();
        }
        let mut steady = true;
        self.volts = match self.servo.as_mut().filter(|_| given.enabled) {
            Some(servo) => {
                let actual = self.place - self.missed - self.origin;
                let output = servo.update(&ServoInputs { setpoint: given.setpoint, actual, moving: given.moving });
                steady = servo.is_steady();
                self.dac.terminal(output.volts)
            }
            None => 0.0,
        };
        still && steady && self.plant == before && self.volts == volts
    }

    /// Takes over what the plant shows. An encoder without signals misses it.
    fn count(&mut self) {
        let place = std::mem::replace(&mut self.place, self.plant.counted());
        if self.blind {
            self.missed += self.place - place;
        }
    }
}

impl Machine {
    /// Lets a tick of `dt` seconds pass for the mechanics of the axes. Without time it only looks at what has happened.
    pub(crate) fn advance_mechanics(&mut self, dt: f64) {
        if self.mechanics.is_empty() {
            return;
        }
        let standing = (STANDING / self.clock.period()) as u32;
        (self.mechanics.busy, self.mechanics.moves) = (false, false);
        for axis in 0..self.model.axes {
            if self.mechanics.of(axis).is_none() {
                continue;
            }
            self.advance_mechanism(axis, dt);
            if let Some(mechanism) = self.mechanics.of(axis) {
                let (steady, quiet) = (mechanism.steady, mechanism.quiet);
                self.mechanics.busy |= !steady;
                self.mechanics.moves |= !steady && quiet < standing;
            }
        }
    }

    fn advance_mechanism(&mut self, axis: u8, dt: f64) {
        let moving = self.axis_in_motion(axis);
        let registers = self.registers_of(axis);
        let enabled = self.flag(law::DRIVE_ENABLE, axis);
        let scale = self.axes[usize::from(axis)].pulses_per_unit;
        let Some(mechanism) = self.mechanics.of_mut(axis) else { return };
        let volts = mechanism.volts;
        if dt > 0.0 {
            mechanism.advance(&Given { setpoint: registers.secondary_setpoint() * scale, moving, enabled, dt });
        }
        if volts != mechanism.volts
            && let Some(output) = law::DAC_OUTPUT.get(u32::from(mechanism.dac_number))
        {
            // Within the range of the converter, which fits.
            let _ = self.registers.set(output, Form::Single, &Value::Double(mechanism.volts));
        }
        self.sense(axis);
        self.watch_error(axis, &registers);
    }

    /// Brings the flags of the following error in line, and lets an error in excess do what the axis is set up for.
    fn watch_error(&mut self, axis: u8, setpoints: &Registers) {
        let scale = self.axes[usize::from(axis)].pulses_per_unit;
        let Some(mechanism) = self.mechanics.of_mut(axis) else { return };
        let error = mechanism.actual().map_or(0.0, |actual| setpoints.secondary_setpoint() - actual / scale);
        let now = mechanism.bands.flags(error, mechanism.volts, setpoints.primary_setpoint());
        let before = (mechanism.in_position, mechanism.error_allowed);
        (mechanism.in_position, mechanism.error_allowed) = (now.in_position, now.error_allowed);
        if before.0 != now.in_position {
            self.update_in_position(axis);
        }
        if before.1 != now.error_allowed {
            self.flags.set_law(law::NOT_EXCESS_ERROR, u32::from(axis), now.error_allowed);
        }
        if !now.error_allowed && self.flag(law::EXC_RESPONSE_ENABLE, axis) && self.flag(law::DRIVE_ENABLE, axis) {
            self.flags.set_law(law::EXC_FAULT_LATCHED, u32::from(axis), true);
            self.fail(axis);
        }
    }

    /// State of a flag of an axis.
    pub(super) fn flag(&self, law: Law, axis: u8) -> bool {
        self.flags.get(law.at(u32::from(axis)))
    }
}
