//! Reports that need the programs: `LIST`, `DIM`, `MEM`, `DEF`. Layouts that are not documented repeat the form of the command that would make
//! what they report.

use acrc_catalog::{OperandClass, command, law, memory};
use acrc_image::list::{ListOptions, list_instructions};
use acrc_image::{Alias, Instruction, Node, Separator};
use acrc_syntax::units::Level;
use acrc_vm::Dimension;

use super::{Controller, Observer};
use crate::aliases::alias_count;
use crate::command::deliver;
use crate::memory::Block;
use crate::request::{Origin, Query};
use crate::terminal::StoredText;

impl Controller {
    /// Answers a question.
    pub(super) fn answer(&mut self, query: Query, origin: Origin, observer: &mut dyn Observer) {
        let lines = match query {
            Query::List { first, last } => self.listing(origin.level, first, last),
            Query::Dimensions => self.dimensions(origin.level),
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
        let _ = self.compile(level);
        let with_numbers = self.machine.flags.get(law::LIST_LINE_NUMBERS.at(0));
        let Some(program) = self.program_at(level) else { return Vec::new() };
        let edited = program.edited.clone();
        let unit = program.unit.clone();
        let text = edited.or_else(|| StoredText::of_unit(&unit?, self.aliases.entries()).ok()).unwrap_or_default();
        let lines = text.lines().iter().filter(|line| (first..=last).contains(&line.number));
        lines.map(|line| line.listed(with_numbers)).collect()
    }

    /// The allocations of a level.
    fn dimensions(&self, level: Level) -> Vec<String> {
        match level {
            Level::Program(number) => self
                .programs
                .get(usize::from(number))
                .map(|program| program.locals.dimensions().iter().map(local_dimension).collect())
                .unwrap_or_default(),
            Level::System => self.machine.memory.blocks().map(system_dimension).collect(),
            Level::Plc(_) => Vec::new(),
        }
    }

    /// Bytes that are free at a level.
    fn free_memory(&self, level: Level) -> u64 {
        let plc = |number: u8| self.plcs.get(usize::from(number)).map_or(0, |plc| plc.text_bytes);
        let used = match level {
            Level::System => return u64::from(self.machine.memory.free()),
            Level::Plc(number) => plc(number),
            Level::Program(number) => self
                .programs
                .get(usize::from(number))
                .map_or(0, |program| program.text_bytes + program.locals.used() + program.frame.memory()),
        };
        self.space_at(level).saturating_sub(used)
    }
}

fn system_dimension((block, bytes): (Block, u32)) -> String {
    let size = match block {
        Block::Parameters => bytes / memory::PARAMETERS.each,
        Block::Aliases => alias_count(bytes),
        Block::Program(_) | Block::Plc(_) | Block::Stream(_) => bytes,
    };
    format!("DIM {block}({size})")
}

fn local_dimension(dimension: &Dimension) -> String {
    let Dimension { class, array, count, length, .. } = *dimension;
    let name = class.name();
    let array = array.map_or_else(String::new, |number| number.to_string());
    let has_length = matches!(class, OperandClass::StringV) || class == OperandClass::StringA && !array.is_empty();
    let length = if has_length { format!(", {length}") } else { String::new() };
    format!("DIM {name}{array}({count}{length})")
}

/// The `#DEFINE` of an alias.
fn definition(alias: &Alias) -> Option<String> {
    let node = Node::Alias { index: 0, parens: 0 };
    let define =
        Instruction { address: 0, separator: Separator::Line, command: command::DEFINE, items: vec![node.into()] };
    let listing = list_instructions(&[define], std::slice::from_ref(alias), &ListOptions::default()).ok()?;
    Some(listing.trim_end().to_owned())
}
