//! Which names the rules forbid.

use acrc_analysis::query::symbols;
use acrc_analysis::{Db, Project};
use acrc_catalog::{check_alias_name, check_axis_name};
use acrc_syntax::units::Level;

use super::RenameError;
use crate::Entity;

/// Refuses a name that something of its kind may not have, or that means something else somewhere.
pub(super) fn check(db: &dyn Db, project: Project, entity: &Entity, name: &str) -> Result<(), RenameError> {
    match entity {
        Entity::Label(..) => check_label(name),
        Entity::Axis(level, old) => check_axis(db, project, *level, old, name),
        _ => check_alias(db, project, name),
    }
}

/// A label has letters and digits (guide, "Program Labels"). One that begins with a digit would read as a line number.
fn check_label(name: &str) -> Result<(), RenameError> {
    if let Some(odd) = name.chars().find(|c| !c.is_ascii_alphanumeric()) {
        return Err(format!("the label `{name}` has a `{odd}`; only letters and digits may be in it").into());
    }
    match name.chars().next() {
        None => Err("a label needs a name".to_owned().into()),
        Some(first) if first.is_ascii_digit() => {
            Err(format!("the label `{name}` begins with a digit: a jump to it would read as one to a line").into())
        }
        Some(_) => Ok(()),
    }
}

fn check_alias(db: &dyn Db, project: Project, name: &str) -> Result<(), RenameError> {
    if name.is_empty() {
        return Err("an alias needs a name".to_owned().into());
    }
    check_alias_name(name, project.model(db)).map_err(|problem| format!("the alias `{name}` {problem}"))?;
    let axes = &symbols(db, project).axes;
    match axes.iter().find(|(_, axes)| axes.has(name)) {
        Some((level, _)) => Err(format!("`{name}` is an axis of {level}: there the word would be the axis").into()),
        None => Ok(()),
    }
}

fn check_axis(db: &dyn Db, project: Project, level: Level, old: &str, name: &str) -> Result<(), RenameError> {
    check_axis_name(name).map_err(|problem| format!("the axis name `{name}` {problem}"))?;
    let symbols = symbols(db, project);
    // The same name in other letters takes nothing that it had not.
    if name.eq_ignore_ascii_case(old) {
        return Ok(());
    }
    if symbols.axes_at(level).is_some_and(|axes| axes.has(name)) {
        return Err(format!("{level} has an axis `{name}`").into());
    }
    match symbols.aliases.iter().find(|alias| alias.name.eq_ignore_ascii_case(name)) {
        Some(alias) => Err(format!("`{}` is an alias: in {level} the word would be the axis", alias.name).into()),
        None => Ok(()),
    }
}
