//! Execution of the setup code, statement by statement as at a prompt.

use acrc_syntax::units::Level;
use acrc_vm::{Budget, Code, Frame, Locals, Run, Stop};

use super::{Controller, Observer, Pace};
use crate::command::Context;
use crate::machine::Machine;
use crate::program::{Program, Watch};
use crate::terminal::ChannelId;

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
        let boot = &mut self.boot;
        boot.statement = boot.frame.pc();
        let statement = Immediate {
            code: &boot.code,
            frame: &mut boot.frame,
            release: &mut boot.release,
            watch: &mut boot.watch,
            spare: &mut boot.locals,
            channel: None,
        };
        let run = statement.run(&mut self.machine, &mut self.programs, observer);
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

/// A statement outside of a program, which is executed at the level of [`Machine::level`].
pub(super) struct Immediate<'a> {
    pub(super) code: &'a Code,
    pub(super) frame: &'a mut Frame,
    pub(super) release: &'a mut Option<u64>,
    pub(super) watch: &'a mut Watch,
    /// Variables where no program has any.
    pub(super) spare: &'a mut Locals,
    /// The channel at which it was typed.
    pub(super) channel: Option<ChannelId>,
}

impl Immediate<'_> {
    /// Executes it, with the variables of the program at the level.
    pub(super) fn run(self, machine: &mut Machine, programs: &mut [Program], observer: &mut dyn Observer) -> Run {
        let level = match machine.level {
            Level::Program(number) => Some(number),
            Level::System | Level::Plc(_) => None,
        };
        let locals = match level.and_then(|number| programs.get_mut(usize::from(number)).zip(Some(number))) {
            Some((program, number)) => {
                program.set_space(machine.space(number));
                &mut program.locals
            }
            None => self.spare,
        };
        let pace = Pace::slice(machine.clock.ticks());
        let mut context = Context {
            machine,
            program: level,
            release: self.release,
            watch: self.watch,
            observer,
            pace,
            immediate: true,
            channel: self.channel,
        };
        acrc_vm::run(self.code, self.frame, locals, &mut context, Budget::statements(1))
    }
}
