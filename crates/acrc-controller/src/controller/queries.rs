//! Reports that need the programs: `LIST`, `DIM`, `MEM`, `DEF`. Layouts that are not documented repeat the form of the command that would make
//! what they report.

use acrc_catalog::memory::SystemBlock;
use acrc_catalog::{CommandId, command, law};
use acrc_image::list::{ListOptions, list_instructions};
use acrc_image::{Alias, Instruction, Node, Separator};
use acrc_syntax::units::Level;
use acrc_vm::Dimension;

use super::{Controller, Observer};
use crate::command::deliver;
use crate::request::{Origin, Query};
use crate::task::Task;
use crate::terminal::StoredText;

impl Controller {
    /// Answers a question.
    pub(super) fn answer(&mut self, query: Query, origin: Origin, observer: &mut dyn Observer) {
        let lines = match query {
            Query::List { first, last } => self.listing(origin.level, first, last),
            Query::Dimensions(dim) => self.dimensions(origin.level, dim),
            Query::FreeMemory => vec![self.free_memory(origin.level).to_string()],
            Query::Aliases => self.aliases.known().filter_map(definition).collect(),
        };
        for line in lines {
            let text: Vec<u8> = line.chars().map(|character| u8::try_from(character).unwrap_or(b'?')).collect();
            deliver(&mut self.machine, observer, origin, 0, &[&text[..], b"\r\n"].concat());
        }
    }

    /// The lines of the program at a level whose numbers lie in a range. A text with mistakes is listed as it was typed.
    fn listing(&mut self, level: Level, first: u32, last: u32) -> Vec<String> {
        let Some(task) = Task::at(level) else { return Vec::new() };
        let _ = self.compile(task);
        let with_numbers = self.machine.flags.get(law::LIST_LINE_NUMBERS.at(0));
        let program = self.program(task);
        let edited = program.edited.clone();
        let unit = program.unit.clone();
        let text = edited.or_else(|| StoredText::of_unit(&unit?, self.aliases.entries()).ok()).unwrap_or_default();
        let lines = text.lines().iter().filter(|line| (first..=last).contains(&line.number));
        lines.map(|line| line.listed(with_numbers)).collect()
    }

    /// The allocations of a level; of a daughter of `DIM` only those that it makes.
    fn dimensions(&self, level: Level, dim: CommandId) -> Vec<String> {
        let mut lines: Vec<String> = match Task::at(level) {
            Some(task) => self.program(task).locals.dimensions().iter().map(local_dimension).collect(),
            None => self.machine.memory.blocks().map(system_dimension).collect(),
        };
        if dim != command::DIM {
            let own = |rest: &str| rest.starts_with(|next: char| next == '(' || next.is_ascii_digit());
            lines.retain(|line| line.strip_prefix(dim.info().name).is_some_and(own));
        }
        lines
    }

    /// Bytes that are free at a level.
    fn free_memory(&self, level: Level) -> u64 {
        let Some(task) = Task::at(level) else { return u64::from(self.machine.memory.free()) };
        let program = self.program(task);
        // A program that has ended within a subroutine has none open any more.
        let calls = if program.is_going() { program.frame.memory() } else { 0 };
        let used = program.text_bytes + program.locals.used() + calls;
        self.machine.space(task).saturating_sub(used)
    }
}

fn system_dimension((block, bytes): (SystemBlock, u32)) -> String {
    format!("DIM {block}({})", block.size(bytes))
}

fn local_dimension(dimension: &Dimension) -> String {
    let Dimension { block, array, count, length, .. } = *dimension;
    let array = array.map_or_else(String::new, |number| number.to_string());
    let length = if block.has_length() { format!(", {length}") } else { String::new() };
    format!("DIM {}{array}({count}{length})", block.word())
}

/// The `#DEFINE` of an alias.
fn definition(alias: &Alias) -> Option<String> {
    let node = Node::Alias { index: 0, parens: 0 };
    let define =
        Instruction { address: 0, separator: Separator::Line, command: command::DEFINE, items: vec![node.into()] };
    let listing = list_instructions(&[define], std::slice::from_ref(alias), &ListOptions::default()).ok()?;
    Some(listing.trim_end().to_owned())
}
