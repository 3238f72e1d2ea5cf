//! What the stored programs of a file take of their memory.

use acrc_analysis::memory::{project_memory, text_bytes};
use acrc_analysis::query::{file_index, parse};
use acrc_analysis::{Db, Project, SourceFile};
use acrc_diagnostics::Span;
use acrc_syntax::units::{Level, SectionKind};

/// A stored program and the bytes of its text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ProgramUsage {
    /// Which it is.
    pub level: Level,
    /// Its `PROGRAM`, or its first statement where there is none.
    pub start: Span,
    /// Its `ENDP`, or its last statement where there is none.
    pub end: Span,
    /// Index of its section in the file.
    pub section: usize,
    /// Bytes of its text.
    pub bytes: u64,
    /// Bytes that it has, where the setup says so.
    pub space: Option<u64>,
}

/// The stored programs of a file in the order of the text, those without statements left out.
pub fn programs(db: &dyn Db, project: Project, file: SourceFile) -> Vec<ProgramUsage> {
    let statements = parse(db, file).statements();
    let span = |statement: u32| statements.get(statement as usize).map(|statement| statement.span);
    let memory = project_memory(db, project);
    let sections = file_index(db, file).sections.iter().zip(text_bytes(db, file)).enumerate();
    let programs = sections.filter_map(|(place, (section, bytes))| {
        let (index, section) = (place, &section.section);
        if section.kind != SectionKind::Stored || section.statements.is_empty() {
            return None;
        }
        Some(ProgramUsage {
            level: section.level,
            start: span(section.opener.unwrap_or(section.statements.start))?,
            end: span(section.closer.unwrap_or(section.statements.end - 1))?,
            section: index,
            bytes: bytes.total(),
            space: memory.space_of(section.level),
        })
    });
    programs.collect()
}
