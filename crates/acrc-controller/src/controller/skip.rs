//! Time in which nothing happens passes at once.

use super::ahead::LINES_PER_SLICE;
use super::scan::LINES_PER_SCAN;
use super::{Controller, Observer, Pace};
use crate::program::State;
use crate::task::Task;
use crate::terminal::Demand;

/// Quiet ticks that are shown to an observer before the run looks whether it is to end.
const WATCHED_TICKS: u64 = 10_000;

impl Controller {
    /// The tick before which nothing happens unless somebody types or changes something, for a driver that has better to do than
    /// to let idle time pass. `None` when the next tick may change something, `u64::MAX` when nothing is to come.
    pub fn rests_until(&self) -> Option<u64> {
        if self.powered { self.quiet_until(u64::MAX) } else { None }
    }

    /// The tick before which nothing can change: no motion, and every program waits for a time or for something that does not happen, or goes round in
    /// a circle.
    pub(super) fn quiet_until(&self, end: u64) -> Option<u64> {
        let boot_waits = self.boot.done
            || self.boot.waiting && (self.boot.release.is_some() || self.boot.waited_at == self.changes.count());
        let mut active = self.programs.iter().filter(|program| program.is_active());
        let quiet = boot_waits
            && !self.machine.is_busy()
            && active.all(|program| program.waits(&self.changes).is_some() || program.circle(&self.changes).is_some());
        let typed = match self.channel_demand() {
            Demand::Now if self.boot.done => return None,
            Demand::At(tick) => Some(tick),
            Demand::Now | Demand::Nothing => None,
        };
        if !quiet {
            return None;
        }
        let active = || self.programs.iter().filter(|program| program.is_active());
        let releases = active().filter_map(|program| program.release).chain(self.boot.release);
        let alarms = active().flat_map(|program| program.alarm.ticks()).chain(self.boot.alarm.ticks());
        let scan = self.scan_ticks();
        let next_scan = (self.machine.clock.ticks() / scan + 1) * scan;
        let plcs = self.plcs.iter().filter(|plc| plc.program.is_active());
        let scans = plcs.map(|plc| plc.rests(&self.changes).unwrap_or(next_scan));
        let expected = releases.chain(alarms).chain(scans).chain(typed).chain(self.machine.next_event_tick());
        expected.chain([end]).min()
    }

    /// Lets time pass up to a tick before which nothing happens. The slices and scans on the way are given out, and change nothing.
    pub(super) fn skip_to(&mut self, tick: u64, observer: &mut dyn Observer) {
        let now = self.machine.clock.ticks();
        let watched = observer.watches_every_tick();
        let tick = if watched { tick.min(now + WATCHED_TICKS) } else { tick };
        if tick <= now {
            return;
        }
        let slice = self.machine.clock.slice_ticks();
        let waiting: Vec<bool> = self.programs.iter().map(|program| program.state == State::Waiting).collect();
        let given = self.scheduler.skip(tick / slice - now / slice, &self.active(), &waiting);
        for (number, slices) in (0..).zip(given) {
            self.go_round(Task::Program(number), slices, LINES_PER_SLICE, observer);
        }
        let scans = tick / self.scan_ticks() - now / self.scan_ticks();
        for number in (0..).take(self.plcs.len()) {
            self.go_round(Task::Plc(number), scans, LINES_PER_SCAN, observer);
        }
        if !watched {
            self.machine.skip(tick - now);
            return;
        }
        for _ in now..tick {
            self.machine.skip(1);
            observer.tick(&self.view());
        }
    }

    /// Gives a program that goes round in a circle so many slices at once. Only what lies behind the last full round is executed.
    fn go_round(&mut self, task: Task, slices: u64, lines: u32, observer: &mut dyn Observer) {
        let program = self.program(task);
        let Some(circle) = program.circle(&self.changes) else { return };
        self.program_mut(task).statements += slices / circle.slices * circle.statements;
        for _ in 0..slices % circle.slices {
            let pace = Pace::slice(self.machine.clock.ticks());
            self.execute(task, lines, pace, observer);
        }
    }
}
