//! Places in the files of a project.

use std::ops::Range;

use acrc_analysis::query::{file_index, parse};
use acrc_analysis::{Db, Project, SectionIndex, SourceFile};
use acrc_diagnostics::Span;
use acrc_syntax::Tree;
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
    section_of(db, file, statement).map_or_else(|| file.role(db).start(), |section| section.section.level)
}

/// The section to which a statement belongs; `PROGRAM` and `ENDP` belong to their text.
pub(crate) fn section_of(db: &dyn Db, file: SourceFile, statement: u32) -> Option<&SectionIndex> {
    file_index(db, file).sections.iter().find(|index| {
        let section = &index.section;
        section.statements.contains(&statement)
            || section.opener == Some(statement)
            || section.closer == Some(statement)
    })
}

/// The lines that a part of a file touches: a range of indices into those of the tree.
pub(crate) fn lines_in(tree: &Tree, part: Span) -> Range<usize> {
    let first = line_at(tree, part.start);
    // What ends where a line begins does not touch it.
    let last = if part.is_empty() { first } else { line_at(tree, part.end - 1) };
    first..last + 1
}

/// The index of the line on which an offset stands.
pub(crate) fn line_at(tree: &Tree, offset: u32) -> usize {
    tree.lines().partition_point(|line| line.span.start <= offset).saturating_sub(1)
}

/// The text at a place; nothing for a place that is outside of it or within a character.
pub(crate) fn slice(text: &str, span: Span) -> &str {
    text.get(span.range()).unwrap_or_default()
}
