//! Scans of the PLC programs: each executes its text from the top once, whatever the programs do.

use super::{Controller, Observer, Pace};
use crate::program::State;
use crate::request::Request;
use crate::task::Task;
use crate::watch::Lap;

/// Lines that a PLC program executes in one scan at most (`docs/fidelity.md`, "PLC programs"); a longer text takes several.
pub(super) const LINES_PER_SCAN: u32 = 1000;

impl Controller {
    /// Ticks from one scan to the next.
    pub(super) fn scan_ticks(&self) -> u64 {
        self.machine.clock.tick_at(self.plc_scan).max(1)
    }

    /// Starts the PLC programs that begin with `PBOOT`, and those that were asked for.
    pub(super) fn start_plcs(&mut self, observer: &mut dyn Observer) {
        for number in (0..).take(self.plcs.len()) {
            if self.plcs[usize::from(number)].program.boots || self.first_plcs.contains(&number) {
                self.apply(Request::Run(Task::Plc(number)), observer);
            }
        }
    }

    /// Scans each PLC program that runs.
    pub(super) fn scan(&mut self, observer: &mut dyn Observer) {
        let now = self.machine.clock.ticks();
        for number in (0..).take(self.plcs.len()) {
            let plc = &mut self.plcs[usize::from(number)];
            if !plc.program.is_active() {
                continue;
            }
            let rests = plc.rests(&self.changes).is_some_and(|until| now < until);
            match plc.program.circle(&self.changes) {
                Some(circle) if rests && circle.slices == 1 => plc.program.statements += circle.statements,
                None if rests => {}
                _ => self.scan_one(number, observer),
            }
        }
    }

    fn scan_one(&mut self, number: u8, observer: &mut dyn Observer) {
        let before = self.plcs[usize::from(number)].program.statements;
        let pace = Pace::slice(self.machine.clock.ticks());
        let done = self.execute(Task::Plc(number), LINES_PER_SCAN, pace, observer);
        let program = &mut self.plcs[usize::from(number)].program;
        if program.state == State::Running {
            let statements = program.statements - before;
            let lap = Lap { slices: 1, statements, footprint: done.footprint, whole: done.ended };
            program.watch.observe(&self.changes, lap, &program.frame, &program.locals);
        }
    }
}
