//! What is known of the thing at a place, as Markdown.

mod names;
mod operands;

use acrc_analysis::memory::text_bytes;
use acrc_analysis::query::file_index;
use acrc_analysis::{Db, SourceFile};
use acrc_catalog::{Entry, Known, OperandClass, bit, parameter};
use acrc_diagnostics::Span;

use crate::{Entity, FilePosition, at};

/// What is known of the thing at a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hover {
    /// What it is about.
    pub span: Span,
    /// The text.
    pub markdown: String,
}

/// What is known of the thing at a place. `None` where nothing stands that has a meaning.
pub fn hover(db: &dyn Db, position: FilePosition) -> Option<Hover> {
    let occurrence = at(db, position)?;
    let mut markdown = page(db, position, &occurrence.entity);
    if let (Entity::Command(_), Some(bytes)) =
        (&occurrence.entity, statement_bytes(db, position.file, occurrence.statement))
    {
        markdown += "\nThis statement takes ";
        markdown += &bytes.to_string();
        markdown += " bytes of program memory.\n";
    }
    Some(Hover { span: occurrence.span, markdown })
}

/// What is known of something that is meant at a place, as Markdown.
pub fn page(db: &dyn Db, position: FilePosition, entity: &Entity) -> String {
    match entity {
        Entity::Command(id) => Entry::Command(id.info()).markdown(),
        Entity::Function(id) => Entry::Function(id.info()).markdown(),
        Entity::Word(keyword) => Entry::Keyword(*keyword).markdown(),
        Entity::Object { kind, number } => names::object(db, position, *kind, *number),
        Entity::Operand { class, number, level } => operands::operand(db, position.project, *class, *number, *level),
        Entity::Alias(name) => names::alias(db, position, name),
        Entity::Axis(level, name) => names::axis(db, position, *level, name),
        Entity::Label(level, name) => names::label(db, position, *level, name),
        Entity::Line(level, number) => names::line(db, position, *level, *number),
    }
}

/// What is known of an operand of the whole controller, or of a class of which the number is not known.
fn entry(class: OperandClass, number: Option<u64>) -> Entry {
    let number = number.and_then(|number| u32::try_from(number).ok());
    match (class, number) {
        (OperandClass::Parameter, Some(number)) => Entry::Parameter(Box::new(parameter(number))),
        (OperandClass::Bit, Some(number)) => Entry::Bit(Box::new(bit(number))),
        _ => Entry::Operand(class.info()),
    }
}

/// The title of a parameter or flag: `Actual Position of axis 0`.
fn title(class: OperandClass, number: u64) -> Option<String> {
    let number = u32::try_from(number).ok()?;
    let (known, title, owner) = match class {
        OperandClass::Parameter => {
            let info = parameter(number);
            (info.known, info.title, info.owner())
        }
        OperandClass::Bit => {
            let info = bit(number);
            (info.known, info.title, info.owner())
        }
        _ => return None,
    };
    (known == Known::Row).then(|| if owner.is_empty() { title.to_owned() } else { format!("{title}, {owner}") })
}

/// Bytes that a statement takes in its stored program.
fn statement_bytes(db: &dyn Db, file: SourceFile, statement: u32) -> Option<u32> {
    let sections = &file_index(db, file).sections;
    let place = sections.iter().position(|section| section.section.statements.contains(&statement))?;
    let first = sections.get(place)?.section.statements.start;
    let bytes = text_bytes(db, file).get(place)?.statements.get((statement - first) as usize)?;
    (*bytes > 0).then_some(*bytes)
}
