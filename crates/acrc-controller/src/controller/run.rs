//! A run: setup code, then ticks and slices until it is over.

use acrc_vm::{Budget, Stop};

use super::ahead::{LINES_PER_SLICE, Pace};
use super::{Controller, Observer, View};
use crate::command::Context;
use crate::program::{Program, State};
use crate::request::Request;
use crate::terminal::Demand;

/// Quiet ticks that are shown to an observer before the run looks whether it is to end.
const WATCHED_TICKS: u64 = 10_000;

/// Why a run is over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stopped {
    /// Every program has ended and nothing moves.
    Ended,
    /// The time given was reached.
    Until,
    /// The observer asked for it.
    Interrupted,
}

impl Controller {
    /// Boots, starts the given programs and runs until everything has ended, `until` seconds are over, or the observer ends the run.
    pub fn run(&mut self, start: &[u8], until: f64, observer: &mut dyn Observer) -> Stopped {
        self.start_after_setup(start);
        self.powered = true;
        self.report_events(observer);
        loop {
            self.prepare_tick(observer);
            // `PERIOD` in the setup code changes how many ticks a time takes.
            let end = self.machine.clock.tick_at(until);
            self.execute_tick(end, observer);
            if self.is_idle() {
                self.machine.settle();
                return Stopped::Ended;
            }
            if self.machine.clock.ticks() >= end {
                return Stopped::Until;
            }
            if observer.interrupted() {
                return Stopped::Interrupted;
            }
            self.advance(end, observer);
        }
    }

    /// Says which programs are started when the setup code is done: at power-up those that begin with `PBOOT`
    /// ([`Controller::boot_programs`]).
    pub fn start_after_setup(&mut self, programs: &[u8]) {
        self.to_start = programs.to_vec();
    }

    /// Lets time pass up to a tick, for a driver that delivers what is typed in between. Unlike [`Controller::run`] it does not end when
    /// nothing runs and nothing moves: an idle controller passes the time, which costs nothing.
    pub fn run_until(&mut self, tick: u64, observer: &mut dyn Observer) {
        if !self.powered {
            self.powered = true;
            self.report_events(observer);
            self.prepare_tick(observer);
            self.execute_tick(tick, observer);
        }
        while self.machine.clock.ticks() < tick && !observer.interrupted() {
            self.advance(tick, observer);
            self.prepare_tick(observer);
            self.execute_tick(tick, observer);
        }
    }

    /// Lets a number of ticks pass.
    pub fn step(&mut self, ticks: u64, observer: &mut dyn Observer) {
        self.run_until(self.machine.clock.ticks() + ticks, observer);
    }

    /// Setup code, and the programs that are started behind it.
    fn prepare_tick(&mut self, observer: &mut dyn Observer) {
        self.execute_setup(observer);
        if self.boot.done {
            for program in std::mem::take(&mut self.to_start) {
                self.apply(Request::Run(program), observer);
            }
        }
    }

    /// What happens at the present tick besides motion: a slice. `end` is the last tick of the run.
    fn execute_tick(&mut self, end: u64, observer: &mut dyn Observer) {
        if self.machine.clock.ticks().is_multiple_of(self.machine.clock.slice_ticks()) {
            self.slice(end, observer);
        }
        observer.tick(&self.view());
    }

    /// Whether nothing goes on: setup code is done, no program runs, nothing moves, and every channel has been answered.
    pub fn is_idle(&self) -> bool {
        self.is_over() && self.channel_demand() == Demand::Nothing
    }

    /// Nothing runs and nothing moves.
    fn is_over(&self) -> bool {
        self.boot.done && !self.machine.in_motion() && !self.programs.iter().any(|program| program.state.is_active())
    }

    /// One tick, or as many as pass before anything can happen.
    fn advance(&mut self, end: u64, observer: &mut dyn Observer) {
        if let Some(tick) = self.quiet_until(end) {
            self.skip_to(tick - 1, observer);
        }
        let moving = self.machine.in_motion();
        self.machine.tick();
        if self.report_events(observer) || moving {
            self.changes += 1;
        }
    }

    /// Lets time pass up to a tick before which nothing happens. The slices on the way are given out, and nobody uses them.
    fn skip_to(&mut self, tick: u64, observer: &mut dyn Observer) {
        let now = self.machine.clock.ticks();
        let watched = observer.watches_every_tick();
        let tick = if watched { tick.min(now + WATCHED_TICKS) } else { tick };
        if tick <= now {
            return;
        }
        let slice = self.machine.clock.slice_ticks();
        let running = self.running();
        self.scheduler.skip(tick / slice - now / slice, &running);
        if !watched {
            self.machine.skip(tick - now);
            return;
        }
        for _ in now..tick {
            self.machine.skip(1);
            observer.tick(&View { machine: &self.machine });
        }
    }

