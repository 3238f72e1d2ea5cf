//! Unified differences: their picture, and that they turn the old text into the new one.

use crate::sample::written;
use acrc_diagnostics::unified_diff;
use proptest::prelude::*;

fn diff(name: &str, old: &str, new: &str) -> String {
    written(|out| unified_diff(name, old, new, false, out))
}

#[test]
fn two_places() {
    let old = (1..=20).map(|line| format!("P{line} = {line}\n")).collect::<Vec<_>>().concat();
    let new = old.replace("P3 = 3\n", "P3 = 33\nP4 = 0\n").replace("P19 = 19\n", "");
    insta::assert_snapshot!(diff("machine\\Prog0.8K", &old, &new));
}

#[test]
fn line_ends() {
    insta::assert_snapshot!(
        [
            diff("last line end missing before", "X1\nY2", "X1\nY2\n"),
            diff("last line end missing after", "X1\nY2\n", "X1\nY2"),
            diff("missing in both", "X1\nY2", "X2\nY2"),
            diff("CRLF", "X1\r\nY2\r\n", "X2\r\nY2\r\n"),
            diff("CRLF to LF", "X1\r\n", "X1\n"),
            diff("CR is no line end", "X1\rY2", "X1\rY3"),
            diff("from nothing", "", "X1\n"),
            diff("to nothing", "X1", ""),
        ]
        .concat()
        .replace('\r', "<CR>")
    );
}

#[test]
fn nothing_changed() {
    assert_eq!(diff("Prog0.8K", "X1\n", "X1\n"), "");
    assert_eq!(diff("Prog0.8K", "", ""), "");
}

#[test]
fn names_that_tools_would_misread() {
    let header = |name| diff(name, "a\n", "b\n").lines().next().map(str::to_owned).unwrap_or_default();
    assert_eq!(header("./machine/Prog0.8K"), "--- machine/Prog0.8K");
    assert_eq!(header("my machine/Prog0.8K"), "--- my machine/Prog0.8K\t");
    assert_eq!(header("Achsé.8K"), "--- Achsé.8K");
    assert_eq!(header("a \"b\"\n+++ c"), "--- \"a \\\"b\\\"\\012+++ c\"");
}

#[test]
fn colors() {
    let shown = written(|out| unified_diff("Prog0.8K", "REM \u{1b}[0m\tx\r\nX1\r\nY2", "X2\r\nY2", true, out));
    let shown = shown.replace('\r', "<CR>").replace('\u{1b}', "<ESC>");
    assert!(shown.contains("-REM ␛[0m\tx<ESC>"), "what is in the text has no effect: {shown}");
    insta::assert_snapshot!(shown);
}

#[test]
fn every_line_of_a_large_file() {
    let old = (0..50_000).map(|line| format!("P{line} = 1\n")).collect::<Vec<_>>().concat();
    let new = old.replace('=', " = ");
    assert_eq!(patched(&old, &diff("Prog0.8K", &old, &new)), new);
}

/// What `patch` does: checks the lines that must be there and takes the new ones.
fn patched(old: &str, diff: &str) -> String {
    let mut old_lines = old.split_inclusive('\n');
    let mut line_number = 1;
    let mut out = String::new();
    let mut diff_lines = diff.split_inclusive('\n').skip(2).peekable();
    while let Some(line) = diff_lines.next() {
        let unended = diff_lines.next_if(|next| next.starts_with('\\')).is_some();
        let (mark, content) = line.split_at(1);
        let content = if unended { content.strip_suffix('\n').expect("it has a line end") } else { content };
        match mark {
            "@" => {
                let (start, count) = old_range(line);
                let first = if count == 0 { start + 1 } else { start };
                while line_number < first {
                    out.push_str(old_lines.next().expect("there are so many lines"));
                    line_number += 1;
                }
            }
            "+" => out.push_str(content),
            _ => {
                assert_eq!(old_lines.next(), Some(content));
                line_number += 1;
                if mark == " " {
                    out.push_str(content);
                }
            }
        }
    }
    out.extend(old_lines);
    out
}

/// Start and length of the old lines, from `@@ -3,7 +3,8 @@`.
fn old_range(header: &str) -> (usize, usize) {
    let range = header.trim_start_matches("@@ -").split(' ').next().expect("a range");
    let (start, count) = range.split_once(',').unwrap_or((range, "1"));
    (start.parse().expect("a number"), count.parse().expect("a number"))
}

proptest! {
    #[test]
    fn old_and_difference_give_new(old in "([ab+@-]?(\n|\r\n|\r)){0,30}[ab\\\\]?", new in "([ab+@-]?(\n|\r\n|\r)){0,30}[ab\\\\]?") {
        prop_assert_eq!(patched(&old, &diff("Prog0.8K", &old, &new)), new);
    }
}
