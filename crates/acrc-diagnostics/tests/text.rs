//! The terminal form, as a user reads it: each snapshot is the whole output for one file.

use acrc_diagnostics::text::{self, Options};
use acrc_diagnostics::{Applicability, Code, Diagnostic, Edit, FileReport, Fix, SourceFile, Span};
use proptest::prelude::*;

const UNDEFINED: Code = Code { id: "ACR101", name: "undefined-label" };

const PLAIN: Options = Options { color: false, context: 0 };

fn render(source: &str, diagnostics: &[Diagnostic], options: Options) -> String {
    let report = FileReport::new(SourceFile::new("Prog0.8K", source), diagnostics);
    let mut out = Vec::new();
    text::render(&[report], options, &mut out).expect("writing to memory works");
    String::from_utf8(out).expect("the output is text")
}

/// The first place where `needle` stands in `source`.
fn at(source: &str, needle: &str) -> Span {
    let start = source.find(needle).expect("the needle is in the source");
    Span::from(start..start + needle.len())
}

fn undefined(span: Span) -> Diagnostic {
    Diagnostic::error(UNDEFINED, span, "no line in program 0 has the label RETRACT").with_label("not defined")
}

#[test]
fn label_help_note_and_fixes() {
    let source = "PROG0\n_RETRAKT\nX0\nGOSUB RETRACT\nEND\n";
    let fix = Fix::safe("call RETRAKT", vec![Edit::replace(at(source, "RETRACT"), "RETRAKT")]);
    let rename = Fix::unsafe_("rename the label", vec![Edit::replace(at(source, "RETRAKT"), "RETRACT")]);
    let sketch = Fix::new(Applicability::DisplayOnly, "add a line with the label RETRACT", Vec::new());
    let diagnostic = undefined(at(source, "RETRACT"))
        .with_related(at(source, "_RETRAKT"), "a label with a similar name")
        .with_help("define the label, or call one that is defined:\nlabels are case-sensitive")
        .with_note("labels are known in their own program only")
        .with_fix(fix)
        .with_fix(rename)
        .with_fix(sketch);
    insta::assert_snapshot!(render(source, &[diagnostic], PLAIN));
}

#[test]
fn a_help_that_a_fix_repeats_is_shown_once() {
    let source = "GOSUB retract\n";
    let diagnostic = undefined(at(source, "retract"))
        .with_help("write RETRACT")
        .with_fix(Fix::safe("write RETRACT", vec![Edit::replace(at(source, "retract"), "RETRACT")]));
    insta::assert_snapshot!(render(source, &[diagnostic], PLAIN));
}

#[test]
fn no_label_no_help() {
    let source = "X10 Y\n";
    let code = Code { id: "ACR204", name: "missing-value" };
    let diagnostic = Diagnostic::warning(code, at(source, "Y"), "axis Y has no target").unconfirmed();
    insta::assert_snapshot!(render(source, &[diagnostic], PLAIN));
}

#[test]
fn tabs_widen_the_marks() {
    let source = "\tIF (P1>0)\tTHEN\tGOTO RETRACT\n";
    insta::assert_snapshot!(render(source, &[undefined(at(source, "RETRACT"))], PLAIN));
}

#[test]
fn a_very_long_line_is_cut_around_the_mark() {
    let source = format!("X1\nREM {}GOTO RETRACT{}\nX2\n", "left ".repeat(90_000), " right".repeat(90_000));
    let diagnostic = undefined(at(&source, "RETRACT")).with_related(at(&source, "REM"), "begins far left");
    insta::assert_snapshot!(render(&source, &[diagnostic], PLAIN));
}

#[test]
fn a_mark_longer_than_the_window_is_cut() {
    let source = format!("REM {}\n", "word ".repeat(200));
    insta::assert_snapshot!(render(&source, &[undefined(Span::new(4, 1_000))], PLAIN));
}

