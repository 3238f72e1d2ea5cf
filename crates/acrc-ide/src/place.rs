//! Places in the files of a project.

use acrc_analysis::query::{file_index, parse};
use acrc_analysis::{Db, Project, SourceFile};
use acrc_diagnostics::Span;
use acrc_syntax::units::Level;

/// A place between two characters of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FilePosition {
    /// The project to which the file belongs, or which is only this file.
    pub project: Project,
    /// The file.
    pub file: SourceFile,
    /// Bytes from the start of its text.
    pub offset: u32,
}

/// A part of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FileRange {
    /// The file.
    pub file: SourceFile,
    /// The part.
    pub span: Span,
}

/// The statement that contains an offset or ends there: its index in the tree. Between two statements that touch it is
/// the second.
pub fn statement_at(db: &dyn Db, file: SourceFile, offset: u32) -> Option<u32> {
    let statements = parse(db, file).statements();
    let after = statements.partition_point(|statement| statement.span.start <= offset);
    let index = after.checked_sub(1)?;
    let statement = statements.get(index)?;
    (offset <= statement.span.end).then_some(index as u32)
}

/// The level at which a statement is entered; `PROGRAM` and `ENDP` have that of their text.
pub fn level_of(db: &dyn Db, file: SourceFile, statement: u32) -> Level {
    let sections = &file_index(db, file).sections;
    let holds = |section: &acrc_syntax::units::Section| {
        section.statements.contains(&statement)
            || section.opener == Some(statement)
            || section.closer == Some(statement)
    };
    let section = sections.iter().find(|section| holds(&section.section));
    section.map_or_else(|| file.role(db).start(), |section| section.section.level)
}
