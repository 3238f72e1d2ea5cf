//! A run: setup code, then ticks and slices until it is over.

use acrc_vm::{Locals, Reference, Value};

use super::{Controller, Observer};
use crate::motion::{ArrayPlace, Arrays};
use crate::plc::Plc;
use crate::program::{NEVER, Program};
use crate::request::Request;
use crate::task::Task;
use crate::terminal::Demand;
use crate::watch::Watch;

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

/// The arrays of the programs, for what follows tables in them.
struct Tables<'a> {
    programs: &'a mut [Program],
    plcs: &'a mut [Plc],
}

impl Tables<'_> {
    fn locals(&self, task: Task) -> Option<&Locals> {
        match task {
            Task::Program(number) => self.programs.get(usize::from(number)).map(|program| &program.locals),
            Task::Plc(number) => self.plcs.get(usize::from(number)).map(|plc| &plc.program.locals),
        }
    }
}

fn element(place: ArrayPlace, index: usize) -> Reference {
    Reference::Element { class: place.class, array: place.array, element: index as i64 }
}

impl Arrays for Tables<'_> {
    fn size(&self, place: ArrayPlace) -> usize {
        let locals = self.locals(place.task);
        locals.and_then(|locals| locals.array_size(place.class, place.array)).map_or(0, |size| size as usize)
    }

    fn read(&self, place: ArrayPlace, index: usize) -> Option<f64> {
        let value = self.locals(place.task)?.read(element(place, index)).ok()?;
        value.to_f64().ok()
    }

    fn store(&mut self, place: ArrayPlace, index: usize, value: &Value) -> bool {
        let program = match place.task {
            Task::Program(number) => self.programs.get_mut(usize::from(number)),
            Task::Plc(number) => self.plcs.get_mut(usize::from(number)).map(|plc| &mut plc.program),
        };
        let Some(program) = program else { return false };
        // A program that goes round in a circle does not look whether somebody else writes its variables.
        program.watch = Watch::default();
        program.locals.write(element(place, index), value).is_ok()
    }
}

impl Controller {
    /// Boots, starts the given programs and runs until everything has ended, `until` seconds are over, or the observer ends the run.
    pub fn run(&mut self, start: &[u8], until: f64, observer: &mut dyn Observer) -> Stopped {
        self.start_after_setup(start);
        self.powered = true;
        self.report_events(observer);
        let mut end = self.machine.clock.tick_at(until);
        loop {
            let period = self.machine.clock.period();
            self.prepare_tick(observer);
            // `PERIOD` in the setup code changes how many ticks a time takes.
            if self.machine.clock.period() != period {
                end = self.machine.clock.tick_at(until);
            }
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
                self.apply(Request::Run(Task::Program(program)), observer);
            }
            if !std::mem::replace(&mut self.plcs_started, true) {
                self.start_plcs(observer);
            }
        }
    }

    /// What happens at the present tick besides motion: a scan and a slice. `end` is the last tick of the run.
    fn execute_tick(&mut self, end: u64, observer: &mut dyn Observer) {
        let scans = self.plcs.iter().any(|plc| plc.program.is_active());
        if scans && self.machine.clock.ticks().is_multiple_of(self.scan_ticks()) {
            self.scan(observer);
        }
        if self.machine.clock.ticks().is_multiple_of(self.machine.clock.slice_ticks()) {
            self.slice(end, observer);
        }
        self.alarms.look(&self.machine);
        observer.tick(&self.view());
    }

    /// Whether nothing goes on: setup code is done, no program runs, nothing moves, and every channel has been answered.
    pub fn is_idle(&self) -> bool {
        self.is_over() && self.channel_demand() == Demand::Nothing
    }

    /// Nothing runs and nothing moves, and no PLC program has anything to come.
    fn is_over(&self) -> bool {
        let programs = self.programs.iter().any(Program::is_active);
        self.boot.done && !self.machine.in_motion() && !programs && self.plcs_are_over()
    }

    /// Scans happen whatever else does. They are over when nothing can change what they do: no timer, no event, nobody else.
    fn plcs_are_over(&self) -> bool {
        let mut scanning = self.plcs.iter().filter(|plc| plc.program.is_active()).peekable();
        scanning.peek().is_none()
            || self.machine.next_event_tick().is_none() && scanning.all(|plc| plc.rests(&self.changes) == Some(NEVER))
    }

    /// One tick, or as many as pass before anything can happen.
    fn advance(&mut self, end: u64, observer: &mut dyn Observer) {
        if let Some(tick) = self.quiet_until(end) {
            self.skip_to(tick - 1, observer);
        }
        let moving = self.machine.is_busy();
        let mut tables = Tables { programs: &mut self.programs, plcs: &mut self.plcs };
        self.machine.tick(&mut tables);
        if self.report_events(observer) || moving {
            self.changes.everywhere();
        }
    }

    /// Tells the observer of the events that the machine has taken in. True when there were any.
    fn report_events(&mut self, observer: &mut dyn Observer) -> bool {
        let applied = self.machine.applied_events();
        let new = applied > self.reported_events;
        let first = std::mem::replace(&mut self.reported_events, applied);
        for event in &self.machine.world().events()[first..applied] {
            observer.event(self.machine.clock.seconds(), event, &self.view());
        }
        self.type_events(first..applied);
        new
    }
}
