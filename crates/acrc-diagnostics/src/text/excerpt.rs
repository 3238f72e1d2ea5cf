//! The few lines of a file that a finding is shown with.
//!
//! An excerpt is a text of its own: lines between the shown ones are left out, a line too long to read is cut to a
//! window around the mark, and every character in it is visible and keeps its place. Offsets in the file are translated
//! to offsets in the excerpt.

use std::ops::Range;

use crate::plain::visible;
use crate::{Diagnostic, SourceFile, Span};

/// Longest line shown in full, in bytes.
const LONGEST_LINE: u32 = 200;
/// How much of a longer line is shown before the mark and from its start on, in bytes.
const WINDOW: (u32, u32) = (60, 100);
/// Stands where a line was cut.
const CUT: &str = "…";
/// Ends every line of an excerpt. The space is what a mark at the end of a line stands on.
const LINE_END: &str = " \n";

/// A part of a file, made to be shown.
pub(super) struct Excerpt {
    text: String,
    rows: Vec<Row>,
    marks: Vec<Range<usize>>,
}

/// One line of an excerpt.
struct Row {
    /// Number in the file, from 1; `None` for a row that stands for lines left out.
    number: Option<u32>,
    /// What is shown of the line: its range in the file and in the excerpt, there without line end and cut marks.
    source: Span,
    shown: Range<usize>,
    /// Where its line end begins in the excerpt.
    line_end: usize,
    /// Whether a mark begins or ends here.
    marked: bool,
}

/// A marked span, brought inside the text, with the lines that it begins and ends on.
#[derive(Clone, Copy)]
struct Mark {
    span: Span,
    first: u32,
    last: u32,
}

impl Excerpt {
    /// The lines on which the spans of `diagnostic` begin or end, with `context` lines around each of them.
    pub(super) fn new(file: &SourceFile<'_>, diagnostic: &Diagnostic, context: u32) -> Self {
        let spans = std::iter::once(diagnostic.span).chain(diagnostic.labels.iter().map(|label| label.span));
        let marks: Vec<Mark> = spans.map(|span| Mark::new(file, span)).collect();
        let mut excerpt = Self { text: String::new(), rows: Vec::new(), marks: Vec::new() };
        let mut previous = None;
        for number in shown_lines(file, &marks, context) {
            if previous.is_some_and(|previous| number > previous + 1) {
                excerpt.push_gap();
            }
            excerpt.push_line(file, number, &marks);
            previous = Some(number);
        }
        excerpt.marks = marks.iter().map(|mark| excerpt.translate(file, *mark)).collect();
        excerpt
    }

    /// The text to show.
    pub(super) fn text(&self) -> &str {
        &self.text
    }

    /// Number in the file of a row of the excerpt, both from 1; `None` for a row that stands for lines left out.
    pub(super) fn line_number(&self, row: usize) -> Option<u32> {
        self.rows.get(row.checked_sub(1)?)?.number
    }

    /// The largest line number shown.
    pub(super) fn last_line_number(&self) -> u32 {
        self.rows.last().and_then(|row| row.number).unwrap_or(1)
    }

    /// Where the marks are in [`Self::text`]: first that of the finding itself, then those of its labels, in order.
    /// None is empty: a mark between two characters stands on the one after it.
    pub(super) fn marks(&self) -> &[Range<usize>] {
        &self.marks
    }

    /// Where the line ends of the lines that no mark touches begin in [`Self::text`].
    pub(super) fn unmarked_line_ends(&self) -> impl Iterator<Item = usize> {
        self.rows.iter().filter(|row| !row.marked && row.number.is_some()).map(|row| row.line_end)
    }

    fn push_gap(&mut self) {
        let here = self.text.len();
        self.rows.push(Row { number: None, source: Span::default(), shown: here..here, line_end: here, marked: false });
        self.text.push_str(LINE_END);
    }