    /// Tells the observer of the events that the machine has taken in. True when there were any.
    fn report_events(&mut self, observer: &mut dyn Observer) -> bool {
        let applied = self.machine.applied_events();
        let new = applied > self.reported_events;
        let first = std::mem::replace(&mut self.reported_events, applied);
        for event in &self.machine.world().events()[first..applied] {
            observer.event(self.machine.clock.seconds(), event, &View { machine: &self.machine });
        }
        self.type_events(first..applied);
        new
    }

    /// The tick before which nothing can change: no motion, and every program waits for a time or for something that does not happen.
    fn quiet_until(&self, end: u64) -> Option<u64> {
        let boot_waits =
            self.boot.done || self.boot.waiting && (self.boot.release.is_some() || self.boot.waited_at == self.changes);
        let quiet = |program: &Program| !program.state.is_active() || program.waits(self.changes);
        let typed = match self.channel_demand() {
            Demand::Now if self.boot.done => return None,
            Demand::At(tick) => Some(tick),
            Demand::Now | Demand::Nothing => None,
        };
        if self.machine.in_motion() || !boot_waits || !self.programs.iter().all(quiet) {
            return None;
        }
        let active = || self.programs.iter().filter(|program| program.state.is_active());
        let releases = active().filter_map(|program| program.release).chain(self.boot.release);
        let watches = active().flat_map(|program| program.watch.ticks()).chain(self.boot.watch.ticks());
        releases.chain(watches).chain(typed).chain(self.machine.next_event_tick()).chain([end]).min()
    }

    fn running(&self) -> Vec<bool> {
        self.programs.iter().map(|program| program.state.is_active()).collect()
    }

    /// Gives the next program its slice, and as many of those to come as nobody would notice. `end` is the last tick of the run.
    fn slice(&mut self, end: u64, observer: &mut dyn Observer) {
        let running = self.running();
        let Some(number) = self.scheduler.next(&running) else {
            if self.boot.done {
                self.communicate(observer);
            }
            return;
        };
        let mut pace = self.pace(number, end, observer);
        let mut lines = pace.budget();
        while lines > 0 {
            let used = self.execute_lines(number, lines, pace, observer);
            if self.programs[number].state != State::Running {
                break;
            }
            // A run that ends early leaves the rest of the slice that it has reached. A statement that had to wait was begun in an earlier slice.
            lines = if used == 0 { LINES_PER_SLICE } else { (lines - used) % LINES_PER_SLICE };
            pace = Pace::slice(self.machine.clock.ticks());
        }
        if self.programs[number].state != State::Waiting {
            self.scheduler.pass_on(number, running.len());
        }
    }

    /// Executes up to so many lines of a program, and then what it asked of the scheduler. Gives the number of lines that were begun.
    fn execute_lines(&mut self, number: usize, lines: u32, pace: Pace, observer: &mut dyn Observer) -> u32 {
        let program = &mut self.programs[number];
        let Some(code) = &program.code else { return lines };
        let mut context = Context {
            machine: &mut self.machine,
            program: Some(number as u8),
            release: &mut program.release,
            watch: &mut program.watch,
            observer,
            pace,
            immediate: false,
            channel: None,
        };
        let run = acrc_vm::run(code, &mut program.frame, &mut program.locals, &mut context, Budget::lines(lines));
        context.pace.reach(run.used);
        context.catch_up();
        program.statements += u64::from(run.statements);
        // A program that only finds again that it has to wait has changed nothing.
        if run.statements > 0 || run.stop != Stop::Blocked {
            self.changes += 1;
        }
        program.waited_at = self.changes;
        program.awaits = self.machine.streams.awaited.filter(|_| run.stop == Stop::Blocked);
        program.state = match run.stop {
            Stop::Budget => State::Running,
            Stop::Blocked => State::Waiting,
            Stop::Ended => State::Ended,
            Stop::Fault(_) => State::Fault,
        };
        if let Stop::Fault(fault) = &run.stop {
            let location = code.location(fault.pc);
            let report = self.fault_report(Some(number as u8), location, fault.to_string());
            self.faulted = true;
            self.tell_fault(number as u8, location, &report.message);
            observer.fault(&report);
        }
        if !self.programs[number].state.is_active() {
            self.update_program_flags();
        }
        self.apply_requests(observer);
        run.used
    }
}
