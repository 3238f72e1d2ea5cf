//! The repairs that come with diagnostics leave a program that needs none.

mod support;

use acrc_diagnostics::{Fix, apply};
use acrc_syntax::debug_tree;

/// Applies the first fix of every diagnostic.
fn fixed(source: &str) -> String {
    let tree = support::checked(source);
    let fixes: Vec<&Fix> = tree.errors().iter().filter_map(|error| error.fixes.first()).collect();
    apply(source, &fixes).expect("fixes of different places")
}

#[test]
fn fixes_leave_nothing_to_say() {
    let cases = [
        ("CLOSE #1 REM done", "CLOSE #1 : REM done"),
        ("VEL 5 ' fast", "VEL 5 : REM fast"),
        ("VEL 5 'fast", "VEL 5 : REM fast"),
        ("_ Failed", "_Failed"),
        ("VEL = 5", "VEL 5"),
        ("VEL=P0 * 2 : ACC = (P1)", "VEL(P0 * 2) : ACC (P1)"),
        ("DIM LV10", "DIM LV(10)"),
        ("DIM $V 2 80", "DIM $V (2, 80)"),
        ("DIM PROG 15 16384", "DIM PROG 15 (16384)"),
        ("GOTO _Start", "GOTO Start"),
        ("PRINT \"abc", "PRINT \"abc\""),
        ("PRINT \"abc  ", "PRINT \"abc\"  "),
        ("PRNT \"x\"", "PRINT \"x\""),
        ("PRINT \u{201C}a\u{201D} : INH \u{2013}516", "PRINT \"a\" : INH -516"),
        ("\u{2018} note", "' note"),
        ("X\u{A0}5", "X 5"),
    ];
    for (source, expected) in cases {
        let repaired = fixed(source);
        assert_eq!(repaired, expected, "{source:?}");
        let tree = support::checked(&repaired);
        assert!(tree.errors().is_empty(), "{repaired:?}: {:#?}", tree.errors());
    }
}

#[test]
fn fixes_of_characters_do_not_change_the_program() {
    let source = "PRINT \u{201C}a\u{201D} : INH \u{2013}516\nX\u{A0}5\nP0 = 5 \u{2212} 3 : REM \u{2013}";
    let repaired = fixed(source);
    let (before, after) = (support::checked(source), support::checked(&repaired));
    assert_eq!(debug_tree(&before, source), debug_tree(&after, &repaired));
}
