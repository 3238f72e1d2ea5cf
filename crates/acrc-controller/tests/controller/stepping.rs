//! Block mode and trace (`program_control.toml`; `docs/fidelity.md`, "Programs and time").

use crate::support::{Sim, TWO_AXES};

/// Program 0 is controlled by program 1.
fn controlled(zero: &str, one: &str) -> Sim {
    Sim::new(&format!("{TWO_AXES}PROGRAM\n{zero}\nENDP\nPROG1\nPROGRAM\n{one}\nENDP\n")).start(&[1])
}

#[test]
fn a_program_in_block_mode_executes_a_line_a_step() {
    let one = "BLK PROG0\nRUN PROG0\nDWL 0.1\nPRINT \"a\"\nSTEP PROG0\nDWL 0.1\nPRINT \"b\"\nSTEP PROG0\nDWL 0.1\nPRINT \"c\"";
    assert_eq!(controlled("PRINT 1 : PRINT 2\nPRINT 3\nPRINT 4", one).prints(), ["a", "1", "2", "b", "3", "c"]);
}

#[test]
fn a_line_that_waits_is_one_step() {
    let one = "BLK PROG0\nRUN PROG0\nSTEP PROG0\nDWL 0.2\nPRINT \"b\"\nSET 128\nDWL 0.2\nPRINT \"c\"";
    let zero = "PRINT 1 : INH 128 : PRINT 2\nPRINT 3";
    assert_eq!(controlled(zero, one).prints(), ["1", "b", "2", "c"]);
    assert_eq!(controlled("PRINT 1 : INH 128\nPRINT 3", one).prints(), ["1", "b", "c"]);
}

#[test]
fn aut_lets_a_program_go_on() {
    let one = "BLK PROG0\nRUN PROG0\nSTEP PROG0\nDWL 0.1\nPRINT \"on\"\nAUT PROG0";
    assert_eq!(controlled("PRINT 1\nPRINT 2\nPRINT 3", one).prints(), ["1", "on", "2", "3"]);
}

#[test]
fn a_running_program_can_be_put_into_block_mode() {
    let one = "RUN PROG0\nDWL 0.1\nBLK PROG0\nP0 = 0\nDWL 0.1\nPRINT P0\nSTEP PROG0\nSTEP PROG0\nDWL 0.1\nPRINT P0";
    assert_eq!(controlled("WHILE (NOT BIT 128) : P0 = P0 + 1 : WEND", one).until(1.0).prints(), ["0", "1"]);
}

#[test]
fn a_step_without_block_mode_does_nothing() {
    assert_eq!(controlled("PRINT 1", "STEP PROG0\nDWL 0.1\nRUN PROG0").prints(), ["1"]);
}

#[test]
fn the_trace_shows_the_number_of_each_line() {
    let zero = "PRINT 1\n25 PRINT 2 : DWL 0.1 : PRINT 3\nIF (BIT 128)\nPRINT 4\nENDIF\nTROFF PROG0\nPRINT 5";
    let one = "TRON PROG0\nRUN PROG0";
    let lines = controlled(zero, one).prints();
    assert_eq!(lines, ["[10]", "1", "[25]", "2", "3", "[30]", "[50]", "[60]", "5"]);
}

#[test]
fn a_trace_changes_no_time() {
    let zero = "PRINT 1\nPRINT 2\nDWL 0.01 : PRINT 3\nPRINT 4\nPRINT 5\nPRINT 6\nX1\nINH -516\nPRINT 7";
    let without: Vec<_> = controlled(zero, "RUN PROG0").timed();
    let with: Vec<_> = controlled(zero, "TRON PROG0 : RUN PROG0").timed();
    assert_eq!(with.into_iter().filter(|line| !line.contains('[')).collect::<Vec<_>>(), without);
}

#[test]
fn pboot_at_a_prompt_starts_everything_that_begins_with_it() {
    let text = "SYS\nDIM PLC0(200)\nPROG0\nPROGRAM\nPBOOT\nPRINT \"zero\"\nENDP\nPROG1\nPROGRAM\nPRINT \"one\"\nENDP\n\
                PROG2\nPROGRAM\nPBOOT\nPRINT \"two\"\nENDP\nSYS\nPBOOT\n";
    assert_eq!(Sim::new(text).prints(), ["zero", "two"]);
}

#[test]
fn all_means_programs_and_plc_programs() {
    let text = "SYS\nDIM PLC0(200)\nPLC0\nPROGRAM\nLD NOT 128\nOUT 40\nENDP\nPROG0\nPROGRAM\nDWL 0.1\nPRINT BIT 40\n\
                HALT ALL\nENDP\nPROG1\nPROGRAM\nDWL 1\nPRINT \"no\"\nENDP\nSYS\nRUN ALL\n";
    let ran = Sim::new(text).run().clean();
    assert_eq!((ran.record.output.len(), &*ran.record.output[0].text), (1, "-1"));
    assert!(!ran.bit(1024) && !ran.bit(1536));
}
