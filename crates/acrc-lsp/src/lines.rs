//! Lines and columns as the protocol counts them: in UTF-8, UTF-16 or UTF-32 units, with lines that end at LF, CRLF or a
//! lone CR.

use acrc_diagnostics::Span;
use tower_lsp_server::ls_types::{Position, PositionEncodingKind, Range};

/// What a column counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Encoding {
    /// Bytes.
    Utf8,
    /// What the protocol counts when nothing is said.
    #[default]
    Utf16,
    /// Characters.
    Utf32,
}

impl Encoding {
    /// The first of the client's choices that is known here.
    pub(crate) fn negotiate(offered: Option<&[PositionEncodingKind]>) -> Self {
        offered.unwrap_or_default().iter().find_map(Self::of).unwrap_or_default()
    }

    fn of(kind: &PositionEncodingKind) -> Option<Self> {
        [Self::Utf8, Self::Utf16, Self::Utf32].into_iter().find(|encoding| encoding.kind() == *kind)
    }

    pub(crate) fn kind(self) -> PositionEncodingKind {
        match self {
            Self::Utf8 => PositionEncodingKind::UTF8,
            Self::Utf16 => PositionEncodingKind::UTF16,
            Self::Utf32 => PositionEncodingKind::UTF32,
        }
    }

    /// Units of a character of so many bytes.
    fn units(self, bytes: u32) -> u32 {
        match self {
            Self::Utf8 => bytes,
            Self::Utf16 => 1 + u32::from(bytes == 4),
            Self::Utf32 => 1,
        }
    }
}

/// The lines of one text. A lookup takes binary searches only, whatever the length of a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Lines {
    encoding: Encoding,
    /// Content of each line, without its end.
    lines: Vec<Span>,
    /// Characters of more than one byte, in order.
    wide: Vec<Wide>,
}

/// A character of more than one byte.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Wide {
    start: u32,
    end: u32,
    /// Bytes beyond one a unit, of all wide characters up to and including this one.
    surplus: u32,
}

impl Lines {
    pub(crate) fn new(text: &str, encoding: Encoding) -> Self {
        Self { encoding, lines: lines_of(text, 0), wide: wide(text, 0, encoding) }
    }

    /// Follows an edit: `text` is what is there now, with `inserted` bytes in place of `span`. Only the lines around it
    /// are read again.
    pub(crate) fn edit(&mut self, text: &str, span: Span, inserted: u32) {
        // A line more at both ends: an edit may make or split a CRLF.
        let first = self.lines.partition_point(|line| line.start <= span.start).saturating_sub(2);
        let next = self.lines.partition_point(|line| line.start <= span.end + 1);
        let start = self.lines.get(first).map_or(0, |line| line.start);
        let behind = self.lines.get(next).map(|line| line.start);
        let moved = |offset: u32| offset - span.len() + inserted;
        let part = slice(text, Span::new(start, behind.map_or(text.len() as u32, moved)));
        let mut lines = lines_of(part, start);
        if behind.is_some() {
            // The line behind the last line end of the part is the next one, which is there.
            lines.pop();
        }
        for line in self.lines.get_mut(next..).unwrap_or_default() {
            *line = Span::new(moved(line.start), moved(line.end));
        }
        self.lines.splice(first..next, lines);
        self.edit_wide(part, Span::new(start, behind.unwrap_or(u32::MAX)), moved);
    }

    /// Replaces the wide characters of a part, and moves those behind it.
    fn edit_wide(&mut self, part: &str, old: Span, moved: impl Fn(u32) -> u32) {
        let first = self.wide.partition_point(|wide| wide.start < old.start);
        let next = self.wide.partition_point(|wide| wide.start < old.end);
        let before = self.surplus(first);
        let gone = self.surplus(next) - before;
        let mut wide = wide(part, old.start, self.encoding);
        let come = wide.last().map_or(0, |wide| wide.surplus);
        for wide in &mut wide {
            wide.surplus += before;
        }
        for wide in self.wide.get_mut(next..).unwrap_or_default() {
            let surplus = wide.surplus - gone + come;
            *wide = Wide { start: moved(wide.start), end: moved(wide.end), surplus };
        }
        self.wide.splice(first..next, wide);
    }

