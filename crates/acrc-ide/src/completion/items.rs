//! What fits each expectation.

use acrc_analysis::Db;
use acrc_catalog::{Command, CommandId, Keyword, Levels, ObjectKind, OperandClass, Shape, all_commands, all_functions};
use acrc_syntax::units::Level;

use super::context::{Context, Expected};
use super::{Completion, CompletionKind, Completions, named, numbers, snippets};
use crate::Entity;

/// Everything that fits.
pub(super) fn of(db: &dyn Db, context: &Context<'_>) -> Completions {
    let mut found = Completions::default();
    match context.expected {
        Expected::Nothing => {}
        Expected::Statement => statement(db, context, &mut found),
        Expected::Argument { id, first } => argument(db, context, id, first, &mut found),
        Expected::Expression => expression(db, context, &mut found),
        Expected::Target => target(db, context, &mut found),
    }
    found
}

fn statement(db: &dyn Db, context: &Context<'_>, found: &mut Completions) {
    commands(context, 1, found);
    found.items.extend(named::axes(db, context, 0));
    found.items.extend(named::aliases(db, context, None, 0));
    found.items.extend(named::variables(db, context, 2));
    found.items.extend(snippets::all(context));
}

/// The commands of the level, without their daughters.
fn commands(context: &Context<'_>, rank: u8, found: &mut Completions) {
    let fitting = all_commands()
        .filter(|row| row.parent.is_none() && !row.clause && !row.word.is_empty() && takes(context.level, row.levels));
    found.items.extend(fitting.filter(|row| begins(row.word, context.part)).map(|row| command(context, row, rank)));
}

/// The commands that may stand behind an object by its number: `AXIS0 JOG`.
fn commands_of(context: &Context<'_>, object: ObjectKind, found: &mut Completions) {
    let fitting = all_commands().filter(|row| row.parent.is_none() && !row.word.is_empty());
    let fitting = fitting.filter(|row| row.prefixes.contains(&object) && begins(row.word, context.part));
    found.items.extend(fitting.map(|row| command(context, row, 1)));
}

fn argument(db: &dyn Db, context: &Context<'_>, id: CommandId, first: bool, found: &mut Completions) {
    let info = id.info();
    if let Some(object) = ObjectKind::from_name(info.word).filter(|_| info.shape == Shape::Object) {
        commands_of(context, object, found);
    }
    if first || info.shape == Shape::Object {
        let daughters = info.daughters.iter().map(|id| id.info()).filter(|row| begins(row.word, context.part));
        found.items.extend(daughters.map(|row| command(context, row, 0)));
    }
    match info.shape {
        Shape::Target => found.items.extend(named::labels(db, context)),
        Shape::Bit | Shape::BitMove => {
            found.items.extend(named::aliases(db, context, Some(OperandClass::Bit), 0));
            numbers::bits(db, context, found);
        }
        Shape::Axes | Shape::AxisValues | Shape::AxisSources | Shape::Move => {
            found.items.extend(named::axes(db, context, 0));
        }
        Shape::Programs => found.items.extend(named::programs(db, context)),
        Shape::Object | Shape::Parent | Shape::None | Shape::Text | Shape::Label => {}
        _ => expression(db, context, found),
    }
    objects(context, info, found);
    // The next statement may stand behind this one without anything between.
    if info.shape == Shape::None || !first && info.shape != Shape::Object {
        commands(context, 4, found);
    }
}

/// Objects and words that the form of a command names.
fn objects(context: &Context<'_>, info: &Command, found: &mut Completions) {
    let words = info.signature.split(|c: char| !c.is_ascii_alphanumeric());
    for word in words {
        let kind = word.strip_suffix(['n', 'm']).and_then(ObjectKind::from_name);
        if let Some(kind) = kind.filter(|kind| begins(&kind.to_string(), context.part)) {
            found.items.push(Completion {
                detail: "object by number".to_owned(),
                entity: Some(Entity::Object { kind, number: None }),
                ..item(context, &kind.to_string(), CompletionKind::Object, 2)
            });
        }
        if let Some(keyword) = Keyword::from_name(word).filter(|keyword| begins(keyword.name(), context.part)) {
            found.items.push(Completion {
                entity: Some(Entity::Word(keyword)),
                ..item(context, keyword.name(), CompletionKind::Keyword, 1)
            });
        }
    }
}

/// An alias stands for no value, and for no other alias.
fn target(db: &dyn Db, context: &Context<'_>, found: &mut Completions) {
    found.items.extend(named::variables(db, context, 1));
    numbers::parameters(db, context, found);
    numbers::bits(db, context, found);
}

fn expression(db: &dyn Db, context: &Context<'_>, found: &mut Completions) {
    found.items.extend(named::aliases(db, context, None, 0));
    found.items.extend(named::variables(db, context, 1));
    let functions = all_functions().filter(|row| begins(row.name, context.part)).map(|row| Completion {
        detail: row.summary.to_owned(),
        insert: if row.max_args == 0 { row.name.to_owned() } else { format!("{}($1)$0", snippets::escaped(row.name)) },
        snippet: row.max_args > 0,
        entity: Some(Entity::Function(row.id)),
        ..item(context, row.name, CompletionKind::Function, 2)
    });
    found.items.extend(functions);
    numbers::parameters(db, context, found);
    numbers::bits(db, context, found);
}

fn command(context: &Context<'_>, row: &'static Command, rank: u8) -> Completion {
    Completion {
        detail: row.summary.to_owned(),
        entity: Some(Entity::Command(row.id)),
        ..item(context, row.word, CompletionKind::Command, rank)
    }
}

/// A completion that writes its label in place of the word.
pub(super) fn item(context: &Context<'_>, label: &str, kind: CompletionKind, rank: u8) -> Completion {
    Completion {
        label: label.to_owned(),
        kind,
        detail: String::new(),
        insert: label.to_owned(),
        snippet: false,
        span: context.span,
        filter: String::new(),
        rank,
        entity: None,
    }
}

/// Whether a word begins with what is typed, in any case.
pub(super) fn begins(word: &str, part: &str) -> bool {
    word.get(..part.len()).is_some_and(|beginning| beginning.eq_ignore_ascii_case(part))
}

fn takes(level: Level, levels: Levels) -> bool {
    match level {
        Level::System => levels.sys(),
        Level::Plc(_) => levels.plc(),
        // The prompt of a program takes commands of the system too.
        Level::Program(_) => levels.prog() || levels.sys(),
    }
}
