//! Which statements of a file belong to which level (guide, "Programs and Commands").
//!
//! A file is what is typed at a controller: `SYS`, `PROG n` and `PLC n` switch the prompt, and between `PROGRAM` and
//! `ENDP` lines are stored instead of executed, as is a line that starts with a number.

use std::fmt;
use std::ops::Range;

use acrc_catalog::command;

use crate::Tree;
use crate::ast::{Argument, Command, ExprKind, Statement, StatementKind};

/// A prompt level.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// The system.
    System,
    /// A program, by number.
    Program(u8),
    /// A PLC program, by number.
    Plc(u8),
}

/// As the controller writes it: `SYS`, `PROG0`, `PLC3`.
impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::System => f.write_str("SYS"),
            Self::Program(number) => write!(f, "PROG{number}"),
            Self::Plc(number) => write!(f, "PLC{number}"),
        }
    }
}

/// What happens to the statements of a section.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SectionKind {
    /// Each is executed when it arrives.
    Immediate,
    /// They are stored as the program of their level.
    Stored,
}

/// Statements that stand together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Section {
    /// The level at which they are entered.
    pub level: Level,
    /// What happens to them.
    pub kind: SectionKind,
    /// Which they are; `PROGRAM` and `ENDP` belong to no section.
    pub statements: Range<u32>,
    /// The `PROGRAM` before them.
    pub opener: Option<u32>,
    /// The `ENDP` behind them. A stored section with an opener and without a closer runs to the end of the file.
    pub closer: Option<u32>,
}

/// Splits the statements of a file whose first line is entered at `start`.
///
/// The sections are in order and never overlap. An immediate section without statements is left out; `PROGRAM`
/// directly before `ENDP` gives an empty stored section. A number behind `PROG` or `PLC` that is too large for any
/// controller counts as 255.
#[must_use]
pub fn split(tree: &Tree, start: Level) -> Vec<Section> {
    let mut splitter =
        Splitter { sections: Vec::new(), level: start, kind: SectionKind::Immediate, first: 0, opener: None };
    for line in tree.lines() {
        if splitter.opener.is_none() && !line.statements.is_empty() {
            let kind = if line.number.is_some() { SectionKind::Stored } else { SectionKind::Immediate };
            splitter.change(line.statements.start, kind);
        }
        for index in line.statements.clone() {
            if let Some(statement) = tree.statements().get(index as usize) {
                splitter.statement(index, statement);
            }
        }
    }
    splitter.close(tree.statements().len() as u32, None);
    splitter.sections
}

struct Splitter {
    sections: Vec<Section>,
    level: Level,
    kind: SectionKind,
    /// First statement of the section that is being collected.
    first: u32,
    opener: Option<u32>,
}

impl Splitter {
    fn statement(&mut self, index: u32, statement: &Statement) {
        let StatementKind::Command(command) = &statement.kind else { return };
        if self.opener.is_some() {
            if command.id == command::ENDP {
                self.close(index, Some(index));
                self.first = index + 1;
            }
        } else if self.kind == SectionKind::Immediate {
            if command.id == command::PROGRAM {
                self.close(index, None);
                self.kind = SectionKind::Stored;
                self.opener = Some(index);
                self.first = index + 1;
            } else if let Some(level) = switched_level(command) {
                self.close(index + 1, None);
                self.level = level;
            }
        }
    }

    /// Starts a section of another kind, if it is another one.
    fn change(&mut self, index: u32, kind: SectionKind) {
        if self.kind != kind {
            self.close(index, None);
            self.kind = kind;
        }
    }

    /// Ends the present section before the statement `end`.
    fn close(&mut self, end: u32, closer: Option<u32>) {
        if self.first < end || self.opener.is_some() {
            self.sections.push(Section {
                level: self.level,
                kind: self.kind,
                statements: self.first..end,
                opener: self.opener.take(),
                closer,
            });
        }
        self.first = end;
        self.kind = SectionKind::Immediate;
    }
}

/// The level to which a command switches. The switch itself is still entered at the level before.
fn switched_level(command: &Command) -> Option<Level> {
    let number = || match command.arguments.first() {
        Some(Argument::Value(value)) => match value.kind {
            ExprKind::Integer(number) => Some(u8::try_from(number).unwrap_or(u8::MAX)),
            _ => None,
        },
        _ => None,
    };
    match command.id {
        command::SYS => Some(Level::System),
        command::PROG => number().map(Level::Program),
        command::PLC => number().map(Level::Plc),
        _ => None,
    }
}
