//! Setup code: immediate statements outside of `PROGRAM` .. `ENDP` (`docs/fidelity.md`, "Programs and time").

use crate::support::{Sim, TWO_AXES};

#[test]
fn setup_code_runs_before_time_begins() {
    let body = (0..100).map(|number| format!("P0 = {number}\n")).collect::<Vec<_>>().concat();
    let ran = Sim::new(&format!("SYS\nDIM P(1)\n{body}PRINT P0\n")).run().clean();
    assert_eq!((ran.record.output[0].milliseconds, &*ran.record.output[0].text), (0.0, "99"));
    assert_eq!(ran.record.output[0].program, None);
}

#[test]
fn a_refused_statement_is_reported_and_the_next_one_taken() {
    let ran = Sim::new("SYS\nDIM P(1)\nDIM P(1)\nX10\nPROG0\nX10\nPRINT \"on\"\n").run();
    let faults: Vec<_> = ran.record.faults.iter().map(ToString::to_string).collect();
    assert_eq!(
        faults,
        [
            "setup test.8K line 3 statement 1: Re-dimensioned block: P has 8 bytes already; CLEAR frees them",
            "setup test.8K line 4 statement 1: axis move is not possible at the SYS level",
            "setup test.8K line 6 statement 1: program 0 has no master: ATTACH MASTER comes first",
        ]
    );
    assert!(ran.controller.faulted());
}

#[test]
fn setup_code_waits() {
    let text = format!("{TWO_AXES}DWL 0.5\nPRINT 1\nX10\nPRINT 2\nINH -516\nPRINT 3\n");
    assert_eq!(Sim::new(&text).timed(), ["500 1", "500 2", "1600 3"]);
}

#[test]
fn moves_of_setup_code_find_the_queue_full() {
    let text = format!("{TWO_AXES}X10\nX20\nPRINT 2\nX30\nPRINT 3\n");
    assert_eq!(Sim::new(&text).timed(), ["0 2", "1100 3"]);
}

#[test]
fn programs_run_while_setup_code_waits() {
    let text = "PROG0\nPROGRAM\nPRINT \"zero\"\nENDP\nRUN PROG0\nDWL 1\nPRINT \"setup\"\n";
    assert_eq!(Sim::new(text).prints(), ["zero", "setup"]);
}

#[test]
fn setup_code_waits_for_a_flag_of_a_program() {
    let text = "PROG0\nPROGRAM\nDWL 3\nSET 128\nENDP\nRUN PROG0\nINH 128\nPRINT \"seen\"\n";
    for watched in [true, false] {
        assert_eq!(Sim::new(text).watched(watched).timed(), ["3000.5 seen"]);
    }
}

#[test]
fn a_wait_of_setup_code_that_never_ends_costs_nothing() {
    let ran = Sim::new("INH 128\n").until(1e8).watched(false).run().clean();
    assert_eq!(ran.milliseconds(), 1e11);
}

#[test]
fn programs_start_when_setup_code_is_over() {
    let text = "PROG0\nPROGRAM\nPRINT \"zero\"\nENDP\nDWL 1\nPRINT \"setup\"\n";
    assert_eq!(Sim::new(text).start(&[0]).prints(), ["setup", "zero"]);
}

#[test]
fn a_new_text_takes_the_place_of_one_that_runs() {
    let text = "PROG0\nPROGRAM\nDWL 1\nPRINT 1\nPRINT 2\nPRINT 3\nENDP\nRUN PROG0\nDWL 0.5\nPROGRAM\nPRINT \"new\"\nENDP\n\
                DWL 1\nRUN PROG0\n";
    assert_eq!(Sim::new(text).prints(), ["new"]);
}

#[test]
fn a_run_of_nothing_ends_at_once() {
    let ran = Sim::new("").run().clean();
    assert_eq!((ran.milliseconds(), ran.record.ticks), (0.0, 1));
}

#[test]
fn what_depends_on_a_refused_condition_is_left_out() {
    let ran = Sim::new("SYS\nWHILE (P99 = 1) : SET 32 : WEND\nIF (P99 = 1) THEN SET 32\nPRINT BIT32\n").run();
    assert_eq!((&*ran.record.output[0].text, ran.record.faults.len()), ("0", 2));
}
