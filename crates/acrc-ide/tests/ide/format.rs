//! Formatting a file, some lines, and while somebody types.

use acrc_diagnostics::{Fix, Span, apply};
use acrc_ide::{LinkTarget, format_file, format_range, format_typed, links, project_links};
use proptest::prelude::*;

use crate::fixture::Fixture;

const UGLY: &str =
    "prog0\nprogram\n\n\nif (bit 24)\nset34:clr  35\nendif\n#define  A   p1\n#define LongName p2\nx10 y/-5\nendp\n\n";

fn after(text: &str, edits: Vec<acrc_diagnostics::Edit>) -> String {
    apply(text, &[&Fix::safe("", edits)]).expect("the edits fit")
}

#[test]
fn only_lines_that_differ_are_edited() {
    let fixture = Fixture::new("PROG0\nPROGRAM\nset 34\nSET 35\nENDP\n");
    let edits = format_file(&fixture.db, fixture.project, fixture.files[0]);
    assert_eq!(edits.len(), 1, "{edits:?}");
    assert_eq!(edits[0].span, Span::new(14, 21));
}

#[test]
fn a_range_leaves_the_other_lines() {
    let fixture = Fixture::new(UGLY);
    let start = UGLY.find("set34").expect("it is there") as u32;
    let text = after(UGLY, format_range(&fixture.db, fixture.project, fixture.files[0], Span::new(start, start + 3)));
    assert_eq!(text, UGLY.replace("set34:clr  35", "    SET 34 : CLR 35"));
    let lines = Span::new(start, start + "set34:clr  35\n".len() as u32);
    assert_eq!(after(UGLY, format_range(&fixture.db, fixture.project, fixture.files[0], lines)), text, "a whole line");
}

/// The text with what is typed before the cursor, and what becomes of it.
fn typed(text: &str) -> String {
    let fixture = Fixture::new(text);
    let place = fixture.cursor();
    let source = place.file.text(&fixture.db);
    let before = source[..place.offset as usize].chars().next_back();
    // An editor has indented the line by itself before it asks.
    let before = before.filter(|typed| !typed.is_whitespace()).unwrap_or('\n');
    after(source, format_typed(&fixture.db, place.project, place.file, place.offset, before))
}

#[test]
fn a_new_line_is_indented() {
    assert_eq!(typed("PROGRAM\nIF (BIT 5)\n$0\nENDP\n"), "PROGRAM\nIF (BIT 5)\n    \nENDP\n");
    assert_eq!(typed("PROGRAM\n  WHILE (BIT 5)\n$0SET 32\nENDP\n"), "PROGRAM\n  WHILE (BIT 5)\n      SET 32\nENDP\n");
    assert_eq!(
        typed("PROGRAM\nIF (BIT 5)\n    SET 32\n    ENDIF\n    $0\nENDP\n"),
        "PROGRAM\nIF (BIT 5)\n    SET 32\n    ENDIF\n\nENDP\n"
    );
    assert_eq!(typed("PROGRAM\nIF (BIT 5) THEN SET 32\n$0\nENDP\n"), "PROGRAM\nIF (BIT 5) THEN SET 32\n\nENDP\n");
    assert_eq!(typed("PROGRAM\n  SET 32\n\n$0\nENDP\n"), "PROGRAM\n  SET 32\n\n  \nENDP\n");
    assert_eq!(typed("PROG0\n10 IF (BIT 5)\n$0\n"), "PROG0\n10 IF (BIT 5)\n\n");
}

#[test]
fn a_word_that_ends_a_block_moves_its_line() {
    assert_eq!(
        typed("PROGRAM\nIF (BIT 5)\n    SET 32\nENDIF$0\nENDP\n"),
        "PROGRAM\nIF (BIT 5)\n    SET 32\n    ENDIF\nENDP\n"
    );
    assert_eq!(
        typed("PROGRAM\nIF (BIT 5)\n        ELSE$0\nENDIF\nENDP\n"),
        "PROGRAM\nIF (BIT 5)\n    ELSE\nENDIF\nENDP\n"
    );
    assert_eq!(typed("PROGRAM\nSET 32 : CLR E$0\nENDP\n"), "PROGRAM\nSET 32 : CLR E\nENDP\n");
}

#[test]
fn links_lead_to_rules_and_files() {
    let text = "' acrc: allow-file(unused-label, ACR101)\nPROG0\nSET 32 ' acrc: allow(no-rule)\n";
    let fixture = Fixture::new(text);
    let found = links(&fixture.db, fixture.files[0]);
    let shown: Vec<_> = found
        .iter()
        .map(|link| match &link.to {
            LinkTarget::Rule(code) => (&text[link.span.range()], code.id),
            LinkTarget::File(_) => unreachable!("a program names no file"),
        })
        .collect();
    assert_eq!(shown, [("unused-label", "ACR103"), ("ACR101", "ACR101")]);

    let toml = "[project]\nname = \"g\"\nfiles = [\"src/Setup.8K\", 'Prog0.8K'] # two\n";
    let found = project_links(toml);
    let shown: Vec<_> = found.iter().map(|link| (&toml[link.span.range()], link.to.clone())).collect();
    assert_eq!(
        shown,
        [
            ("\"src/Setup.8K\"", LinkTarget::File("src/Setup.8K".to_owned())),
            ("'Prog0.8K'", LinkTarget::File("Prog0.8K".to_owned())),
        ]
    );
    for bad in ["", "[project]", "project = 1", "[project]\nfiles = 1", "[project", "[project]\nfiles = [1]"] {
        assert_eq!(project_links(bad), [], "{bad}");
    }
}

proptest! {
    #[test]
    fn edits_of_a_file_give_the_formatted_text(
        lines in prop::collection::vec("|  |set34|if [(]bit 24[)]|endif|rem a|'b|x10 y/-5|PROGRAM|endp|_A|\u{e4}|IF [(]", 0..12),
        end in "\n|\r\n|\r",
    ) {
        let text = lines.join(&end);
        let fixture = Fixture::new(&text);
        let expected = acrc_fmt::format(&text, &acrc_fmt::Options::default()).text;
        prop_assert_eq!(after(&text, format_file(&fixture.db, fixture.project, fixture.files[0])), expected);
    }
}
