//! The slices of programs (`docs/fidelity.md`, "Programs and time").

use acrc_vm::{Budget, Stop};

use super::ahead::{LINES_PER_SLICE, Pace};
use super::{Controller, Observer};
use crate::command::{Context, deliver};
use crate::footprint::Footprint;
use crate::program::{Mode, Program, State};
use crate::request::Origin;
use crate::scheduler::PROGRAMS;
use crate::task::Task;
use crate::watch::Lap;

/// What some lines of a program came to.
#[derive(Clone, Copy, Debug)]
pub(super) struct Done {
    /// Lines that were begun.
    used: u32,
    pub(super) footprint: Footprint,
    /// Its text is over.
    pub(super) ended: bool,
}

impl Controller {
    /// Which programs take slices.
    pub(super) fn active(&self) -> [bool; PROGRAMS] {
        std::array::from_fn(|number| self.programs.get(number).is_some_and(Program::is_active))
    }

    /// All programs and PLC programs that the model has.
    pub(crate) fn tasks(&self) -> impl Iterator<Item = Task> + use<> {
        let programs = (0..).take(self.programs.len()).map(Task::Program);
        programs.chain((0..).take(self.plcs.len()).map(Task::Plc))
    }

    /// What is in their slots.
    pub(crate) fn texts(&self) -> impl Iterator<Item = &Program> {
        self.programs.iter().chain(self.plcs.iter().map(|plc| &plc.program))
    }

    pub(crate) fn program(&self, task: Task) -> &Program {
        match task {
            Task::Program(number) => &self.programs[usize::from(number)],
            Task::Plc(number) => &self.plcs[usize::from(number)].program,
        }
    }

    pub(crate) fn program_mut(&mut self, task: Task) -> &mut Program {
        match task {
            Task::Program(number) => &mut self.programs[usize::from(number)],
            Task::Plc(number) => &mut self.plcs[usize::from(number)].program,
        }
    }

    /// Gives the next program its slice, and as many of those to come as nobody would notice. `end` is the last tick of the run.
    pub(super) fn slice(&mut self, end: u64, observer: &mut dyn Observer) {
        let active = self.active();
        let Some(number) = self.scheduler.next(&active) else {
            if self.boot.done {
                self.communicate(observer);
            }
            return;
        };
        let program = &mut self.programs[number];
        match program.circle(&self.changes) {
            Some(circle) if circle.slices == 1 => program.statements += circle.statements,
            _ if program.mode == Mode::Step || program.trace => self.line_by_line(number, observer),
            _ => self.lines(number, end, observer),
        }
        if self.programs[number].state != State::Waiting {
            self.scheduler.pass_on(number, active.len());
        }
    }

    /// Executes the lines of a slice, and of those behind it that nobody would notice.
    fn lines(&mut self, number: usize, end: u64, observer: &mut dyn Observer) {
        let mut pace = self.pace(number, end, observer);
        let round = if pace.is_ahead() { self.circling(number) } else { Vec::new() };
        let (first, slices, before) = (pace, u64::from(pace.slices()), self.programs[number].statements);
        let mut lines = pace.budget();
        let (mut footprint, mut whole) = (Footprint::default(), true);
        while lines > 0 {
            let done = self.execute(Task::Program(number as u8), lines, pace, observer);
            footprint.add(done.footprint);
            if self.programs[number].state != State::Running {
                break;
            }
            whole &= done.used == lines;
            // A run that ends early leaves the rest of the slice that it has reached. A statement that had to wait was begun in an earlier slice.
            lines = if done.used == 0 { LINES_PER_SLICE } else { (lines - done.used) % LINES_PER_SLICE };
            pace = Pace::slice(self.machine.clock.ticks());
        }
        self.pass_slices(&round, first);
        let program = &mut self.programs[number];
        if program.state == State::Running {
            let lap = Lap { slices, statements: program.statements - before, footprint, whole };
            program.watch.observe(&self.changes, lap, &program.frame, &program.locals);
        }
    }

    /// The others that go round in circles, with the statements of a round.
    fn circling(&self, number: usize) -> Vec<(Task, u64)> {
        let programs = (0..).zip(&self.programs).filter(|(other, _)| usize::from(*other) != number);
        let programs = programs.map(|(number, program)| (Task::Program(number), program));
        let plcs = self.plcs.iter().map(|plc| (Task::Plc(plc.ladder.number()), &plc.program));
        let circles = programs.chain(plcs).filter_map(|(task, program)| Some((task, program.circle(&self.changes)?)));
        circles.map(|(task, circle)| (task, circle.statements)).collect()
    }

