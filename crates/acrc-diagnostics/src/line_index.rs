//! Byte offsets to lines and columns.

use std::fmt;

use crate::Span;

/// A place as people and editors name it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Position {
    /// Line, from 1.
    pub line: u32,
    /// Column in Unicode scalar values, from 1. A tab is one column.
    pub column: u32,
}

impl fmt::Display for Position {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.line, self.column)
    }
}

/// The lines of one text, so that an offset finds its line and column without looking at the text again.
///
/// A line ends at LF, CRLF or a lone CR. The text after the last line end is a line of its own, also when it is empty,
/// so every text has at least one line. A lookup takes two binary searches, whatever the length of a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LineIndex {
    /// Content of each line, without its line end.
    lines: Vec<Span>,
    /// Characters of more than one byte, in order.
    wide: Vec<Wide>,
}

/// A character of more than one byte.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Wide {
    start: u32,
    /// Bytes beyond one a character, of all wide characters up to and including this one.
    surplus: u32,
}

impl LineIndex {
    /// Reads `text` once. Bytes beyond the first 4 GiB are not indexed: an offset can't name them.
    #[must_use]
    pub fn new(text: &str) -> Self {
        let bytes = text.as_bytes();
        let mut lines = Vec::with_capacity(bytes.len() / 32 + 1);
        let mut wide: Vec<Wide> = Vec::new();
        let mut surplus = 0;
        let mut line_start = 0;
        let mut after_cr = false;
        for (offset, &byte) in (0..u32::MAX).zip(bytes) {
            match byte {
                // The second half of a CRLF: the line was closed at the CR, and its successor starts one byte later.
                b'\n' if after_cr => line_start = offset + 1,
                b'\n' | b'\r' => {
                    lines.push(Span::new(line_start, offset));
                    line_start = offset + 1;
                }
                0x80..=0xBF => {
                    surplus += 1;
                    if let Some(last) = wide.last_mut() {
                        last.surplus = surplus;
                    }
                }
                0xC0.. => wide.push(Wide { start: offset, surplus }),
                _ => {}
            }
            after_cr = byte == b'\r';
        }
        lines.push(Span::from(line_start as usize..bytes.len()));
        Self { lines, wide }
    }

    /// Line and column of `offset`. An offset inside a character counts as its start, one inside a line end as the end
    /// of the line, one beyond the text as its end.
    #[must_use]
    pub fn position(&self, offset: u32) -> Position {
        let line = self.line_of(offset);
        let span = self.lines.get(line).copied().unwrap_or_default();
        let offset = offset.min(span.end);
        let column = (offset - self.surplus_before(offset)) - (span.start - self.surplus_before(span.start));
        Position { line: line as u32 + 1, column: column + 1 }
    }

    /// The content of a line, counted from 1, without its line end; `None` beyond the last line.
    #[must_use]
    pub fn line_span(&self, line: u32) -> Option<Span> {
        self.lines.get((line as usize).checked_sub(1)?).copied()
    }

    /// Number of lines, at least 1.
    #[must_use]
    pub fn line_count(&self) -> u32 {
        self.lines.len() as u32
    }

    /// The line that `offset` is on, counted from 0.
    fn line_of(&self, offset: u32) -> usize {
        self.lines.partition_point(|line| line.start <= offset).saturating_sub(1)
    }

    /// How many of the bytes before `offset` do not begin a character that ends at or before it.
    fn surplus_before(&self, offset: u32) -> u32 {
        let count = self.wide.partition_point(|wide| wide.start < offset);
        let Some((last, before)) = self.wide.get(..count).and_then(<[Wide]>::split_last) else {
            return 0;
        };
        let surplus_of_earlier = before.last().map_or(0, |wide| wide.surplus);
        last.surplus.min(surplus_of_earlier + (offset - last.start))
    }
}
