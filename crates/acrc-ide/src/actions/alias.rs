//! Names for numbers: an alias in place of a parameter or flag, or a new one.

use acrc_analysis::query::{file_index, parse, symbols};
use acrc_analysis::{Db, Project, SourceFile};
use acrc_catalog::{OperandClass, check_alias_name, command};
use acrc_diagnostics::{Applicability, Edit, Span};
use acrc_syntax::ast::{Dim, StatementKind};
use acrc_syntax::units::Level;

use super::{ActionKind, CodeAction, Request};
use crate::edits::{FileEdits, line_break, spaced};
use crate::place::{line_at, slice};
use crate::{Entity, FilePosition, Occurrence, everywhere};

/// The longest alias that is proposed, in letters.
const LONGEST: usize = 24;

/// How many aliases a new table has room for.
const ROOM: u32 = 10;

pub(super) fn add(request: &Request<'_>, actions: &mut Vec<CodeAction>) {
    let Request { db, project, file, part, .. } = *request;
    let Some(occurrence) = crate::at(db, FilePosition { project, file, offset: part.start }) else { return };
    let Entity::Operand { class, number: Some(number), level: None } = occurrence.entity else { return };
    if defines(db, file, &occurrence) {
        return;
    }
    let operand = if class == OperandClass::Bit { format!("BIT{number}") } else { format!("P{number}") };
    let uses = uses(db, project, &occurrence.entity);
    let used = uses.iter().map(|(_, spans)| spans.len()).sum::<usize>();
    if let Some(alias) = symbols(db, project).alias_for(class, number) {
        if is_axis(db, project, &alias.name) {
            return;
        }
        let own = vec![(file, vec![named(request.text, occurrence.span, &alias.name)])];
        actions.push(action(request, ActionKind::Rewrite, format!("Write `{}` for {operand}", alias.name), own));
        if used > 1 {
            let title = format!("Write `{}` for {operand} in all {used} places", alias.name);
            actions.push(action(request, ActionKind::Rewrite, title, replaced(db, &uses, &alias.name)));
        }
        return;
    }
    let name = proposed(db, project, class, number);
    let Some(define) = definition(db, project, &format!("#DEFINE {name} {operand}")) else { return };
    let everywhere = with(replaced(db, &uses, &name), define.clone());
    let title = format!("Extract {operand} into the alias `{name}`");
    actions.push(action(request, ActionKind::Extract, title, everywhere));
    if used > 1 {
        let own = with(vec![(file, vec![named(request.text, occurrence.span, &name)])], define);
        let title = format!("Extract {operand} into the alias `{name}`, in this place only");
        actions.push(action(request, ActionKind::Extract, title, own));
    }
}

/// A name in place of a number means the same.
fn action(request: &Request<'_>, kind: ActionKind, title: String, edits: Vec<FileEdits>) -> CodeAction {
    CodeAction { edits, applicability: Applicability::Safe, ..request.here(kind, title, Vec::new()) }
}

/// Whether an occurrence stands in a `#DEFINE`.
fn defines(db: &dyn Db, file: SourceFile, occurrence: &Occurrence) -> bool {
    let statement = parse(db, file).statements().get(occurrence.statement as usize);
    statement.is_some_and(|statement| matches!(statement.kind, StatementKind::Define(_)))
}

fn is_axis(db: &dyn Db, project: Project, name: &str) -> bool {
    symbols(db, project).axes.iter().any(|(_, axes)| axes.open || axes.has(name))
}

/// Where a number is used in the project, definitions aside.
fn uses(db: &dyn Db, project: Project, entity: &Entity) -> Vec<(SourceFile, Vec<Span>)> {
    let mut uses: Vec<(SourceFile, Vec<Span>)> = Vec::new();
    for (file, occurrence) in everywhere(db, project, entity) {
        if defines(db, file, &occurrence) {
            continue;
        }
        match uses.last_mut() {
            Some((last, spans)) if *last == file => {
                // `SET BIT(5)` is one place, though the statement and the expression both name it.
                if spans.last().is_none_or(|last| last.end <= occurrence.span.start) {
                    spans.push(occurrence.span);
                }
            }
            _ => uses.push((file, vec![occurrence.span])),
        }
    }
    uses
}

