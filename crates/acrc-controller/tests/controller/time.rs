//! Dwell, inhibit, slices and the group of programs that share one (guide, "INH"; `docs/fidelity.md`, "Programs and time").

use acrc_controller::Stopped;

use crate::support::Sim;

/// Programs with their numbers, all started.
fn programs(bodies: &[(u8, &str)]) -> Sim {
    let space = |number: &u8| if *number > 7 { format!("DIM PROG{number}(1000)\n") } else { String::new() };
    let dims: String = bodies.iter().map(|(number, _)| space(number)).collect();
    let texts = bodies.iter().map(|(number, body)| format!("PROG{number}\nPROGRAM\n{body}\nENDP\n"));
    let texts: String = texts.collect();
    let numbers: Vec<u8> = bodies.iter().map(|(number, _)| *number).collect();
    Sim::new(&format!("SYS\nDIM P(10)\n{dims}{texts}")).start(&numbers)
}

#[test]
fn a_dwell_ends_in_the_first_slice_after_its_time() {
    // Alone, a program shares the time with communication: a slice every 2 ms.
    let sim = Sim::program("DWL 0.1\nPRINT 1\nDWL 0.0101\nPRINT 2\nDWL 0\nPRINT 3");
    assert_eq!(sim.timed(), ["100 1", "112 2", "112 3"]);
}

#[test]
fn a_slice_executes_four_lines() {
    let sim = Sim::program("PRINT 1\nPRINT 2 : PRINT 22\nPRINT 3\nPRINT 4\nPRINT 5");
    assert_eq!(sim.timed(), ["0 1", "0 2", "0 22", "0 3", "0 4", "2 5"]);
}

#[test]
fn high_programs_get_a_slice_each_in_turn() {
    let body = "PRINT 1\nPRINT 2\nPRINT 3\nPRINT 4\nPRINT 5";
    let ran = programs(&[(0, body), (3, body)]).run().clean();
    let fives = ran.record.output.iter().filter(|line| line.text == "5");
    let found: Vec<_> = fives.map(|line| (line.program, line.milliseconds)).collect();
    // 0: program 0, 1: program 3, 2: communication, 3: program 0, 4: program 3.
    assert_eq!(found, [(Some(0), 3.0), (Some(3), 4.0)]);
}

#[test]
fn a_program_that_has_ended_takes_no_slice() {
    let sim = programs(&[(0, "END"), (1, "PRINT 1\nREM a\nREM b\nREM c\nPRINT 2\nREM\nREM\nREM\nPRINT 3")]);
    // Program 0 has the slice at 0; then program 1 and communication have one each in turn.
    assert_eq!(sim.timed(), ["1 1", "3 2", "5 3"]);
}

#[test]
fn low_programs_take_turns_at_one_slice() {
    let body = "PRINT 1\nPRINT 2\nPRINT 3\nPRINT 4\nPRINT 5";
    let ran = programs(&[(8, body), (9, body)]).run().clean();
    let found: Vec<_> = ran
        .record
        .output
        .iter()
        .filter(|line| line.text == "5")
        .map(|line| (line.program, line.milliseconds))
        .collect();
    // Communication at 0, program 8 at 1, communication, program 9 at 3, communication, program 8 at 5.
    assert_eq!(found, [(Some(8), 5.0), (Some(9), 7.0)]);
}

#[test]
fn a_dwell_in_a_low_program_holds_its_whole_group() {
    let sim = programs(&[(8, "DWL 1\nPRINT \"eight\""), (9, "PRINT \"nine\""), (0, "PRINT \"zero\"")]);
    assert_eq!(sim.timed(), ["0 zero", "1002 eight", "1004 nine"]);
}

#[test]
fn an_inhibit_in_a_low_program_holds_its_whole_group_for_good() {
    let ran = programs(&[(8, "INH 128"), (9, "SET 128\nPRINT \"nine\"")]).until(5.0).run().clean();
    assert_eq!((ran.stopped, ran.record.output.len()), (Stopped::Until, 0));
}

#[test]
fn dwells_of_high_programs_do_not_hold_each_other() {
    let sim = programs(&[(0, "DWL 1\nPRINT 0"), (1, "DWL 0.5\nPRINT 1")]);
    assert_eq!(sim.prints(), ["1", "0"]);
}

#[test]
fn an_inhibit_waits_for_a_set_or_for_a_clear_flag() {
    let sim = programs(&[
        (0, "INH 128\nPRINT \"set\"\nINH -128\nPRINT \"clear\""),
        (1, "DWL 0.1\nSET 128\nDWL 0.1\nCLR 128"),
    ]);
    assert_eq!(sim.prints(), ["set", "clear"]);
}

