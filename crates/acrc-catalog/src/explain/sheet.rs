//! A page of facts as plain text: a heading, a sentence, then labelled facts and small tables in aligned columns.

use crate::Confidence;

/// Columns before a fact.
const LABEL: usize = 16;
/// Columns of a page.
const WIDTH: usize = 100;

/// A page under construction. Empty facts leave no trace.
pub(super) struct Sheet(String);

impl Sheet {
    /// A page with its heading: the name of a thing and what it is.
    pub(super) fn new(name: &str, what: &str) -> Self {
        Self(format!("{name} - {what}\n"))
    }

    /// The sentence below the heading.
    pub(super) fn summary(mut self, text: &str) -> Self {
        if !text.is_empty() {
            self.wrap("  ", &format!("{text}."));
        }
        self
    }

    /// A labelled fact.
    pub(super) fn fact(mut self, label: &str, text: impl AsRef<str>) -> Self {
        let text = text.as_ref();
        if !text.is_empty() {
            let label = format!("  {label:<width$}", width = LABEL - 2);
            self.wrap(&label, text);
        }
        self
    }

    /// A labelled list of names.
    pub(super) fn list<'a>(self, label: &str, names: impl IntoIterator<Item = &'a str>) -> Self {
        self.fact(label, names.into_iter().collect::<Vec<_>>().join(", "))
    }

    /// A table with a heading for each column; columns without any text are left out.
    pub(super) fn table<const N: usize>(mut self, heads: [&str; N], rows: &[[&str; N]]) -> Self {
        if rows.is_empty() {
            return self;
        }
        self.0.push('\n');
        let width = |column: usize| {
            let longest = rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
            if longest == 0 { 0 } else { longest.max(heads[column].len()) }
        };
        let widths: [usize; N] = std::array::from_fn(width);
        for row in std::iter::once(&heads).chain(rows) {
            let cells =
                row.iter().zip(widths).filter(|(_, width)| *width > 0).map(|(cell, width)| format!("{cell:<width$}"));
            let line = format!("  {}", cells.collect::<Vec<_>>().join("  "));
            self.0.push_str(line.trim_end());
            self.0.push('\n');
        }
        self.0.push('\n');
        self
    }

    /// Where the facts come from, which ends the page.
    pub(super) fn origin(self, source: &str, confidence: Confidence) -> String {
        self.fact("source", source).fact("confidence", confidence.label()).0
    }

    /// Ends the page without a source.
    pub(super) fn end(self) -> String {
        self.0
    }

    /// Adds words behind a label, on as many lines as they need.
    fn wrap(&mut self, label: &str, text: &str) {
        let indent = label.chars().count();
        let mut column = indent;
        self.0.push_str(label);
        for (index, word) in text.split(' ').enumerate() {
            let length = word.chars().count();
            if index > 0 && column + 1 + length > WIDTH {
                self.0.push('\n');
                self.0.push_str(&" ".repeat(indent));
                column = indent;
            } else if index > 0 {
                self.0.push(' ');
                column += 1;
            }
            self.0.push_str(word);
            column += length;
        }
        self.0.push('\n');
    }
}