#[test]
fn end_of_file() {
    let after_line_end = "PROG0\nX10\n";
    let without_line_end = "PROG0\nX10";
    let at_end = |source: &str| undefined(Span::empty(source.len() as u32)).with_label("END expected");
    let beyond = undefined(Span::new(900, 950)).with_label("a span outside the text is moved to its end");
    insta::assert_snapshot!(
        [
            render(after_line_end, &[at_end(after_line_end)], PLAIN),
            render(without_line_end, &[at_end(without_line_end)], PLAIN),
            render(without_line_end, &[beyond], PLAIN),
        ]
        .concat()
    );
}

#[test]
fn an_empty_file() {
    insta::assert_snapshot!(render("", &[undefined(Span::default()).with_label("nothing here")], PLAIN));
}

#[test]
fn a_place_between_two_characters() {
    let source = "X10Y20\nX30\n";
    let first_column = undefined(Span::empty(7)).with_label("start of line 2");
    let middle = undefined(Span::empty(3)).with_label("a space would help");
    let line_end = undefined(Span::new(6, 7)).with_label("the line end");
    insta::assert_snapshot!(render(source, &[middle, line_end, first_column], PLAIN));
}

#[test]
fn all_line_ends_give_the_same_picture() {
    let lines = ["PROG0", "GOTO RETRACT", "END", ""];
    let render_with = |line_end: &str| {
        let source = lines.join(line_end);
        render(&source, &[undefined(at(&source, "RETRACT"))], PLAIN)
    };
    assert_eq!(render_with("\r\n"), render_with("\n"));
    assert_eq!(render_with("\r"), render_with("\n"));
    insta::assert_snapshot!(render_with("\r\n"));
}

#[test]
fn multi_byte_and_wide_characters() {
    let source = "REM Achsé µm → 軸軸 : GOTO RETRACT 軸\n";
    let diagnostic = undefined(at(source, "RETRACT"))
        .with_related(at(source, "軸軸"), "two columns a character")
        .with_related(at(source, "→"), "three bytes");
    insta::assert_snapshot!(render(source, &[diagnostic], PLAIN));
}

#[test]
fn a_span_that_splits_a_character_is_widened() {
    let source = "REM µm\n";
    insta::assert_snapshot!(render(source, &[undefined(Span::new(5, 6))], PLAIN));
}

#[test]
fn overlapping_labels() {
    let source = "SET 32 : X(P1+P2) : CLR 32\n";
    let diagnostic = undefined(at(source, "X(P1+P2)"))
        .with_label("the move")
        .with_related(at(source, "P1+P2"), "its target")
        .with_related(at(source, "P2"), "never assigned")
        .with_related(at(source, "X(P1+P2)"), "the same place again");
    insta::assert_snapshot!(render(source, &[diagnostic], PLAIN));
}

#[test]
fn a_span_of_many_lines() {
    let source = "PROG0\nWHILE (P1<10)\nX(P1)\nP1=P1+1\nY(P1)\nEND\n";
    let body = Span::new(6, source.len() as u32 - 1);
    let diagnostic = undefined(body).with_label("this WHILE has no WEND").with_related(at(source, "END"), "ends here");
    insta::assert_snapshot!(render(source, &[diagnostic], PLAIN));
}

#[test]
fn line_numbers_are_those_of_the_file() {
    let mut source = String::new();
    for line in 1..=12_000 {
        source.push_str(if line == 9_999 { "GOTO RETRACT\n" } else { "X/1\n" });
    }
    let first = Span::new(0, 3);
    let next_to_it = Span::new(8, 11);
    let diagnostic =
        undefined(at(&source, "RETRACT")).with_related(next_to_it, "third line").with_related(first, "first line");
    insta::assert_snapshot!(render(&source, &[diagnostic], PLAIN));
}

#[test]
fn context_lines() {
    let source = "PROG0\nACC 100\nDEC 100\nGOTO RETRACT\nX1\nX2\nEND\n";
    let options = Options { context: 2, ..PLAIN };
    insta::assert_snapshot!(render(source, &[undefined(at(source, "RETRACT"))], options));
}

