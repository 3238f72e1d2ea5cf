//! Execution of the setup code, statement by statement as at a prompt.

use acrc_image::UnitName;
use acrc_vm::{Budget, Code, Frame, Locals, Run, Stop};

use super::{Controller, Observer, Pace};
use crate::command::Context;
use crate::footprint::Footprint;
use crate::machine::Machine;
use crate::plc::Plc;
use crate::program::{Alarm, Program};
use crate::task::Task;
use crate::terminal::ChannelId;
use crate::watch::Watch;

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
            alarm: &mut boot.alarm,
            spare: &mut boot.locals,
            channel: None,
        };
        let (run, _) = statement.run(&mut self.machine, &mut self.programs, &mut self.plcs, observer);
        boot.waiting = run.stop == Stop::Blocked;
        boot.done = run.stop == Stop::Ended;
        if run.statements > 0 || run.stop != Stop::Blocked {
            self.changes.everywhere();
        }
        boot.waited_at = self.changes.count();
        if let Stop::Fault(fault) = &run.stop {
            // As at the prompt: the controller says what is wrong and takes the next statement.
            let location = boot.code.location(fault.pc);
            boot.frame.skip_statement(&boot.code);
            let report = self.fault_report(UnitName::Boot, location, fault.to_string());
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
    pub(super) alarm: &'a mut Alarm,
    /// Variables where no program has any.
    pub(super) spare: &'a mut Locals,
    /// The channel at which it was typed.
    pub(super) channel: Option<ChannelId>,
}

impl Immediate<'_> {
    /// Executes it, with the variables of the program at the level. Gives what it has touched, too.
    pub(super) fn run(
        self,
        machine: &mut Machine,
        programs: &mut [Program],
        plcs: &mut [Plc],
        observer: &mut dyn Observer,
    ) -> (Run, Footprint) {
        let task = Task::at(machine.level);
        let program = match task {
            None => None,
            Some(Task::Program(number)) => programs.get_mut(usize::from(number)),
            Some(Task::Plc(number)) => plcs.get_mut(usize::from(number)).map(|plc| &mut plc.program),
        };
        let locals = match program.zip(task) {
            Some((program, task)) => {
                program.set_space(machine.space(task));
                // A program that goes round in a circle does not look whether somebody else writes its variables.
                program.watch = Watch::default();
                &mut program.locals
            }
            None => self.spare,
        };
        let pace = Pace::slice(machine.clock.ticks());
        let mut context = Context {
            machine,
            program: if let Some(Task::Program(number)) = task { Some(number) } else { None },
            ladder: None,
            release: self.release,
            alarm: self.alarm,
            observer,
            pace,
            moves: locals.moves(),
            footprint: Footprint::default(),
            immediate: true,
            channel: self.channel,
        };
        let run = acrc_vm::run(self.code, self.frame, locals, &mut context, Budget::statements(1));
        (run, context.footprint)
    }
}