#[test]
fn a_wait_for_something_that_never_happens_lasts_until_the_end_of_the_run() {
    let ran = Sim::program("INH 128").until(1e7).watched(false).run().clean();
    assert_eq!((ran.stopped, ran.milliseconds()), (Stopped::Until, 1e10));
}

#[test]
fn waiting_costs_no_ticks_when_nobody_watches() {
    let ran = Sim::program("DWL 100000\nPRINT 1").until(1e9).watched(false).run().clean();
    assert_eq!(ran.record.output[0].milliseconds, 1e8);
    assert!(ran.record.ticks < 100, "{}", ran.record.ticks);
}

#[test]
fn a_negative_dwell_is_refused() {
    assert_eq!(Sim::program("DWL (-1)").faults(), ["DWL: a time of -1 seconds is not possible"]);
    assert_eq!(Sim::program("DWL 1e30").faults().len(), 1);
}

#[test]
fn a_run_may_end_in_the_middle_of_a_move() {
    let ran = Sim::program("X10\nINH -516").until(0.55).run().clean();
    assert_eq!((ran.stopped, ran.position(0), ran.milliseconds()), (Stopped::Until, 5.0, 550.0));
    let before = Sim::program("PRINT 1").until(0.0).run().clean();
    assert_eq!((before.stopped, before.milliseconds()), (Stopped::Ended, 0.0));
}

#[test]
fn the_servo_period_is_set_before_time_begins() {
    let text = "SYS\nPERIOD\nPERIOD 0.001\nPERIOD\nPROG0\nPROGRAM\nDWL 0.5\nPRINT 1\nENDP\n";
    let ran = Sim::new(text).start(&[0]).run().clean();
    assert_eq!(ran.record.output.iter().map(|line| &*line.text).collect::<Vec<_>>(), ["0.0005", "0.001", "1"]);
    assert_eq!(ran.record.output[2].milliseconds, 500.0);
    let ran = Sim::new(&format!("{text}RUN PROG0\nDWL 0.01\nPERIOD 0.002\n")).until(0.25).run();
    assert_eq!(ran.milliseconds(), 250.0, "the end of a run is a time, whatever the period");
    assert_eq!(ran.record.faults[0].message, "PERIOD: the servo period can only be set before time begins");
    assert_eq!(Sim::new("SYS\nPERIOD 5\n").faults(), ["PERIOD: a servo period of 5 seconds is not possible"]);
}

#[test]
fn the_clock_parameter_counts_milliseconds_and_can_be_set() {
    let sim = Sim::program("PRINT P6916\nDWL 1.5\nPRINT P6916\nP6916 = 100\nDWL 0.25\nPRINT P6916");
    assert_eq!(sim.prints(), ["0", "1500", "350"]);
    let wrapped = Sim::program("P6916 = 2147483647\nDWL 0.01\nPRINT P6916");
    assert_eq!(wrapped.prints(), ["9"]);
}

#[test]
fn a_wait_for_a_parameter_ends_behind_the_setpoint_or_in_time() {
    assert_eq!(Sim::program("X10\nIHPOS P12290 (4, 0)\nPRINT P12290 > 4, P12290 < 6").prints(), ["-1\t-1"]);
    assert_eq!(Sim::program("RES X10\nX0\nIHPOS -P12290 (5, 0)\nPRINT P12290 < 5, P12290 > 3").prints(), ["-1\t-1"]);
    assert_eq!(Sim::program("IHPOS P12290 (4, 5.5)\nPRINT P12290").timed(), ["5500 0"]);
    // User parameters, too; the timeout does not delay what another program brings about.
    let text =
        "SYS\nDIM P(2)\nPROG0\nPROGRAM\nIHPOS P1 (2, 100)\nPRINT P1\nENDP\nPROG1\nPROGRAM\nDWL 3\nP1 = 3\nENDP\n";
    for watched in [false, true] {
        let timed = Sim::new(text).start(&[0, 1]).watched(watched).timed();
        assert!(timed.len() == 1 && timed[0].starts_with("300"), "{timed:?}");
    }
}

#[test]
fn a_wait_for_the_clock_ends_in_time() {
    for watched in [false, true] {
        let timed = Sim::program("DWL 0.5\nIHPOS P6916 (2000, 0)\nPRINT P6916").watched(watched).timed();
        assert_eq!(timed, ["2002 2002"]);
    }
}

#[test]
fn a_wait_for_a_parameter_has_a_setpoint_and_a_timeout() {
    let fault = "IHPOS: a timeout of -1 seconds is not possible";
    assert_eq!(Sim::program("IHPOS P12290 (4, -1)").faults(), [fault]);
}
