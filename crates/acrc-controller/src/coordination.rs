//! What decides besides the profilers how the moves of masters go on: gates, interrupts, common starts (`TRG`, `INT`,
//! `HSINT`, `SYNC`).

use acrc_catalog::law;
use acrc_motion::{Master as Profiler, start_together};

use crate::flags::Flags;
use crate::machine::Machine;

/// A state of a flag that a move waits for, or that cuts it short.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Condition {
    pub(crate) flag: u32,
    pub(crate) state: bool,
}

impl Condition {
    /// The number under which the profiler keeps it.
    pub(crate) fn code(self) -> u32 {
        self.flag << 1 | u32::from(self.state)
    }

    fn of(code: u32) -> Self {
        Self { flag: code >> 1, state: code & 1 == 1 }
    }

    fn holds(self, flags: &Flags) -> bool {
        flags.get(self.flag) == self.state
    }
}

/// What becomes of a move when the position of an axis is captured (`HSINT`). All positions are in units.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Redirection {
    pub(crate) axis: u8,
    pub(crate) slot: usize,
    /// What captures.
    pub(crate) mode: u8,
    /// How far behind the captured position the move ends.
    pub(crate) width: f64,
    /// Where a capture counts.
    pub(crate) window: (f64, f64),
    /// What ends the move for good.
    pub(crate) abort: Option<Condition>,
}

impl Machine {
    /// Takes up a move that a master has just been given.
    pub(crate) fn begin_moves(&mut self, index: usize) {
        self.watch_moves(index);
        self.start_groups();
        self.update_master_flags(index);
    }

    /// Looks at the flags that the moves of a master depend on.
    pub(crate) fn watch_moves(&mut self, index: usize) {
        let master = &mut self.masters[index];
        if let Some(gate) = master.profiler.gate()
            && Condition::of(gate).holds(&self.flags)
        {
            master.profiler.open_gate();
        }
        let Some(code) = master.profiler.interruptible() else { return };
        let happened = if self.seeks(index) { self.has_sought(index) } else { Condition::of(code).holds(&self.flags) };
        let master = &mut self.masters[index];
        match master.ahead.redirection {
            Some(redirection) => self.redirect(index, &redirection, happened),
            None if happened => master.profiler.interrupt(),
            None => {}
        }
    }

    /// A move that a capture may redirect.
    fn redirect(&mut self, index: usize, to: &Redirection, captured: bool) {
        let axis = u32::from(to.axis);
        let position = self.axes[usize::from(to.axis)].units(self.registers.number(law::HARDWARE_CAPTURE.at(axis)));
        let profiler = &mut self.masters[index].profiler;
        if to.abort.is_some_and(|abort| abort.holds(&self.flags)) {
            profiler.interrupt();
            self.masters[index].ahead.redirection = None;
            self.flags.set_law(law::HSINT_ABORTED, axis, true);
        } else if captured {
            let (low, high) = to.window;
            if !(low..=high).contains(&position) {
                // Armed again: what was outside of the window is as if it had not been.
                self.arm_capture(to.axis, to.mode, to.axis);
                return;
            }
            if let Err(error) = profiler.redirect(to.slot, position + to.width) {
                self.notes.insert(format!("HSINT of axis {axis}: {error}; the move goes on to its target"));
                return;
            }
            self.masters[index].ahead.redirection = None;
            self.flags.set_law(law::HSINT_REGISTERED, axis, true);
        }
    }

    /// Begins the next moves of masters that wait for each other, where all of them are ready (`SYNC`).
    pub(crate) fn start_groups(&mut self) {
        for first in 0..self.masters.len() {
            let group = self.masters[first].group;
            // Each group once: by its lowest master.
            if group == 0 || group.trailing_zeros() as usize != first {
                continue;
            }
            let is_member = |index: &usize| group >> index & 1 == 1;
            let members = (0..self.masters.len()).filter(is_member);
            if !members.clone().all(|index| self.masters[index].profiler.is_ready()) {
                continue;
            }
            let profilers = self.masters.iter_mut().enumerate().filter(|(index, _)| is_member(index));
            let mut profilers: Vec<&mut Profiler> = profilers.map(|(_, master)| &mut master.profiler).collect();
            start_together(&mut profilers);
            members.for_each(|index| self.update_master_flags(index));
        }
    }
}