    fn push_line(&mut self, file: &SourceFile<'_>, number: u32, marks: &[Mark]) {
        let line = file.index().line_span(number).unwrap_or_default();
        let focus = marks.iter().find_map(|mark| mark.anchor_on(number));
        let source = window(file, line, focus.unwrap_or(line.start));
        if source.start > line.start {
            self.text.push_str(CUT);
        }
        let start = self.text.len();
        self.text.extend(file.slice(source).chars().map(shown));
        let shown = start..self.text.len();
        if source.end < line.end {
            self.text.push_str(CUT);
        }
        let line_end = self.text.len();
        self.text.push_str(LINE_END);
        self.rows.push(Row { number: Some(number), source, shown, line_end, marked: focus.is_some() });
    }

    fn translate(&self, file: &SourceFile<'_>, mark: Mark) -> Range<usize> {
        let start = self.offset(file, mark.first, mark.span.start);
        let end = self.offset(file, mark.last, mark.span.end);
        if end > start {
            return start..end;
        }
        // An empty span, or one that lies in what was cut off: the character that now stands there.
        let next = self.text.get(start..).and_then(|rest| rest.chars().next());
        start..start + next.map_or(0, char::len_utf8)
    }

    /// Translates an offset on line `number` of the file. What lies before the part shown is moved to its start, what
    /// lies behind it to the place after it.
    fn offset(&self, file: &SourceFile<'_>, number: u32, offset: u32) -> usize {
        let found = self.rows.iter().find(|row| row.number == Some(number));
        let Some(Row { source, shown: place, .. }) = found else {
            return 0;
        };
        if offset > source.end {
            let behind = self.text.get(place.end..).and_then(|rest| rest.chars().next());
            return place.end + behind.map_or(0, char::len_utf8);
        }
        let before = Span::new(source.start, offset);
        place.start + file.slice(before).chars().map(|c| shown(c).len_utf8()).sum::<usize>()
    }
}

impl Mark {
    fn new(file: &SourceFile<'_>, span: Span) -> Self {
        let Range { start, end } = span.range();
        let start = file.text.floor_char_boundary(start);
        let end = file.text.ceil_char_boundary(end.max(start));
        let span = Span::from(start..end);
        let last_byte = span.start.max(span.end.saturating_sub(1));
        let line = |offset| file.position(offset).line;
        Self { span, first: line(span.start), last: line(last_byte) }
    }

    /// The offset to look at when only a part of line `number` can be shown; `None` if the mark neither begins nor ends
    /// there.
    fn anchor_on(self, number: u32) -> Option<u32> {
        if self.first == number { Some(self.span.start) } else { (self.last == number).then_some(self.span.end) }
    }
}

/// The lines to show, in order: those with a mark, their context, and single lines that would be left out between them.
fn shown_lines(file: &SourceFile<'_>, marks: &[Mark], context: u32) -> Vec<u32> {
    let last_line = file.index().line_count();
    let mut lines: Vec<u32> = marks
        .iter()
        .flat_map(|mark| [mark.first, mark.last])
        .flat_map(|line| line.saturating_sub(context).max(1)..=line.saturating_add(context).min(last_line))
        .collect();
    lines.sort_unstable();
    lines.dedup();
    let single_gaps: Vec<u32> =
        lines.windows(2).filter(|pair| pair[1] - pair[0] == 2).map(|pair| pair[0] + 1).collect();
    lines.extend(single_gaps);
    lines.sort_unstable();
    lines
}

/// The part of `line` to show so that `focus` can be read with what stands around it.
fn window(file: &SourceFile<'_>, line: Span, focus: u32) -> Span {
    if line.len() <= LONGEST_LINE {
        return line;
    }
    let (before, after) = WINDOW;
    let start = focus.saturating_sub(before).max(line.start);
    let end = focus.saturating_add(after).min(line.end);
    let start = file.text.floor_char_boundary(start as usize);
    let end = file.text.ceil_char_boundary(end as usize);
    Span::from(start..end)
}

/// A tab stays, because its width depends on where it stands; ariadne expands it.
const fn shown(c: char) -> char {
    match c {
        '\t' => c,
        other => visible(other),
    }
}
