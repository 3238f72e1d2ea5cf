//! Offsets to lines and columns.

use acrc_diagnostics::{LineIndex, Position, Span};
use proptest::prelude::*;

fn at(line: u32, column: u32) -> Position {
    Position { line, column }
}

#[test]
fn an_empty_text_has_one_line() {
    let index = LineIndex::new("");
    assert_eq!(index.line_count(), 1);
    assert_eq!(index.position(0), at(1, 1));
    assert_eq!(index.line_span(1), Some(Span::empty(0)));
    assert_eq!(index.line_span(0), None);
    assert_eq!(index.line_span(2), None);
}

#[test]
fn lines_end_at_lf_crlf_and_cr() {
    let text = "a\nbb\r\ncc\rdd\n\r\n\n\re";
    let index = LineIndex::new(text);
    let lines: Vec<&str> =
        (1..=index.line_count()).filter_map(|line| text.get(index.line_span(line)?.range())).collect();
    assert_eq!(lines, ["a", "bb", "cc", "dd", "", "", "", "e"]);
}

#[test]
fn a_line_end_belongs_to_its_line() {
    let index = LineIndex::new("ab\r\ncd\n");
    assert_eq!(index.position(2), at(1, 3), "at the CR");
    assert_eq!(index.position(3), at(1, 3), "between CR and LF");
    assert_eq!(index.position(4), at(2, 1), "after the LF");
    assert_eq!(index.position(7), at(3, 1), "at the end of the text");
    assert_eq!(index.position(u32::MAX), at(3, 1), "beyond the text");
}

#[test]
fn columns_count_characters() {
    let index = LineIndex::new("aµ軸😀b\nµb");
    let columns: Vec<u32> = (0..11).map(|offset| index.position(offset).column).collect();
    assert_eq!(columns, [1, 2, 2, 3, 3, 3, 4, 4, 4, 4, 5]);
    assert_eq!(index.position(12), at(2, 1));
    assert_eq!(index.position(13), at(2, 1), "inside the first character");
    assert_eq!(index.position(14), at(2, 2));
}

#[test]
fn positions_read_as_line_and_column() {
    assert_eq!(at(12, 3).to_string(), "12:3");
}

#[test]
fn spans() {
    let span = Span::new(2, 5);
    assert_eq!((span.len(), span.is_empty(), span.range()), (3, false, 2..5));
    assert!(span.contains(2) && span.contains(4) && !span.contains(5) && !span.contains(1));
    assert!(Span::empty(2).is_empty() && !Span::empty(2).contains(2));
    assert_eq!(Span::new(5, 2), Span::empty(5));
    assert_eq!(Span::cover(Span::new(7, 9), span), Span::new(2, 9));
    assert_eq!(Span::from(3..usize::MAX), Span::new(3, u32::MAX));
}

/// The definition, read off the text: what the index must agree with.
fn position_by_counting(text: &str, offset: usize) -> Position {
    let before = &text[..offset];
    let before =
        if before.ends_with('\r') && text[offset..].starts_with('\n') { &before[..offset - 1] } else { before };
    let before = before.replace("\r\n", "\n").replace('\r', "\n");
    let line_text = before.rsplit('\n').next().unwrap_or_default();
    at(before.matches('\n').count() as u32 + 1, line_text.chars().count() as u32 + 1)
}

proptest! {
    #[test]
    fn agrees_with_counting(text in "[a\tµ軸😀\r\n]{0,40}") {
        let index = LineIndex::new(&text);
        for offset in (0..=text.len()).filter(|&offset| text.is_char_boundary(offset)) {
            prop_assert_eq!(index.position(offset as u32), position_by_counting(&text, offset));
        }
    }
}
