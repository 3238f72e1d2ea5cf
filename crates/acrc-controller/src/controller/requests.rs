//! What programs ask of the scheduler and of the memory, carried out between statements.

use acrc_catalog::law;
use acrc_image::UnitName;
use acrc_vm::Code;

use super::{Controller, Observer};
use crate::error::ControllerError;
use crate::machine::Request;
use crate::program::{Program, State};

impl Controller {
    pub(super) fn apply_requests(&mut self, observer: &mut dyn Observer) {
        for request in std::mem::take(&mut self.machine.requests) {
            self.apply(request, observer);
        }
    }

    /// Carries out one request.
    pub(super) fn apply(&mut self, request: Request, observer: &mut dyn Observer) {
        self.changes += 1;
        match request {
            Request::Run(number) => self.start(number),
            Request::Halt(number) => self.halt(number),
            Request::Pause(number) => self.suspend(number, true),
            Request::Resume(number) => self.suspend(number, false),
            Request::New(number) => {
                self.halt(number);
                self.programs[usize::from(number)] = Program::new();
            }
            Request::ClearAllLocals => self.programs.iter_mut().for_each(|program| program.locals.clear()),
            Request::Install(index) => {
                if let Err(message) = self.install(index) {
                    self.faulted = true;
                    let location = self.boot.code.location(self.boot.frame.pc());
                    let report = self.fault_report(None, location, message);
                    observer.fault(&report);
                }
            }
        }
        self.update_program_flags();
    }

    /// Stores a program's text in its space.
    fn install(&mut self, index: usize) -> Result<(), String> {
        let Some(unit) = self.image.programs.get(index) else { return Ok(()) };
        let UnitName::Program(number) = unit.name else { return Ok(()) };
        let Some(program) = self.programs.get_mut(usize::from(number)) else {
            let last = self.machine.model.programs.saturating_sub(1);
            return Err(ControllerError::NoSuchObject { object: "PROG", index: i64::from(number), last }.to_string());
        };
        let available = self.machine.space(number);
        let needed = u64::from(unit.memory());
        if needed > available {
            return Err(ControllerError::ProgramTooLarge { program: number, needed, available }.to_string());
        }
        let code = Code::load(unit, &self.image.aliases).map_err(|error| error.to_string())?;
        program.code = Some(code);
        program.text_bytes = needed;
        program.set_space(available);
        Ok(())
    }

    /// Starts a program that has text; as on the controller, one that has none simply does not run.
    fn start(&mut self, number: u8) {
        if let Some(program) = self.programs.get_mut(usize::from(number)).filter(|program| program.code.is_some()) {
            program.start();
        }
    }

    /// Stops a program and the motion of its master.
    fn halt(&mut self, number: u8) {
        let program = &mut self.programs[usize::from(number)];
        if program.state.is_active() || program.state == State::Paused {
            program.stop(State::Ended);
        }
        if let Ok(master) = self.machine.master_of(number) {
            self.machine.masters[usize::from(master)].profiler.stop();
        }
    }

    fn suspend(&mut self, number: u8, pause: bool) {
        let program = &mut self.programs[usize::from(number)];
        program.state = match (program.state, pause) {
            (State::Running | State::Waiting, true) => State::Paused,
            (State::Paused, false) => State::Running,
            _ => return,
        };
        if let Ok(master) = self.machine.master_of(number) {
            let profiler = &mut self.machine.masters[usize::from(master)].profiler;
            if pause { profiler.feedhold() } else { profiler.cycle_start() }
        }
    }

    fn update_program_flags(&mut self) {
        for (number, program) in self.programs.iter().enumerate() {
            self.machine.flags.set(law::PROGRAM_RUNNING.at(number as u32), program.state.is_active());
            self.machine.flags.set(law::PROGRAM_PAUSE.at(number as u32), program.state == State::Paused);
        }
    }
}
