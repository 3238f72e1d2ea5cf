//! Which statements of a file belong to which level.

mod support;

use std::fmt::Write;

use acrc_syntax::units::{Level, SectionKind, split};

/// The sections of a file, one a line: level, kind, statements, opener and closer.
fn shown(source: &str, start: Level) -> String {
    let tree = support::checked(source);
    let mut out = String::new();
    let mut end = 0;
    for section in split(&tree, start) {
        assert!(section.statements.start >= end, "sections are in order");
        end = section.statements.end;
        let kind = match section.kind {
            SectionKind::Immediate => "immediate",
            SectionKind::Stored => "stored",
        };
        let _ = write!(out, "{} {kind} {:?}", section.level, section.statements);
        for (name, place) in [("opener", section.opener), ("closer", section.closer)] {
            if let Some(place) = place {
                let _ = write!(out, " {name} {place}");
            }
        }
        out.push('\n');
    }
    out
}

#[test]
fn a_whole_machine() {
    let source = "SYS\nDIM PROG0(100)\nPROG0\nATTACH MASTER0\nPROGRAM\nX5\nEND\nENDP\nPLC 1\nPROGRAM\nLD 5 OUT 32\nENDP\nSYS\nRUN PROG0";
    insta::assert_snapshot!(shown(source, Level::System), @"
    SYS immediate 0..1
    SYS immediate 1..3
    PROG0 immediate 3..4
    PROG0 stored 5..7 opener 4 closer 7
    PROG0 immediate 8..9
    PLC1 stored 10..12 opener 9 closer 12
    PLC1 immediate 13..14
    SYS immediate 14..15
    ");
}

#[test]
fn switches_inside_a_stored_program_switch_nothing() {
    insta::assert_snapshot!(shown("PROGRAM\nPROG1\nSYS\nENDP\nVEL 5", Level::Program(0)), @"
    PROG0 stored 1..3 opener 0 closer 3
    PROG0 immediate 4..5
    ");
}

#[test]
fn numbered_lines_are_stored() {
    insta::assert_snapshot!(shown("VEL 5\n10 X5\n20 X0 : END\n\nLIST\n30 X9", Level::Program(2)), @"
    PROG2 immediate 0..1
    PROG2 stored 1..4
    PROG2 immediate 4..5
    PROG2 stored 5..6
    ");
}

#[test]
fn a_program_without_its_end_reaches_to_the_end_of_the_file() {
    insta::assert_snapshot!(shown("PROGRAM\nX5\n", Level::Program(0)), @"PROG0 stored 1..2 opener 0");
    insta::assert_snapshot!(shown("PROGRAM", Level::Program(0)), @"PROG0 stored 1..1 opener 0");
}

#[test]
fn an_end_without_its_program_is_a_statement_of_its_level() {
    insta::assert_snapshot!(shown("X5\nENDP\nX6", Level::Program(0)), @"PROG0 immediate 0..3");
}

#[test]
fn a_file_without_statements_has_no_sections() {
    assert_eq!(shown("' nothing\n\n", Level::System), "");
}

#[test]
fn levels_are_written_as_the_controller_does() {
    let levels = [Level::System, Level::Program(0), Level::Plc(3)];
    assert_eq!(levels.map(|level| level.to_string()), ["SYS", "PROG0", "PLC3"]);
    insta::assert_snapshot!(shown("PROG 900\nVEL 5\nPROG\nVEL 6", Level::System), @"
    SYS immediate 0..1
    PROG255 immediate 1..4
    ");
}
