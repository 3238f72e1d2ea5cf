//! The controller's `LIST` form of a unit (guide, "IF/ELSE" for the indentation).
//!
//! Keywords in upper case, one blank between the parts of a statement, ` : ` between statements, statements that stood side by side still side
//! by side, texts of remarks as they were written. What lies under `IF`, `FOR` or `WHILE` is indented, the closing statement included, so that a
//! block that does not close is seen at once. Compiling a listing gives the same words.

mod expression;
mod statement;

use acrc_catalog::command;

use crate::error::{ImageError, Problem};
use crate::image::Alias;
use crate::instruction::{Instruction, Mark, Separator};
use crate::node::Node;
use crate::text;
use crate::unit::Unit;

/// Blanks that a block is indented by.
pub const INDENT: usize = 4;

/// The distance of the numbers that lines without one get: the next multiple of it behind the number before.
pub const LINE_NUMBER_STEP: u32 = 10;

/// What a listing shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ListOptions {
    /// Numbers in front of all lines, as with flag 5651 set; otherwise only where the line was written with one.
    pub line_numbers: bool,
}

/// The number of a line that has none of its own, behind a line with the number `before` (0 at the start).
pub fn hidden_line_number(before: u32) -> u32 {
    (before / LINE_NUMBER_STEP).saturating_add(1).saturating_mul(LINE_NUMBER_STEP)
}

/// Lists a unit.
///
/// # Errors
/// [`ImageError`] when the unit cannot be decoded or refers to an alias outside the table.
pub fn list(unit: &Unit, aliases: &[Alias], options: &ListOptions) -> Result<String, ImageError> {
    let instructions = unit.decode()?;
    list_instructions(&instructions, aliases, options).map_err(|(address, problem)| ImageError::Word {
        unit: unit.name,
        address,
        problem,
    })
}

/// Lists decoded statements, as for [`list`].
///
/// # Errors
/// The address of the statement and the alias or label outside its table.
pub fn list_instructions(
    instructions: &[Instruction],
    aliases: &[Alias],
    options: &ListOptions,
) -> Result<String, (u32, Problem)> {
    let mut lister = Lister { out: String::new(), aliases, labels: labels(instructions) };
    let (mut depth, mut number) = (0_usize, 0);
    let mut rest = instructions;
    while let Some(first) = rest.first() {
        let length = rest.iter().skip(1).take_while(|instruction| instruction.separator != Separator::Line).count() + 1;
        let (line, behind) = rest.split_at(length);
        rest = behind;
        let own = line_number(first);
        number = own.unwrap_or_else(|| hidden_line_number(number));
        if own.is_some() || options.line_numbers {
            lister.out.push_str(&number.to_string());
            lister.out.push(' ');
        }
        lister.out.push_str(&" ".repeat(INDENT * depth));
        lister.line(if own.is_some() { line.get(1..).unwrap_or_default() } else { line })?;
        lister.end_line();
        depth = line.iter().fold(depth, block_depth);
    }
    Ok(lister.out)
}

/// The number that a line was written with.
fn line_number(first: &Instruction) -> Option<u32> {
    match first.items.first().map(|item| &item.node) {
        Some(&Node::Long(number)) if first.command == command::LINE_NUMBER => u32::try_from(number).ok(),
        _ => None,
    }
}

/// How many blocks are open behind a statement, when `depth` were open before it.
fn block_depth(depth: usize, instruction: &Instruction) -> usize {
    let then = instruction.items.first().is_some_and(|item| item.mark == Mark::Comma);
    match instruction.command {
        command::IF if then => depth,
        command::IF | command::FOR | command::WHILE => depth + 1,
        command::ENDIF | command::NEXT | command::WEND => depth.saturating_sub(1),
        _ => depth,
    }
}

fn labels(instructions: &[Instruction]) -> Vec<String> {
    let definitions = instructions.iter().filter(|instruction| instruction.command == command::LABEL);
    let name = |instruction: &Instruction| match instruction.items.first().map(|item| &item.node) {
        Some(Node::String { bytes, .. }) => text::decode(bytes),
        _ => String::new(),
    };
    definitions.map(name).collect()
}

/// Writes statements.
struct Lister<'a> {
    out: String,
    aliases: &'a [Alias],
    labels: Vec<String>,
}

impl Lister<'_> {
    fn line(&mut self, line: &[Instruction]) -> Result<(), (u32, Problem)> {
        for (place, instruction) in line.iter().enumerate() {
            match instruction.separator {
                _ if place == 0 => {}
                Separator::Colon => self.out.push_str(" : "),
                _ => self.out.push(' '),
            }
            self.statement(instruction).map_err(|problem| (instruction.address, problem))?;
        }
        Ok(())
    }

    fn end_line(&mut self) {
        let end = self.out.trim_end_matches(' ').len();
        self.out.truncate(end);
        self.out.push('\n');
    }
}
