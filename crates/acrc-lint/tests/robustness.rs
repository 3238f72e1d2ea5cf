//! Whatever a text holds: the linter does not panic, its findings lie in the text, and it says the same each time.

use acrc_analysis::project::Config;
use acrc_analysis::{Database, FileRole, Project, SourceFile};
use acrc_diagnostics::{Diagnostic, Severity};
use proptest::prelude::*;

fn lint(files: &[(&str, &str)]) -> Vec<Vec<Diagnostic>> {
    let db = Database::new();
    let inputs = files.iter().map(|(name, text)| {
        SourceFile::new(&db, (*name).to_owned(), (*text).to_owned(), FileRole::of(name), Vec::new())
    });
    let mut config = Config::default();
    config.lint.select = Some(vec!["ALL".to_owned()]);
    let project = Project::new(&db, inputs.collect(), acrc_catalog::default_model(), config);
    acrc_lint::check(&db, project).into_iter().map(|(_, found)| found).collect()
}

/// Pieces of which most sequences mean something to a rule.
const PIECES: [&str; 56] = [
    "PROG0",
    "PROG1",
    "PLC0",
    "SYS",
    "PROGRAM",
    "ENDP",
    "END",
    "RETURN",
    "GOSUB A",
    "GOTO A",
    "GOTO 100",
    "_A",
    "_B",
    "_A1",
    "IF (BIT 1)",
    "IF (P0 > 1) THEN",
    "ELSE",
    "ELSEIF (BIT 2)",
    "ELSE IF (1)",
    "ENDIF",
    "FOR LV0 = 0 TO 9",
    "NEXT",
    "WHILE (1)",
    "WEND",
    "BREAK",
    "ATTACH MASTER0",
    "ATTACH SLAVE0 AXIS0 \"X\"",
    "ATTACH SLAVE1 AXIS0 \"Y\"",
    "DETACH",
    "DETACH ALL",
    "#DEFINE Lamp BIT32",
    "#DEFINE Lamp P1",
    "SET Lamp",
    "Lamp = 1",
    "X10 Y/5",
    "AXIS0 PPU (1,2)",
    "HLIM X4",
    "SLM X(1,2,3)",
    "P99999999 = \"a\" + 1",
    "P0 = -99999999999999999999",
    "$V0 = SQRT(\"a\", 2)",
    "INH -BIT(999999)",
    "DIM P(9999)",
    "IHPOS P0 (1)",
    "100 SET 32",
    "REM \u{e4}\u{2014}",
    "VLE 5",
    "\"",
    "10 GOTO A",
    "PBOOT",
    "LV0 = LV0 + 1",
    "WHILE (LV0 < 3 OR 2 AND LV1)",
    "if (bit1) then LV(P0) = LV0",
    "FOR LV0 = 5 TO 1 STEP -1",
    "GOSUB B",
    "HALT ALL",
];

fn program() -> impl Strategy<Value = String> {
    let piece = (prop::sample::select(&PIECES[..]), prop::sample::select(&["\n", "\r\n", " : ", " ", "", "("][..]));
    prop::collection::vec(piece, 0..60)
        .prop_map(|pieces| pieces.into_iter().map(|(piece, end)| piece.to_owned() + end).collect())
}

proptest! {
    #[test]
    fn findings_lie_in_the_text_and_are_the_same_each_time(first in program(), second in program()) {
        let files = [("Setup.8K", first.as_str()), ("Prog0.8K", second.as_str())];
        let found = lint(&files);
        prop_assert_eq!(&found, &lint(&files));
        for ((_, text), found) in files.iter().zip(&found) {
            for diagnostic in found {
                let edits = diagnostic.fixes.iter().flat_map(|fix| &fix.edits).map(|edit| edit.span);
                let labels = diagnostic.labels.iter().map(|label| label.span);
                for span in labels.chain(edits).chain([diagnostic.span]) {
                    prop_assert!(text.get(span.range()).is_some(), "{:?} in {:?}", diagnostic, text);
                }
                for fix in &diagnostic.fixes {
                    prop_assert!(acrc_diagnostics::apply(text, &[fix]).is_ok(), "{:?} in {:?}", fix, text);
                }
                prop_assert!(!(diagnostic.unconfirmed && diagnostic.severity == Severity::Error));
            }
            prop_assert!(found.is_sorted_by_key(|diagnostic| (diagnostic.span.start, diagnostic.span.end)));
        }
    }

    #[test]
    fn any_text_is_linted(text in any::<String>()) {
        lint(&[("test.8K", text.as_str())]);
    }
}