fn replaced(db: &dyn Db, uses: &[(SourceFile, Vec<Span>)], name: &str) -> Vec<FileEdits> {
    let edits = |(file, spans): &(SourceFile, Vec<Span>)| {
        (*file, spans.iter().map(|span| named(file.text(db), *span, name)).collect())
    };
    uses.iter().map(edits).collect()
}

/// A name in place of a number; the sign of an `INH` belongs to the statement.
fn named(text: &str, span: Span, name: &str) -> Edit {
    let number = slice(text, span).trim_start_matches(|c: char| c == '-' || c == '+' || c.is_whitespace());
    let span = Span::new(span.end - number.len() as u32, span.end);
    Edit::replace(span, spaced(text, span, name))
}

/// Edits with those of a definition, each file once and in the order of its text.
fn with(mut edits: Vec<FileEdits>, (file, define): FileEdits) -> Vec<FileEdits> {
    match edits.iter_mut().find(|(other, _)| *other == file) {
        Some((_, own)) => own.extend(define),
        None => edits.push((file, define)),
    }
    for (_, own) in &mut edits {
        own.sort_by_key(|edit| edit.span);
    }
    edits
}

/// A free name made of what the catalogue calls the number; `Flag` and `Value` where it calls it nothing.
fn proposed(db: &dyn Db, project: Project, class: OperandClass, number: u64) -> String {
    let small = u32::try_from(number).unwrap_or(u32::MAX);
    let (title, default) = match class {
        OperandClass::Bit => (acrc_catalog::bit(small).title, "Flag"),
        _ => (acrc_catalog::parameter(small).title, "Value"),
    };
    let mut name = String::new();
    for word in title.split(|c: char| !c.is_ascii_alphabetic()).filter(|word| !word.is_empty()) {
        let (first, rest) = word.split_at(1);
        let word = format!("{}{}", first.to_ascii_uppercase(), rest.to_ascii_lowercase());
        if name.len() + word.len() < LONGEST {
            name.push_str(&word);
        }
    }
    let symbols = symbols(db, project);
    let is_free = |name: &str| {
        let same = |other: &str| other.eq_ignore_ascii_case(name);
        check_alias_name(name, project.model(db)).is_ok()
            && !symbols.aliases.iter().any(|alias| same(&alias.name))
            && !is_axis(db, project, name)
            && !project
                .files(db)
                .iter()
                .any(|file| acrc_analysis::query::exports(db, *file).uses.iter().any(|(used, _)| same(used)))
    };
    if !is_free(&name) && name.len() < 2 {
        default.clone_into(&mut name);
    }
    // Letters are all that every model takes.
    let stem = name.clone();
    let mut candidates = std::iter::once(stem.clone()).chain(('A'..='Z').map(|letter| format!("{stem}{letter}")));
    candidates.find(|name| is_free(name)).unwrap_or(stem)
}

/// Where the project has its definitions: below the last one of the first file with some, else at the start of what is
/// typed at the SYS prompt, with room for a table where nothing makes it. `None` where a project has neither.
fn definition(db: &dyn Db, project: Project, line: &str) -> Option<FileEdits> {
    for &file in project.files(db) {
        let (text, tree) = (file.text(db), parse(db, file));
        if let Some(last) = file_index(db, file).defines.last() {
            let place = tree.lines().get(line_at(tree, last.name.start))?.span.end;
            return Some((file, vec![Edit::insert(place, format!("{}{line}", line_break(text, tree, place)))]));
        }
    }
    let is_table = |dim: &Dim| dim.id == command::DIM_DEF;
    let statements = |file: &SourceFile| parse(db, *file).statements().iter();
    let table = |file: &SourceFile| {
        statements(file).find_map(|statement| match &statement.kind {
            StatementKind::Dim(dim) if is_table(dim) => Some((*file, statement.span)),
            _ => None,
        })
    };
    if let Some((file, dim)) = project.files(db).iter().find_map(table) {
        let (text, tree) = (file.text(db), parse(db, file));
        let place = tree.lines().get(line_at(tree, dim.start))?.span.end;
        return Some((file, vec![Edit::insert(place, format!("{}{line}", line_break(text, tree, place)))]));
    }
    let file = project.files(db).iter().find(|file| file.role(db).start() == Level::System)?;
    let end = line_break(file.text(db), parse(db, *file), 0);
    Some((*file, vec![Edit::insert(0, format!("DIM DEF({ROOM}){end}{line}{end}"))]))
}
