//! What fixes promise: they come to an end soon, never make a text that can't be read, and a safe one leaves the
//! program as it is, but for its remarks.

use acrc_analysis::project::{Config, LoadedFile, LoadedProject};
use acrc_analysis::{FileRole, parse};
use acrc_diagnostics::{Applicability, Severity};
use acrc_image::Image;
use acrc_image::list::{ListOptions, list};
use acrc_lint::fix::{Outcome, fix};
use acrc_syntax::SourceText;
use proptest::prelude::*;

fn project(text: &str) -> LoadedProject {
    let file = LoadedFile {
        path: "test.8K".into(),
        role: FileRole::Any,
        source: SourceText { text: text.to_owned(), encoding: acrc_syntax::Encoding::Utf8, end_mark: false },
    };
    LoadedProject {
        name: "test".to_owned(),
        model: acrc_catalog::default_model(),
        root: camino::Utf8PathBuf::new(),
        config: Config::default(),
        files: vec![file],
    }
}

struct Repaired {
    text: String,
    outcome: Outcome,
    /// How much the parser refuses before and after.
    errors: [usize; 2],
}

fn repair(text: &str, boldest: Applicability) -> Repaired {
    let project = project(text);
    let mut db = acrc_analysis::Database::new();
    let input = project.add_to(&db);
    let mut sources: Vec<SourceText> = project.files.iter().map(|file| file.source.clone()).collect();
    let file = input.files(&db)[0];
    let refused = |db: &acrc_analysis::Database| {
        parse(db, file).errors().iter().filter(|error| error.severity == Severity::Error).count()
    };
    let before = refused(&db);
    let outcome = fix(&mut db, input, &mut sources, boldest, |_| true);
    Repaired { text: sources.remove(0).text, outcome, errors: [before, refused(&db)] }
}

/// The programs as the controller lists them, without remarks, parentheses and blanks; `None` when they do not compile. What
/// fixes put in parentheses, they put in them as a whole.
fn listing(text: &str) -> Option<Vec<String>> {
    let image: Image = project(text).compile().ok()?;
    let options = ListOptions { line_numbers: false };
    let texts = image.units().map(|unit| list(unit, &image.aliases, &options).expect("a fresh image is whole"));
    let mut lines = Vec::new();
    for text in texts {
        for line in text.lines() {
            let code = line.split("REM").next().unwrap_or_default().trim_end_matches([' ', ':']).trim_end();
            lines.push(code.replace(['(', ')', ' '], ""));
        }
    }
    Some(lines)
}

fn keeps_promises(text: &str, boldest: Applicability) {
    let repaired = repair(text, boldest);
    assert_eq!(repaired.outcome.troubles, [], "{text:?}");
    assert!(repaired.outcome.rounds <= 10, "{} rounds for {text:?}", repaired.outcome.rounds);
    assert!(repaired.errors[1] <= repaired.errors[0], "{text:?} became {:?}", repaired.text);
    let again = repair(&repaired.text, boldest);
    assert_eq!(again.text, repaired.text, "nothing is left to repair");
    if boldest == Applicability::Safe
        && let Some(before) = listing(text)
    {
        assert_eq!(listing(&repaired.text), Some(before), "{text:?} became {:?}", repaired.text);
    }
}

#[test]
fn the_examples_of_all_pages() {
    for doc in acrc_lint::rules() {
        for text in [doc.bad, doc.good] {
            keeps_promises(text, Applicability::Safe);
            keeps_promises(text, Applicability::Unsafe);
        }
    }
}

#[test]
fn what_is_repaired_is_gone() {
    let text = "PROG0\nPROGRAM\nCLEAR\nDIM LV10\nSET 32 ' open\nPRINT \u{201c}ready\u{201d}\nIF BIT 5 THEN SET 33 REM x\n\
                ' acrc: allow(ACR103)\nP0 := LV9\nENDP\n";
    let repaired = repair(text, Applicability::Safe);
    assert_eq!(
        repaired.text,
        "PROG0\nPROGRAM\nCLEAR\nDIM LV(10)\nSET 32 : REM open\nPRINT \"ready\"\nIF (BIT 5) THEN SET 33 : REM x\nP0 = LV9\nENDP\n"
    );
    assert_eq!(repaired.outcome.applied, [8]);
    assert_eq!(repaired.outcome.findings.iter().map(|(_, found)| found.len()).sum::<usize>(), 0);
}

