use acrc_ide::{SignatureHelp, signature_help};

use crate::fixture::Fixture;

fn help(line: &str) -> Option<SignatureHelp> {
    let fixture = Fixture::new(&format!("PROG0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nVEL 5\n{line}\nENDP\n"));
    let position = fixture.cursor();
    signature_help(&fixture.db, position.file, position.offset)
}

/// The form with the active argument in angle brackets, and its facts.
fn shown(line: &str) -> String {
    let Some(help) = help(line) else { return "nothing".to_owned() };
    let argument = help.active.and_then(|active| help.arguments.get(active as usize));
    let mut label = help.label.clone();
    if let Some(range) = argument.and_then(|argument| argument.label.clone()) {
        label.insert(range.end as usize, '>');
        label.insert(range.start as usize, '<');
    }
    let facts = argument.map(|argument| format!(" [{}]", argument.facts)).unwrap_or_default();
    format!("{label}{facts}")
}

#[test]
fn the_argument_that_is_written_is_marked() {
    let lines = [
        "DWL $0",
        "DWL (P0+$0",
        "JOG VEL X$0",
        "JOG VEL X5$0",
        "SINE X($0",
        "SINE X(5, $0)",
        "SINE X(5, (2+3)*$0, 4)",
        "SINE X(5, 0, SQRT($0), 4)",
        "P0 = MID$($V0, $0)",
        "P0 = (1 + ABS($0",
        "P0 = P(12288+$0)",
        "LA0($0) = 5",
        "IHPOS P12290 (100, $0)",
        "MOV X5 : DWL $0",
        "ACC10 DEC$0",
        "DIM LV($0",
        "FOR LV0 = $0",
        "X10 $0",
        "P0 = 5$0",
        "DWL 1 : $0",
        "DWL 1 ' not $0here",
        "REM nor $0here",
        "PRINT \"nor $0here\"",
    ];
    let shown: Vec<String> = lines.iter().map(|line| format!("{line:<32}{}", shown(line))).collect();
    insta::assert_snapshot!(shown.join("\n"));
}
