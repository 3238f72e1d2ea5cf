//! Definitions, references, highlights, symbols, calls, folds and selections.

use acrc_ide::{
    Calls, Fold, Symbol, definition, document_symbols, folds, highlights, incoming_calls, outgoing_calls, references,
    routine_at, selection_ranges, workspace_symbols,
};

use crate::fixture::Fixture;

const PROJECT: &str = "\
=== Setup.8K
SYS : DIM DEF(4) : DIM P(10)
#DEFINE Clamp BIT32
#DEFINE Speed P1
' about
REM the axis
PROG0
ATTACH MASTER0 : ATTACH SLAVE0 AXIS0 \"X\"
DIM LV(3)
DIM LA(1) : DIM LA0(8)
RUN PROG0
=== Prog0.8K
PROGRAM
_Main
10 SET Clamp : VEL (Speed)
X10 : x/-5
IF (BIT32 AND P1 > 2)
    GOSUB Open
ELSE
    GOSUB Shut : GOTO 10
ENDIF
WHILE (LV2 < 3)
    LA0(1) = LV2
    BREAK
WEND
GOTO Main
_Open
REM opens
SET Clamp
GOSUB Shut
RETURN
_Shut
CLR 32
IF (P2) THEN GOSUB Shut
RETURN
ENDP
";

fn with_cursor(before: &str, behind: &str) -> Fixture {
    let whole = format!("{before}{behind}");
    assert_eq!(PROJECT.matches(&whole).count(), 1, "{whole}");
    Fixture::new(&PROJECT.replace(&whole, &format!("{before}$0{behind}")))
}

fn defined(before: &str, behind: &str) -> Vec<String> {
    let fixture = with_cursor(before, behind);
    definition(&fixture.db, fixture.cursor()).iter().map(|target| fixture.show(target.file, target.name)).collect()
}

#[test]
fn everything_is_declared_somewhere() {
    assert_eq!(defined("10 SET ", "Clamp"), ["Setup.8K:2:9 Clamp"]);
    assert_eq!(defined("(BIT", "32 AND"), ["Setup.8K:2:9 Clamp"]);
    assert_eq!(defined("CLR ", "32"), ["Setup.8K:2:9 Clamp"]);
    assert_eq!(defined("(P", "2)"), ["Setup.8K:1:20 DIM P"]);
    assert_eq!(defined(" : x", "/-5"), ["Setup.8K:7:39 X"]);
    assert_eq!(defined("(LV", "2 <"), ["Setup.8K:8:1 DIM LV"]);
    assert_eq!(defined("    LA", "0(1)"), ["Setup.8K:9:1 DIM LA", "Setup.8K:9:13 DIM LA"]);
    assert_eq!(defined("GOTO ", "Main"), ["Prog0.8K:2:2 Main"]);
    assert_eq!(defined("GOTO 1", "0"), ["Prog0.8K:3:1 10"]);
    assert_eq!(defined("RUN PR", "OG0"), ["Prog0.8K:1:1 PROGRAM"]);
    assert_eq!(defined("AXIS", "0"), ["Setup.8K:7:18 ATTACH SLAVE0 AXIS0 \"X\""]);
}

#[test]
fn words_of_blocks_lead_to_what_opens_them() {
    assert_eq!(defined("EL", "SE"), ["Prog0.8K:5:1 IF (BIT32 AND P1 > 2)"]);
    assert_eq!(defined("ENDI", "F"), ["Prog0.8K:5:1 IF (BIT32 AND P1 > 2)"]);
    assert_eq!(defined("BRE", "AK"), ["Prog0.8K:10:1 WHILE (LV2 < 3)"]);
    assert_eq!(defined("END", "P\n"), ["Prog0.8K:1:1 PROGRAM"]);
    assert_eq!(defined("VE", "L"), [""; 0]);
}

#[test]
fn references_see_through_aliases() {
    let found = |before: &str, behind: &str, with: bool| -> Vec<String> {
        let fixture = with_cursor(before, behind);
        let found = references(&fixture.db, fixture.cursor(), with);
        found.iter().map(|range| fixture.show(range.file, range.span)).collect()
    };
    assert_eq!(found("10 SET ", "Clamp", true), ["Setup.8K:2:9 Clamp", "Prog0.8K:3:8 Clamp", "Prog0.8K:17:5 Clamp"]);
    assert_eq!(found("10 SET ", "Clamp", false), ["Prog0.8K:3:8 Clamp", "Prog0.8K:17:5 Clamp"]);
    let all =
        ["Setup.8K:2:15 BIT32", "Prog0.8K:3:8 Clamp", "Prog0.8K:5:5 BIT32", "Prog0.8K:17:5 Clamp", "Prog0.8K:21:5 32"];
    assert_eq!(found("CLR ", "32", false), all);
    assert_eq!(found("(LV", "2 <", true), ["Setup.8K:8:1 DIM LV", "Prog0.8K:10:8 LV2", "Prog0.8K:11:14 LV2"]);
    assert_eq!(found("GOTO 1", "0", true), ["Prog0.8K:3:1 10", "Prog0.8K:8:23 10"]);
}

