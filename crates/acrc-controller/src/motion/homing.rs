//! Homing by the jog profiler (guide, "Homing").

use acrc_catalog::law;
use acrc_motion::axis::{HomeInputs, HomingOptions, HomingStatus, Side};

use super::Preload;
use crate::axis::Axis;
use crate::error::ControllerError;
use crate::machine::Machine;

impl Axis {
    /// Whether it looks for its home.
    pub(super) fn homes(&self) -> bool {
        self.profilers.homing.status() == HomingStatus::Running
    }
}

impl Machine {
    /// Refuses an axis that may not start to look for home.
    pub(crate) fn may_home(&self, axis: u8) -> Result<(), ControllerError> {
        self.may_move(axis)?;
        if self.axis_in_motion(axis) { Err(ControllerError::InMotion) } else { Ok(()) }
    }

    /// Starts to look for home (`JOG HOME`). Refused for an axis that moves.
    pub(crate) fn home(&mut self, axis: u8, side: Side) -> Result<(), ControllerError> {
        self.refresh_axes();
        self.may_home(axis)?;
        let flag = |law: acrc_catalog::Law| self.flags.get(law.at(u32::from(axis)));
        let options = HomingOptions {
            backup: flag(law::HOME_BACKUP_ENABLE),
            negative_edge: flag(law::HOME_NEGATIVE_EDGE),
            negative_final: flag(law::HOME_NEGATIVE_FINAL),
        };
        let levels = self.switch_levels(axis);
        let setpoint = self.registers_of(axis).primary_setpoint();
        let state = &mut self.axes[usize::from(axis)];
        // What the switches show at this moment, also when nothing has moved yet.
        state.limits.update(levels, setpoint, 0.0, true);
        let inputs = state.limits.homing_inputs();
        let ramp = state.limits.settings().hardware_deceleration;
        let profilers = &mut state.profilers;
        profilers
            .homing
            .start(&mut profilers.jog, side, options, inputs, ramp)
            .map_err(|_| ControllerError::InMotion)?;
        for law in [law::HOME_FOUND, law::HOME_FAILED] {
            self.flags.set_law(law, u32::from(axis), false);
        }
        self.motion.wake();
        self.update_axis_flags(axis);
        Ok(())
    }

    /// The levels at the limit and home inputs of an axis.
    pub(super) fn switch_levels(&self, axis: u8) -> HomeInputs {
        let level = |input: Option<u32>| input.is_some_and(|input| self.flags.get(input));
        let [positive, negative, home] = self.axes[usize::from(axis)].switches;
        HomeInputs { home: level(home), positive_limit: level(positive), negative_limit: level(negative) }
    }

    /// Lets the homing of an axis react to what its switches show.
    pub(super) fn advance_homing(&mut self, axis: u8) {
        let state = &mut self.axes[usize::from(axis)];
        let before = state.profilers.homing.status();
        if before != HomingStatus::Running {
            return;
        }
        let inputs = state.limits.homing_inputs();
        state.profilers.homing.update(&mut state.profilers.jog, inputs);
        self.motion.wake();
        self.report_homing(axis, before);
    }

    /// Sets the flags of a homing that has just ended; found, its place becomes zero.
    pub(super) fn report_homing(&mut self, axis: u8, before: HomingStatus) {
        let status = self.axes[usize::from(axis)].profilers.homing.status();
        if before != HomingStatus::Running || status == before {
            return;
        }
        let found = status == HomingStatus::Found;
        let law = if found { law::HOME_FOUND } else { law::HOME_FAILED };
        self.flags.set_law(law, u32::from(axis), true);
        if found && self.preload(axis, Preload::All(0.0)).is_err() {
            // Its master moves other axes: the coordinated position is theirs, so the jog offset makes up for it.
            let before = self.registers_of(axis);
            let jog = before.jog - before.primary_setpoint();
            let preloaded = self.axes[usize::from(axis)].profilers.jog.preload(jog);
            debug_assert!(preloaded.is_ok(), "homing ends at rest");
            self.rename_actual(axis, before.actual, 0.0, 0.0);
        }
    }
}
