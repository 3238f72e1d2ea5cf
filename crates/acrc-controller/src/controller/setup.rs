//! Execution of the setup code, statement by statement as at a prompt.

use acrc_syntax::units::Level;
use acrc_vm::{Budget, Stop};

use super::{Controller, Observer, Pace};
use crate::command::Context;

/// Statements of setup code that may be executed in one tick before the run looks at time again.
const SETUP_STATEMENTS_PER_TICK: u32 = 10_000;

impl Controller {
    /// Executes setup code until it waits, ends, or has used its share of this tick.
    pub(super) fn execute_setup(&mut self, observer: &mut dyn Observer) {
        for _ in 0..SETUP_STATEMENTS_PER_TICK {
            if self.boot.done {
                return;
            }
            if !self.execute_setup_statement(observer) {
                return;
            }
        }
    }

    /// One statement of setup code. False when it waits.
    fn execute_setup_statement(&mut self, observer: &mut dyn Observer) -> bool {
        let level = match self.machine.level {
            Level::Program(number) => Some(number),
            Level::System | Level::Plc(_) => None,
        };
        let boot = &mut self.boot;
        let locals = match level {
            Some(number) => {
                let program = &mut self.programs[usize::from(number)];
                program.set_space(self.machine.space(number));
                &mut program.locals
            }
            None => &mut boot.locals,
        };
        let pace = Pace::slice(self.machine.clock.ticks());
        let mut context = Context {
            machine: &mut self.machine,
            program: level,
            release: &mut boot.release,
            watch: &mut boot.watch,
            observer,
            pace,
            immediate: true,
        };
        boot.statement = boot.frame.pc();
        let run = acrc_vm::run(&boot.code, &mut boot.frame, locals, &mut context, Budget::statements(1));
        boot.waiting = run.stop == Stop::Blocked;
        boot.done = run.stop == Stop::Ended;
        if run.statements > 0 || run.stop != Stop::Blocked {
            self.changes += 1;
        }
        boot.waited_at = self.changes;
        if let Stop::Fault(fault) = &run.stop {
            // As at the prompt: the controller says what is wrong and takes the next statement.
            let location = boot.code.location(fault.pc);
            boot.frame.skip_statement(&boot.code);
            let report = self.fault_report(None, location, fault.to_string());
            self.faulted = true;
            observer.fault(&report);
        }
        self.apply_requests(observer);
        !self.boot.waiting
    }
}
