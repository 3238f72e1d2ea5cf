//! Renaming: labels within their program, aliases everywhere, axis names within their program with the `ATTACH` that
//! gives them.
//!
//! A renamed project compiles to the same image, names aside. That is proved each time: the renamed text is read again,
//! and everything with a name must be what it was, at the same statement.

mod names;
mod proof;

use std::error::Error;
use std::fmt;

use acrc_analysis::query::{exports, parse, symbols};
use acrc_analysis::{Db, Project, SourceFile};
use acrc_diagnostics::{Edit, LineIndex, Severity, Span};
use acrc_syntax::units::Level;

use crate::edits::{FileEdits, spaced};
use crate::place::slice;
use crate::{Entity, FilePosition, Occurrence, Role, at, in_file};

/// Why something cannot be renamed, as a sentence without a period.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RenameError(String);

impl fmt::Display for RenameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl Error for RenameError {}

impl From<String> for RenameError {
    fn from(message: String) -> Self {
        Self(message)
    }
}

/// The name at a place that can be renamed.
///
/// # Errors
/// When nothing with a name of its own stands there, when nothing declares it, and when some file that may use it cannot
/// be read.
pub fn prepare_rename(db: &dyn Db, position: FilePosition) -> Result<Span, RenameError> {
    named_at(db, position).map(|occurrence| occurrence.span)
}

/// Gives what stands at a place another name. The edits of each file are in the order of the text; there are none when it
/// has that name.
///
/// # Errors
/// As [`prepare_rename`], when the rules forbid the name, when something has it, and when some line would mean something
/// else with it.
pub fn rename(db: &dyn Db, position: FilePosition, name: &str) -> Result<Vec<FileEdits>, RenameError> {
    let FilePosition { project, file, .. } = position;
    let occurrence = named_at(db, position)?;
    if slice(file.text(db), occurrence.span) == name {
        return Ok(Vec::new());
    }
    let old = occurrence.entity;
    names::check(db, project, &old, name)?;
    let new = renamed(&old, name);
    let mut edits = Vec::new();
    for &file in project.files(db) {
        let own = in_file(db, project, file);
        // The name of an axis in other letters is the same name.
        if let Some(taken) = own.iter().find(|other| other.entity == new && new != old) {
            let place = place(db, file, taken.span);
            return Err(RenameError(format!("`{name}` is taken: it stands at {place}")));
        }
        let own = own.iter().filter(|other| other.entity == old);
        let own: Vec<Edit> = own.map(|other| edit(file.text(db), other, name)).collect();
        if !own.is_empty() {
            edits.push((file, own));
        }
    }
    proof::check(db, project, &edits, &old, &new)?;
    Ok(edits)
}

/// The thing with another name.
fn renamed(entity: &Entity, name: &str) -> Entity {
    match entity {
        Entity::Axis(level, _) => Entity::Axis(*level, name.to_ascii_uppercase().into()),
        Entity::Label(level, _) => Entity::Label(*level, name.into()),
        _ => Entity::Alias(name.into()),
    }
}

fn edit(text: &str, occurrence: &Occurrence, name: &str) -> Edit {
    let is_axis = matches!(occurrence.entity, Entity::Axis(..));
    let text = match occurrence.role {
        Role::Define => name.to_owned(),
        // The value of an axis touches its name.
        _ if is_axis => spaced(text, occurrence.span, name).trim_end().to_owned(),
        _ => spaced(text, occurrence.span, name),
    };
    Edit::replace(occurrence.span, text)
}

fn named_at(db: &dyn Db, position: FilePosition) -> Result<Occurrence, RenameError> {
    let FilePosition { project, file, .. } = position;
    let nothing = || RenameError("only labels, aliases and axis names can be renamed".to_owned());
    let occurrence = at(db, position).ok_or_else(nothing)?;
    let name = slice(file.text(db), occurrence.span);
    let level = match &occurrence.entity {
        Entity::Alias(name) if symbols(db, project).alias(name).is_some() => None,
        Entity::Alias(_) => return Err(format!("no #DEFINE gives the alias `{name}`").into()),
        Entity::Axis(level, _) => {
            if !symbols(db, project).axes_at(*level).is_some_and(|axes| axes.has(name)) {
                return Err(format!("no ATTACH SLAVE of {level} names an axis `{name}`").into());
            }
            Some(*level)
        }
        Entity::Label(level, _) => {
            if crate::definition::declarations(db, project, &occurrence.entity).is_empty() {
                return Err(format!("{level} has no label `{name}`").into());
            }
            Some(*level)
        }
        _ => return Err(nothing()),
    };
    readable(db, project, level)?;
    Ok(occurrence)
}

/// Refuses when a file cannot be read in which the name may stand: in all of them, or where a program has code.
fn readable(db: &dyn Db, project: Project, level: Option<Level>) -> Result<(), RenameError> {
    let may_use = |file: &&SourceFile| level.is_none_or(|level| exports(db, **file).levels.contains(&level));
    for &file in project.files(db).iter().filter(may_use) {
        if let Some(error) = parse(db, file).errors().iter().find(|error| error.severity == Severity::Error) {
            let place = place(db, file, error.span);
            return Err(format!("the name may stand in what can't be read at {place}: {}", error.message).into());
        }
    }
    Ok(())
}

/// A place as people name it: `Setup.8K:2:9`.
fn place(db: &dyn Db, file: SourceFile, span: Span) -> String {
    format!("{}:{}", file.name(db), LineIndex::new(file.text(db)).position(span.start))
}
