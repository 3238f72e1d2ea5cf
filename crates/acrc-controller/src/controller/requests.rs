//! What programs ask of the scheduler and of the memory, carried out between statements.

use acrc_catalog::{Confidence, command, law};
use acrc_image::{Instruction, Unit, UnitName};
use acrc_vm::{AngleUnit, Code, Doubt, LoadError, Unconfirmed};

use super::{Controller, Observer};
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::nonvolatile::Operation;
use crate::orders::Order;
use crate::plc::Ladder;
use crate::program::{Mode, Program, State};
use crate::report::FaultReport;
use crate::request::Request;
use crate::task::Task;

/// Why a program is not stored.
pub(crate) enum Refusal {
    Controller(ControllerError),
    /// The text of this program cannot be executed.
    Code(UnitName, LoadError),
}

impl From<ControllerError> for Refusal {
    fn from(error: ControllerError) -> Self {
        Self::Controller(error)
    }
}

impl Controller {
    pub(crate) fn apply_requests(&mut self, observer: &mut dyn Observer) {
        for request in std::mem::take(&mut self.machine.requests) {
            self.apply(request, observer);
            if request == Request::Memories(Operation::Reboot) {
                break;
            }
        }
    }

    /// Carries out one request.
    pub(crate) fn apply(&mut self, request: Request, observer: &mut dyn Observer) {
        self.changes.everywhere();
        match request {
            Request::Run(task) => self.start(task, observer),
            Request::Halt(task) => self.halt(task),
            Request::Pause(number) => self.pause(number),
            Request::Resume(number) => self.resume(number),
            Request::New(task) => {
                self.halt(task);
                *self.program_mut(task) = Program::new();
                self.machine.memory.set_stored(task.space(), false);
            }
            Request::Boot => self.start_boot_programs(observer),
            Request::Block(number, on) => {
                let program = &mut self.programs[usize::from(number)];
                program.mode = if on { Mode::Block } else { Mode::Automatic };
            }
            Request::Step(number) => {
                let program = &mut self.programs[usize::from(number)];
                if program.mode == Mode::Block {
                    program.mode = Mode::Step;
                }
            }
            Request::Trace(number, on) => self.programs[usize::from(number)].trace = on,
            Request::ClearAllLocals => {
                for task in self.tasks() {
                    self.program_mut(task).locals.clear();
                }
            }
            Request::ForgetAliases => self.aliases.clear(),
            Request::Report(query, origin) => self.answer(query, origin, observer),
            Request::Memories(operation) => self.operate(operation, observer),
            Request::Install(index) => {
                if let Err(refusal) = self.install(index) {
                    self.faulted = true;
                    let report = match refusal {
                        Refusal::Code(unit, error) if error.location.source_line() > 0 => {
                            self.fault_report(unit, error.location, error.kind.to_string())
                        }
                        Refusal::Code(_, error) => self.setup_fault(error.to_string()),
                        Refusal::Controller(error) => self.setup_fault(error.to_string()),
                    };
                    observer.fault(&report);
                }
            }
        }
        self.update_program_flags();
    }

    /// A fault at the present statement of the setup code.
    fn setup_fault(&self, message: String) -> FaultReport {
        self.fault_report(UnitName::Boot, self.boot.code.location(self.boot.statement), message)
    }

    /// Stores a program's text of the image in its space.
    fn install(&mut self, index: usize) -> Result<(), Refusal> {
        let Some(unit) = self.image.programs.get(index).cloned() else { return Ok(()) };
        self.store(unit)
    }

    /// Stores a text that can be executed.
    fn store(&mut self, unit: Unit) -> Result<(), Refusal> {
        let code = Code::load_with(&unit, self.aliases.entries(), self.load)
            .map_err(|error| Refusal::Code(unit.name, error))?;
        self.note_doubts(&unit, &code);
        if let Some(task) = self.store_text(unit)? {
            self.program_mut(task).code = Some(code);
        }
        Ok(())
    }

    /// Stores a text in its space. Whether it can be executed shows when it is started.
    pub(crate) fn store_text(&mut self, unit: Unit) -> Result<Option<Task>, ControllerError> {
        let Some(task) = self.task_of(unit.name)? else { return Ok(None) };
        let available = self.machine.space(task);
        let needed = u64::from(unit.memory());
        if needed > available {
            return Err(ControllerError::ProgramTooLarge { unit: unit.name, needed, available });
        }
        let program = self.program_mut(task);
        // The place at which the old text stood means nothing in the new one.
        program.stop(State::Idle);
        program.frame.reset();
        program.keep(unit);
        program.set_space(available);
        self.machine.memory.set_stored(task.space(), true);
        Ok(Some(task))
    }

    /// What executes a text; the controller must have it.
    pub(crate) fn task_of(&self, name: UnitName) -> Result<Option<Task>, ControllerError> {
        let task = Task::of(name);
        match task {
            Some(Task::Program(number)) => Machine::object("PROG", i64::from(number), self.programs.len() as u8)?,
            Some(Task::Plc(number)) => Machine::object("PLC", i64::from(number), self.plcs.len() as u8)?,
            None => 0,
        };
        Ok(task)
    }

