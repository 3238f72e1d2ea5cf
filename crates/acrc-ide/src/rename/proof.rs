//! The proof that another name changes nothing but names.

use acrc_analysis::query::parse;
use acrc_analysis::{Database, Db, Project, SourceFile};
use acrc_diagnostics::{Fix, Severity, apply};

use super::{RenameError, place};
use crate::edits::FileEdits;
use crate::{Entity, Occurrence, in_file};

/// Refuses edits with which something would be read differently.
pub(super) fn check(
    db: &dyn Db,
    project: Project,
    edits: &[FileEdits],
    old: &Entity,
    new: &Entity,
) -> Result<(), RenameError> {
    let scratch = Database::new();
    let files: Vec<SourceFile> = project.files(db).iter().map(|file| edited(db, &scratch, *file, edits)).collect();
    let renamed = Project::new(&scratch, files.clone(), project.model(db), project.config(db).clone());
    for (before, after) in project.files(db).iter().zip(files) {
        let (known, found) = (in_file(db, project, *before), in_file(&scratch, renamed, after));
        let is_same = |known: &Occurrence, found: &Occurrence| {
            let entity = if known.entity == *old { new } else { &known.entity };
            *entity == found.entity && known.role == found.role && known.statement == found.statement
        };
        let same = known.iter().zip(&found).take_while(|(known, found)| is_same(known, found)).count();
        let errors = |db: &dyn Db, file: SourceFile| {
            parse(db, file).errors().iter().filter(|error| error.severity == Severity::Error).count()
        };
        if same < known.len().max(found.len()) || errors(db, *before) != errors(&scratch, after) {
            let span = known.get(same.min(known.len().saturating_sub(1))).map(|known| known.span).unwrap_or_default();
            let place = place(db, *before, span);
            return Err(format!("with this name the text at {place} would mean something else").into());
        }
    }
    Ok(())
}

fn edited(db: &dyn Db, scratch: &Database, file: SourceFile, edits: &[FileEdits]) -> SourceFile {
    let own = edits.iter().find(|(edited, _)| *edited == file).map(|(_, edits)| edits.clone());
    let text = match own {
        // Edits that overlap change nothing, which is not what was asked for, and so is found out.
        Some(own) => apply(file.text(db), &[&Fix::safe("rename", own)]).unwrap_or_default(),
        None => file.text(db).to_owned(),
    };
    SourceFile::new(scratch, file.name(db).to_owned(), text, file.role(db), Vec::new())
}