#[test]
fn highlights_say_what_is_written() {
    let found = |before: &str, behind: &str| -> Vec<String> {
        let fixture = with_cursor(before, behind);
        let place = fixture.cursor();
        let found = highlights(&fixture.db, place);
        found.iter().map(|(span, access)| format!("{} {access:?}", fixture.show(place.file, *span))).collect()
    };
    assert_eq!(found("10 SET ", "Clamp"), ["Prog0.8K:3:8 Clamp Write", "Prog0.8K:17:5 Clamp Write"]);
    assert_eq!(found("GOSUB ", "Open"), ["Prog0.8K:6:11 Open Read", "Prog0.8K:15:2 Open Write"]);
    assert_eq!(found("EL", "SE"), ["Prog0.8K:5:1 IF Text", "Prog0.8K:7:1 ELSE Text", "Prog0.8K:9:1 ENDIF Text"]);
    assert_eq!(found("END", "P\n"), ["Prog0.8K:1:1 PROGRAM Text", "Prog0.8K:24:1 ENDP Text"]);
}

#[test]
fn the_outline_is_a_tree() {
    fn write(fixture: &Fixture, file: acrc_analysis::SourceFile, symbol: &Symbol, depth: usize, out: &mut Vec<String>) {
        let place = fixture.show(file, symbol.place);
        let place = place.split(' ').next().expect("a place");
        let whole = fixture.show(file, symbol.whole);
        let lines = whole.lines().count();
        let indent = "  ".repeat(depth);
        out.push(format!("{indent}{:?} {} {} [{place}, {lines} lines]", symbol.kind, symbol.name, symbol.detail));
        for child in &symbol.children {
            write(fixture, file, child, depth + 1, out);
        }
    }
    let fixture = Fixture::new(PROJECT);
    let mut out = Vec::new();
    for &file in &fixture.files {
        for symbol in document_symbols(&fixture.db, file) {
            write(&fixture, file, &symbol, 0, &mut out);
        }
    }
    insta::assert_snapshot!(out.join("\n"));
}

#[test]
fn the_best_fit_is_found_first() {
    let fixture = Fixture::new(PROJECT);
    let found = |pattern: &str| -> Vec<String> {
        let found = workspace_symbols(&fixture.db, fixture.project, pattern, 4);
        found.iter().map(|symbol| format!("{:?} {} {}", symbol.kind, symbol.name, symbol.container)).collect()
    };
    assert_eq!(found("op"), ["Subroutine Open PROG0"]);
    assert_eq!(found("m"), ["Label Main PROG0", "Alias Clamp SYS"]);
    assert_eq!(found("prog0"), ["Program PROG0 "]);
    assert_eq!(found("").len(), 4);
}

fn calls(found: &[Calls], fixture: &Fixture, file: acrc_analysis::SourceFile) -> Vec<String> {
    let places = |calls: &Calls| -> Vec<String> { calls.places.iter().map(|span| fixture.show(file, *span)).collect() };
    found.iter().map(|calls| format!("{} at {}", calls.routine.name, places(calls).join(", "))).collect()
}

#[test]
fn subroutines_call_each_other() {
    for (before, behind, name, callers, called) in [
        ("GOSUB ", "Open", "Open", vec!["PROG0 at Prog0.8K:6:11 Open"], vec!["Shut at Prog0.8K:18:7 Shut"]),
        (
            "_Sh",
            "ut",
            "Shut",
            vec!["PROG0 at Prog0.8K:8:11 Shut", "Open at Prog0.8K:18:7 Shut", "Shut at Prog0.8K:22:20 Shut"],
            vec!["Shut at Prog0.8K:22:20 Shut"],
        ),
        ("PROGR", "AM", "PROG0", vec![], vec!["Open at Prog0.8K:6:11 Open", "Shut at Prog0.8K:8:11 Shut"]),
    ] {
        let fixture = with_cursor(before, behind);
        let routine = routine_at(&fixture.db, fixture.cursor()).expect("a routine");
        assert_eq!(routine.name, name);
        let file = routine.target.file;
        let place = acrc_ide::FilePosition { offset: routine.target.name.start, file, ..fixture.cursor() };
        assert_eq!(calls(&incoming_calls(&fixture.db, place), &fixture, file), callers, "{name}");
        assert_eq!(calls(&outgoing_calls(&fixture.db, place), &fixture, file), called, "{name}");
    }
    let fixture = with_cursor("CL", "R 32");
    assert_eq!(routine_at(&fixture.db, fixture.cursor()), None);
}

#[test]
fn a_file_that_is_the_program_has_main_code_too() {
    let fixture = Fixture::new("=== Prog1.8K\nS$0ET 1\nGOSUB A\nEND\n_A\nRETURN\n");
    let routine = routine_at(&fixture.db, fixture.cursor()).expect("main code");
    assert_eq!((routine.name.as_str(), routine.is_main), ("PROG1", true));
    let found = outgoing_calls(&fixture.db, fixture.cursor());
    assert_eq!(calls(&found, &fixture, fixture.cursor().file), ["A at Prog1.8K:2:7 A"]);
}

#[test]
fn lines_that_can_be_folded() {
    let fixture = Fixture::new(PROJECT);
    let mut out = Vec::new();
    for &file in &fixture.files {
        for Fold { span, kind } in folds(&fixture.db, file) {
            let text = fixture.show(file, span);
            let lines: Vec<&str> = text.lines().collect();
            let (first, last) = (lines.first().expect("a line"), lines.last().expect("a line"));
            out.push(format!("{kind:?}: {first} .. {last}"));
        }
    }
    insta::assert_snapshot!(out.join("\n"));
}

#[test]
fn a_selection_grows() {
    let fixture = with_cursor("    LA0(1) = LV", "2");
    let place = fixture.cursor();
    let spans = selection_ranges(&fixture.db, place.file, place.offset);
    let shown: Vec<String> = spans.iter().map(|span| fixture.show(place.file, *span)).collect();
    insta::assert_snapshot!(shown.join("\n----\n"));
}
