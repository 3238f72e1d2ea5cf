//! Applying fixes.

use acrc_diagnostics::{ApplyError, Edit, Fix, Span, apply, compatible};
use proptest::prelude::*;

fn fix(edits: Vec<Edit>) -> Fix {
    Fix::safe("change it", edits)
}

#[test]
fn edits_refer_to_the_text_as_given() {
    let spread = fix(vec![Edit::insert(3, " "), Edit::replace(Span::new(0, 1), "Z")]);
    let end = fix(vec![Edit::insert(6, "\n"), Edit::delete(Span::new(3, 4))]);
    assert_eq!(apply("X10Y20", &[&end, &spread]), Ok("Z10 20\n".to_owned()));
    assert_eq!(apply("X10Y20", &[]), Ok("X10Y20".to_owned()));
}

#[test]
fn neighbours_do_not_overlap() {
    let left = fix(vec![Edit::replace(Span::new(0, 2), "a")]);
    let right = fix(vec![Edit::replace(Span::new(2, 4), "b")]);
    let between = fix(vec![Edit::insert(2, "-")]);
    assert_eq!(apply("XXYY", &[&right, &between, &left]), Ok("a-b".to_owned()));
}

#[test]
fn overlaps_are_refused() {
    let wide = fix(vec![Edit::replace(Span::new(0, 3), "a")]);
    let inner = fix(vec![Edit::replace(Span::new(2, 4), "b")]);
    let inside = fix(vec![Edit::insert(1, "-")]);
    let overlap = |first, second| Err(ApplyError::Overlapping { first, second });
    assert_eq!(apply("XXYY", &[&inner, &wide]), overlap(Span::new(0, 3), Span::new(2, 4)));
    assert_eq!(apply("XXYY", &[&wide, &inside]), overlap(Span::new(0, 3), Span::empty(1)));
    assert_eq!(apply("XXYY", &[&inside, &inside]), overlap(Span::empty(1), Span::empty(1)));
}

#[test]
fn edits_that_do_not_fit_the_text_are_refused() {
    for span in [Span::new(3, 9), Span::empty(9), Span::new(0, 1), Span::new(1, 2)] {
        let refused = apply("µm", &[&fix(vec![Edit::replace(span, "u")])]);
        assert_eq!(refused, Err(ApplyError::OutsideText { span, len: 3 }));
    }
    let backwards = Edit::replace(Span { start: 2, end: 0 }, "u");
    assert!(apply("µm", &[&fix(vec![backwards])]).is_err());
}

#[test]
fn errors_name_the_bytes() {
    let first = fix(vec![Edit::delete(Span::new(0, 3))]);
    let second = fix(vec![Edit::delete(Span::new(2, 4))]);
    let error = apply("XXYY", &[&first, &second]).expect_err("the edits overlap");
    assert_eq!(error.to_string(), "edits overlap: bytes 0..3 and 2..4");
    let error = apply("X", &[&first]).expect_err("the edit is too long");
    assert_eq!(error.to_string(), "edit of bytes 0..3 does not fit a text of 1 bytes");
}

#[test]
fn compatible_takes_the_first_of_what_conflicts() {
    let both_ends = fix(vec![Edit::delete(Span::new(0, 1)), Edit::delete(Span::new(3, 4))]);
    let end = fix(vec![Edit::replace(Span::new(3, 4), "!")]);
    let middle = fix(vec![Edit::delete(Span::new(1, 2))]);
    let chosen = compatible(&[&both_ends, &end, &middle]);
    assert_eq!(chosen, [&both_ends, &middle]);
    assert_eq!(apply("XYZW", &chosen), Ok("Z".to_owned()));
}

proptest! {
    #[test]
    fn compatible_fixes_always_apply(
        text in "[a-zµ軸]{0,20}",
        spans in prop::collection::vec((0_usize..24, 0_usize..6), 0..12),
    ) {
        let fixes: Vec<Fix> = spans
            .into_iter()
            .map(|(start, len)| {
                let start = text.floor_char_boundary(start);
                let end = text.floor_char_boundary(start + len);
                fix(vec![Edit::replace(Span::from(start..end), "<>")])
            })
            .collect();
        let fixes: Vec<&Fix> = fixes.iter().collect();
        let chosen = compatible(&fixes);
        let changed = apply(&text, &chosen).expect("compatible fixes apply");
        let removed: usize = chosen.iter().map(|fix| fix.edits[0].span.len() as usize).sum();
        prop_assert_eq!(changed.len(), text.len() - removed + 2 * chosen.len());
        prop_assert_eq!(changed.matches("<>").count(), chosen.len());
    }
}
