//! Where something is declared.
//!
//! An alias is declared by its `#DEFINE`, a label and a line by themselves, an axis name by `ATTACH SLAVE`, a local
//! variable by the `DIM` of its program, a program by its `PROGRAM`. A parameter or flag has no declaration; the nearest
//! to one is the `#DEFINE` that names it, else the `DIM P` that makes room for it. From the words that branch and close a
//! block the way leads to the one that opens it.

use acrc_analysis::index::AttachmentKind;
use acrc_analysis::memory::local_class;
use acrc_analysis::query::{exports, file_index, parse, symbols};
use acrc_analysis::{Db, Project, SourceFile};
use acrc_catalog::{CommandId, FIRST_FLAG_WORD, ObjectKind, OperandClass, command};
use acrc_diagnostics::Span;
use acrc_syntax::ast::{Argument, Dim, ExprKind, StatementKind};
use acrc_syntax::units::Level;

use crate::place::section_of;
use crate::{Entity, FilePosition, Occurrence, Role, Target, at, everywhere};

/// Where what stands at a place is declared, in the order of the files. More than one where it is declared twice.
pub fn definition(db: &dyn Db, position: FilePosition) -> Vec<Target> {
    let Some(occurrence) = at(db, position) else { return Vec::new() };
    let FilePosition { project, file, .. } = position;
    match &occurrence.entity {
        Entity::Command(id) => of_command(db, project, file, *id, occurrence.statement),
        Entity::Label(..) | Entity::Line(..) => of_jump(db, position, &occurrence),
        entity => declarations(db, project, entity),
    }
}

/// Where something that has a name or a number is declared, in the order of the files.
pub(crate) fn declarations(db: &dyn Db, project: Project, entity: &Entity) -> Vec<Target> {
    match entity {
        Entity::Alias(name) => of_alias(db, project, name),
        Entity::Label(..) | Entity::Line(..) | Entity::Axis(..) => defined(db, project, entity),
        Entity::Operand { class, number, level: Some(level) } => dims(db, project, *class, *number, *level),
        Entity::Operand { class, number, level: None } => {
            let alias = number.and_then(|number| symbols(db, project).alias_for(*class, number));
            match alias {
                Some(alias) => of_alias(db, project, &alias.name),
                None => user_parameters(db, project, *class, *number),
            }
        }
        Entity::Object { kind, number: Some(number) } => of_object(db, project, *kind, *number),
        Entity::Object { number: None, .. } | Entity::Command(_) | Entity::Function(_) | Entity::Word(_) => Vec::new(),
    }
}

/// The places that are occurrences with the role of a declaration.
fn defined(db: &dyn Db, project: Project, entity: &Entity) -> Vec<Target> {
    let found = everywhere(db, project, entity).into_iter().filter(|(_, occurrence)| occurrence.role == Role::Define);
    found.filter_map(|(file, occurrence)| target(db, file, occurrence.statement, Some(occurrence.span))).collect()
}

/// The `#DEFINE`s of an alias. All of them lie in files that export it.
fn of_alias(db: &dyn Db, project: Project, name: &str) -> Vec<Target> {
    let mut found = Vec::new();
    for &file in project.files(db) {
        let sites = exports(db, file).aliases.iter().zip(&file_index(db, file).defines);
        for (_, site) in sites.filter(|((known, _), _)| **known == *name) {
            let whole = crate::statement_at(db, file, site.name.start);
            found.extend(whole.and_then(|statement| target(db, file, statement, Some(site.name))));
        }
    }
    found
}

/// A jump goes to the label or line of its own text, which may be stored at this level more than once.
fn of_jump(db: &dyn Db, position: FilePosition, occurrence: &Occurrence) -> Vec<Target> {
    let FilePosition { project, file, .. } = position;
    let all = defined(db, project, &occurrence.entity);
    let own = section_of(db, file, occurrence.statement).map(|section| section.section.statements.clone());
    let is_own = |target: &&Target| {
        target.file == file
            && crate::statement_at(db, file, target.whole.start)
                .is_some_and(|statement| own.as_ref().is_some_and(|own| own.contains(&statement)))
    };
    let own: Vec<Target> = all.iter().filter(is_own).copied().collect();
    if own.is_empty() { all } else { own }
}

fn of_command(db: &dyn Db, project: Project, file: SourceFile, id: CommandId, statement: u32) -> Vec<Target> {
    let Some(section) = section_of(db, file, statement) else { return Vec::new() };
    let opener = match id {
        command::ENDP => section.section.opener,
        command::BREAK => section.blocks.enclosing_loop(statement).map(|block| block.opener),
        command::PROG | command::PLC => return of_switch(db, project, file, id, statement),
        _ => section.blocks.block_of(statement).map(|block| block.opener).filter(|opener| *opener != statement),
    };
    opener.and_then(|opener| target(db, file, opener, None)).into_iter().collect()
}

