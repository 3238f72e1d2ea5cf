//! A page of facts: a heading, a sentence, then labelled facts and small tables; as plain text in aligned columns, or as Markdown.

use crate::Confidence;

/// Columns before a fact.
const LABEL: usize = 16;
/// Columns of a page.
const WIDTH: usize = 100;

/// A page under construction. Empty facts leave no trace.
pub(super) struct Sheet {
    name: String,
    what: String,
    parts: Vec<Part>,
}

enum Part {
    Summary(String),
    /// What is written in the language.
    Code(&'static str, String),
    Fact(&'static str, String),
    /// Headings and rows; columns without any text are left out.
    Table(Vec<Vec<String>>),
}

impl Sheet {
    /// A page with its heading: the name of a thing and what it is.
    pub(super) fn new(name: &str, what: &str) -> Self {
        Self { name: name.to_owned(), what: what.to_owned(), parts: Vec::new() }
    }

    /// The sentence below the heading.
    pub(super) fn summary(mut self, text: &str) -> Self {
        if !text.is_empty() {
            self.parts.push(Part::Summary(format!("{text}.")));
        }
        self
    }

    /// A labelled form of the language.
    pub(super) fn code(mut self, label: &'static str, text: impl Into<String>) -> Self {
        let text = text.into();
        if !text.is_empty() {
            self.parts.push(Part::Code(label, text));
        }
        self
    }

    /// A labelled fact.
    pub(super) fn fact(mut self, label: &'static str, text: impl Into<String>) -> Self {
        let text = text.into();
        if !text.is_empty() {
            self.parts.push(Part::Fact(label, text));
        }
        self
    }

    /// A labelled list of names.
    pub(super) fn list<'a>(self, label: &'static str, names: impl IntoIterator<Item = &'a str>) -> Self {
        self.fact(label, names.into_iter().collect::<Vec<_>>().join(", "))
    }

    /// A table with a heading for each column; columns without any text are left out.
    pub(super) fn table<const N: usize>(mut self, heads: [&str; N], rows: &[[&str; N]]) -> Self {
        if rows.is_empty() {
            return self;
        }
        let kept: Vec<usize> = (0..N).filter(|column| rows.iter().any(|row| !row[*column].is_empty())).collect();
        let cells = |row: &[&str; N]| kept.iter().map(|column| row[*column].to_owned()).collect();
        self.parts.push(Part::Table(std::iter::once(&heads).chain(rows).map(cells).collect()));
        self
    }

    /// Where the facts come from, which ends the page.
    pub(super) fn origin(self, source: &str, confidence: Confidence) -> Self {
        self.fact("source", source).fact("confidence", confidence.label())
    }

    /// The page as plain text.
    pub(super) fn plain(&self) -> String {
        let mut page = format!("{} - {}\n", self.name, self.what);
        for part in &self.parts {
            match part {
                Part::Summary(text) => wrap(&mut page, "  ", text),
                Part::Code(label, text) | Part::Fact(label, text) => {
                    wrap(&mut page, &format!("  {label:<width$}", width = LABEL - 2), text);
                }
                Part::Table(rows) => table(&mut page, rows),
            }
        }
        page
    }

    /// The page as Markdown.
    pub(super) fn markdown(&self) -> String {
        let mut page = vec![format!("**{}** — {}\n", escaped(&self.name), escaped(&self.what))];
        let mut in_list = false;
        for part in &self.parts {
            if !matches!((part, in_list), (Part::Fact(..), true)) {
                page.push("\n".to_owned());
            }
            in_list = matches!(part, Part::Fact(..));
            page.push(match part {
                Part::Summary(text) => format!("{}\n", escaped(text)),
                Part::Code(_, text) => format!("```acrobasic\n{text}\n```\n"),
                Part::Fact(label, text) => format!("- {label}: {}\n", escaped(text)),
                Part::Table(rows) => markdown_table(rows),
            });
        }
        page.concat()
    }
}

/// A table in aligned columns between two empty lines.
fn table(page: &mut String, rows: &[Vec<String>]) {
    let columns = rows.first().map_or(0, Vec::len);
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns).map(width).collect();
    page.push('\n');
    for row in rows {
        let cells = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}"));
        let line = format!("  {}", cells.collect::<Vec<_>>().join("  "));
        page.push_str(line.trim_end());
        page.push('\n');
    }
    page.push('\n');
}

fn markdown_table(rows: &[Vec<String>]) -> String {
    let line =
        |row: &Vec<String>| format!("| {} |\n", row.iter().map(|cell| escaped(cell)).collect::<Vec<_>>().join(" | "));
    let mut lines: Vec<String> = rows.iter().map(line).collect();
    if let Some(heads) = rows.first() {
        lines.insert(1, format!("|{}\n", "---|".repeat(heads.len())));
    }
    lines.concat()
}

/// Text that Markdown shows as it is.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        if matches!(character, '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '|') {
            out.push('\\');
        }
        out.push(character);
    }
    out
}

/// Adds words behind a label, on as many lines as they need.
fn wrap(page: &mut String, label: &str, text: &str) {
    let indent = label.chars().count();
    let mut column = indent;
    page.push_str(label);
    for (index, word) in text.split(' ').enumerate() {
        let length = word.chars().count();
        if index > 0 && column + 1 + length > WIDTH {
            page.push('\n');
            page.push_str(&" ".repeat(indent));
            column = indent;
        } else if index > 0 {
            page.push(' ');
            column += 1;
        }
        page.push_str(word);
        column += length;
    }
    page.push('\n');
}
