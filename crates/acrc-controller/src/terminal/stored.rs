//! The text of a stored program as lines, while it is edited: lines with a number take their places, replace and are deleted (guide, "Adding
//! Lines of Code to Programs").
//!
//! A line that cannot be read is kept as it was typed: the controller says nothing about syntax when a program is entered, only when it is run.

use std::ops::Range;

use acrc_catalog::command;
use acrc_image::list::{ListOptions, hidden_line_number, list};
use acrc_image::{Alias, ImageError, Separator, Unit};

use crate::nonvolatile::TypedLine;

/// Bytes of a command word and of a long constant.
const WORD: u64 = 4;
/// Bytes of a number written in front of a line: a command and a constant.
const NUMBER: u64 = 2 * WORD;

/// A line of a stored text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct StoredLine {
    /// Its number, written or hidden.
    pub(crate) number: u32,
    /// The number is part of the text.
    pub(crate) written: bool,
    /// Its statements.
    pub(crate) text: String,
    bytes: u64,
}

impl StoredLine {
    fn new(number: u32, written: bool, text: String) -> Self {
        let bytes = line_bytes(&text) + if written { NUMBER } else { 0 };
        Self { number, written, text, bytes }
    }

    /// As `LIST` shows it.
    pub(crate) fn listed(&self, with_number: bool) -> String {
        if self.written || with_number { format!("{} {}", self.number, self.text) } else { self.text.clone() }
    }
}

/// The lines of a stored text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct StoredText {
    lines: Vec<StoredLine>,
    bytes: u64,
}

impl StoredText {
    /// The lines of a unit as the controller lists them, indented.
    pub(crate) fn of_unit(unit: &Unit, aliases: &[Alias]) -> Result<Self, ImageError> {
        let instructions = unit.decode()?;
        let firsts = instructions.iter().enumerate().filter(|(place, instruction)| {
            // The first statement begins a line whatever stands before it.
            *place == 0 || instruction.separator == Separator::Line
        });
        let written = firsts.map(|(_, instruction)| instruction.command == command::LINE_NUMBER);
        let listing = list(unit, aliases, &ListOptions { line_numbers: true })?;
        let mut text = Self { lines: Vec::new(), bytes: u64::from(unit.memory()) };
        for (line, written) in listing.lines().zip(written) {
            let (number, statements) = line.split_once(' ').unwrap_or((line, ""));
            text.lines.push(StoredLine::new(number.parse().unwrap_or(0), written, statements.to_owned()));
        }
        Ok(text)
    }

    /// A text that was kept as it was typed.
    pub(crate) fn of_lines(lines: &[TypedLine]) -> Self {
        let stored = |line: &TypedLine| StoredLine::new(line.number, line.written, line.text.clone());
        let lines: Vec<StoredLine> = lines.iter().map(stored).collect();
        let bytes = lines.iter().map(|line| line.bytes).sum();
        Self { lines, bytes }
    }

    /// The text as it was typed.
    pub(crate) fn typed(&self) -> Vec<TypedLine> {
        let typed =
            |line: &StoredLine| TypedLine { number: line.number, written: line.written, text: line.text.clone() };
        self.lines.iter().map(typed).collect()
    }

    /// The lines in their order.
    pub(crate) fn lines(&self) -> &[StoredLine] {
        &self.lines
    }

    /// Whether there is no line.
    pub(crate) fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }

    /// What the text takes of program memory.
    pub(crate) fn bytes(&self) -> u64 {
        self.bytes
    }

    /// Adds a line between `PROGRAM` and `ENDP`: at the end, but a number that does not rise puts its line before the first line with a higher
    /// written number, or in the place of the one with the same. What is beyond `space` bytes is counted and not kept.
    pub(crate) fn enter(&mut self, number: Option<u32>, text: &str, space: u64) {
        let end = self.lines.len();
        let range = number.map_or(end..end, |number| self.place_among_written(number));
        let last = self.lines.last().map_or(0, |line| line.number);
        let line =
            StoredLine::new(number.unwrap_or_else(|| hidden_line_number(last)), number.is_some(), text.to_owned());
        let replaced: u64 = self.lines.iter().take(range.end).skip(range.start).map(|line| line.bytes).sum();
        self.bytes = self.bytes.saturating_sub(replaced).saturating_add(line.bytes);
        if self.bytes <= space {
            self.lines.splice(range, [line]);
        }
    }

    /// What a line with a number that was written takes the place of, hidden numbers aside: nothing, or the line with this number.
    fn place_among_written(&self, number: u32) -> Range<usize> {
        let below = self.lines.iter().rposition(|line| line.written && line.number < number);
        let from = below.map_or(0, |below| below + 1);
        match self.lines.iter().enumerate().skip(from).find(|(_, line)| line.written) {
            Some((place, other)) => place..place + usize::from(other.number == number),
            None => self.lines.len()..self.lines.len(),
        }
    }

    /// Puts a numbered line at its place, where one with the same number is replaced.
    ///
    /// # Errors
    /// The bytes that the text would take, when they are more than `space`.
    pub(crate) fn put(&mut self, number: u32, text: &str, space: u64) -> Result<(), u64> {
        let line = StoredLine::new(number, true, text.to_owned());
        let place = self.lines.iter().position(|line| line.number >= number).unwrap_or(self.lines.len());
        let replaced = self.lines.get(place).filter(|line| line.number == number);
        let bytes = self.bytes.saturating_sub(replaced.map_or(0, |line| line.bytes)) + line.bytes;
        if bytes > space {
            return Err(bytes);
        }
        self.bytes = bytes;
        let end = place + usize::from(replaced.is_some());
        self.lines.splice(place..end, [line]);
        Ok(())
    }

    /// Removes the line with a number, if there is one.
    pub(crate) fn delete(&mut self, number: u32) {
        if let Some(place) = self.lines.iter().position(|line| line.number == number) {
            let line = self.lines.remove(place);
            self.bytes = self.bytes.saturating_sub(line.bytes);
        }
    }

    /// The text as a file would hold it. A line without a written number gets it where its neighbours would give it another one, so that no
    /// line changes its number when another is added or deleted.
    pub(crate) fn source(&self) -> String {
        let mut source = String::new();
        let mut before = 0;
        for line in &self.lines {
            source.push_str(&line.listed(line.number != hidden_line_number(before)));
            source.push('\n');
            before = line.number;
        }
        source
    }
}

/// What a line takes of program memory; one that cannot be read counts as a remark of its characters.
fn line_bytes(text: &str) -> u64 {
    let tree = acrc_syntax::parse(text);
    acrc_compile::stored_bytes(text, tree.statements()).map_or(2 * WORD + text.len() as u64, u64::from)
}