    /// Notes what the behaviour of a text rests on without proof.
    pub(super) fn note_doubts(&mut self, unit: &Unit, code: &Code) {
        let (notes, angles) = (&mut self.machine.notes, self.load.angle);
        notes.extend(code.unconfirmed().iter().map(|doubt| unconfirmed_note(unit.name, doubt, angles)));
        notes.extend(unconfirmed_rungs(unit.name, &unit.decode().unwrap_or_default()));
    }

    /// Starts a program that has text; as on the controller, one that has none simply does not run.
    fn start(&mut self, task: Task, observer: &mut dyn Observer) {
        if !self.program(task).has_text() {
            return;
        }
        if let Err(flaws) = self.prepare(task) {
            self.refuse_start(task, &flaws, observer);
            return;
        }
        if let Task::Plc(number) = task {
            self.plcs[usize::from(number)].ladder = Ladder::new(number);
        }
        if let Task::Program(number) = task
            && let Ok(master) = self.machine.master_of(number)
        {
            // What a run before this one has left half said.
            self.machine.masters[usize::from(master)].forget();
        }
        let program = self.program_mut(task);
        let held = program.state == State::Paused;
        program.start();
        if held && let Task::Program(number) = task {
            self.order(number, Order::CycleStart);
        }
    }

    /// Starts every program that begins with `PBOOT`.
    fn start_boot_programs(&mut self, observer: &mut dyn Observer) {
        for task in self.tasks() {
            // Whether a text that was edited begins with it shows when it is compiled.
            let compiled = self.compile(task);
            if compiled.is_ok() && self.program(task).boots {
                self.start(task, observer);
            }
        }
    }

    /// Stops a program and the motion of its master.
    fn halt(&mut self, task: Task) {
        let program = self.program_mut(task);
        if program.state.is_active() || program.state == State::Paused {
            program.stop(State::Ended);
        }
        if let Task::Program(number) = task {
            self.order(number, Order::Halt);
        }
    }

    /// Holds a program and its motion. Motion that outlives its program is held, too; a program at rest is not.
    fn pause(&mut self, number: u8) {
        let program = &mut self.programs[usize::from(number)];
        let active = program.state.is_active();
        if active {
            program.state = State::Paused;
        }
        let moves = self.machine.master_of(number).is_ok_and(|master| self.machine.moves(usize::from(master)));
        if active || moves {
            self.order(number, Order::Feedhold);
        }
    }

    /// Lets a program and its motion go on; as cycle start, it also ends a feedhold that was requested by flag.
    fn resume(&mut self, number: u8) {
        let program = &mut self.programs[usize::from(number)];
        if program.state == State::Paused {
            program.state = State::Running;
        }
        self.order(number, Order::CycleStart);
    }

    /// An order to the master of a program, if it has one.
    fn order(&mut self, number: u8, order: Order) {
        if let Ok(master) = self.machine.master_of(number) {
            self.machine.order(usize::from(master), order);
        }
    }

    /// Shows the state of the programs in their flags.
    pub(crate) fn update_program_flags(&mut self) {
        for (number, program) in self.programs.iter().enumerate() {
            self.machine.flags.set_law(law::PROGRAM_RUNNING, number as u32, program.state.is_active());
            self.machine.flags.set_law(law::PROGRAM_PAUSE, number as u32, program.state == State::Paused);
        }
        for plc in &self.plcs {
            let number = u32::from(plc.ladder.number());
            self.machine.flags.set_law(law::PLC_RUNNING, number, plc.program.state.is_active());
        }
    }
}

/// What a run says of behaviour that no document describes.
fn unconfirmed_note(unit: UnitName, unconfirmed: &Unconfirmed, angles: AngleUnit) -> String {
    let place = format!("{unit} line {}", unconfirmed.location.source_line());
    let name = unconfirmed.name;
    match unconfirmed.doubt {
        Doubt::Existence => format!("{place} uses {name}, whose behaviour is unconfirmed"),
        Doubt::AngleUnit => format!("{place} uses {name}: angles are taken in {angles}, which is unconfirmed"),
    }
}

/// The ladder commands whose behaviour rests on little.
fn unconfirmed_rungs(unit: UnitName, instructions: &[Instruction]) -> impl Iterator<Item = String> {
    instructions.iter().filter_map(move |instruction| {
        let info = instruction.command.info();
        let ladder = info.levels.plc() && !info.levels.prog() && !info.levels.sys();
        match instruction.command {
            command::TIM => Some(format!("{unit} uses TIM: presets are taken in milliseconds, which is unconfirmed")),
            _ if ladder && info.confidence == Confidence::Low => {
                Some(format!("{unit} uses {}, whose behaviour is unconfirmed", info.name))
            }
            _ => None,
        }
    })
}