/// `PROG 3` goes to the prompt of a program: its text is what a reader wants to see.
fn of_switch(db: &dyn Db, project: Project, file: SourceFile, id: CommandId, statement: u32) -> Vec<Target> {
    let statement = parse(db, file).statements().get(statement as usize).map(|statement| &statement.kind);
    let Some(StatementKind::Command(switch)) = statement else {
        return Vec::new();
    };
    let number = switch.arguments.iter().find_map(|argument| match argument {
        Argument::Value(value) => acrc_analysis::walk::whole(value),
        _ => None,
    });
    let kind = if id == command::PLC { ObjectKind::Plc } else { ObjectKind::Prog };
    let number = number.and_then(|number| u32::try_from(number).ok());
    number.map_or_else(Vec::new, |number| of_object(db, project, kind, number))
}

fn of_object(db: &dyn Db, project: Project, kind: ObjectKind, number: u32) -> Vec<Target> {
    let small = u8::try_from(number).ok();
    match kind {
        ObjectKind::Prog => small.map_or_else(Vec::new, |number| programs(db, project, Level::Program(number))),
        ObjectKind::Plc => small.map_or_else(Vec::new, |number| programs(db, project, Level::Plc(number))),
        ObjectKind::Master => attachments(
            db,
            project,
            &|kind| matches!(kind, AttachmentKind::Master { master } if *master == Some(number)),
        ),
        ObjectKind::Axis => attachments(db, project, &|kind| match kind {
            AttachmentKind::Axis { axis, .. } | AttachmentKind::Slave { axis, .. } => *axis == Some(number),
            _ => false,
        }),
        _ => Vec::new(),
    }
}

/// The texts that are stored for a level: their `PROGRAM`, or the first statement where the file is the program.
fn programs(db: &dyn Db, project: Project, level: Level) -> Vec<Target> {
    let mut found = Vec::new();
    for &file in project.files(db) {
        let index = file_index(db, file);
        for section in index.sections.iter().filter(|section| section.section.level == level) {
            let opener = section.section.opener.or(index.implicit_program.then_some(section.section.statements.start));
            let closer = section.section.closer.or(section.section.statements.end.checked_sub(1));
            let Some(mut target) = opener.and_then(|opener| target(db, file, opener, None)) else { continue };
            let last = closer.and_then(|closer| parse(db, file).statements().get(closer as usize));
            target.whole = last.map_or(target.whole, |last| Span::cover(target.whole, last.span));
            found.push(target);
        }
    }
    found
}

fn attachments(db: &dyn Db, project: Project, wanted: &dyn Fn(&AttachmentKind) -> bool) -> Vec<Target> {
    let mut found = Vec::new();
    for &file in project.files(db) {
        let sites = exports(db, file).attachments.iter().zip(&file_index(db, file).attachments);
        for (_, site) in sites.filter(|(attachment, _)| wanted(&attachment.kind)) {
            found.push(Target { file, whole: site.statement, name: site.statement });
        }
    }
    found
}

/// The `DIM`s of a class of local variables; of an array its references and its elements.
fn dims(db: &dyn Db, project: Project, class: OperandClass, number: Option<u64>, level: Level) -> Vec<Target> {
    let is_meant = |dim: &Dim| {
        local_class(dim.id) == Some(class)
            && match (&dim.index, number) {
                (Some(index), Some(number)) => matches!(index.kind, ExprKind::Integer(own) if own == number),
                _ => true,
            }
    };
    dimensioned(db, project, level, &is_meant)
}

fn user_parameters(db: &dyn Db, project: Project, class: OperandClass, number: Option<u64>) -> Vec<Target> {
    let is_users = number.is_none_or(|number| number < u64::from(FIRST_FLAG_WORD));
    if class != OperandClass::Parameter || !is_users {
        return Vec::new();
    }
    dimensioned(db, project, Level::System, &|dim| dim.id == command::DIM_P)
}

fn dimensioned(db: &dyn Db, project: Project, level: Level, is_meant: &dyn Fn(&Dim) -> bool) -> Vec<Target> {
    let mut found = Vec::new();
    for &file in project.files(db).iter().filter(|file| exports(db, **file).levels.contains(&level)) {
        for section in file_index(db, file).sections.iter().filter(|section| section.section.level == level) {
            let range = section.section.statements.start as usize..section.section.statements.end as usize;
            for statement in parse(db, file).statements().get(range).unwrap_or_default() {
                if let StatementKind::Dim(dim) = &statement.kind
                    && is_meant(dim)
                {
                    found.push(Target { file, whole: statement.span, name: dim.name });
                }
            }
        }
    }
    found
}

/// A statement, and the part of it that names what it declares.
fn target(db: &dyn Db, file: SourceFile, statement: u32, name: Option<Span>) -> Option<Target> {
    let statement = parse(db, file).statements().get(statement as usize)?;
    let name = name.unwrap_or(statement.span);
    // The number of a line stands before its statement.
    Some(Target { file, whole: Span::cover(statement.span, name), name })
}
