//! What raw numbers mean, and what programs take of their memory, written between the words of a text.

use acrc_analysis::memory::{grouped, text_bytes};
use acrc_analysis::query::{file_index, parse};
use acrc_analysis::{Db, Project, SourceFile};
use acrc_catalog::{Known, OperandClass, Space, bit, parameter};
use acrc_diagnostics::Span;

use crate::occurrence::in_span;
use crate::{Entity, ProgramUsage, Role, programs};

/// Which hints are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HintOptions {
    /// The meaning of parameters and flags that are written by their numbers.
    pub numbers: bool,
    /// The bytes of each program at its end.
    pub bytes: bool,
    /// The bytes of the program up to each line.
    pub running_bytes: bool,
}

impl Default for HintOptions {
    fn default() -> Self {
        Self { numbers: true, bytes: true, running_bytes: false }
    }
}

/// A text between two words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InlayHint {
    /// Where it is shown.
    pub offset: u32,
    /// The text.
    pub label: String,
}

/// The hints in a part of a file, in the order of the text.
pub fn inlay_hints(
    db: &dyn Db,
    project: Project,
    file: SourceFile,
    part: Span,
    options: HintOptions,
) -> Vec<InlayHint> {
    let mut hints = Vec::new();
    if options.numbers {
        hints.extend(numbers(db, project, file, part));
    }
    if options.bytes || options.running_bytes {
        for program in programs(db, project, file) {
            if options.bytes && part.contains(program.end.end) {
                hints.push(InlayHint { offset: program.end.end, label: total(&program) });
            }
            if options.running_bytes {
                hints.extend(running(db, file, program.section, part));
            }
        }
    }
    hints.sort_by_key(|hint| hint.offset);
    hints
}

fn numbers(db: &dyn Db, project: Project, file: SourceFile, part: Span) -> impl Iterator<Item = InlayHint> {
    let found = in_span(db, project, file, part).into_iter();
    found.filter(|occurrence| occurrence.role != Role::Define).filter_map(|occurrence| {
        let Entity::Operand { class, number: Some(number), .. } = occurrence.entity else { return None };
        Some(InlayHint { offset: occurrence.span.end, label: meaning(class, u32::try_from(number).ok()?)? })
    })
}

/// What a parameter or flag is, with its number among its like. Those of the user mean what the program makes of them.
fn meaning(class: OperandClass, number: u32) -> Option<String> {
    let (known, space, title, index, element) = match class {
        OperandClass::Parameter => {
            let info = parameter(number);
            (info.known, info.object, info.title, info.object_index, info.element)
        }
        OperandClass::Bit => {
            let info = bit(number);
            (info.known, info.object, info.title, info.object_index, info.element)
        }
        _ => return None,
    };
    if known != Known::Row || space == Space::User {
        return None;
    }
    let element = element.map(|element| format!(" {element}")).unwrap_or_default();
    let owner = index.map(|index| format!(", {space} {index}")).unwrap_or_default();
    Some(format!("{title}{element}{owner}"))
}

fn total(program: &ProgramUsage) -> String {
    match program.space {
        Some(space) => format!("{} of {} bytes", grouped(program.bytes), grouped(space)),
        None => format!("{} bytes", grouped(program.bytes)),
    }
}

/// The bytes of a program up to each line that holds a part of it.
fn running(db: &dyn Db, file: SourceFile, section: usize, part: Span) -> Vec<InlayHint> {
    let tree = parse(db, file);
    let Some(bytes) = text_bytes(db, file).get(section) else { return Vec::new() };
    let Some(index) = file_index(db, file).sections.get(section) else { return Vec::new() };
    let mut sum = 0;
    let mut hints: Vec<InlayHint> = Vec::new();
    let mut line = None;
    for (statement, bytes) in index.section.statements.clone().zip(&bytes.statements) {
        sum += u64::from(*bytes);
        let at = tree.line_of(statement);
        let Some(end) = tree.statements().get(statement as usize).map(|statement| statement.span.end) else { break };
        let hint = InlayHint { offset: end, label: grouped(sum) };
        match hints.last_mut().filter(|_| line == Some(at)) {
            Some(last) => *last = hint,
            None => hints.push(hint),
        }
        line = Some(at);
    }
    hints.retain(|hint| part.contains(hint.offset));
    hints
}
