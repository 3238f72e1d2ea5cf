//! Orders to the jog profiler of an axis (guide, "Jog Profiler").

use acrc_motion::axis::Side;

use super::settings::refused;
use crate::error::ControllerError;
use crate::machine::Machine;

/// What a jog profiler is told.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum JogOrder {
    /// Go to an offset, units (`JOG ABS`).
    To(f64),
    /// Go a distance, units (`JOG INC`).
    By(f64),
    /// Run until told otherwise (`JOG FWD`, `JOG REV`).
    Run(Side),
    /// Ramp down (`JOG OFF`).
    Off,
}

impl Machine {
    /// Gives an order to the jog profiler of an axis. A homing that is under way ends without home.
    pub(crate) fn jog(&mut self, axis: u8, order: JogOrder) -> Result<(), ControllerError> {
        if order != JogOrder::Off {
            self.may_move(axis)?;
        }
        self.refresh_axes();
        let state = &mut self.axes[usize::from(axis)];
        let homed = state.profilers.homing.status();
        state.profilers.homing.abort();
        let jog = &mut state.profilers.jog;
        match order {
            JogOrder::To(target) => jog.to_offset(target).map_err(refused)?,
            JogOrder::By(distance) => jog.by_distance(distance).map_err(refused)?,
            JogOrder::Run(side) => jog.run(side),
            JogOrder::Off => jog.off(),
        }
        let waits = jog.active() && jog.settings().velocity == 0.0 && order != JogOrder::Off;
        if waits {
            self.notes.insert(format!("AXIS{axis} was told to jog while JOG VEL is 0: it waits for a velocity"));
        }
        self.report_homing(axis, homed);
        self.motion.wake();
        self.update_axis_flags(axis);
        Ok(())
    }
}
