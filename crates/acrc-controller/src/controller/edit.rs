//! Texts of programs that are entered and changed at a terminal (guide, "Adding Lines of Code to Programs").
//!
//! A text that was changed is compiled when it is needed: when the program is started or listed. Nothing is said about its syntax before: mistakes
//! show when the program is started with `LRUN`.

use acrc_catalog::message;
use acrc_compile::{compile_stored, read_alias};
use acrc_syntax::ast::StatementKind;
use acrc_syntax::units::Level;
use acrc_vm::{Code, Location};

use super::{Controller, Observer};
use crate::error::ControllerError;
use crate::program::{Program, State};
use crate::report::FaultReport;
use crate::task::Task;
use crate::terminal::{Entry, StoredText, complaint, known_words};

/// Why a text cannot be executed.
#[derive(Clone, Debug)]
pub(crate) struct Flaw {
    /// The number of the line.
    number: Option<u32>,
    text: String,
}

impl Controller {
    /// `PROGRAM` at a prompt.
    pub(super) fn begin_entry(&mut self, level: Level) -> (Entry, Result<(), ControllerError>) {
        let allowed = self.changeable(level).map(|_| ());
        (Entry::new(level, allowed.is_err()), allowed)
    }

    /// `ENDP`: the text takes the place of the one before.
    pub(super) fn finish_entry(&mut self, entry: Entry) -> Result<(), ControllerError> {
        if entry.discarded {
            return Ok(());
        }
        let space = self.space_at(entry.level);
        if entry.text.bytes() > space {
            return Err(too_large(entry.level, entry.text.bytes(), space));
        }
        self.changeable(entry.level)?;
        if let Some(task) = Task::at(entry.level) {
            self.replace_text(task, entry.text);
        }
        Ok(())
    }

    /// A line with a number: it is stored, or deleted when it is empty.
    pub(super) fn store_line(&mut self, level: Level, number: u32, line: &str) -> Result<(), ControllerError> {
        let mut text = self.text_at(level)?;
        let space = self.space_at(level);
        if line.is_empty() {
            text.delete(number);
        } else {
            text.put(number, line, space).map_err(|needed| too_large(level, needed, space))?;
        }
        if let Some(task) = Task::at(level) {
            self.replace_text(task, text);
        }
        Ok(())
    }

    /// The text of a program as lines, to be changed.
    fn text_at(&mut self, level: Level) -> Result<StoredText, ControllerError> {
        let program = self.changeable(level)?;
        let (edited, unit) = (program.edited.clone(), program.unit.clone());
        Ok(edited.or_else(|| StoredText::of_unit(&unit?, self.aliases.entries()).ok()).unwrap_or_default())
    }

    /// The program at a level, if its text may be changed now.
    fn changeable(&mut self, level: Level) -> Result<&mut Program, ControllerError> {
        match self.program_at(level) {
            None => Err(ControllerError::Said(message::UNKNOWN_COMMAND)),
            Some(program) if program.is_going() => Err(ControllerError::Said(message::PROGRAM_RUNNING)),
            Some(program) => Ok(program),
        }
    }

    /// A text that is compiled when it is needed takes the place of the one before.
    pub(crate) fn replace_text(&mut self, task: Task, text: StoredText) {
        let space = self.machine.space(task);
        self.machine.memory.set_stored(task.space(), !text.is_empty());
        let program = self.program_mut(task);
        program.stop(State::Idle);
        program.frame.reset();
        program.unit = None;
        program.code = None;
        program.boots = false;
        program.text_bytes = text.bytes();
        program.edited = Some(text).filter(|text| !text.is_empty());
        program.set_space(space);
        self.update_program_flags();
    }

    /// The program or PLC program at a level.
    pub(super) fn program_at(&mut self, level: Level) -> Option<&mut Program> {
        Task::at(level).map(|task| self.program_mut(task))
    }

    /// Bytes that a program or PLC program has for its text and its variables.
    pub(super) fn space_at(&self, level: Level) -> u64 {
        Task::at(level).map_or(0, |task| self.machine.space(task))
    }

