//! Code actions, before and after.

use acrc_diagnostics::{Fix, Span, apply};
use acrc_ide::{CodeAction, code_actions, fix_all};

use crate::fixture::Fixture;

fn lines_of(fixture: &Fixture, action: &CodeAction) -> String {
    let mut shown = format!(
        "{} ({:?}, {:?}{})\n",
        action.title,
        action.kind,
        action.applicability,
        if action.preferred { ", preferred" } else { "" }
    );
    for (file, edits) in &action.edits {
        let before = file.text(&fixture.db);
        let after = apply(before, &[&Fix::safe("", edits.clone())]).expect("the edits fit");
        let mut diff = Vec::new();
        acrc_diagnostics::unified_diff(file.name(&fixture.db), before, &after, false, &mut diff)
            .expect("it is written");
        let diff = String::from_utf8(diff).expect("text");
        for line in diff.lines().filter(|line| !line.starts_with("---") && !line.starts_with("+++")) {
            let line = if line.starts_with("@@") { format!("@@ {}", file.name(&fixture.db)) } else { line.to_owned() };
            if line.starts_with(['+', '-', '@']) {
                shown.push_str(&line);
                shown.push('\n');
            }
        }
    }
    shown
}

/// The actions at the cursor whose titles hold a word.
fn actions(text: &str, title: &str) -> String {
    let fixture = Fixture::new(text);
    let place = fixture.cursor();
    let found = code_actions(&fixture.db, place.project, place.file, Span::empty(place.offset));
    let shown: Vec<String> =
        found.iter().filter(|action| action.title.contains(title)).map(|action| lines_of(&fixture, action)).collect();
    shown.join("\n")
}

#[test]
fn findings_are_repaired_and_allowed() {
    insta::assert_snapshot!(actions("PROG0\nPROGRAM\n_Cycle\n    GOTO cy$0cle\nENDP\n", ""));
}

#[test]
fn a_comment_that_allows_takes_another_name() {
    let text = "PROG0\nPROGRAM\n_Cycle\nGOTO cy$0cle ' acrc: allow(ACR102) -- why\nENDP\n";
    insta::assert_snapshot!(actions(text, "on this line"));
    let remark = "PROG0\r\nPROGRAM\r\n  GOTO cy$0cle : REM why\r\nENDP\r\n";
    insta::assert_snapshot!("above_a_remark", actions(remark, "on this line"));
}

#[test]
fn no_action_puts_an_apostrophe_behind_a_statement() {
    let lines = [
        "GOTO cy$0cle",
        "' acrc: allow(ACR102)\nGOTO cy$0cle",
        "LV0 = 1 : GOTO cy$0cle : REM why",
        "SET 32 : REM $0why",
    ];
    for line in lines {
        let fixture = Fixture::new(&format!("PROG0\nPROGRAM\n{line}\nENDP\n"));
        let place = fixture.cursor();
        for action in code_actions(&fixture.db, place.project, place.file, Span::empty(place.offset)) {
            let [(file, edits)] = action.edits.as_slice() else { panic!("{}", action.title) };
            let after = apply(file.text(&fixture.db), &[&Fix::safe("", edits.clone())]).expect("the edits fit");
            let repaired = Fixture::new(&format!("{after}$0"));
            let found =
                acrc_analysis::diagnostics(&repaired.db, repaired.project, repaired.files[0], acrc_lint::CHECKER);
            assert!(found.iter().all(|finding| finding.code.name != "comment-after-statement"), "{after}");
            if action.title == "Allow undefined-label on this line" {
                assert!(found.iter().all(|finding| finding.code.name != "undefined-label"), "{after}");
            }
        }
    }
}

#[test]
fn a_missing_label_is_made() {
    insta::assert_snapshot!("a_called_label", actions("PROG0\nPROGRAM\n  GOSUB Op$0en\nENDP\n", "Create"));
    insta::assert_snapshot!("a_label_of_a_program_file", actions("=== Prog0.8K\nGOTO Op$0en\nEND", "Create"));
    assert_eq!(actions("PROG0\n10 GOTO Op$0en\n", "Create"), "", "numbered lines");
}

