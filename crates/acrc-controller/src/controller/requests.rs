//! What programs ask of the scheduler and of the memory, carried out between statements.

use acrc_catalog::law;
use acrc_image::{Unit, UnitName};
use acrc_vm::{AngleUnit, Code, Doubt, LoadError, Unconfirmed};

use super::{Controller, Observer};
use crate::error::ControllerError;
use crate::nonvolatile::Operation;
use crate::orders::Order;
use crate::program::{Program, State};
use crate::report::FaultReport;
use crate::request::Request;

/// Why a program is not stored.
pub(crate) enum Refusal {
    Controller(ControllerError),
    /// The text of this program cannot be executed.
    Code(u8, LoadError),
}

impl From<ControllerError> for Refusal {
    fn from(error: ControllerError) -> Self {
        Self::Controller(error)
    }
}

impl Controller {
    pub(super) fn apply_requests(&mut self, observer: &mut dyn Observer) {
        for request in std::mem::take(&mut self.machine.requests) {
            self.apply(request, observer);
            if request == Request::Memories(Operation::Reboot) {
                break;
            }
        }
    }

    /// Carries out one request.
    pub(crate) fn apply(&mut self, request: Request, observer: &mut dyn Observer) {
        self.changes += 1;
        match request {
            Request::Run(number) => self.start(number, observer),
            Request::Halt(number) => self.halt(number),
            Request::Pause(number) => self.pause(number),
            Request::Resume(number) => self.resume(number),
            Request::New(number) => {
                self.halt(number);
                self.programs[usize::from(number)] = Program::new();
            }
            Request::ForgetAliases => self.aliases.clear(),
            Request::Report(query, origin) => self.answer(query, origin, observer),
            Request::ClearAllLocals => self.programs.iter_mut().for_each(|program| program.locals.clear()),
            Request::Memories(operation) => self.operate(operation, observer),
            Request::Install(index) => {
                if let Err(refusal) = self.install(index) {
                    self.faulted = true;
                    let report = match refusal {
                        Refusal::Code(number, error) if error.location.source_line() > 0 => {
                            self.fault_report(Some(number), error.location, error.kind.to_string())
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
        self.fault_report(None, self.boot.code.location(self.boot.statement), message)
    }

    /// Stores a program's text of the image in its space.
    fn install(&mut self, index: usize) -> Result<(), Refusal> {
        let Some(unit) = self.image.programs.get(index).cloned() else { return Ok(()) };
        self.store(unit)
    }

    /// Stores a text in its space.
    pub(crate) fn store(&mut self, unit: Unit) -> Result<(), Refusal> {
        let needed = u64::from(unit.memory());
        let UnitName::Program(number) = unit.name else {
            self.machine
                .notes
                .insert(format!("{} has a program: the dry run does not execute PLC programs", unit.name));
            if let UnitName::Plc(number) = unit.name
                && let Some(plc) = self.plcs.get_mut(usize::from(number))
            {
                *plc = Program { unit: Some(unit), text_bytes: needed, ..Program::new() };
            }
            return Ok(());
        };
        let Some(program) = self.programs.get_mut(usize::from(number)) else {
            let last = self.machine.model.programs.saturating_sub(1);
            return Err(ControllerError::NoSuchObject { object: "PROG", index: i64::from(number), last }.into());
        };
        let available = self.machine.space(number);
        if needed > available {
            return Err(ControllerError::ProgramTooLarge { program: number, needed, available }.into());
        }
        let code =
            Code::load_with(&unit, self.aliases.entries(), self.load).map_err(|error| Refusal::Code(number, error))?;
        let angles = self.load.angle;
        self.machine.notes.extend(code.unconfirmed().iter().map(|doubt| unconfirmed_note(number, doubt, angles)));
        // The place at which the old text stood means nothing in the new one.
        program.stop(State::Idle);
        program.frame.reset();
        program.unit = Some(unit);
        program.code = Some(code);
        program.edited = None;
        program.text_bytes = needed;
        program.set_space(available);
        Ok(())
    }

    /// Starts a program that has text; as on the controller, one that has none simply does not run.
    fn start(&mut self, number: u8, observer: &mut dyn Observer) {
        if !self.programs.get(usize::from(number)).is_some_and(Program::has_text) {
            return;
        }
        if let Err(flaws) = self.prepare(number) {
            self.refuse_start(number, &flaws, observer);
            return;
        }
        let program = &mut self.programs[usize::from(number)];
        let held = program.state == State::Paused;
        program.start();
        if held {
            self.order(number, Order::CycleStart);
        }
    }

    /// Stops a program and the motion of its master.
    fn halt(&mut self, number: u8) {
        let program = &mut self.programs[usize::from(number)];
        if program.state.is_active() || program.state == State::Paused {
            program.stop(State::Ended);
        }
        self.order(number, Order::Halt);
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
    }
}

/// What a run says of behaviour that no document describes.
fn unconfirmed_note(program: u8, unconfirmed: &Unconfirmed, angles: AngleUnit) -> String {
    let place = format!("PROG{program} line {}", unconfirmed.location.source_line());
    let name = unconfirmed.name;
    match unconfirmed.doubt {
        Doubt::Existence => format!("{place} uses {name}, whose behaviour is unconfirmed"),
        Doubt::AngleUnit => format!("{place} uses {name}: angles are taken in {angles}, which is unconfirmed"),
    }
}