    /// Makes the text of a program ready to run.
    pub(super) fn prepare(&mut self, task: Task) -> Result<(), Vec<Flaw>> {
        self.compile(task)?;
        let program = self.program(task);
        let (Some(unit), None) = (program.unit.clone(), &program.code) else { return Ok(()) };
        match Code::load_with(&unit, self.aliases.entries(), self.load) {
            Ok(code) => {
                self.note_doubts(&unit, &code);
                self.program_mut(task).code = Some(code);
                Ok(())
            }
            Err(error) => {
                let number = self.line_number(task, error.location);
                Err(vec![Flaw { number, text: error.kind.to_string() }])
            }
        }
    }

    /// Compiles a text that was edited.
    pub(crate) fn compile(&mut self, task: Task) -> Result<(), Vec<Flaw>> {
        let Some(text) = self.program(task).edited.clone() else { return Ok(()) };
        let source = text.source();
        let tree = acrc_syntax::parse(&source);
        self.define_all(&source, &tree).map_err(|text| vec![Flaw { number: None, text }])?;
        let unit = compile_stored(task.unit(), &source, &tree, self.aliases.names()).map_err(|errors| {
            let flaw = |error: acrc_compile::CompileError| {
                let line = tree.lines().partition_point(|line| line.span.end < error.span.start);
                let number = text.lines().get(line).map(|line| line.number);
                Flaw { number, text: complaint(&source, &tree, error.span, &error.kind) }
            };
            errors.into_iter().map(flaw).collect::<Vec<_>>()
        })?;
        let (needed, space) = (u64::from(unit.memory()), self.machine.space(task));
        if needed > space {
            return Err(vec![Flaw { number: None, text: too_large(task.level(), needed, space).to_string() }]);
        }
        let program = self.program_mut(task);
        program.keep(unit);
        program.set_space(space);
        Ok(())
    }

    /// Adds the aliases that a text defines to those of the controller.
    fn define_all(&mut self, source: &str, tree: &acrc_syntax::Tree) -> Result<(), String> {
        for statement in tree.statements() {
            // What is wrong with a definition the compiler says.
            if let StatementKind::Define(define) = &statement.kind
                && let Ok(alias) = read_alias(source, define)
            {
                self.aliases
                    .define(alias, self.machine.model, &self.machine.memory)
                    .map_err(|error| error.to_string())?;
            }
        }
        Ok(())
    }

    /// A program that was to be started and cannot: its mistakes are told to those who listen.
    pub(super) fn refuse_start(&mut self, task: Task, flaws: &[Flaw], observer: &mut dyn Observer) {
        self.faulted = true;
        self.program_mut(task).stop(State::Fault);
        self.alarms.program_fault(task);
        for flaw in flaws {
            let heard = self.tell_flaw(task, &flaw.text, flaw.number);
            observer.fault(&FaultReport {
                seconds: self.machine.clock.seconds(),
                unit: task.unit(),
                file: None,
                line: flaw.number,
                statement: 1,
                message: flaw.text.clone(),
                heard,
            });
        }
    }

    /// Tells those who listen to a program of its run-time error. False when nobody does.
    pub(super) fn tell_fault(&mut self, task: Task, location: Location, message: &str) -> bool {
        self.tell_flaw(task, message, self.line_number(task, location))
    }

    fn tell_flaw(&mut self, task: Task, message: &str, line: Option<u32>) -> bool {
        let terminal = &mut self.machine.terminal;
        let heard = terminal.channels().any(|channel| channel.listening == Some(task));
        if heard {
            terminal.tell_listeners(task, fault_line(message, line).as_bytes());
        }
        heard
    }

    /// The number, written or hidden, of a line of a program.
    fn line_number(&self, task: Task, location: Location) -> Option<u32> {
        self.program(task).numbers.get((location.line as usize).checked_sub(1)?).copied()
    }
}

/// A mistake of a program as a terminal shows it, in Latin-1. The place is ours.
fn fault_line(message: &str, number: Option<u32>) -> String {
    let place = number.map_or_else(String::new, |number| format!(" [line {number}]"));
    format!("{}{place}\r\n", known_words(message))
}

fn too_large(level: Level, needed: u64, available: u64) -> ControllerError {
    ControllerError::TextTooLarge { program: level.to_string(), needed, available }
}
