//! Kill All Motion Request and Kill All Moves as they spread over axes and masters (guide, "Kill All Motion Request vs. Kill All Moves").

use acrc_catalog::{Law, law, message};
use acrc_motion::axis::{Groups, KillFlags, NumberSet, Refusal, members};

use crate::axis::SlaveSlot;
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::orders::Order;

impl Machine {
    /// Carries out what the kill flags ask for since they were last looked at. To be called when one of them was set or cleared.
    pub(crate) fn update_kills(&mut self) {
        let groups = self.groups();
        let mut flags = self.kill_flags();
        let before = flags;
        let mut protocol = std::mem::take(&mut self.motion.kills);
        let actions = protocol.update(&mut flags, &groups, |master| {
            self.masters.get(master).is_some_and(|master| master.profiler.in_motion())
        });
        self.motion.kills = protocol;
        self.write_kill_flags(before, flags);
        for (axes, software) in [(actions.stop_axes, false), (actions.soft_stop_axes, true)] {
            for axis in members(axes) {
                self.stop_axis(axis, software);
                self.disable_killed(axis as u8, software);
            }
        }
        for master in members(actions.kill_masters) {
            self.order(master, Order::Kill);
        }
    }

    /// Switches the drive of a killed axis off, where it is set up for that.
    fn disable_killed(&mut self, axis: u8, software: bool) {
        let set = |law: Law| self.flags.get(law.at(u32::from(axis)));
        if !software && set(law::DISABLE_DRIVE_ON_KILL) && set(law::DRIVE_ENABLE) {
            self.set_drive(axis, false);
        }
    }

    /// Sets the Kill All Motion Request of an axis, with all that follows.
    pub(crate) fn kill_motion(&mut self, axis: u8) {
        self.flags.set_law(law::KILL_ALL_MOTION_REQUEST, u32::from(axis), true);
        self.update_kills();
    }

    /// Axis and master stop after a software limit.
    pub(super) fn meet_software_limit(&mut self, axis: u8) {
        let groups = self.groups();
        let mut flags = self.kill_flags();
        let before = flags;
        self.motion.kills.software_limit(&mut flags, &groups, usize::from(axis));
        self.write_kill_flags(before, flags);
        self.update_kills();
    }

    /// Refuses an axis that may not start to move by its own profilers.
    pub(crate) fn may_move(&self, axis: u8) -> Result<(), ControllerError> {
        self.refusal(axis).map_or(Ok(()), |_| Err(ControllerError::Said(message::SLAVE_KILLED)))
    }

    /// Why an axis may not start to move by its own profilers.
    fn refusal(&self, axis: u8) -> Option<Refusal> {
        self.kill_flags().refusal(&self.groups(), usize::from(axis), false)
    }

    /// Stops an axis with the ramp of its limits; its jog profiler takes over the velocity of them all.
    fn stop_axis(&mut self, index: usize, software: bool) {
        let coordinated = self.axes.get(index).map_or(0.0, |_| self.coordinated_motion(index as u8).0);
        let Some(axis) = self.axes.get_mut(index) else { return };
        let settings = axis.limits.settings();
        let ramp = if software { settings.software_deceleration } else { settings.hardware_deceleration };
        if coordinated == 0.0 && !axis.profilers.active() && axis.profilers.velocity() == 0.0 {
            axis.profilers.hand_wheel.halt();
            axis.profilers.ballscrew.halt();
            axis.engages = false;
            return;
        }
        let homed = axis.profilers.homing.status();
        axis.engages = false;
        // Velocity and ramp are finite and not negative: the profilers have checked them.
        let stopped = axis.profilers.stop(coordinated, ramp);
        debug_assert!(stopped.is_ok(), "{stopped:?}");
        self.report_homing(index as u8, homed);
        self.update_axis_flags(index as u8);
        self.motion.wake();
    }

    fn groups(&self) -> Groups {
        let mut groups = Groups::default();
        for (master_of, axis) in groups.master_of.iter_mut().zip(&self.axes) {
            *master_of = axis.slave.map(|SlaveSlot { master, .. }| master);
        }
        groups
    }

    fn kill_flags(&self) -> KillFlags {
        let set = |law: Law, count: usize| -> NumberSet {
            let numbers = 0..count.min(NumberSet::BITS as usize);
            numbers.filter(|number| self.flags.get(law.at(*number as u32))).fold(0, |set, number| set | 1 << number)
        };
        KillFlags {
            requests: set(law::KILL_ALL_MOTION_REQUEST, self.axes.len()),
            moves: set(law::KILL_ALL_MOVES, self.masters.len()),
            // Masters ramp down by themselves (`Order::Stop`).
            stops: 0,
        }
    }

    fn write_kill_flags(&mut self, before: KillFlags, after: KillFlags) {
        for (law, before, after) in [
            (law::KILL_ALL_MOTION_REQUEST, before.requests, after.requests),
            (law::KILL_ALL_MOVES, before.moves, after.moves),
        ] {
            for number in members(before ^ after) {
                self.flags.set(law.at(number as u32), after >> number & 1 == 1);
            }
        }
    }
}
