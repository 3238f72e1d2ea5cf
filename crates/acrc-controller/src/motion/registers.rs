//! The position registers of an axis, and the commands that move values between them (guide, "Primary Setpoint", "REN Details", "RES Details", "JOG REN
//! Details", "JOG RES Details").

use acrc_motion::axis::Registers;

use crate::axis::SlaveSlot;
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::mechanics::Mechanism;

/// A command that gives position registers of an axis other values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Preload {
    /// `RES`: everything becomes the position, units.
    All(f64),
    /// `REN`: the setpoints become the actual position.
    Match,
    /// `JOG REN`: the coordinated position becomes this, and the jog offset takes the difference.
    CoordinatedIntoJog(f64),
    /// `JOG RES`: the jog offset becomes this, and the coordinated position takes the difference.
    JogIntoCoordinated(f64),
    /// `CAM RES`: the cam offset becomes this, and the coordinated position takes the difference.
    CamIntoCoordinated(f64),
    /// `BSC RES`: the same for the ballscrew offset.
    BallscrewIntoCoordinated(f64),
    /// `GEAR RES`: the gear offset becomes this, and nothing takes the difference.
    Gear(f64),
    /// `NORM`: the coordinated position is folded into a turn of this length.
    Fold(f64),
    /// Writing P12288: the coordinated position alone.
    Coordinated(f64),
    /// Writing P12297: the jog offset alone.
    Jog(f64),
    /// Writing P12290: the actual position, and the coordinated one with it.
    Actual(f64),
}

impl Machine {
    /// The position registers of an axis, in units.
    pub(crate) fn registers_of(&self, axis: u8) -> Registers {
        let state = &self.axes[usize::from(axis)];
        let profilers = &state.profilers;
        let mut setpoints = Registers {
            coordinated: self.position(axis),
            jog: profilers.jog.offset(),
            gear: profilers.gear.offset() + profilers.hand_wheel.state().position,
            cam: profilers.cam.offset(),
            backlash: state.backlash,
            ballscrew: profilers.ballscrew.offset(),
            actual: 0.0,
        };
        if let Some(lock) = &state.lock {
            // The place to which the axis is led, as its own profilers would have to say it.
            let leader = self.registers_of(lock.leader).primary_setpoint();
            setpoints = lock.gantry.released(leader, &setpoints);
        }
        let actual = self.mechanics.of(axis).and_then(Mechanism::actual).map(|pulses| state.units(pulses));
        Registers { actual: actual.unwrap_or_else(|| setpoints.secondary_setpoint()), ..setpoints }
    }

    /// Gives position registers of an axis other values. Refused while it moves, or waits for a jog velocity.
    pub(crate) fn preload(&mut self, axis: u8, preload: Preload) -> Result<(), ControllerError> {
        // An axis may follow a source while these offsets change.
        let free = matches!(preload, Preload::Gear(_) | Preload::CamIntoCoordinated(_));
        let moves = self.axis_in_motion(axis) || self.axes[usize::from(axis)].profilers.jog.active();
        if self.master_moves(axis) || !free && moves {
            return Err(ControllerError::InMotion);
        }
        let before = self.registers_of(axis);
        let after = match preload {
            Preload::All(position) => before.reset(position),
            Preload::Match => before.match_actual(),
            Preload::CoordinatedIntoJog(position) => before.coordinated_into_jog(position),
            Preload::JogIntoCoordinated(offset) => before.jog_into_coordinated(offset),
            Preload::CamIntoCoordinated(offset) => before.cam_into_coordinated(offset),
            Preload::BallscrewIntoCoordinated(offset) => {
                Registers { coordinated: before.coordinated + (before.ballscrew - offset), ballscrew: offset, ..before }
            }
            Preload::Gear(offset) => before.reset_gear(offset),
            Preload::Fold(length) => before.normalized(length),
            Preload::Coordinated(position) => Registers { coordinated: position, ..before },
            Preload::Jog(offset) => Registers { jog: offset, ..before },
            Preload::Actual(position) => Registers { actual: position, ..before }.match_actual(),
        };
        self.set_registers(axis, &before, &after)
    }

    /// Makes the registers of an axis others.
    pub(crate) fn set_registers(
        &mut self,
        axis: u8,
        before: &Registers,
        after: &Registers,
    ) -> Result<(), ControllerError> {
        let refused = |error: &dyn std::fmt::Display| ControllerError::Move(error.to_string());
        // Where nothing moves but the numbers, what is locked to the axis stays where it is.
        let led = if after.actual == before.actual { Vec::new() } else { self.followers_of(axis) };
        self.set_coordinated(axis, after.coordinated)?;
        if after.actual != before.actual || after.following_error() == 0.0 {
            self.rename_actual(axis, before.actual, after.actual, after.secondary_setpoint());
        }
        let profilers = &mut self.axes[usize::from(axis)].profilers;
        if after.jog != before.jog {
            profilers.jog.preload(after.jog).map_err(|error| refused(&error))?;
        }
        if after.gear != before.gear {
            profilers.hand_wheel.preload(0.0).map_err(|error| refused(&error))?;
            profilers.gear.preload(after.gear).map_err(|error| refused(&error))?;
        }
        if after.cam != before.cam {
            profilers.cam.preload(after.cam).map_err(|error| refused(&error))?;
        }
        if after.ballscrew != before.ballscrew && after.ballscrew != 0.0 {
            profilers.ballscrew.preload(after.ballscrew).map_err(|error| refused(&error))?;
        }
        self.lock_at(axis, after.primary_setpoint());
        for (follower, setpoint) in led {
            self.lock_at(follower, setpoint);
        }
        self.motion.wake();
        Ok(())
    }

    /// Gives the coordinated position of a resting axis another value, in units.
    pub(super) fn set_coordinated(&mut self, axis: u8, units: f64) -> Result<(), ControllerError> {
        if !units.is_finite() {
            return Err(ControllerError::Move(format!(
                "AXIS{axis} cannot be at a position beyond the range of numbers"
            )));
        }
        let state = &mut self.axes[usize::from(axis)];
        match state.slave {
            Some(SlaveSlot { master, slot }) => {
                let profiler = &mut self.masters[usize::from(master)].profiler;
                profiler
                    .set_position(usize::from(slot), units)
                    .map_err(|error| ControllerError::Move(error.to_string()))
            }
            None => {
                state.rest_position = units;
                Ok(())
            }
        }
    }

    /// Changes pulses per unit. The pulses of the registers stay, so the positions in units change.
    pub(crate) fn set_pulses_per_unit(&mut self, axis: u8, ratio: f64) -> Result<(), ControllerError> {
        if ratio <= 0.0 {
            return Err(ControllerError::BadValue { command: "PPU", problem: format!("{ratio} is not above 0") });
        }
        if self.axis_in_motion(axis) || self.axes[usize::from(axis)].profilers.jog.active() {
            return Err(ControllerError::InMotion);
        }
        let factor = self.axes[usize::from(axis)].pulses_per_unit / ratio;
        let before = self.registers_of(axis);
        let after = Registers {
            coordinated: before.coordinated * factor,
            jog: before.jog * factor,
            gear: before.gear * factor,
            cam: before.cam * factor,
            ..before
        };
        let led = self.followers_of(axis);
        self.set_registers(axis, &before, &after)?;
        self.axes[usize::from(axis)].pulses_per_unit = ratio;
        for (follower, setpoint) in led {
            self.lock_at(follower, setpoint);
        }
        self.motion.touch_axis(axis);
        Ok(())
    }
}