    /// What columns count.
    pub(crate) fn encoding(&self) -> Encoding {
        self.encoding
    }

    /// Line and column of an offset. One inside a character counts as its start, one inside a line end as the end of
    /// the line, one beyond the text as its end.
    pub(crate) fn position(&self, offset: u32) -> Position {
        let line = self.lines.partition_point(|line| line.start <= offset).saturating_sub(1);
        let span = self.lines.get(line).copied().unwrap_or_default();
        let offset = offset.min(span.end);
        let first = self.wide.partition_point(|wide| wide.end <= span.start);
        let last = self.wide.partition_point(|wide| wide.end <= offset);
        let inside = self.wide.get(last).map(|wide| wide.start).filter(|start| *start < offset);
        let offset = inside.unwrap_or(offset);
        Position::new(line as u32, offset - span.start - (self.surplus(last) - self.surplus(first)))
    }

    pub(crate) fn range(&self, span: Span) -> Range {
        Range::new(self.position(span.start), self.position(span.end))
    }

    /// The offset of a position. A column beyond its line counts as the end of the line, a line beyond the text as the
    /// end of the text, a place inside a character as its start.
    pub(crate) fn offset(&self, position: Position) -> u32 {
        let Some(line) = self.lines.get(position.line as usize) else {
            return self.lines.last().map_or(0, |line| line.end);
        };
        let first = self.wide.partition_point(|wide| wide.end <= line.start);
        let last = self.wide.partition_point(|wide| wide.end <= line.end);
        let base = self.surplus(first);
        let inside = self.wide.get(first..last).unwrap_or_default();
        // How many wide characters end at or before the column.
        let before = inside.partition_point(|wide| wide.end - line.start - (wide.surplus - base) <= position.character);
        let surplus = self.surplus(first + before) - base;
        let offset = line.start.saturating_add(position.character).saturating_add(surplus).min(line.end);
        match inside.get(before) {
            Some(next) if next.start < offset => next.start,
            _ => offset,
        }
    }

    /// The bytes of a range; `None` when it ends before it begins.
    pub(crate) fn span(&self, range: Range) -> Option<Span> {
        let (start, end) = (self.offset(range.start), self.offset(range.end));
        (start <= end).then(|| Span::new(start, end))
    }

    /// Units from one offset to another in the same line.
    pub(crate) fn units(&self, span: Span) -> u32 {
        let (start, end) = (self.position(span.start), self.position(span.end));
        end.character.saturating_sub(start.character)
    }

    /// The parts of a span by line, without line ends: what many clients want of tokens.
    pub(crate) fn split(&self, span: Span) -> impl Iterator<Item = Span> + '_ {
        let first = self.lines.partition_point(|line| line.start <= span.start).saturating_sub(1);
        let lines = self.lines.get(first..).unwrap_or_default().iter();
        lines
            .take_while(move |line| line.start < span.end || (line.start == span.start && span.is_empty()))
            .map(move |line| Span::new(span.start.max(line.start), span.end.min(line.end)))
            .filter(|part| !part.is_empty())
    }

    fn surplus(&self, count: usize) -> u32 {
        count.checked_sub(1).and_then(|last| self.wide.get(last)).map_or(0, |wide| wide.surplus)
    }
}

fn slice(text: &str, span: Span) -> &str {
    text.get(span.range()).unwrap_or_default()
}

/// The lines of a text that begins at `offset`.
fn lines_of(text: &str, offset: u32) -> Vec<Span> {
    let bytes = text.as_bytes();
    let mut lines = Vec::with_capacity(bytes.len() / 24 + 1);
    let mut start = offset;
    let mut after_cr = false;
    for (at, &byte) in (offset..).zip(bytes) {
        match byte {
            // The second half of a CRLF: the line was closed at the CR.
            b'\n' if after_cr => start = at + 1,
            b'\n' | b'\r' => {
                lines.push(Span::new(start, at));
                start = at + 1;
            }
            _ => {}
        }
        after_cr = byte == b'\r';
    }
    lines.push(Span::new(start, offset + bytes.len() as u32));
    lines
}

