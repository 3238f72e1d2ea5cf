//! What a controller has and does, by queries that the guide documents: programs, memory, aliases, what runs, moves and is
//! enabled.
//!
//! The layouts of `DIM` and `DEF` are not documented. What is not understood counts as unknown, and a download then takes
//! the longer way.

use std::collections::{BTreeMap, BTreeSet};

use acrc_catalog::memory::SystemBlock;
use acrc_catalog::{Law, Model, law};
use acrc_compile::read_alias;
use acrc_image::{Alias, UnitName};
use acrc_syntax::ast::StatementKind;
use acrc_syntax::units::Level;

use super::immediate::system_dimension;
use super::listing::Listing;
use super::script::level_of;
use crate::{Console, LinkError};

/// What a controller has and does.
#[derive(Clone, Debug, Default)]
pub struct Survey {
    /// The texts of the programs that have one.
    pub programs: BTreeMap<UnitName, Listing>,
    /// Programs are protected from being listed; this is what the controller says.
    pub protected: Option<String>,
    /// What `DIM` reports at the system prompt; `None` when it is not understood.
    pub memory: Option<BTreeMap<SystemBlock, u64>>,
    /// What `DEF` reports; `None` when it is not understood.
    pub aliases: Option<Vec<Alias>>,
    /// The same as it was reported.
    pub alias_lines: Vec<String>,
    /// What `ATTACH` reports at the prompt of each program that has attachments.
    pub attachments: BTreeMap<UnitName, Vec<String>>,
    /// What `ATTACH` reports at the system prompt: what each axis uses.
    pub hardware: Vec<String>,
    /// What `VER` reports.
    pub version: Vec<String>,
    /// Programs that run or are paused.
    pub running: Vec<UnitName>,
    /// Masters and axes that move.
    pub moving: Vec<String>,
    /// Axes whose drive is enabled.
    pub enabled: Vec<u8>,
}

/// Goes to the system prompt. Text that somebody left half entered is ended first: until then nothing is executed.
///
/// # Errors
/// When the prompt does not come.
pub(super) fn begin(console: &mut dyn Console) -> Result<(), LinkError> {
    for line in ["SYS", "ENDP"] {
        if console.command(line)?.prompt == Level::System {
            return Ok(());
        }
    }
    let answer = console.command("SYS")?;
    if answer.prompt == Level::System {
        return Ok(());
    }
    Err(LinkError::NotUnderstood { line: answer.command, answer: format!("the prompt of {}", answer.prompt) })
}

/// Looks at everything.
///
/// # Errors
/// When the controller does not answer.
pub fn survey(console: &mut dyn Console, model: &Model) -> Result<Survey, LinkError> {
    begin(console)?;
    let mut survey = Survey::default();
    survey.activity(console, model)?;
    survey.version = console.command("VER")?.lines;
    survey.memory = dimensions(&console.command("DIM")?.lines);
    survey.alias_lines = console.command("DEF")?.lines;
    survey.aliases = definitions(&survey.alias_lines);
    survey.hardware = console.command("ATTACH")?.lines;
    survey.texts(console, model)?;
    Ok(survey)
}

impl Survey {
    /// What runs, moves and is enabled.
    ///
    /// # Errors
    /// When the controller does not answer.
    pub fn activity(&mut self, console: &mut dyn Console, model: &Model) -> Result<(), LinkError> {
        (self.running, self.moving, self.enabled) = (Vec::new(), Vec::new(), Vec::new());
        for number in 0..model.programs {
            if flag(console, law::PROGRAM_RUNNING, number)? || flag(console, law::PROGRAM_PAUSE, number)? {
                self.running.push(UnitName::Program(number));
            }
        }
        for number in 0..model.plcs {
            if flag(console, law::PLC_RUNNING, number)? {
                self.running.push(UnitName::Plc(number));
            }
        }
        for number in 0..model.masters {
            if flag(console, law::IN_MOTION, number)? {
                self.moving.push(format!("MASTER{number}"));
            }
        }
        for number in 0..model.axes {
            if flag(console, law::JOG_ACTIVE, number)? {
                self.moving.push(format!("AXIS{number}"));
            }
            if flag(console, law::DRIVE_ENABLE, number)? {
                self.enabled.push(number);
            }
        }
        Ok(())
    }