#[test]
fn a_number_gets_a_name() {
    let project = "=== Setup.8K\nSYS\nDIM DEF(5)\n#DEFINE Clamp BIT32\nPROG0\n=== Prog0.8K\nPROGRAM\nSET32 : CLR BIT 32\nINH -516\nIF (BIT(516) AND BIT516) THEN SET 33\nP1 = P12290\nENDP\n";
    insta::assert_snapshot!("an_existing_alias", actions(&project.replace("SET32", "SET$032"), "Clamp"));
    insta::assert_snapshot!("a_new_alias", actions(&project.replace("INH -516", "INH -5$016"), "Extract"));
    insta::assert_snapshot!("a_new_alias_for_a_parameter", actions(&project.replace("P12290", "P1$02290"), "Extract"));
    let bare = "=== Setup.8K\nPROG0\n=== Prog0.8K\nPROGRAM\nSET 3$02\nENDP\n";
    insta::assert_snapshot!("a_new_alias_where_none_was", actions(bare, "Extract"));
}

#[test]
fn what_has_no_memory_gets_it() {
    let project = "SYS\nCLEAR\nDIM PROG0(4000)\nPROG0\nPROGRAM\nLV3 = 1\nLV7 = LA1(2) + LA1(9)\n$V2 = \"a\"\nENDP\n";
    insta::assert_snapshot!("the_first_dim", actions(&project.replace("LV3", "L$0V3"), "Add"));
    insta::assert_snapshot!("an_array", actions(&project.replace("LA1(2)", "L$0A1(2)"), "Add"));
    insta::assert_snapshot!("strings", actions(&project.replace("$V2", "$0$V2"), "Add"));
    let prompt = project.replace("PROG0\nPROGRAM", "PROG0\n  DIM DV(2)\nPROGRAM").replace("LV3", "L$0V3");
    insta::assert_snapshot!("beside_another_dim", actions(&prompt, "Add"));
    let parameters = "SYS\nCLEAR\nDIM PROG0(4000)\nPROG0\nPROGRAM\nP5 = 1\nP$06 = 1\nENDP\n"
        .replace("P$06", "P6")
        .replace("P5 =", "P$05 =");
    insta::assert_snapshot!("parameters", actions(&parameters, "Add"));
}

#[test]
fn a_conditional_line_is_a_block_and_back() {
    let line = "PROG0\nPROGRAM\n  IF (BIT 5)$0 THEN SET 32 : CLR 33\nENDP\n";
    insta::assert_snapshot!("to_a_block", actions(line, "condition"));
    let block = "PROG0\nPROGRAM\n  IF$0 (BIT 5)\n    SET 32 : CLR 33\n  ENDIF\n SET 34\nENDP\n";
    insta::assert_snapshot!("to_a_line", actions(block, "condition"));
    for left_alone in [
        "IF$0 (BIT 5)\nSET 32\nCLR 33\nENDIF\n",
        "IF$0 (BIT 5)\nSET 32\nELSE\nCLR 33\nENDIF\n",
        "IF$0 (BIT 5)\n_A\nENDIF\n",
        "IF (BIT 4)\nIF$0 (BIT 5)\nSET 32\nENDIF\nENDIF\n",
        "IF$0 (BIT 5)\nSET 32 ' why\nENDIF\n",
        "IF$0 (BIT 5)\nENDIF\n",
        "IF$0 (BIT 5) THEN IF (BIT 6) THEN SET 32\n",
    ] {
        assert_eq!(actions(&format!("PROG0\nPROGRAM\n{left_alone}ENDP\n"), "condition"), "", "{left_alone}");
    }
}

#[test]
fn a_remark_becomes_a_comment() {
    let text = "PROG0\nPROGRAM\n  REM lam$0p\nSET 32 : REM \u{e4}ndern\nENDP\n";
    insta::assert_snapshot!("a_remark_alone", actions(text, "apostrophe"));
    let text = text.replace("$0", "").replace("REM \u{e4}n", "REM $0\u{e4}n");
    insta::assert_snapshot!("a_remark_behind", actions(&text, "apostrophe"));
    assert_eq!(actions("10 REM a$0\n", "apostrophe"), "");
    assert_eq!(actions("IF (BIT 5) THEN REM a$0\n", "apostrophe"), "");
}

#[test]
fn all_safe_repairs_together() {
    let fixture = Fixture::new("PROG0\nPROGRAM\n_ Cycle\nSET 32\nGOTO _Cycle\nPRINT \u{201c}a\u{201d}$0\nENDP\n");
    let place = fixture.cursor();
    let action = fix_all(&fixture.db, place.project, place.file).expect("there is something to repair");
    insta::assert_snapshot!(lines_of(&fixture, &action));
    let clean = Fixture::new("PROG0\n$0");
    assert_eq!(fix_all(&clean.db, clean.project, clean.files[0]), None);
}
