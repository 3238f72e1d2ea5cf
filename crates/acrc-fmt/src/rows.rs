//! The lines of the new text, before columns are filled up and blank lines are set.

use std::ops::Range;

/// Written lines.
#[derive(Debug, Default)]
pub(crate) struct Rows {
    /// The text of all rows, one behind the other.
    body: String,
    pub(crate) rows: Vec<Row>,
}

/// One written line.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    /// Its text in the body.
    range: Range<usize>,
    /// Blanks before its first statement.
    pub(crate) indent: usize,
    /// Where it may be widened to stand in a column with its neighbours.
    pub(crate) table: Option<(Table, Stop)>,
    pub(crate) remark: Option<Stop>,
    pub(crate) role: Role,
    /// A blank line is put before it.
    pub(crate) blank_before: bool,
}

/// The tables whose lines are put into columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Table {
    /// `#DEFINE name operand`
    Define,
    /// `DIM kind(size)`
    Dim,
}

/// A place in a row that may be widened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Stop {
    /// Offset in the body.
    at: usize,
    /// Blanks that are put there.
    pub(crate) pad: usize,
}

/// What a line is, as far as blank lines go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// A blank line.
    Blank,
    /// A comment or a remark and nothing else.
    Comment,
    /// Statements.
    Code {
        /// The first one is a label.
        label: bool,
        /// The last one leaves the routine.
        leaves: bool,
    },
    /// A line that must stay as it is, as must the blank lines around it.
    Frozen,
}

impl Role {
    /// A line of which nothing is known.
    pub(crate) const OTHER: Self = Self::Code { label: false, leaves: false };
}

impl Rows {
    pub(crate) fn with_capacity(bytes: usize, rows: usize) -> Self {
        Self { body: String::with_capacity(bytes), rows: Vec::with_capacity(rows) }
    }

    /// The row that is being written.
    pub(crate) fn begin(&self, indent: usize, role: Role) -> Row {
        let start = self.body.len();
        Row { range: start..start, indent, table: None, remark: None, role, blank_before: false }
    }

    /// Where the body may be continued.
    pub(crate) fn out(&mut self) -> &mut String {
        &mut self.body
    }

    /// The present end of the body, as a place to widen.
    pub(crate) fn stop(&self) -> Stop {
        Stop { at: self.body.len(), pad: 0 }
    }

    /// Adds the row that was begun; its text is what was written since.
    pub(crate) fn end(&mut self, mut row: Row) {
        row.range.end = self.body.len();
        self.rows.push(row);
    }

    /// Adds a blank line, unless there is one already or it would be the first.
    pub(crate) fn blank(&mut self) {
        if self.rows.last().is_some_and(|last| last.role != Role::Blank) {
            self.rows.push(self.begin(0, Role::Blank));
        }
    }

    /// Adds a row with this text.
    pub(crate) fn copy(&mut self, text: &str, role: Role) {
        let row = self.begin(0, role);
        self.body.push_str(text);
        self.end(row);
    }

    /// Characters before a place in a row, padding not included.
    pub(crate) fn width(&self, row: &Row, stop: Stop) -> usize {
        self.body.get(row.range.start..stop.at).unwrap_or_default().chars().count()
    }

    /// The text with the line end given, without blank lines at its end.
    pub(crate) fn join(&self, line_end: &str) -> String {
        let padding: usize = self.rows.iter().map(|row| stops(row).map(|stop| stop.pad).sum::<usize>()).sum();
        let mut out = String::with_capacity(self.body.len() + padding + (self.rows.len() + 1) * line_end.len());
        let mut blank = false;
        for row in &self.rows {
            if row.role == Role::Blank {
                blank = true;
                continue;
            }
            if blank || row.blank_before {
                out.push_str(line_end);
            }
            blank = false;
            self.write(&mut out, row);
            out.push_str(line_end);
        }
        out
    }

    fn write(&self, out: &mut String, row: &Row) {
        let mut from = row.range.start;
        for stop in stops(row).filter(|stop| stop.pad > 0) {
            out.push_str(self.body.get(from..stop.at).unwrap_or_default());
            out.extend(std::iter::repeat_n(' ', stop.pad));
            from = stop.at;
        }
        out.push_str(self.body.get(from..row.range.end).unwrap_or_default());
    }
}

/// The places of a row that are widened, in order.
fn stops(row: &Row) -> impl Iterator<Item = Stop> + use<> {
    row.table.map(|(_, stop)| stop).into_iter().chain(row.remark)
}
