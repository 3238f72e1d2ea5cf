//! The marked source, laid out by ariadne.

use std::io;

use ariadne::{Color, Config, IndexType, Label, Report, ReportKind, Source};

use super::excerpt::Excerpt;
use super::gutter::{Gutter, Margin};
use super::severity_color;
use crate::Diagnostic;
use crate::plain::plain_line;

/// Blue of the places that explain a finding.
const RELATED_COLOR: Color = Color::Blue;
/// What is written at a mark that has no text: ariadne draws no mark without one.
const UNNAMED: &str = "here";
/// What ariadne ends its own margin with beside a row that shows something, and beside lines left out.
const RULE: char = '│';
const GAP_RULE: char = '┆';
/// Rows that ariadne puts before the source: title, place, and an empty one.
const ROWS_ABOVE: usize = 3;
const COLOR_RESET: &str = "\x1b[0m";

/// Draws the rows of the excerpt with the marks of `diagnostic` below them.
pub(super) fn draw(
    excerpt: &Excerpt,
    diagnostic: &Diagnostic,
    color: bool,
    gutter: &Gutter,
    page: &mut Vec<u8>,
) -> io::Result<()> {
    let mut drawn = Vec::new();
    let config = Config::new().with_color(color).with_index_type(IndexType::Byte);
    Report::build(ReportKind::Error, 0..0)
        .with_config(config)
        .with_labels(labels(excerpt, diagnostic))
        .finish()
        .write(&Source::from(excerpt.text()), &mut drawn)?;

    let drawn = String::from_utf8_lossy(&drawn);
    let mut rows = drawn.lines().skip(ROWS_ABOVE).peekable();
    while let Some(row) = rows.next() {
        // The last row is ariadne's bottom edge; the gutter draws its own, after the remarks.
        if rows.peek().is_none() {
            break;
        }
        let (margin, row) = split_margin(row, excerpt);
        gutter.row(page, margin, row)?;
    }
    Ok(())
}

/// Parts a row from its margin, and finds the line that the margin numbers: ariadne counts from the top of the excerpt.
fn split_margin<'r>(row: &'r str, excerpt: &Excerpt) -> (Margin, &'r str) {
    let Some((left, rule, right)) = split_at_rule(row) else {
        return (Margin::Blank, row);
    };
    let right = right.strip_prefix(COLOR_RESET).unwrap_or(right);
    let right = right.strip_prefix(' ').unwrap_or(right);
    let number = trailing_number(left).and_then(|row| excerpt.line_number(row));
    // A row of marks always shows something; one that does not stands for lines without marks.
    let is_gap = rule == GAP_RULE || right.trim().is_empty();
    let margin = match number {
        Some(number) => Margin::Line(number),
        None if is_gap => Margin::Gap,
        None => Margin::Blank,
    };
    (margin, right)
}

fn split_at_rule(row: &str) -> Option<(&str, char, &str)> {
    let (at, rule) = row.char_indices().find(|(_, c)| [RULE, GAP_RULE].contains(c))?;
    Some((row.get(..at)?, rule, row.get(at + rule.len_utf8()..)?))
}

/// The number that `text` ends with, before spaces.
fn trailing_number(text: &str) -> Option<usize> {
    let text = text.trim_end_matches(' ');
    let before = text.trim_end_matches(|c: char| c.is_ascii_digit());
    text.strip_prefix(before)?.parse().ok()
}

fn labels(excerpt: &Excerpt, diagnostic: &Diagnostic) -> Vec<Label> {
    let primary = diagnostic.label.as_deref().unwrap_or(UNNAMED);
    let texts = std::iter::once((primary, severity_color(diagnostic.severity)))
        .chain(diagnostic.labels.iter().map(|label| (label.message.as_str(), RELATED_COLOR)));
    let marked = excerpt.marks().iter().cloned().zip(texts.map(Some));
    // ariadne leaves out a line without a label; one without text shows its line and draws nothing.
    let unmarked = excerpt.unmarked_line_ends().map(|end| (end..end + 1, None));
    let mut labels: Vec<_> = marked.chain(unmarked).collect();
    // ariadne opens the file a second time when a label ends on an earlier line than the label before it.
    labels.sort_by_key(|(mark, _)| (mark.end, mark.start));
    let label = |(mark, text): (_, Option<(&str, Color)>)| match text {
        Some((text, color)) => Label::new(mark).with_message(plain_line(text)).with_color(color),
        None => Label::new(mark),
    };
    labels.into_iter().map(label).collect()
}