#[test]
fn what_a_terminal_would_obey_is_made_visible() {
    let source = "REM \x1b[31mred\x07\u{202e}txet\u{2028}\u{feff} \x0c GOTO RETRACT\n";
    let diagnostic = Diagnostic::error(UNDEFINED, at(source, "RETRACT"), "bad \x1b[2J\nmessage")
        .with_label("bell \x07")
        .with_help("escape \x1b");
    let out = render(source, &[diagnostic], PLAIN);
    assert!(!out.contains(['\x1b', '\x07', '\u{202e}', '\u{2028}', '\x0c']));
    insta::assert_snapshot!(out);
}

#[test]
fn color_is_added_and_nothing_else() {
    let source = "PROG0\n\tGOTO RETRACT : X│1\n";
    let diagnostic = undefined(at(source, "RETRACT")).with_help("define it").with_related(at(source, "PROG0"), "here");
    let diagnostic = [diagnostic];
    let plain = render(source, &diagnostic, PLAIN);
    let colored = render(source, &diagnostic, Options { color: true, ..PLAIN });
    assert!(!plain.contains('\x1b'));
    assert_ne!(plain, colored);
    assert_eq!(without_escapes(&colored), plain);
}

#[test]
fn findings_are_shown_by_place_and_the_worst_first() {
    let source = "A\nB\n";
    let code = |id| Code { id, name: "x" };
    let second = Diagnostic::error(code("ACR300"), at(source, "B"), "second line");
    let mild = Diagnostic::advice(code("ACR100"), at(source, "A"), "first line, mild");
    let severe = Diagnostic::error(code("ACR200"), at(source, "A"), "first line, severe");
    insta::assert_snapshot!(render(source, &[second, mild, severe], PLAIN));
}

proptest! {
    #[test]
    fn any_text_and_any_spans_can_be_shown(
        lines in prop::collection::vec(("[ab \t\r\nµ軸é\u{301}\u{200d}\u{0}│┆7]{0,30}", 1_usize..20), 0..8),
        spans in prop::collection::vec((0_u32..2_000, 0_u32..2_000), 1..6),
        context in 0_u32..3,
        color: bool,
    ) {
        let source = lines.iter().map(|(text, times)| text.repeat(*times) + "\n").collect::<String>();
        let mut spans = spans.into_iter().map(|(start, end)| Span { start, end });
        let mut diagnostic = undefined(spans.next().unwrap_or_default());
        for span in spans {
            diagnostic = diagnostic.with_related(span, "related");
        }
        let out = render(&source, std::slice::from_ref(&diagnostic), Options { color, context });
        let related = out.matches(" related").count();
        prop_assert_eq!(related, diagnostic.labels.len(), "every label is shown once:\n{}", out);
        prop_assert_eq!(out.matches(" not defined").count(), 1);
        prop_assert_eq!(out.matches("Prog0.8K").count(), 1);
        prop_assert!(color || !out.contains('\x1b'));
    }
}

/// `text` without its colour sequences and without spaces at line ends, which a coloured line may keep.
fn without_escapes(text: &str) -> String {
    let mut out = String::new();
    let mut pieces = text.split("\x1b[");
    out.push_str(pieces.next().unwrap_or_default());
    for piece in pieces {
        out.push_str(piece.split_once('m').map_or("", |(_, rest)| rest));
    }
    out.lines().flat_map(|line| [line.trim_end(), "\n"]).collect()
}

#[test]
fn thousands_of_findings_in_many_files_come_in_their_order() {
    let source = "GOSUB RETRACT\n".repeat(90);
    let findings: Vec<_> = (0..90).map(|line| undefined(Span::new(line * 14 + 6, line * 14 + 13))).collect();
    let names: Vec<_> = (0..40).map(|file| format!("part{file:02}.8K")).collect();
    let shown = |names: &[String]| {
        let reports: Vec<_> =
            names.iter().map(|name| FileReport::new(SourceFile::new(name, &source), &findings)).collect();
        let mut out = Vec::new();
        text::render(&reports, PLAIN, &mut out).expect("writing to memory works");
        String::from_utf8(out).expect("the output is text")
    };
    let one_by_one: String = names.iter().map(|name| shown(std::slice::from_ref(name))).collect();
    assert!(shown(&names) == one_by_one);
}
