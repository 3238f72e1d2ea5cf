//! The controller's `LIST` form of a unit (guide, "IF/ELSE" for the indentation).
//!
//! Keywords in upper case, one blank between the parts of a statement, ` : ` between statements, statements that stood side by side still side
//! by side, texts of remarks as they were written. What lies under `IF`, `FOR` or `WHILE` is indented, the closing statement included, so that a
//! block that does not close is seen at once. Compiling a listing gives the same words.

mod annotate;
mod expression;
mod lines;
mod statement;

pub use lines::{LINE_NUMBER_STEP, Line, hidden_line_number, lines};

use acrc_catalog::command;

use crate::error::{ImageError, Problem};
use crate::image::Alias;
use crate::instruction::{Instruction, Mark, Separator};
use crate::node::Node;
use crate::text;
use crate::unit::Unit;

/// Blanks that a block is indented by.
pub const INDENT: usize = 4;

/// What a listing shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ListOptions {
    /// Numbers in front of all lines, as with flag 5651 set; otherwise only where the line was written with one.
    pub line_numbers: bool,
}

/// Lists a unit.
///
/// # Errors
/// [`ImageError`] when the unit cannot be decoded or refers to an alias outside the table.
pub fn list(unit: &Unit, aliases: &[Alias], options: &ListOptions) -> Result<String, ImageError> {
    of_unit(unit, |instructions| list_instructions(instructions, aliases, options))
}

/// Lists a unit with the names of its flags and parameters: above a line with some of them stands an apostrophe comment, which vanishes when
/// the listing is compiled.
///
/// # Errors
/// As for [`list`].
pub fn list_annotated(unit: &Unit, aliases: &[Alias], options: &ListOptions) -> Result<String, ImageError> {
    of_unit(unit, |instructions| {
        write_lines(instructions, aliases, options.line_numbers, |statements| annotate::comment(statements, aliases))
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
    write_lines(instructions, aliases, options.line_numbers, |_| None)
}

fn of_unit(
    unit: &Unit,
    write: impl FnOnce(&[Instruction]) -> Result<String, (u32, Problem)>,
) -> Result<String, ImageError> {
    let instructions = unit.decode()?;
    write(&instructions).map_err(|(address, problem)| ImageError::Word { unit: unit.name, address, problem })
}

/// Writes all lines; what `comment` gives stands on a line of its own above.
fn write_lines(
    instructions: &[Instruction],
    aliases: &[Alias],
    line_numbers: bool,
    comment: impl Fn(&[Instruction]) -> Option<String>,
) -> Result<String, (u32, Problem)> {
    let mut lister = Lister { out: String::new(), aliases, labels: labels(instructions) };
    let mut depth = 0_usize;
    for Line { number, numbered, statements, .. } in lines(instructions) {
        let number = if numbered || line_numbers { format!("{number} ") } else { String::new() };
        let indent = " ".repeat(INDENT * depth);
        if let Some(comment) = comment(statements) {
            let below_number = " ".repeat(number.len());
            lister.out.extend([&below_number, &indent, "' ", &comment, "\n"]);
        }
        lister.out.extend([number, indent]);
        lister.line(statements)?;
        lister.end_line();
        depth = statements.iter().fold(depth, block_depth);
    }
    Ok(lister.out)
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