/// The wide characters of a text that begins at `offset`.
fn wide(text: &str, offset: u32, encoding: Encoding) -> Vec<Wide> {
    if text.is_ascii() {
        return Vec::new();
    }
    let mut surplus = 0;
    let characters = text.char_indices().filter(|(_, character)| !character.is_ascii());
    let wide = characters.map(|(start, character)| {
        let bytes = character.len_utf8() as u32;
        surplus += bytes - encoding.units(bytes);
        let start = offset + start as u32;
        Wide { start, end: start + bytes, surplus }
    });
    wide.collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const ENCODINGS: [Encoding; 3] = [Encoding::Utf8, Encoding::Utf16, Encoding::Utf32];

    fn units(text: &str, encoding: Encoding) -> u32 {
        text.chars().map(|character| encoding.units(character.len_utf8() as u32)).sum()
    }

    #[test]
    fn columns_count_what_was_agreed() {
        let text = "a\u{e9}\u{1f600}z\r\nb\rc\n";
        for (encoding, column) in ENCODINGS.into_iter().zip([7, 4, 3]) {
            let lines = Lines::new(text, encoding);
            assert_eq!(lines.position(7), Position::new(0, column), "{encoding:?}");
            assert_eq!(lines.offset(Position::new(0, column)), 7, "{encoding:?}");
        }
    }

    #[test]
    fn every_line_end_counts() {
        let lines = Lines::new("a\r\nb\rc\n", Encoding::Utf16);
        assert_eq!(lines.position(3), Position::new(1, 0));
        assert_eq!(lines.position(5), Position::new(2, 0));
        assert_eq!(lines.position(7), Position::new(3, 0));
        assert_eq!(lines.position(2), Position::new(0, 1), "between CR and LF");
    }

    #[test]
    fn a_place_beyond_is_brought_back() {
        let lines = Lines::new("ab\ncd", Encoding::Utf16);
        assert_eq!(lines.offset(Position::new(0, 9)), 2);
        assert_eq!(lines.offset(Position::new(7, 0)), 5);
        assert_eq!(lines.offset(Position::new(0, u32::MAX)), 2);
        assert_eq!(lines.span(Range::new(Position::new(1, 0), Position::new(0, 1))), None);
    }

    proptest! {
        #[test]
        fn offsets_come_back(text in "[ab\u{e9}\u{20ac}\u{1f600}\r\n]{0,40}") {
            for encoding in ENCODINGS {
                let lines = Lines::new(&text, encoding);
                for (offset, _) in text.char_indices().chain([(text.len(), ' ')]) {
                    let position = lines.position(offset as u32);
                    let back = lines.offset(position) as usize;
                    let inside_line_end = offset > 0 && text.get(offset - 1..offset + 1) == Some("\r\n");
                    prop_assert_eq!(back, if inside_line_end { offset - 1 } else { offset });
                    let start = lines.offset(Position::new(position.line, 0)) as usize;
                    prop_assert_eq!(position.character, units(&text[start..back], encoding));
                }
            }
        }

        #[test]
        fn an_edit_leaves_what_a_new_look_finds(
            text in "[ab\u{e9}\u{1f600}\r\n]{0,30}",
            edits in proptest::collection::vec((0.0..1.0_f64, 0.0..1.0_f64, "[a\u{20ac}\u{1f600}\r\n]{0,6}"), 1..6),
        ) {
            for encoding in ENCODINGS {
                let mut text = text.clone();
                let mut lines = Lines::new(&text, encoding);
                for (a, b, new) in &edits {
                    let place = |part: f64| text.floor_char_boundary((text.len() as f64 * part) as usize);
                    let span = place(a.min(*b))..place(a.max(*b));
                    text.replace_range(span.clone(), new);
                    lines.edit(&text, Span::from(span), new.len() as u32);
                    prop_assert_eq!(&lines, &Lines::new(&text, encoding));
                }
            }
        }

        #[test]
        fn any_place_is_some_place(text in ".{0,20}", line in 0u32..5, character in 0u32..30) {
            for encoding in ENCODINGS {
                let offset = Lines::new(&text, encoding).offset(Position::new(line, character));
                prop_assert!(text.is_char_boundary(offset as usize));
            }
        }
    }
}
