//! Sends the steps of a plan and looks at the answer to every line.

use std::time::Duration;

use acrc_catalog::{Model, law};
use acrc_image::UnitName;
use acrc_syntax::units::Level;
use thiserror::Error;

use super::listing::Difference;
use super::plan::{Deed, Plan, Save, Settings, Step};
use super::problem::{Problem, codes};
use super::script::Script;
use super::state::{Fate, State};
use super::survey::{self, Survey, switch};
use crate::{Answer, Console, LinkError};

/// How long a line may take that waits or writes to slow memory.
const PATIENCE: Duration = Duration::from_mins(1);
/// How long is waited for motion to end behind `HALT ALL`, in looks and the time between them.
const LOOKS: u32 = 100;
const BETWEEN_LOOKS: Duration = Duration::from_millis(50);

/// What happens, for whoever watches.
#[derive(Clone, Copy, Debug)]
pub enum Event<'a> {
    /// A line is about to be sent: the `number`-th of `of`, from 1.
    Sending {
        /// Its number.
        number: usize,
        /// How many there are.
        of: usize,
        /// The line.
        step: &'a Step,
    },
    /// A line that may report has reported.
    Answered {
        /// The line.
        step: &'a Step,
        /// What it reported.
        lines: &'a [String],
    },
    /// A program is listed and compared.
    Verifying(UnitName),
    /// The controller is told to save.
    Saving(Save),
    /// A program was started; whether it runs.
    Started(UnitName, bool),
    /// Something went wrong; a text that was being entered is ended and erased now.
    Tidying,
    /// Something is not known that would be compared otherwise.
    Note(&'a str),
}

/// Whoever watches a download.
pub trait Watcher {
    /// Something happens.
    fn event(&mut self, event: Event<'_>);
    /// Whether the user wants to end it.
    fn interrupted(&mut self) -> bool;
    /// Lets time pass.
    fn pause(&mut self, time: Duration);
}

/// Why a download ended early.
#[derive(Debug, Error)]
pub enum Cause {
    /// The connection.
    #[error(transparent)]
    Link(#[from] LinkError),
    /// The controller did not take a line.
    #[error("the controller answered `{0}`")]
    Refused(String),
    /// The prompt behind a line is another one.
    #[error("the prompt behind it is that of {found}, and not of {expected}")]
    Prompt {
        /// What it should be.
        expected: Level,
        /// What it is.
        found: Level,
    },
    /// Motion did not end.
    #[error("{} still in motion behind HALT ALL", .0.join(", "))]
    Moving(Vec<String>),
    /// A program is not what was sent.
    #[error("{0} on the controller is not what the project has: line {line} differs", line = .1.line)]
    Different(UnitName, Difference),
    /// Memory, or an alias, is not what was sent.
    #[error("{what} on the controller is not what the project has: {expected} expected, {found} found")]
    Unequal {
        /// What.
        what: String,
        /// As it should be.
        expected: String,
        /// As it is.
        found: String,
    },
    /// The user ended it.
    #[error("interrupted")]
    Interrupted,
}

/// A download that ended early.
#[derive(Debug, Error)]
#[error("{cause}")]
pub struct Failure {
    /// Why.
    pub cause: Cause,
    /// The line at which it ended.
    pub step: Option<Step>,
    /// What is known of the controller.
    pub state: State,
    /// What was done to leave no program half entered.
    pub tidied: Option<String>,
}

impl Failure {
    /// As a finding at its place in the source.
    pub fn problem(&self) -> Option<Problem> {
        let place = match &self.cause {
            Cause::Different(_, difference) => difference.place?,
            _ => self.step.as_ref()?.place?,
        };
        let problem = match &self.cause {
            Cause::Refused(text) => {
                Problem::new(codes::REFUSED, place, format!("the controller refused this: {text}"), text.clone())
            }
            Cause::Different(unit, difference) => {
                let found = difference.found.as_deref().map_or("nothing".to_owned(), |line| format!("`{line}`"));
                let message = format!("{unit} differs from here on: the controller lists {found}");
                Problem::new(codes::NOT_EQUAL, place, message, "not this on the controller")
            }
            _ => return None,
        };
        Some(problem)
    }
}

/// Sends what a plan says, verifies it, and saves and starts what is wanted.
///
/// # Errors
/// The first thing that went wrong, with the state in which the controller is. A text that was being entered is ended and
/// erased then, if the connection still works.
pub fn send(
    console: &mut dyn Console,
    script: &Script,
    plan: &Plan,
    settings: &Settings,
    watcher: &mut dyn Watcher,
    model: &Model,
) -> Result<State, Box<Failure>> {
    let mut sender = Sender { console, watcher, state: plan.state.clone(), model, script, step: None };
    let result = sender.all(plan, settings);
    let Err(cause) = result else { return Ok(sender.state) };
    let tidied = sender.tidy();
    Err(Box::new(Failure { cause, step: sender.step, state: sender.state, tidied }))
}

pub(super) struct Sender<'a> {
    pub(super) console: &'a mut dyn Console,
    pub(super) watcher: &'a mut dyn Watcher,
    pub(super) state: State,
    pub(super) model: &'a Model,
    pub(super) script: &'a Script,
    /// The line that was sent last.
    pub(super) step: Option<Step>,
}

impl Sender<'_> {
    fn all(&mut self, plan: &Plan, settings: &Settings) -> Result<(), Cause> {
        survey::begin(self.console)?;
        for (place, step) in plan.steps.iter().enumerate() {
            if self.watcher.interrupted() {
                return Err(Cause::Interrupted);
            }
            self.watcher.event(Event::Sending { number: place + 1, of: plan.steps.len(), step });
            self.step(step)?;
            self.state.done += 1;
        }
        self.step = None;
        if !settings.unverified {
            self.verify(Some(plan))?;
        }
        for step in &plan.protect {
            self.switch(step.level)?;
            self.step(step)?;
        }
        self.step = None;
        self.switch(Level::System)?;
        for save in &settings.save {
            self.watcher.event(Event::Saving(*save));
            self.quietly(save.command())?;
        }
        for unit in &settings.run {
            self.quietly(&format!("RUN {unit}"))?;
            let running = self.runs(*unit)?;
            self.watcher.event(Event::Started(*unit, running));
        }
        Ok(())
    }

