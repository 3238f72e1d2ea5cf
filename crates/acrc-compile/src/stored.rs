//! The stored text of one program while files are read: lines entered between `PROGRAM` and `ENDP`, and lines with a number, which take their
//! place among them (guide, "Line Numbers").

use std::ops::Range;

use acrc_image::list::hidden_line_number;
use acrc_syntax::ast::LineNumber;

/// A line of a stored text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct StoredLine {
    /// The number written in front of it.
    pub(crate) number: Option<u32>,
    /// Index of its file.
    pub(crate) file: usize,
    /// Its statements in the tree of the file.
    pub(crate) statements: Range<u32>,
}

/// The stored text of one program.
#[derive(Clone, Debug, Default)]
pub(crate) struct StoredText {
    /// The lines in their order, with the number that each has or is hidden behind.
    lines: Vec<(u32, StoredLine)>,
}

impl StoredText {
    /// The lines in their order.
    pub(crate) fn lines(&self) -> impl Iterator<Item = &StoredLine> {
        self.lines.iter().map(|(_, line)| line)
    }

    /// Adds a line between `PROGRAM` and `ENDP`: at the end, but a number that does not rise puts its line before the first line with a higher
    /// written number, or in the place of the one with the same. Hidden numbers do not count: nobody wrote them.
    pub(crate) fn enter(&mut self, line: StoredLine) {
        let Some(number) = line.number.filter(|number| *number <= LineNumber::MAX) else { return self.append(line) };
        let below = self.lines.iter().rposition(|(_, other)| other.number.is_some_and(|other| other < number));
        let from = below.map_or(0, |below| below + 1);
        let next = self.lines.iter().enumerate().skip(from).find_map(|(place, (_, line))| Some((place, line.number?)));
        match next {
            None => self.append(line),
            Some((place, other)) => {
                let end = place + usize::from(other == number);
                self.lines.splice(place..end, [(number, line)]);
            }
        }
    }

    /// Adds a line at the end.
    pub(crate) fn append(&mut self, line: StoredLine) {
        let number = line.number.unwrap_or_else(|| hidden_line_number(self.last()));
        self.lines.push((number, line));
    }

    /// Puts a numbered line at its place; one with the same number is replaced.
    pub(crate) fn insert(&mut self, number: u32, line: StoredLine) {
        match self.place(number) {
            Ok(place) => {
                self.lines.splice(place..=place, [(number, line)]);
            }
            Err(place) => self.lines.insert(place, (number, line)),
        }
    }

    /// Removes the line with a number.
    pub(crate) fn delete(&mut self, number: u32) {
        if let Ok(place) = self.place(number) {
            self.lines.remove(place);
        }
    }

    fn last(&self) -> u32 {
        self.lines.last().map_or(0, |&(number, _)| number)
    }

    /// The place of the line with a number, or the place where it would stand.
    fn place(&self, number: u32) -> Result<usize, usize> {
        if self.last() < number {
            return Err(self.lines.len());
        }
        let place = self.lines.iter().position(|&(other, _)| other >= number).unwrap_or(self.lines.len());
        match self.lines.get(place) {
            Some(&(other, _)) if other == number => Ok(place),
            _ => Err(place),
        }
    }
}
