//! The lines of a stored text and their numbers.

use acrc_catalog::command;

use crate::instruction::{Instruction, Separator};
use crate::node::Node;

/// The distance of the numbers that lines without one get: the next multiple of it behind the number before.
pub const LINE_NUMBER_STEP: u32 = 10;

/// The number of a line that has none of its own, behind a line with the number `before` (0 at the start).
pub fn hidden_line_number(before: u32) -> u32 {
    (before / LINE_NUMBER_STEP).saturating_add(1).saturating_mul(LINE_NUMBER_STEP)
}

/// A line of a stored text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line<'a> {
    /// Its number: the one it was written with, or the one it is hidden behind.
    pub number: u32,
    /// It was written with its number.
    pub numbered: bool,
    /// Where it begins, in words from the start of the unit.
    pub address: u32,
    /// Its statements, without the number.
    pub statements: &'a [Instruction],
}

/// The lines of a unit in their order.
pub fn lines(instructions: &[Instruction]) -> impl Iterator<Item = Line<'_>> {
    let (mut rest, mut number) = (instructions, 0);
    std::iter::from_fn(move || {
        let first = rest.first()?;
        let length = rest.iter().skip(1).take_while(|instruction| instruction.separator != Separator::Line).count() + 1;
        let (line, behind) = rest.split_at(length);
        rest = behind;
        let own = line_number(first);
        number = own.unwrap_or_else(|| hidden_line_number(number));
        let statements = if own.is_some() { line.get(1..).unwrap_or_default() } else { line };
        Some(Line { number, numbered: own.is_some(), address: first.address, statements })
    })
}

/// The number that a line was written with.
fn line_number(first: &Instruction) -> Option<u32> {
    match first.items.first().map(|item| &item.node) {
        Some(&Node::Long(number)) if first.command == command::LINE_NUMBER => u32::try_from(number).ok(),
        _ => None,
    }
}