    fn step(&mut self, step: &Step) -> Result<(), Cause> {
        self.step = Some(step.clone());
        self.before(step);
        let answer = self.ask(&step.line, step.waits)?;
        let wrong = if step.speaks { answer.refusal() } else { answer.lines.iter().map(String::as_str).find(said) };
        if let Some(text) = wrong {
            return Err(Cause::Refused(text.trim().to_owned()));
        }
        if step.speaks && !answer.lines.is_empty() {
            self.watcher.event(Event::Answered { step, lines: &answer.lines });
        }
        if answer.prompt != step.behind {
            return Err(Cause::Prompt { expected: step.behind, found: answer.prompt });
        }
        self.behind(step)
    }

    /// What is no longer known from here on until the line has been answered.
    fn before(&mut self, step: &Step) {
        match &step.deed {
            Deed::Open(unit) => {
                self.state.open = Some(*unit);
                self.state.set(*unit, Fate::Partial);
            }
            Deed::Number(unit, _) => self.state.set(*unit, Fate::Partial),
            Deed::Erase(units) => {
                let sent: Vec<UnitName> =
                    units.iter().copied().filter(|unit| self.state.programs.contains_key(unit)).collect();
                for unit in sent {
                    self.state.set(unit, Fate::Partial);
                }
            }
            _ => {}
        }
    }

    fn behind(&mut self, step: &Step) -> Result<(), Cause> {
        match &step.deed {
            Deed::Nothing | Deed::Open(_) | Deed::Text(_) => {}
            Deed::Halt => self.standstill()?,
            Deed::Clear => self.state.cleared = true,
            Deed::Erase(units) => {
                for unit in units {
                    self.state.set(*unit, Fate::Erased);
                }
            }
            Deed::Close(unit, fate) => {
                self.state.open = None;
                self.state.set(*unit, *fate);
            }
            Deed::Number(unit, fate) => self.state.set(*unit, *fate),
        }
        Ok(())
    }

    pub(super) fn ask(&mut self, line: &str, waits: bool) -> Result<Answer, LinkError> {
        if waits { self.console.command_within(line, PATIENCE) } else { self.console.command(line) }
    }

    /// A line of our own that reports nothing.
    pub(super) fn quietly(&mut self, line: &str) -> Result<(), Cause> {
        self.ask(line, true)?.silence()?;
        Ok(())
    }

    pub(super) fn switch(&mut self, level: Level) -> Result<(), Cause> {
        let found = self.ask(&switch(level), false)?.prompt;
        if found == level { Ok(()) } else { Err(Cause::Prompt { expected: level, found }) }
    }

    /// Waits until nothing moves any more.
    fn standstill(&mut self) -> Result<(), Cause> {
        let mut survey = Survey::default();
        for _ in 0..LOOKS {
            survey.activity(self.console, self.model)?;
            if survey.moving.is_empty() {
                return Ok(());
            }
            if self.watcher.interrupted() {
                return Err(Cause::Interrupted);
            }
            self.watcher.pause(BETWEEN_LOOKS);
        }
        Err(Cause::Moving(survey.moving))
    }

    fn runs(&mut self, unit: UnitName) -> Result<bool, Cause> {
        let (law, number) = match unit {
            UnitName::Plc(number) => (law::PLC_RUNNING, number),
            UnitName::Program(number) => (law::PROGRAM_RUNNING, number),
            UnitName::Boot => return Ok(false),
        };
        Ok(self.ask(&format!("?BIT{}", law.at(number.into())), false)?.number().is_ok_and(|value| value != 0.0))
    }

    /// Ends and erases a text that was being entered, so that its beginning cannot be run.
    fn tidy(&mut self) -> Option<String> {
        let numbered = self.step.as_ref().and_then(|step| match step.deed {
            Deed::Number(unit, _) => Some(unit),
            _ => None,
        });
        let numbered = numbered.filter(|unit| self.state.programs.get(unit) == Some(&Fate::Partial));
        let unit = self.state.open.or(numbered)?;
        self.watcher.event(Event::Tidying);
        let mut erase = || -> Result<(), Cause> {
            if self.state.open.is_some() {
                // What it answers does not matter: the text goes anyway.
                self.ask("ENDP", false)?;
            }
            self.switch(super::script::level_of(unit))?;
            self.quietly("NEW")?;
            self.switch(Level::System)
        };
        match erase() {
            Ok(()) => {
                self.state.open = None;
                self.state.set(unit, Fate::Erased);
                Some(format!("{unit} was being entered: it was ended and erased"))
            }
            Err(_) => None,
        }
    }
}

fn said(line: &&str) -> bool {
    !line.trim().is_empty()
}