#[test]
fn a_bold_repair_is_made_only_when_asked_for() {
    let text = "PROG0\nPROGRAM\n_Start\nGOTO start\nENDP\n";
    assert_eq!(repair(text, Applicability::Safe).text, text);
    assert_eq!(repair(text, Applicability::Unsafe).text, text.replace("start", "Start"));
    assert_eq!(repair(text, Applicability::DisplayOnly).text, text.replace("start", "Start"));
}

#[test]
fn a_text_that_becomes_ascii_is_no_matter_of_encodings() {
    let mut project = project("");
    project.files[0].source = SourceText::decode(b"PRINT \x93hi\x94\n").expect("a text");
    let mut db = acrc_analysis::Database::new();
    let input = project.add_to(&db);
    let mut sources = [project.files[0].source.clone()];
    let outcome = fix(&mut db, input, &mut sources, Applicability::Safe, |_| true);
    assert_eq!(sources[0].encode(), b"PRINT \"hi\"\n");
    assert_eq!(outcome.findings[0].1, []);
}

const PIECES: [&str; 44] = [
    "PROG0\nPROGRAM",
    "ENDP",
    "GOSUB A",
    "GOTO _A",
    "GOTO a",
    "_A",
    "_ B",
    "IF BIT 1",
    "IF (P0 > 1) THEN",
    "IF P0 > 1 THEN SET 32",
    "ELSE",
    "ENDIF",
    "END IF",
    "FOR LV0 = 0 TO 9",
    "NEXT LV0",
    "WHILE BIT 2",
    "WEND",
    "DIM LV10",
    "DIM $V 1 20",
    "#DEFINE Lamp BIT32",
    "SET Lmap",
    "SET 34 ' why",
    "SET 35 REM why",
    "' acrc: allow(ACR101)",
    "REM acrc: allow(undefined-label, unused-label) -- why",
    "REM acrc: allow(ACR1010)",
    "' acrc: allow-file(unused-label)",
    "' acrc: alow(x)",
    "PRINT \u{201c}a\u{201d}",
    "P0 = 5 \u{2013} 3",
    "P0\u{a0}= 1",
    "P0 := 1",
    "P0 = 0x1F",
    "ACC P0 DEC P1",
    "DWL P0",
    "X10 Y/5",
    "100 SET 32",
    "10 REM acrc: allow(ACR101)",
    "PRINT \"open",
    "PRNT 5",
    "ATTACH SLAVE0 AXIS0 \"X\"",
    "\u{2018}late",
    "REM",
    "\"",
];

fn program() -> impl Strategy<Value = String> {
    let ends = ["\n", "\n", "\n", "\r\n", " : ", " ", ""];
    let piece = (prop::sample::select(&PIECES[..]), prop::sample::select(ends.to_vec()));
    prop::collection::vec(piece, 0..40)
        .prop_map(|pieces| pieces.into_iter().map(|(piece, end)| piece.to_owned() + end).collect())
}

/// Programs that mostly compile.
fn sound_program() -> impl Strategy<Value = String> {
    let lines = [
        "DIM LV10",
        "SET 34 ' why",
        "SET 35 REM why",
        "' acrc: allow(ACR101)",
        "IF BIT 1 THEN SET 32",
        "_ B",
        "REM acrc: allow(ACR101)",
        "PRINT \u{201c}a\u{201d}",
        "P0 = 5 \u{2013} 3",
        "P0\u{a0}= 1",
        "DWL P0",
        "ACC P0 DEC P1",
        "SET 36 : REM acrc: allow(ACR101): x",
        "IF (BIT 1) THEN REM acrc: allow(ACR101)",
        "WHILE BIT 2\nWEND",
        "",
    ];
    let line = (prop::sample::select(lines.to_vec()), prop::sample::select(vec!["\n", "\r\n"]));
    prop::collection::vec(line, 0..20).prop_map(|lines| {
        let body: String = lines.into_iter().map(|(line, end)| line.to_owned() + end).collect();
        format!("PROG0\nPROGRAM\n{body}ENDP\n")
    })
}

proptest! {
    #[test]
    fn any_program(text in program()) {
        keeps_promises(&text, Applicability::Safe);
        keeps_promises(&text, Applicability::Unsafe);
    }

    #[test]
    fn a_program_that_compiles_stays_what_it_is(text in sound_program()) {
        keeps_promises(&text, Applicability::Safe);
    }
}
