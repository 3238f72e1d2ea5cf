//! A tick of the axes.

use acrc_motion::axis::{LimitKind, SourceCounts};

use crate::axis::Axis;
use crate::machine::Machine;

impl Axis {
    /// Whether the axis moves by its own profilers, or is about to.
    pub(crate) fn moves(&self) -> bool {
        let jog = &self.profilers.jog;
        let waits_for_velocity = jog.settings().velocity == 0.0 && jog.state().velocity == 0.0;
        jog.active() && !waits_for_velocity || self.profilers.velocity() != 0.0
    }

    /// Whether its limits have to be watched while its master moves it.
    fn is_guarded(&self) -> bool {
        let settings = self.limits.settings();
        let (hardware, software) = (settings.hardware, settings.software);
        hardware.positive || hardware.negative || software.positive || software.negative
    }
}

impl Machine {
    /// Lets a tick of `dt` seconds pass for the axes, whose masters have advanced. Without time it only looks at what has happened.
    pub(crate) fn advance_axes(&mut self, dt: f64) {
        if std::mem::take(&mut self.motion.stale) {
            self.refresh_axes();
        }
        let awake = std::mem::take(&mut self.motion.awake);
        for axis in 0..self.model.axes {
            let state = &self.axes[usize::from(axis)];
            let active = state.profilers.active();
            if active {
                self.advance_axis(axis, dt);
            }
            let state = &self.axes[usize::from(axis)];
            if awake || active || state.is_guarded() && self.axis_in_motion(axis) {
                self.watch_axis(axis);
            }
        }
    }

    fn advance_axis(&mut self, axis: u8, dt: f64) {
        let state = &mut self.axes[usize::from(axis)];
        let before = state.profilers.jog.offset() + state.profilers.gear.offset() + state.profilers.cam.offset();
        let no_points = |_: usize, _: usize| 0.0;
        state.profilers.advance(&SourceCounts::clock(dt), dt, &no_points, &no_points);
        let after = state.profilers.jog.offset() + state.profilers.gear.offset() + state.profilers.cam.offset();
        let (velocity, acceleration) = self.motion(axis);
        let statistics = &mut self.axes[usize::from(axis)].statistics;
        statistics.record(before, after, velocity, acceleration);
        self.motion.awake |= self.axes[usize::from(axis)].profilers.active();
    }

    /// Looks at the limits of an axis, lets its homing go on, and brings its flags in line.
    fn watch_axis(&mut self, axis: u8) {
        let (velocity, _) = self.motion(axis);
        let setpoint = self.registers_of(axis).primary_setpoint();
        let levels = self.switch_levels(axis);
        let state = &mut self.axes[usize::from(axis)];
        let stop = state.limits.update(levels, setpoint, velocity, state.homes());
        self.advance_homing(axis);
        // The flags first: a stop may clear or set some of them.
        self.update_axis_flags(axis);
        match stop.map(|stop| stop.kind) {
            Some(LimitKind::Hardware) => self.kill_motion(axis),
            Some(LimitKind::Software) => self.meet_software_limit(axis),
            None => {}
        }
    }
}
