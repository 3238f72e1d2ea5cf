//! A typed line: what it consists of, ready to be executed.
//!
//! Its statements are executed as one text where that is possible, so that the condition of a one-line `IF` holds for the rest of the line. Where
//! a statement cannot be read, the others are executed all the same; a one-line `IF` and what depends on it belong together.

use std::collections::VecDeque;
use std::ops::Range;

use acrc_catalog::{Model, command, message, word};
use acrc_compile::{CompileErrorKind, LINE_NUMBERS, encode_statements, read_alias};
use acrc_diagnostics::Span;
use acrc_image::{UnitName, encode};
use acrc_syntax::Tree;
use acrc_syntax::ast::{LineNumber, Statement, StatementKind};
use acrc_syntax::units::Level;
use acrc_vm::{Code, Frame, LoadErrorKind, LoadOptions};

use crate::aliases::Aliases;
use crate::footprint::Places;
use crate::memory::SystemMemory;
use crate::program::Alarm;

/// A line that is being executed.
#[derive(Debug, Default)]
pub(crate) struct Typed {
    /// What is left of it.
    pub(crate) pieces: VecDeque<Piece>,
    /// How far the first piece has come.
    pub(crate) frame: Frame,
    /// Tick at which its dwell ends.
    pub(crate) release: Option<u64>,
    /// When its wait for a parameter looks again.
    pub(crate) alarm: Alarm,
    /// It found that it has to wait.
    pub(crate) waiting: bool,
    /// The count of changes when it last found so.
    pub(crate) waited_at: u64,
    /// What its waiting depends on.
    pub(crate) waits_for: Places,
}

/// A part of a typed line.
#[derive(Debug)]
pub(crate) enum Piece {
    /// Statements to be executed.
    Run(Box<Code>),
    /// A text that says why a statement is not executed.
    Refuse(String),
    /// The rest of the line, to be read when what stands before it has been executed.
    Read(String),
    /// `PROGRAM`: what follows on the line is entered first.
    Enter(String),
    /// A line with a number, to be stored; without text it is deleted.
    Store(u32, String),
}

/// Reads typed lines.
pub(crate) struct Reader<'a> {
    /// What names mean; `#DEFINE` adds to it.
    pub(crate) aliases: &'a mut Aliases,
    /// The controller.
    pub(crate) model: &'static Model,
    /// The level at which the line is typed.
    pub(crate) level: Level,
    /// Where the alias table has its memory.
    pub(crate) memory: &'a SystemMemory,
    /// How statements are made ready to run.
    pub(crate) load: LoadOptions,
}

impl Reader<'_> {
    /// What a line consists of.
    pub(crate) fn read(&mut self, line: &str) -> VecDeque<Piece> {
        let (text, tree) = parse(line);
        let first = tree.lines().first();
        if first.is_some_and(|line| line.statements.is_empty() && line.comment.is_some()) {
            // The download tool drops such lines; one that arrives means nothing.
            return VecDeque::new();
        }
        if let Some(number) = first.and_then(|line| line.number) {
            if number.value > LineNumber::MAX {
                let written = text.get(number.span.range()).unwrap_or_default().to_owned();
                let refusal = CompileErrorKind::NumberTooLarge { text: written, limit: LINE_NUMBERS };
                return [Piece::Refuse(refusal.to_string())].into();
            }
            let statements = text.get(number.span.end as usize..).unwrap_or_default().trim();
            return [Piece::Store(number.value, statements.to_owned())].into();
        }
        let mut pieces = VecDeque::new();
        let (entry, count) = program_entry(&text, &tree);
        let (now, later) = until_definition(&text, &tree, count);
        self.statements(&text, &tree, 0..now, &mut pieces);
        pieces.extend(later.map(Piece::Read).or(entry.map(Piece::Enter)));
        pieces
    }

    fn statements(&mut self, text: &str, tree: &Tree, range: Range<u32>, pieces: &mut VecDeque<Piece>) {
        if range.is_empty() {
            return;
        }
        let parts = parts(tree, &range);
        let undefined: Vec<Option<String>> = parts.iter().map(|part| self.define(text, tree, part)).collect();
        if undefined.iter().all(Option::is_none)
            && let Ok(code) = self.code(text, tree, range)
        {
            pieces.push_back(Piece::Run(code));
            return;
        }
        for (part, undefined) in parts.into_iter().zip(undefined) {
            let refusal = match undefined {
                Some(refusal) => Err(refusal),
                None => self.code(text, tree, part),
            };
            pieces.push_back(refusal.map_or_else(Piece::Refuse, Piece::Run));
        }
    }

    /// Adds the aliases that statements define. Gives why one of them cannot be added.
    fn define(&mut self, text: &str, tree: &Tree, part: &Range<u32>) -> Option<String> {
        let definitions = statements(tree, part).iter().filter_map(|statement| match &statement.kind {
            StatementKind::Define(define) => Some(define),
            _ => None,
        });
        for define in definitions {
            let defined = match read_alias(text, define) {
                Ok(alias) => self.aliases.define(alias, self.model, self.memory).map_err(|error| error.to_string()),
                Err(mistakes) => Err(mistakes.first().map_or_else(String::new, ToString::to_string)),
            };
            if let Err(refusal) = defined {
                return Some(refusal);
            }
        }
        None
    }

    /// Statements as code, or what the controller says instead of executing them.
    fn code(&self, text: &str, tree: &Tree, range: Range<u32>) -> Result<Box<Code>, String> {
        let unknown = || message::UNKNOWN_COMMAND.text().to_owned();
        let in_program = matches!(self.level, Level::Program(_));
        let instructions = encode_statements(tree, text, range, self.aliases.names()).map_err(|errors| {
            errors.first().map_or_else(String::new, |error| match error.kind {
                CompileErrorKind::UndefinedLabel(_) if !in_program => unknown(),
                _ => complaint(text, tree, error.span, &error.kind),
            })
        })?;
        let unit = encode(UnitName::Boot, &instructions).map_err(|error| error.to_string())?;
        let code = Code::load_with(&unit, self.aliases.entries(), self.load).map_err(|error| match error.kind {
            LoadErrorKind::NotOpen { .. } if !in_program => unknown(),
            kind => kind.to_string(),
        })?;
        Ok(Box::new(code))
    }
}

