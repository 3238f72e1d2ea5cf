//! Where something is used.

use acrc_analysis::index::AliasTarget;
use acrc_analysis::query::symbols;
use acrc_analysis::{Db, Project, SourceFile};
use acrc_diagnostics::Span;

use crate::definition::declarations;
use crate::{Entity, FilePosition, FileRange, Role, at, everywhere};

/// Where what stands at a place is used in the project, in the order of the files; with its declarations where they are
/// wanted. A parameter or flag is used through its aliases too.
pub fn references(db: &dyn Db, position: FilePosition, with_declarations: bool) -> Vec<FileRange> {
    let Some(occurrence) = at(db, position) else { return Vec::new() };
    let project = position.project;
    let mut found = Vec::new();
    for entity in std::iter::once(occurrence.entity.clone()).chain(aliases(db, project, &occurrence.entity)) {
        for (file, occurrence) in everywhere(db, project, &entity) {
            if with_declarations || occurrence.role != Role::Define {
                found.push(FileRange { file, span: occurrence.span });
            }
        }
    }
    if with_declarations {
        let dims = declarations(db, project, &occurrence.entity);
        found.extend(dims.iter().map(|target| FileRange { file: target.file, span: target.name }));
    }
    in_order(db, project, &mut found);
    found
}

/// The aliases of a parameter or flag.
fn aliases(db: &dyn Db, project: Project, entity: &Entity) -> Vec<Entity> {
    let Entity::Operand { class, number: Some(number), level: None } = entity else { return Vec::new() };
    let aliases = symbols(db, project).aliases.iter();
    let own = aliases.filter(|alias| alias.operand.target == AliasTarget::Operand(*class, Some(*number)));
    own.map(|alias| Entity::Alias(alias.name.clone())).collect()
}

fn in_order(db: &dyn Db, project: Project, found: &mut Vec<FileRange>) {
    let place = |file: SourceFile| project.files(db).iter().position(|known| *known == file);
    found.sort_by_key(|range| (place(range.file), range.span));
    found.dedup();
}

/// What is done with something that is highlighted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Access {
    /// It stands there: a word of the language, a label.
    Text,
    /// It is read.
    Read,
    /// It is declared or gets another value.
    Write,
}

/// The other places of a file at which what stands at a place occurs, with this one. Of a word that opens, branches or
/// closes a block all words of the block; of `PROGRAM` and `ENDP` both.
pub fn highlights(db: &dyn Db, position: FilePosition) -> Vec<(Span, Access)> {
    let Some(occurrence) = at(db, position) else { return Vec::new() };
    let FilePosition { project, file, .. } = position;
    if matches!(occurrence.entity, Entity::Command(_))
        && let Some(parts) = block_parts(db, position, occurrence.statement)
    {
        return parts.into_iter().map(|span| (span, Access::Text)).collect();
    }
    let same = crate::in_file(db, project, file).into_iter().filter(|other| other.entity == occurrence.entity);
    same.map(|other| (other.span, access(&other.entity, other.role))).collect()
}

fn access(entity: &Entity, role: Role) -> Access {
    match (entity, role) {
        (Entity::Command(_) | Entity::Function(_) | Entity::Word(_), _) => Access::Text,
        (_, Role::Write | Role::Define) => Access::Write,
        _ => Access::Read,
    }
}

/// The words that belong together with a statement: `IF`, `ELSE` and `ENDIF` of a block, `PROGRAM` and `ENDP`.
fn block_parts(db: &dyn Db, position: FilePosition, statement: u32) -> Option<Vec<Span>> {
    let FilePosition { project, file, .. } = position;
    let section = crate::place::section_of(db, file, statement)?;
    let own = &section.section;
    let parts: Vec<u32> = if own.opener == Some(statement) || own.closer == Some(statement) {
        own.opener.into_iter().chain(own.closer).collect()
    } else {
        let block = section.blocks.block_of(statement)?;
        std::iter::once(block.opener).chain(block.branches.iter().copied()).chain(block.closer).collect()
    };
    let statements = acrc_analysis::query::parse(db, file).statements();
    let word = |part: u32| {
        let span = statements.get(part as usize)?.span;
        let all = crate::occurrence::in_span(db, project, file, Span::new(span.start, span.start + 1));
        all.into_iter().find(|other| other.statement == part && matches!(other.entity, Entity::Command(_)))
    };
    Some(parts.into_iter().filter_map(word).map(|word| word.span).collect())
}
