//! What a master is told beside its moves: feedhold, cycle start, halt, Stop All Moves, Kill All Moves (guide, "Kill All Moves" and
//! "Starting, Pausing, and Halting Programs").

use acrc_catalog::law;

use crate::machine::Machine;

/// An order to a master.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Order {
    /// Brake with `DEC` and wait.
    Feedhold,
    /// Go on after a feedhold.
    CycleStart,
    /// Brake with `DEC` and drop every move.
    Halt,
    /// The same, then set Kill All Moves.
    Stop,
    /// Drop every move without a ramp and refuse others until the flag is cleared.
    Kill,
}

impl Machine {
    /// Carries out an order. A master that does not exist is left alone.
    pub(crate) fn order(&mut self, index: usize, order: Order) {
        let Some(master) = self.masters.get_mut(index) else { return };
        if !matches!(order, Order::Feedhold | Order::CycleStart) {
            master.forget();
        }
        match order {
            Order::Feedhold => master.profiler.feedhold(),
            Order::CycleStart => master.profiler.cycle_start(),
            Order::Halt => self.brake(index),
            Order::Stop => {
                self.flags.set(law::STOP_ALL_MOVES.at(index as u32), true);
                self.brake(index);
            }
            Order::Kill => {
                master.profiler.kill();
                self.flags.set(law::KILL_ALL_MOVES.at(index as u32), true);
                self.flags.set(law::STOP_ALL_MOVES.at(index as u32), false);
            }
        }
        self.update_master_flags(index);
    }

    /// Ramps down and drops every move; at rest there is nothing to ramp, only a hold to release.
    fn brake(&mut self, index: usize) {
        let profiler = &mut self.masters[index].profiler;
        if profiler.in_motion() {
            profiler.stop();
        } else {
            profiler.kill();
            self.stopped(index);
        }
    }

    /// A master has come to rest after [`Order::Halt`] or [`Order::Stop`]: Stop All Moves ends by setting Kill All Moves.
    pub(crate) fn stopped(&mut self, index: usize) {
        let stop_all = law::STOP_ALL_MOVES.at(index as u32);
        if self.flags.get(stop_all) {
            self.flags.set(stop_all, false);
            self.flags.set(law::KILL_ALL_MOVES.at(index as u32), true);
        }
    }
}
