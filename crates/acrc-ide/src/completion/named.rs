//! What the project gives names to.

use acrc_analysis::index::AliasTarget;
use acrc_analysis::memory::{LocalBlock, project_memory};
use acrc_analysis::query::{exports, file_index, symbols};
use acrc_analysis::{Db, facts};
use acrc_catalog::OperandClass;
use acrc_syntax::units::Level;

use super::context::Context;
use super::items::{begins, item};
use super::{Completion, CompletionKind};
use crate::Entity;

/// The axes of the program.
pub(super) fn axes(db: &dyn Db, context: &Context<'_>, rank: u8) -> Vec<Completion> {
    let Some(table) = symbols(db, context.project).axes_at(context.level) else { return Vec::new() };
    let fitting = table.names.iter().filter(|(name, _)| begins(name, context.part));
    fitting
        .map(|(name, axis)| Completion {
            detail: axis.map_or_else(|| "axis".to_owned(), |axis| format!("axis {axis}")),
            entity: Some(Entity::Axis(context.level, name.clone())),
            ..item(context, name, CompletionKind::Axis, rank)
        })
        .collect()
}

/// The aliases, or those of a class.
pub(super) fn aliases(db: &dyn Db, context: &Context<'_>, class: Option<OperandClass>, rank: u8) -> Vec<Completion> {
    let fits = |target: AliasTarget| match (class, target) {
        (None, _) => true,
        (Some(wanted), AliasTarget::Operand(class, _)) => class == wanted,
        _ => false,
    };
    let all = symbols(db, context.project).aliases.iter();
    let fitting = all.filter(|alias| fits(alias.operand.target) && begins(&alias.name, context.part));
    fitting
        .map(|alias| Completion {
            detail: alias.operand.text.to_string(),
            entity: Some(Entity::Alias(alias.name.clone())),
            ..item(context, &alias.name, CompletionKind::Alias, rank)
        })
        .collect()
}

/// The labels and line numbers of the program.
pub(super) fn labels(db: &dyn Db, context: &Context<'_>) -> Vec<Completion> {
    let labels = facts::labels(db, context.project, context.level).into_iter().map(|label| Completion {
        detail: format!("label of {}", context.level),
        entity: Some(Entity::Label(context.level, label.name.clone())),
        ..item(context, &label.name, CompletionKind::Label, 0)
    });
    let files = context.project.files(db).iter();
    let sections = files.flat_map(|file| &file_index(db, *file).sections);
    let lines = sections.filter(|section| section.section.level == context.level).flat_map(|section| &section.lines);
    let lines = lines.map(|line| Completion {
        detail: format!("line of {}", context.level),
        entity: Some(Entity::Line(context.level, line.number)),
        ..item(context, &line.number.to_string(), CompletionKind::Label, 1)
    });
    labels.chain(lines).filter(|label| begins(&label.label, context.part)).collect()
}

/// The programs that the project holds.
pub(super) fn programs(db: &dyn Db, context: &Context<'_>) -> Vec<Completion> {
    let mut levels: Vec<Level> =
        context.project.files(db).iter().flat_map(|file| exports(db, *file).stored.iter().copied()).collect();
    levels.sort_unstable();
    levels.dedup();
    let names = levels.iter().filter(|level| **level != Level::System).map(ToString::to_string);
    names
        .filter(|name| begins(name, context.part))
        .map(|name| Completion {
            detail: "program of the project".to_owned(),
            ..item(context, &name, CompletionKind::Object, 0)
        })
        .collect()
}

/// The local variables that the program dimensions, a class each, with the numbers that exist.
pub(super) fn variables(db: &dyn Db, context: &Context<'_>, rank: u8) -> Vec<Completion> {
    let memory = project_memory(db, context.project);
    let Some((_, locals)) = memory.locals.iter().find(|(level, _)| *level == context.level) else { return Vec::new() };
    let mut found = Vec::new();
    for class in OperandClass::ALL.iter().copied().filter(|class| class.is_local() && locals.has(*class)) {
        let name = class.to_string();
        if !begins(&name, context.part) {
            continue;
        }
        let block = if class.is_array() { LocalBlock::References(class) } else { LocalBlock::Variables(class) };
        let count = locals.extent(block, 0).and_then(|extent| extent.count);
        let numbers = match count {
            Some(count @ 1..) => format!(", numbers 0 to {}", count - 1),
            _ => String::new(),
        };
        found.push(Completion {
            detail: format!("{}{numbers}", class.info().summary),
            entity: Some(Entity::Operand { class, number: None, level: Some(context.level) }),
            ..item(context, &name, CompletionKind::Variable, rank)
        });
    }
    found
}
