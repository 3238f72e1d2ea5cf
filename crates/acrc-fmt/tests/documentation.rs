//! The pairs of programs in `docs/formatter.md` are true.

mod support;

use std::path::Path;

use acrc_fmt::{BlockEnds, Options, format};

/// The fenced programs of a page: the words behind the fence, and the text.
fn programs(page: &str) -> Vec<(&str, String)> {
    let mut programs: Vec<(&str, String)> = Vec::new();
    let mut open = false;
    for line in page.lines() {
        match line.strip_prefix("```") {
            Some(info) if !open => {
                programs.push((info, String::new()));
                open = true;
            }
            Some(_) => open = false,
            None if open => programs.iter_mut().last().expect("a fence before").1.extend([line, "\n"]),
            None => {}
        }
    }
    programs
}

#[test]
fn pairs_are_what_the_formatter_does() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/formatter.md");
    let page = std::fs::read_to_string(path).expect("the page of the formatter");
    let programs = programs(&page);
    assert!(programs.len() > 20, "the page has its examples");
    for pair in programs.chunks(2) {
        let [(before, text), (after, expected)] = pair else { panic!("a text without its result: {pair:?}") };
        let block_ends = match *after {
            "acrobasic after" => BlockEnds::Body,
            "acrobasic after opener" => BlockEnds::Opener,
            other => panic!("an unknown fence: {other}"),
        };
        assert_eq!(*before, "acrobasic before");
        let formatted = format(text, &Options { block_ends, ..Options::default() });
        assert_eq!(&formatted.text, expected);
        assert_eq!(formatted.unreadable, Vec::<u32>::new(), "{text}");
        support::checked(text);
    }
}