/// Reads a line; one whose last parenthesis is missing is read as if it were there, as the controller does.
fn parse(line: &str) -> (String, Tree) {
    let tree = acrc_syntax::parse(line);
    let broken = |tree: &Tree| tree.statements().iter().any(|statement| statement.kind == StatementKind::Error);
    if broken(&tree) {
        let closed = format!("{line})");
        let repaired = acrc_syntax::parse(&closed);
        if !broken(&repaired) {
            return (closed, repaired);
        }
    }
    (line.to_owned(), tree)
}

/// What stands behind a `PROGRAM` of the line, and how many statements stand before it.
fn program_entry(text: &str, tree: &Tree) -> (Option<String>, u32) {
    let count = tree.statements().len() as u32;
    let opens = |statement: &&Statement| matches!(&statement.kind, StatementKind::Command(command) if command.id == command::PROGRAM);
    let conditional = tree.statements().iter().position(is_one_line_if).unwrap_or(usize::MAX);
    let Some(place) = tree.statements().iter().position(|statement| opens(&statement)) else { return (None, count) };
    if place > conditional {
        return (None, count);
    }
    let behind = tree
        .statements()
        .get(place)
        .map_or("", |statement| text.get(statement.span.end as usize..).unwrap_or_default());
    (Some(behind.trim_start_matches([' ', '\t', ':']).to_owned()), place as u32)
}

/// How many of the first `count` statements can be read at once, and the text behind them: a `#DEFINE` needs the memory that a `DIM DEF` before
/// it gives. What stands in a block is read with it.
fn until_definition(text: &str, tree: &Tree, count: u32) -> (u32, Option<String>) {
    let first = statements(tree, &(0..count));
    let defines = |statement: &Statement| matches!(statement.kind, StatementKind::Define(_));
    let blocks = |statement: &Statement| match &statement.kind {
        StatementKind::If(_) | StatementKind::For(_) => true,
        StatementKind::Command(command) => command.id == command::WHILE,
        _ => false,
    };
    match first.iter().enumerate().find(|(place, statement)| blocks(statement) || (*place > 0 && defines(statement))) {
        Some((place, statement)) if defines(statement) => {
            (place as u32, text.get(statement.span.start as usize..).map(str::to_owned))
        }
        _ => (count, None),
    }
}

fn is_one_line_if(statement: &Statement) -> bool {
    matches!(&statement.kind, StatementKind::If(condition) if condition.then.is_some())
}

/// The statements of a range one by one, but a one-line `IF` with all that follows it.
fn parts(tree: &Tree, range: &Range<u32>) -> Vec<Range<u32>> {
    let mut parts = Vec::new();
    for (index, statement) in range.clone().zip(statements(tree, range)) {
        if is_one_line_if(statement) {
            parts.push(index..range.end);
            return parts;
        }
        parts.push(index..index + 1);
    }
    parts
}

fn statements<'t>(tree: &'t Tree, range: &Range<u32>) -> &'t [Statement] {
    tree.statements().get(range.start as usize..range.end as usize).unwrap_or_default()
}

/// What the controller says of a mistake in a text.
pub(crate) fn complaint(text: &str, tree: &Tree, span: Span, kind: &CompileErrorKind) -> String {
    let statement = tree.statements().iter().find(|statement| Span::cover(statement.span, span) == statement.span);
    match kind {
        CompileErrorKind::Syntax => syntax_error(text, tree, statement),
        // `FOO = 5` begins with a word that means nothing.
        CompileErrorKind::UndefinedAlias(_)
            if statement.is_some_and(|statement| statement.span.start == span.start) =>
        {
            message::UNKNOWN_COMMAND.text().to_owned()
        }
        other => other.to_string(),
    }
}

fn syntax_error(text: &str, tree: &Tree, statement: Option<&Statement>) -> String {
    let unknown = || message::UNKNOWN_COMMAND.text().to_owned();
    let Some(statement) = statement else { return unknown() };
    let rest = text.get(statement.span.range()).unwrap_or_default();
    let end = rest.find(|character: char| !character.is_ascii_alphabetic()).unwrap_or(rest.len());
    if word(rest.get(..end).unwrap_or_default()).is_none_or(|word| word.command.is_none()) {
        return unknown();
    }
    let within = |span: Span| statement.span.start <= span.start && span.start <= statement.span.end;
    let told = tree.errors().iter().find(|error| within(error.span));
    let words = message::SYNTAX_ERROR.text();
    told.map_or_else(|| words.to_owned(), |error| format!("{words}: {}", error.message))
}
