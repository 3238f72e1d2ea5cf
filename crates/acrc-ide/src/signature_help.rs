//! The form of the command or function whose arguments are being written, and which of them comes next.

use std::ops::Range;

use acrc_analysis::query::parse;
use acrc_analysis::{Db, SourceFile};
use acrc_catalog::{CommandId, FunctionId, OperandClass, Shape};
use acrc_syntax::ast::{Argument, StatementKind};

use crate::typed::{Head, Typed};

/// A form with its arguments.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SignatureHelp {
    /// The form, in the notation of the guide.
    pub label: String,
    /// What it does.
    pub summary: String,
    /// Its arguments in order.
    pub arguments: Vec<ArgumentHelp>,
    /// The place in `arguments` of the one that is being written.
    pub active: Option<u32>,
}

/// An argument of a form.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ArgumentHelp {
    /// Where its name stands in the form, in bytes; `None` when the form does not name it.
    pub label: Option<Range<u32>>,
    /// Kind, unit, range and default.
    pub facts: String,
}

/// The form of what is being written at a place. `None` in remarks and texts, and where nothing takes arguments.
pub fn signature_help(db: &dyn Db, file: SourceFile, offset: u32) -> Option<SignatureHelp> {
    let typed = Typed::before(db, file, offset)?;
    let mut end = typed.tokens.len();
    // From the innermost parenthesis outwards: one that only groups has no meaning of its own.
    while let Some((open, commas)) = typed.open_paren(end) {
        match typed.head(open) {
            Head::Function(id) => return Some(function(id, commas)),
            Head::Operand(class) => {
                let dim = typed.command(db, file, offset).filter(|id| id.info().shape == Shape::Dim);
                return Some(dim.map_or_else(|| operand(class), |id| command_help(id, commas)));
            }
            Head::Argument => {
                let id = typed.command(db, file, offset)?;
                return Some(command_help(id, commas));
            }
            Head::Group => end = open,
        }
    }
    let id = typed.command(db, file, offset)?;
    Some(command_help(id, written(db, file, offset, id)))
}

/// Which argument of a command comes next, outside of parentheses.
fn written(db: &dyn Db, file: SourceFile, offset: u32, id: CommandId) -> u32 {
    let statements = parse(db, file).statements();
    let after = statements.partition_point(|statement| statement.span.start < offset);
    let statement = after.checked_sub(1).and_then(|place| statements.get(place));
    match statement.map(|statement| &statement.kind) {
        Some(StatementKind::Command(written)) if id.info().shape == Shape::Values => {
            let values = written.arguments.iter().filter_map(|argument| match argument {
                Argument::Value(value) => Some(value.span),
                _ => None,
            });
            values.filter(|span| span.end < offset).count() as u32
        }
        _ => 0,
    }
}

fn command_help(id: CommandId, active: u32) -> SignatureHelp {
    let info = id.info();
    let arguments: Vec<ArgumentHelp> = info
        .arguments
        .iter()
        .map(|argument| ArgumentHelp {
            label: place_of(info.signature, argument.name),
            facts: facts(&[
                ("", argument.kind),
                ("in ", argument.unit),
                ("range ", argument.range),
                ("default ", argument.default),
            ]),
        })
        .collect();
    let active = Some(active).filter(|active| (*active as usize) < arguments.len());
    SignatureHelp { label: info.signature.to_owned(), summary: info.summary.to_owned(), arguments, active }
}

fn function(id: FunctionId, commas: u32) -> SignatureHelp {
    let info = id.info();
    let mut label = format!("{}(", info.name);
    let mut arguments = Vec::new();
    for (place, class) in info.argument_types.iter().enumerate() {
        label += if place > 0 { ", " } else { "" };
        let start = label.len() as u32;
        label += class.name();
        let optional = if place >= usize::from(info.min_args) { "may be left out" } else { "" };
        let facts = facts(&[("", class.name()), ("", optional), ("", info.domain)]);
        arguments.push(ArgumentHelp { label: Some(start..label.len() as u32), facts });
    }
    label += ")";
    let active = Some(commas).filter(|active| (*active as usize) < arguments.len());
    SignatureHelp { label, summary: info.summary.to_owned(), arguments, active }
}

fn operand(class: OperandClass) -> SignatureHelp {
    let info = class.info();
    let argument = ArgumentHelp { label: None, facts: facts(&[("numbers ", info.index)]) };
    SignatureHelp {
        label: info.name.to_owned(),
        summary: info.summary.to_owned(),
        arguments: vec![argument],
        active: Some(0),
    }
}

/// Where a name stands in a form, as a word of its own.
fn place_of(signature: &str, name: &str) -> Option<Range<u32>> {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let at = signature.match_indices(name).map(|(at, _)| at).find(|at| {
        let before = signature.get(..*at).and_then(|text| text.chars().next_back());
        let behind = signature.get(at + name.len()..).and_then(|text| text.chars().next());
        !before.is_some_and(is_word) && !behind.is_some_and(is_word)
    })?;
    Some(at as u32..(at + name.len()) as u32)
}

/// The facts that are known, with what introduces them.
fn facts(facts: &[(&str, &str)]) -> String {
    let known = facts.iter().filter(|(_, fact)| !fact.is_empty());
    known.map(|(word, fact)| format!("{word}{fact}")).collect::<Vec<_>>().join(", ")
}
