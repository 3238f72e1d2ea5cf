//! The queries that the database remembers.

use super::events::{self, MemoryEvents, MemorySites};
use super::play::{Part, ProjectMemory, play};
use super::text::{self, SectionBytes};
use super::view::MemoryView;
use crate::query::{exports, file_index, parse, symbols};
use crate::{Db, Project, SourceFile};

#[salsa::tracked(returns(ref), no_eq)]
pub(crate) fn memory_index(db: &dyn Db, file: SourceFile) -> (MemoryEvents, MemorySites) {
    events::collect(parse(db, file), file_index(db, file))
}

/// Where the events of a file stand.
pub(crate) fn memory_sites(db: &dyn Db, file: SourceFile) -> &MemorySites {
    &memory_index(db, file).1
}

/// What a file does to memory.
#[salsa::tracked(returns(ref))]
pub(super) fn memory_events(db: &dyn Db, file: SourceFile) -> MemoryEvents {
    memory_index(db, file).0.clone()
}

/// The exact bytes of the stored texts of a file, by section.
#[salsa::tracked(returns(deref))]
pub fn text_bytes(db: &dyn Db, file: SourceFile) -> Vec<SectionBytes> {
    text::bytes(file.text(db), parse(db, file), file_index(db, file))
}

/// What the files of a project make of the memory.
#[salsa::tracked(returns(ref))]
pub fn project_memory(db: &dyn Db, project: Project) -> ProjectMemory {
    let files = project.files(db);
    let exact: Vec<_> = files.iter().map(|file| move || text_bytes(db, *file)).collect();
    let part = |(file, exact): (&SourceFile, _)| Part { events: memory_events(db, *file), exact };
    let parts: Vec<_> = files.iter().zip(exact.iter().map(|exact| exact as _)).map(part).collect();
    let mut memory = play(&parts, project.model(db));
    memory.count_aliases(symbols(db, project));
    memory
}

/// What `file` needs to know of the memory of the project.
#[salsa::tracked(returns(ref))]
pub fn memory_view(db: &dyn Db, project: Project, file: SourceFile) -> MemoryView {
    let files = project.files(db);
    let place = files.iter().position(|other| *other == file).unwrap_or(files.len());
    MemoryView::new(project_memory(db, project), place as u32, &exports(db, file).levels)
}
