//! What has a name or a number, and where it occurs.

mod collect;

use acrc_analysis::query::{file_index, parse, symbols};
use acrc_analysis::{Db, Project, SectionIndex, SourceFile};
use acrc_catalog::{CommandId, FunctionId, Keyword, ObjectKind, OperandClass};
use acrc_diagnostics::Span;
use acrc_syntax::ast::Separator;
use acrc_syntax::units::Level;

use self::collect::Collector;
use crate::FilePosition;
use crate::place::section_of;

pub use acrc_analysis::index::Name;

/// What something is: two places mean the same thing when their entities are equal.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Entity {
    /// A command of the language.
    Command(CommandId),
    /// A function.
    Function(FunctionId),
    /// A word that is only part of a statement: `ALL`, `CLOCK`.
    Word(Keyword),
    /// An object by number: `AXIS0`, `ENC3`, `PROG1`.
    Object {
        /// Its kind.
        kind: ObjectKind,
        /// Its number, when one is written.
        number: Option<u32>,
    },
    /// A parameter, flag or variable.
    Operand {
        /// Its class.
        class: OperandClass,
        /// Its number, when it is known before the program runs.
        number: Option<u64>,
        /// The program to which it belongs; `None` for parameters and flags, which belong to the controller.
        level: Option<Level>,
    },
    /// An alias, which is known everywhere.
    Alias(Name),
    /// The name of an axis, in capital letters, which is known in a program.
    Axis(Level, Name),
    /// A label of a program.
    Label(Level, Name),
    /// A line number of a program.
    Line(Level, u32),
}

/// What is done with something at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Role {
    /// It is declared.
    Define,
    /// It is used.
    Read,
    /// It gets another value.
    Write,
    /// It is jumped to with `GOTO`.
    Jump,
    /// It is called with `GOSUB`.
    Call,
}

/// Something at a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Occurrence {
    /// Where its name or number stands.
    pub span: Span,
    /// What it is.
    pub entity: Entity,
    /// What is done with it.
    pub role: Role,
    /// Index of the statement in the tree of the file.
    pub statement: u32,
}

/// What stands at a place. Of things within each other the innermost; between two that touch, the one that begins.
pub fn at(db: &dyn Db, position: FilePosition) -> Option<Occurrence> {
    let FilePosition { project, file, offset } = position;
    // Who points at the underscore of a label means the label.
    let is_mark = file.text(db).as_bytes().get(offset as usize) == Some(&b'_');
    let offset = offset + u32::from(is_mark);
    let after = parse(db, file).statements().partition_point(|statement| statement.span.start <= offset) as u32;
    let mut found = Vec::new();
    // A statement that ends where the next one begins may have a name there, and the number of a line stands before its
    // first statement.
    for statement in after.saturating_sub(2)..=after {
        collect_at(db, project, file, section_of(db, file, statement), statement, &mut found);
    }
    let touching = found.into_iter().filter(|occurrence| {
        occurrence.span.start <= offset && offset <= occurrence.span.end && !occurrence.span.is_empty()
    });
    touching.min_by_key(|occurrence| (offset == occurrence.span.end, occurrence.span.len()))
}

/// Everything that occurs in a file, in the order of the text.
pub fn in_file(db: &dyn Db, project: Project, file: SourceFile) -> Vec<Occurrence> {
    in_span(db, project, file, Span::new(0, file.text(db).len() as u32))
}

/// What occurs in the statements that reach into a part of a file, in the order of the text.
pub(crate) fn in_span(db: &dyn Db, project: Project, file: SourceFile, part: Span) -> Vec<Occurrence> {
    let statements = parse(db, file).statements();
    let first = statements.partition_point(|statement| statement.span.end < part.start) as u32;
    let end = statements.partition_point(|statement| statement.span.start < part.end) as u32;
    let mut found = Vec::new();
    for index in &file_index(db, file).sections {
        let section = &index.section;
        let own = section.opener.into_iter().chain(section.statements.clone()).chain(section.closer);
        for statement in own.filter(|statement| (first..end).contains(statement)) {
            collect_at(db, project, file, Some(index), statement, &mut found);
        }
    }
    found
}

/// Where something occurs in the files of a project, in their order.
pub fn everywhere(db: &dyn Db, project: Project, entity: &Entity) -> Vec<(SourceFile, Occurrence)> {
    let files = project.files(db).iter().copied();
    files
        .flat_map(|file| in_file(db, project, file).into_iter().map(move |occurrence| (file, occurrence)))
        .filter(|(_, occurrence)| occurrence.entity == *entity)
        .collect()
}

fn collect_at(
    db: &dyn Db,
    project: Project,
    file: SourceFile,
    section: Option<&SectionIndex>,
    statement: u32,
    found: &mut Vec<Occurrence>,
) {
    let tree = parse(db, file);
    let Some(node) = tree.statements().get(statement as usize) else { return };
    let level = section.map_or_else(|| file.role(db).start(), |section| section.section.level);
    let symbols = symbols(db, project);
    // Within a program that has an axis of this name the word is the axis.
    let is_alias =
        |name: &str| symbols.alias(name).is_some() && !symbols.axes_at(level).is_some_and(|axes| axes.has(name));
    let first = found.len();
    if node.separator == Separator::Line
        && let Some(number) = tree.lines().get(tree.line_of(statement) as usize).and_then(|line| line.number)
    {
        let entity = Entity::Line(level, number.value);
        found.push(Occurrence { span: number.span, entity, role: Role::Define, statement });
    }
    Collector { text: file.text(db), tree, level, section, is_alias: &is_alias, statement, found }.statement(node);
    if let Some(new) = found.get_mut(first..) {
        new.sort_by_key(|occurrence| (occurrence.span.start, occurrence.span.end));
    }
}