    /// Those that went round in circles had as many slices as the program that ran ahead of its own, and the PLC programs their scans.
    fn pass_slices(&mut self, round: &[(Task, u64)], pace: Pace) {
        let now = self.machine.clock.ticks();
        let slices = pace.passed(now);
        let scans = now / self.scan_ticks() - pace.first() / self.scan_ticks();
        for (task, statements) in round {
            let times = if matches!(task, Task::Plc(_)) { scans } else { slices };
            self.program_mut(*task).statements += times * statements;
        }
    }

    /// Block mode and trace: lines are executed one by one.
    fn line_by_line(&mut self, number: usize, observer: &mut dyn Observer) {
        let lines = if self.programs[number].mode == Mode::Step { 1 } else { LINES_PER_SLICE };
        for _ in 0..lines {
            if !self.one_line(number, observer) {
                return;
            }
        }
    }

    /// Executes a line, or what is left of one that had to wait. False when the program does not run any more, or waits.
    fn one_line(&mut self, number: usize, observer: &mut dyn Observer) -> bool {
        let task = Task::Program(number as u8);
        let pace = Pace::slice(self.machine.clock.ticks());
        let before = self.programs[number].location();
        if self.programs[number].frame.is_blocked() {
            self.execute(task, 0, pace, observer);
            let program = &mut self.programs[number];
            let behind = program.location();
            if program.state != State::Running || behind.line != before.line || behind.statement <= before.statement {
                return program.line_is_over();
            }
        } else if self.programs[number].trace && self.programs[number].state == State::Running {
            let line = self.programs[number].line_number();
            let origin = Origin { level: task.level(), channel: None, immediate: false };
            deliver(&mut self.machine, observer, origin, 0, format!("[{line}]\r\n").as_bytes());
        }
        self.execute(task, 1, pace, observer);
        self.programs[number].line_is_over()
    }

    /// Executes up to so many lines of a program, and then what it asked of the scheduler.
    pub(super) fn execute(&mut self, task: Task, lines: u32, pace: Pace, observer: &mut dyn Observer) -> Done {
        let (program, ladder) = match task {
            Task::Program(number) => (&mut self.programs[usize::from(number)], None),
            Task::Plc(number) => {
                let plc = &mut self.plcs[usize::from(number)];
                (&mut plc.program, Some(&mut plc.ladder))
            }
        };
        let nothing = Done { used: lines, footprint: Footprint::default(), ended: true };
        let Some(code) = &program.code else { return nothing };
        let mut context = Context {
            machine: &mut self.machine,
            program: if let Task::Program(number) = task { Some(number) } else { None },
            ladder,
            release: &mut program.release,
            alarm: &mut program.alarm,
            observer,
            pace,
            moves: program.locals.moves(),
            footprint: Footprint::default(),
            immediate: false,
            channel: None,
        };
        let run = acrc_vm::run(code, &mut program.frame, &mut program.locals, &mut context, Budget::lines(lines));
        context.pace.reach(run.used);
        context.catch_up();
        let mut footprint = context.footprint;
        program.statements += u64::from(run.statements);
        let ended = run.stop == Stop::Ended;
        if let Some(ladder) = context.ladder {
            footprint.changed |= ladder.take_changed();
            if ended {
                // The next scan begins at the top.
                ladder.begin_scan();
                program.frame.reset();
            }
        }
        program.awaits = self.machine.streams.awaited.filter(|_| run.stop == Stop::Blocked);
        program.state = state_behind(&run.stop, task);
        let fault = if let Stop::Fault(fault) = run.stop { Some((code.location(fault.pc), fault)) } else { None };
        self.conclude(task, footprint);
        if let Some((location, fault)) = fault {
            let mut report = self.fault_report(task.unit(), location, fault.to_string());
            self.faulted = true;
            self.machine.fail_transformations(task);
            self.alarms.program_fault(task);
            report.heard = self.tell_fault(task, location, &report.message);
            observer.fault(&report);
        }
        self.apply_requests(observer);
        Done { used: run.used, footprint, ended }
    }

    /// Tells those who wait what some lines have changed.
    fn conclude(&mut self, task: Task, footprint: Footprint) {
        let over = !self.program(task).state.is_active();
        // A program that only finds again that it has to wait, or only computes, has changed nothing for others.
        if over {
            self.changes.everywhere();
            self.update_program_flags();
        } else if footprint.changed {
            self.changes.at(footprint.writes);
        }
        let count = self.changes.count();
        let program = self.program_mut(task);
        (program.waited_at, program.waits_for) = (count, footprint.reads);
    }
}

/// Where a program is in its life when its run has stopped. A PLC program begins its next scan instead of ending.
fn state_behind(stop: &Stop, task: Task) -> State {
    match (stop, task) {
        (Stop::Budget, _) | (Stop::Ended, Task::Plc(_)) => State::Running,
        (Stop::Blocked, _) => State::Waiting,
        (Stop::Ended, Task::Program(_)) => State::Ended,
        (Stop::Fault(_), _) => State::Fault,
    }
}
