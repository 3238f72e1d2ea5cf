//! Questions about a project with places in the answers: the ground for navigation, references and reports.

use acrc_catalog::{CommandId, ObjectKind, OperandClass, command};
use acrc_diagnostics::Span;
use acrc_syntax::ast::{Argument, Command, Statement, StatementKind};
use acrc_syntax::units::Level;

use crate::index::{AttachmentKind, Name};
use crate::query::{exports, file_index, parse, symbols};
use crate::references::{self, Reference};
use crate::symbols::{AliasSymbol, AxisTable};
use crate::{Db, Project, SourceFile};

/// Something that a project declares.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Definition {
    /// Its file.
    pub file: SourceFile,
    /// The place of its name.
    pub span: Span,
    /// Its name.
    pub name: Name,
    /// What it is.
    pub kind: DefinitionKind,
}

/// What can be declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DefinitionKind {
    /// A label, valid in the program of its level.
    Label(Level),
    /// An alias, valid everywhere.
    Alias,
    /// An axis name, valid in the program of its level.
    Axis(Level),
}

/// Everything that the project declares, in the order of its files and, within one, of aliases, labels, axis names.
pub fn definitions(db: &dyn Db, project: Project) -> Vec<Definition> {
    let files = project.files(db).iter();
    files
        .flat_map(|file| [alias_definitions(db, *file), label_definitions(db, *file), axis_definitions(db, *file)])
        .flatten()
        .collect()
}

/// The labels of the program of `level`, in the order of the files and by name.
pub fn labels(db: &dyn Db, project: Project, level: Level) -> Vec<Definition> {
    let all = project.files(db).iter().flat_map(|file| label_definitions(db, *file));
    all.filter(|definition| definition.kind == DefinitionKind::Label(level)).collect()
}

/// The aliases of the project, in the order of their first definition.
pub fn aliases(db: &dyn Db, project: Project) -> &[AliasSymbol] {
    &symbols(db, project).aliases
}

/// The axis names that are valid in the program of `level`. `None` when nothing attaches an axis there.
pub fn axis_names(db: &dyn Db, project: Project, level: Level) -> Option<&AxisTable> {
    symbols(db, project).axes_at(level)
}

/// A statement that reads or writes a parameter or bit of the whole controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Access {
    /// Its file.
    pub file: SourceFile,
    /// The level of its section.
    pub level: Level,
    /// What it accesses, where, and how.
    pub reference: Reference,
}

/// Who reads and who writes the parameters and bits of the controller, through aliases and constants too, in the order of
/// the files. Numbers that are computed when a program runs are not known.
pub fn accesses(db: &dyn Db, project: Project) -> Vec<Access> {
    let symbols = symbols(db, project);
    let mut found = Vec::new();
    let mut references = Vec::new();
    for &file in project.files(db) {
        let text = file.text(db);
        let alias_at = |span: Span| Some(symbols.alias(text.get(span.range())?)?.operand.target);
        each_statement(db, file, &mut |level, statement| {
            references::collect(&alias_at, statement, &mut references);
            let global = references.iter().filter(|reference| GLOBAL.contains(&reference.class));
            found.extend(global.map(|&reference| Access { file, level, reference }));
        });
    }
    found
}

/// The operands that all programs share.
const GLOBAL: [OperandClass; 2] = [OperandClass::Parameter, OperandClass::Bit];

/// A statement that starts or stops programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ProgramOrder {
    /// Its file.
    pub file: SourceFile,
    /// Its place.
    pub span: Span,
    /// The level at which it stands.
    pub from: Level,
    /// What is ordered: [`command::RUN`], [`command::HALT`], ...
    pub order: CommandId,
    /// The program that is meant. `None` for `ALL`.
    pub to: Option<Level>,
}

/// Which programs start, stop, hold and resume which, in the order of the files.
pub fn program_orders(db: &dyn Db, project: Project) -> Vec<ProgramOrder> {
    let mut found = Vec::new();
    for &file in project.files(db) {
        each_statement(db, file, &mut |from, statement| {
            let StatementKind::Command(command) = &statement.kind else { return };
            if ORDERS.contains(&command.id) {
                let to = ordered(command, from);
                found.push(ProgramOrder { file, span: statement.span, from, order: command.id, to });
            }
        });
    }
    found
}

const ORDERS: [CommandId; 5] = [command::RUN, command::LRUN, command::HALT, command::PAUSE, command::RESUME];

/// The program that an order means: the one that it names, or its own.
fn ordered(order: &Command, from: Level) -> Option<Level> {
    match order.arguments.first() {
        Some(Argument::Object(object)) => {
            let number = object.index.and_then(|index| u8::try_from(index).ok())?;
            match object.kind {
                ObjectKind::Prog => Some(Level::Program(number)),
                ObjectKind::Plc => Some(Level::Plc(number)),
                _ => None,
            }
        }
        Some(_) => None,
        None => Some(from),
    }
}

fn each_statement(db: &dyn Db, file: SourceFile, visit: &mut dyn FnMut(Level, &Statement)) {
    let tree = parse(db, file);
    for section in &file_index(db, file).sections {
        let range = section.section.statements.start as usize..section.section.statements.end as usize;
        for statement in tree.statements().get(range).unwrap_or_default() {
            visit(section.section.level, statement);
        }
    }
}

fn alias_definitions(db: &dyn Db, file: SourceFile) -> Vec<Definition> {
    let names = exports(db, file).aliases.iter().map(|(name, _)| name.clone());
    let sites = &file_index(db, file).defines;
    let define = |(name, site): (Name, &crate::index::DefineSite)| Definition {
        file,
        span: site.name,
        name,
        kind: DefinitionKind::Alias,
    };
    names.zip(sites).map(define).collect()
}

fn label_definitions(db: &dyn Db, file: SourceFile) -> Vec<Definition> {
    let text = file.text(db);
    let mut found = Vec::new();
    for section in &file_index(db, file).sections {
        let kind = DefinitionKind::Label(section.section.level);
        found.extend(section.labels.iter().map(|label| {
            let name = text.get(label.name.range()).unwrap_or_default().into();
            Definition { file, span: label.name, name, kind }
        }));
    }
    found
}

fn axis_definitions(db: &dyn Db, file: SourceFile) -> Vec<Definition> {
    let attachments = exports(db, file).attachments.iter();
    let mut found = Vec::new();
    for (attachment, site) in attachments.zip(&file_index(db, file).attachments) {
        if let (AttachmentKind::Slave { name: Some(name), .. }, Some(span)) = (&attachment.kind, site.name) {
            found.push(Definition { file, span, name: name.clone(), kind: DefinitionKind::Axis(attachment.level) });
        }
    }
    found
}