    /// What is another than in an earlier survey, in words. What moves is not told: that changes while a program runs.
    pub fn changes_since(&self, before: &Self) -> Vec<String> {
        let units: BTreeSet<UnitName> = self.programs.keys().chain(before.programs.keys()).copied().collect();
        let other = units.into_iter().filter(|unit| self.programs.get(unit) != before.programs.get(unit));
        let mut changes: Vec<String> = other.map(|unit| format!("the text of {unit}")).collect();
        let rest = [
            (self.protected != before.protected, "the protection of the programs"),
            (self.memory != before.memory, "what DIM reports"),
            (self.alias_lines != before.alias_lines, "what DEF reports"),
            (self.attachments != before.attachments || self.hardware != before.hardware, "what ATTACH reports"),
            (self.running != before.running, "which programs run"),
            (self.enabled != before.enabled, "which drives are enabled"),
        ];
        changes.extend(rest.into_iter().filter(|(differs, _)| *differs).map(|(_, what)| what.to_owned()));
        changes
    }

    fn texts(&mut self, console: &mut dyn Console, model: &Model) -> Result<(), LinkError> {
        let numbered = numbers_lines(console)?;
        if numbered {
            console.command(&format!("CLR {}", law::LIST_LINE_NUMBERS.at(0)))?;
        }
        let programs = (0..model.programs).map(UnitName::Program);
        for unit in programs.chain((0..model.plcs).map(UnitName::Plc)) {
            match list_program(console, unit)? {
                Listed::Missing => {}
                Listed::Protected(text) => self.protected = Some(text),
                Listed::Text(listing) => {
                    if !listing.lines.is_empty() {
                        self.programs.insert(unit, listing);
                    }
                    if matches!(unit, UnitName::Program(_)) {
                        let lines = console.command("ATTACH")?.lines;
                        if !lines.is_empty() {
                            self.attachments.insert(unit, lines);
                        }
                    }
                }
            }
        }
        console.command("SYS")?;
        if numbered {
            console.command(&format!("SET {}", law::LIST_LINE_NUMBERS.at(0)))?;
        }
        Ok(())
    }
}

/// What a controller answers when a program is to be listed.
pub(super) enum Listed {
    /// It has no such program.
    Missing,
    /// It does not show it; this is what it says.
    Protected(String),
    /// The text, which may be empty.
    Text(Listing),
}

/// Lists a program, with the line numbers that were written.
pub(super) fn list_program(console: &mut dyn Console, unit: UnitName) -> Result<Listed, LinkError> {
    let level = level_of(unit);
    if console.command(&switch(level))?.prompt != level {
        return Ok(Listed::Missing);
    }
    let answer = console.command("LIST")?;
    match (answer.refusal(), &answer.lines[..]) {
        (Some(text), [_]) => Ok(Listed::Protected(text.trim().to_owned())),
        _ => Ok(Listed::Text(Listing::new(&answer.lines))),
    }
}

/// Whether `LIST` numbers all lines, so that hidden numbers look like written ones.
pub(super) fn numbers_lines(console: &mut dyn Console) -> Result<bool, LinkError> {
    flag(console, law::LIST_LINE_NUMBERS, 0)
}

/// The command that switches to a prompt.
pub(super) fn switch(level: Level) -> String {
    match level {
        Level::System => "SYS".to_owned(),
        Level::Program(number) => format!("PROG{number}"),
        Level::Plc(number) => format!("PLC{number}"),
    }
}

/// Whether a flag is set; one that the controller does not know is not.
fn flag(console: &mut dyn Console, law: Law, index: u8) -> Result<bool, LinkError> {
    let Some(number) = law.get(index.into()) else { return Ok(false) };
    match console.command(&format!("?BIT{number}"))?.number() {
        Ok(value) => Ok(value != 0.0),
        Err(error) if error.is_broken() => Err(error),
        Err(_) => Ok(false),
    }
}

/// The blocks of a `DIM` report; `None` when a line is none.
pub(super) fn dimensions(lines: &[String]) -> Option<BTreeMap<SystemBlock, u64>> {
    lines.iter().filter(|line| !line.trim().is_empty()).map(|line| dimension(line)).collect()
}

fn dimension(line: &str) -> Option<(SystemBlock, u64)> {
    let tree = acrc_syntax::parse(line);
    match tree.statements() {
        [only] => match &only.kind {
            StatementKind::Dim(dim) => system_dimension(dim),
            _ => None,
        },
        _ => None,
    }
}

/// The aliases of a `DEF` report; `None` when a line is none.
pub(super) fn definitions(lines: &[String]) -> Option<Vec<Alias>> {
    lines.iter().filter(|line| !line.trim().is_empty()).map(|line| definition(line)).collect()
}

fn definition(line: &str) -> Option<Alias> {
    let with_word = format!("#DEFINE {line}");
    [line, &with_word].into_iter().find_map(|text| {
        let tree = acrc_syntax::parse(text);
        match tree.statements() {
            [only] => match &only.kind {
                StatementKind::Define(define) => read_alias(text, define).ok(),
                _ => None,
            },
            _ => None,
        }
    })
}
