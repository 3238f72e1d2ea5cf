//! The margin: file name, line numbers, the rule down the left side, and the remarks that hang on it.

use std::fmt;
use std::io::{self, Write};

use ariadne::{Color, Fmt};

use crate::Position;
use crate::plain::plain_line;

/// Grey of the numbers and rules.
const MARGIN_COLOR: Color = Color::Fixed(246);
/// Green of the headings of remarks.
const REMARK_COLOR: Color = Color::Fixed(115);

/// What stands left of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Margin {
    /// A line of the source, with its number from 1.
    Line(u32),
    /// A row below such a line.
    Blank,
    /// Lines left out.
    Gap,
}

/// A margin wide enough for the line numbers of one excerpt.
pub(super) struct Gutter {
    width: usize,
    color: bool,
}

impl Gutter {
    pub(super) fn new(last_line_number: u32, color: bool) -> Self {
        Self { width: last_line_number.max(1).ilog10() as usize + 1, color }
    }

    /// The top edge with the place of the finding.
    pub(super) fn open(&self, out: &mut Vec<u8>, file: &str, place: Position) -> io::Result<()> {
        let indent = self.width + 2;
        let edge = self.paint("╭─[");
        writeln!(out, "{:indent$}{edge} {}:{place} {}", "", plain_line(file), self.paint("]"))
    }

    /// One row of the excerpt. Spaces at its end are dropped.
    pub(super) fn row(&self, out: &mut Vec<u8>, margin: Margin, row: &str) -> io::Result<()> {
        let width = self.width;
        let left = match margin {
            Margin::Line(number) => format!(" {number:width$} │"),
            Margin::Blank => format!(" {:width$} │", ""),
            Margin::Gap => format!(" {:width$} ┆", ""),
        };
        let row = row.trim_end();
        let space = if row.is_empty() { "" } else { " " };
        writeln!(out, "{}{space}{row}", self.paint(left))
    }

    /// A remark below the excerpt; its further lines stand under the first.
    pub(super) fn remark(&self, out: &mut Vec<u8>, heading: &str, text: &str) -> io::Result<()> {
        let painted = heading.fg(self.color.then_some(REMARK_COLOR));
        let indent = heading.len() + 2;
        let mut lines = text.lines();
        let first = plain_line(lines.next().unwrap_or_default());
        self.row(out, Margin::Blank, &format!("{painted}: {first}"))?;
        for line in lines {
            self.row(out, Margin::Blank, &format!("{:indent$}{}", "", plain_line(line)))?;
        }
        Ok(())
    }

    /// The bottom edge.
    pub(super) fn close(&self, out: &mut Vec<u8>) -> io::Result<()> {
        writeln!(out, "{}", self.paint(format!("{}╯", "─".repeat(self.width + 2))))
    }

    fn paint(&self, text: impl fmt::Display) -> impl fmt::Display {
        text.fg(self.color.then_some(MARGIN_COLOR))
    }
}
