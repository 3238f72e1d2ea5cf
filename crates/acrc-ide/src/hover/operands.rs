//! Parameters, flags and variables.

use acrc_analysis::memory::{LocalBlock, local_class, project_memory};
use acrc_analysis::query::{file_index, parse, symbols};
use acrc_analysis::{Db, Project, SourceFile, walk};
use acrc_catalog::OperandClass;
use acrc_diagnostics::Span;
use acrc_syntax::ast::{Dim, StatementKind};
use acrc_syntax::units::Level;

use super::{entry, title};

/// The page of an operand, with the alias that the project gives it.
pub(super) fn operand(
    db: &dyn Db,
    project: Project,
    class: OperandClass,
    number: Option<u64>,
    level: Option<Level>,
) -> String {
    let mut page = vec![match (level, number) {
        (Some(level), Some(number)) => local(db, project, class, number, level),
        _ => entry(class, number).markdown(),
    }];
    if let Some(alias) = number.and_then(|number| symbols(db, project).alias_for(class, number)) {
        page.push(format!("- alias: `{}`\n", alias.name));
    }
    page.concat()
}

/// A local variable or array: what it is, and what dimensions it.
fn local(db: &dyn Db, project: Project, class: OperandClass, number: u64, level: Level) -> String {
    let info = class.info();
    let mut page = vec![format!("**{class}{number}** — {}, of {level} alone\n\n", info.summary)];
    let dims = dims(db, project, class, number, level);
    for (file, dim) in &dims {
        let text = file.text(db).get(dim.range()).unwrap_or_default();
        page.push(format!("- `{text}` in {}\n", file.name(db)));
    }
    let memory = project_memory(db, project);
    let locals = memory.locals.iter().find(|(at, _)| *at == level).map(|(_, locals)| locals);
    let (block, array) = if class.is_array() {
        (LocalBlock::Array(class), u32::try_from(number).unwrap_or(u32::MAX))
    } else {
        (LocalBlock::Variables(class), 0)
    };
    match locals.and_then(|locals| locals.extent(block, array)).and_then(|extent| extent.count) {
        Some(0) => page.push("- it has no elements\n".to_owned()),
        Some(count) if class.is_array() => page.push(format!("- elements 0 to {}\n", count - 1)),
        Some(count) => page.push(format!("- numbers 0 to {}\n", count - 1)),
        None if dims.is_empty() => page.push("- nothing in the project dimensions it\n".to_owned()),
        None => {}
    }
    if !info.storage.is_empty() {
        page.push(format!("- storage: {}\n", info.storage));
    }
    page.concat()
}

/// The statements that dimension a local variable, or the array.
fn dims(db: &dyn Db, project: Project, class: OperandClass, number: u64, level: Level) -> Vec<(SourceFile, Span)> {
    let matches = |dim: &Dim| {
        local_class(dim.id) == Some(class)
            && dim.index.as_ref().and_then(walk::whole).is_none_or(|index| index == number)
    };
    let mut found = Vec::new();
    for file in project.files(db) {
        let statements = parse(db, *file).statements();
        for section in file_index(db, *file).sections.iter().filter(|section| section.section.level == level) {
            let range = section.section.statements.start as usize..section.section.statements.end as usize;
            let dims = statements
                .get(range)
                .unwrap_or_default()
                .iter()
                .filter(|statement| matches!(&statement.kind, StatementKind::Dim(dim) if matches(dim)));
            found.extend(dims.map(|statement| (*file, statement.span)));
        }
    }
    found
}

/// An operand as a person reads it: `BIT32 (Output 0)`.
pub(super) fn described(class: OperandClass, number: u64) -> String {
    let written = format!("`{class}{number}`");
    match title(class, number) {
        Some(title) => format!("{written} ({title})"),
        None => written,
    }
}
