//! A tick of the axes.

use acrc_motion::axis::LimitKind;

use super::tables::{Arrays, Points};

use crate::axis::Axis;
use crate::machine::Machine;

impl Axis {
    /// Whether the axis moves by its own profilers, or is about to.
    pub(crate) fn moves(&self) -> bool {
        let jog = &self.profilers.jog;
        let waits_for_velocity = jog.settings().velocity == 0.0 && jog.state().velocity == 0.0;
        jog.active() && !waits_for_velocity || self.profilers.velocity() != 0.0
    }

    /// Whether a profiler of the axis has something to do in each tick.
    pub(super) fn works(&self) -> bool {
        let profilers = &self.profilers;
        self.engages || profilers.active() || profilers.hand_wheel.works() || profilers.ballscrew.is_on()
    }

    /// What its own profilers add to the setpoint, units.
    fn own_offset(&self) -> f64 {
        let profilers = &self.profilers;
        let wheel = profilers.hand_wheel.state().position;
        profilers.jog.offset() + profilers.gear.offset() + profilers.cam.offset() + wheel
    }

    /// Whether limits or compensation have to be looked at while its master moves it.
    pub(super) fn is_guarded(&self) -> bool {
        let settings = self.limits.settings();
        let (hardware, software) = (settings.hardware, settings.software);
        let limited = hardware.positive || hardware.negative || software.positive || software.negative;
        limited || self.profilers.backlash.value != 0.0
    }
}

impl Machine {
    /// Reads the sources of what follows one, before anything moves.
    pub(crate) fn read_sources(&mut self) {
        let gated =
            self.masters.iter().any(|master| master.time.follower.feed.is_gate() && master.profiler.in_motion());
        if self.motion.awake || gated {
            self.read_gates();
        }
        for master in 0..self.masters.len() {
            if self.masters[master].profiler.in_motion() {
                self.read_time(master);
            }
        }
        if !self.motion.awake {
            return;
        }
        for axis in 0..self.model.axes {
            if self.axes[usize::from(axis)].works() {
                let counts = self.read_followers(axis);
                self.axes[usize::from(axis)].counts = counts;
            }
        }
    }

    /// Lets a tick of `dt` seconds pass for the axes, whose masters have advanced. Without time it only looks at what has happened.
    pub(crate) fn advance_axes(&mut self, dt: f64, arrays: &mut dyn Arrays) {
        self.refresh_axes();
        let awake = std::mem::take(&mut self.motion.awake);
        // Axes to be looked at, as bits: few of them in most ticks.
        let mut watched = 0_u32;
        // While all are asleep none works by itself.
        for axis in (0..self.model.axes).filter(|_| awake) {
            if self.axes[usize::from(axis)].works() {
                self.advance_axis(axis, dt, arrays);
            }
            watched |= 1 << axis;
        }
        let mut guarded = self.motion.guarded & !watched;
        while guarded != 0 {
            let axis = guarded.trailing_zeros();
            watched |= u32::from(self.axis_in_motion(axis as u8)) << axis;
            guarded &= guarded - 1;
        }
        self.advance_mechanics(dt);
        while watched != 0 {
            self.watch_axis(watched.trailing_zeros() as u8);
            watched &= watched - 1;
        }
        if awake {
            self.advance_limit_switches(arrays);
        }
        if awake || dt > 0.0 && self.is_sampling_due() {
            self.advance_sampling(arrays);
        }
    }

    fn advance_axis(&mut self, axis: u8, dt: f64, arrays: &dyn Arrays) {
        self.resolve_tables(axis, arrays);
        self.drop_lost_tables(axis, arrays);
        let state = &mut self.axes[usize::from(axis)];
        let before = state.own_offset();
        let cam = Points { arrays, segments: &state.cam_table.segments };
        let ballscrew = Points { arrays, segments: &state.ballscrew_table.segments };
        let counts = std::mem::take(&mut state.counts);
        state.profilers.advance(&counts, dt, &cam, &ballscrew);
        let after = state.own_offset();
        if std::mem::take(&mut state.engages) {
            state.profilers.gear.on();
        }
        let carried = std::mem::take(&mut state.carried);
        let (velocity, acceleration) = self.motion(axis);
        let statistics = &mut self.axes[usize::from(axis)].statistics;
        statistics.record(before, after + carried, velocity, acceleration);
        self.motion.awake |= self.axes[usize::from(axis)].works();
    }

    /// Looks at the limits of an axis, lets its homing go on, and brings its flags in line.
    fn watch_axis(&mut self, axis: u8) {
        let (velocity, _) = self.motion(axis);
        let setpoint = self.registers_of(axis).primary_setpoint();
        let levels = self.switch_levels(axis);
        let state = &mut self.axes[usize::from(axis)];
        state.backlash = state.profilers.backlash.update(setpoint);
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
