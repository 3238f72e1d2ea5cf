//! Coordinated moves and what runs beside them (guide, "Making Motion", "Velocity Profile Commands").

use crate::support::{Ran, Sim, TWO_AXES};

#[test]
fn the_program_runs_ahead_of_its_move() {
    assert_eq!(Sim::program("X10\nPRINT \"given\"\nINH -516\nPRINT \"done\"").timed(), ["0 given", "1100 done"]);
}

#[test]
fn one_move_waits_and_the_next_statement_of_a_move_blocks() {
    // 1.1 seconds a move: the third one finds room when the first has ended.
    let timed = Sim::program("X10\nPRINT 1\nX20\nPRINT 2\nX30\nPRINT 3").timed();
    assert_eq!(timed, ["0 1", "0 2", "1100 3"]);
}

#[test]
fn a_move_buffer_takes_as_many_moves_as_it_has_memory_for() {
    let moves = "MBUF ON\nX10\nX20\nX30\nX40\nPRINT 4\nX50\nPRINT 5";
    assert_eq!(Sim::program(&format!("DIM MBUF(3)\n{moves}")).timed(), ["2 4", "1100 5"]);
    assert_eq!(Sim::program(moves).timed(), ["2200 4", "3300 5"], "without memory one move waits");
    let idle = format!("DIM MBUF(3)\n{moves}").replace("MBUF ON", "MBUF OFF");
    assert_eq!(Sim::program(&idle).timed(), ["2200 4", "3300 5"]);
}

#[test]
fn a_move_buffer_that_goes_leaves_its_moves() {
    for gone in ["CLEAR MBUF", "CLEAR", "MBUF OFF"] {
        let text = format!("DIM MBUF(3)\nMBUF ON\nX10\nX20\nX30\nX40\n{gone}\nX50\nPRINT 5\nINH -516\nPRINT P12290");
        // The fifth move gets room when the fourth one has begun.
        let ran = Sim::program(&text).run().clean();
        let lines: Vec<_> = ran.record.output.iter().map(|line| (line.milliseconds, &*line.text)).collect();
        assert_eq!(lines, [(3300.0, "5"), (5500.0, "50")], "{gone}");
    }
}

#[test]
fn a_move_buffer_that_grows_lets_a_waiting_program_go_on() {
    let setup = "PROG0\nDIM MBUF(2)\nMBUF ON\n";
    let text = format!("{TWO_AXES}{setup}PROGRAM\nX10\nX20\nX30\nX40\nPRINT 4\nENDP\n");
    assert_eq!(Sim::new(&text).start(&[0]).timed(), ["1100 4"]);
    let world = "[[event]]\nat = 0.5\nstream = \"COM1\"\ntext = \"PROG0\\rCLEAR MBUF : DIM MBUF(4)\\r\"\n";
    let ran = Sim::new(&text).start(&[0]).world(world).run().clean();
    let printed = ran.record.output.iter().find(|line| line.text == "4").expect("it is printed");
    assert!((500.0..520.0).contains(&printed.milliseconds), "{printed:?}");
}

#[test]
fn the_buffer_of_a_master_is_that_of_its_program() {
    let text = format!(
        "{TWO_AXES}DIM MBUF(3)\nPROGRAM\nDWL 0.1\nX10\nX20\nX30\nPRINT 3\nENDP\nPROG1\nPROGRAM\nMASTER0 MBUF ON\nENDP\n"
    );
    assert_eq!(Sim::new(&text).start(&[0, 1]).timed(), ["101 3"]);
    assert_eq!(Sim::program("DIM MBUF(-1)").faults(), ["DIM cannot give -1 elements"]);
    assert_eq!(Sim::program("DIM MBUF(1)\nDIM MBUF(1)").faults(), ["Re-dimensioned block"]);
    assert_eq!(Sim::new("PROG1\nPROGRAM\nMBUF ON\nENDP\n").start(&[1]).faults().len(), 1, "it has no master");
}

#[test]
fn flags_change_when_they_are_reached_and_not_when_motion_ends() {
    let ran = Sim::program("X10\nSET 32\nINH -516\nCLR 32").until(0.5).run().clean();
    assert!(ran.bit(32) && ran.bit(516));
    let ran = Sim::program("X10\nSET 32\nINH -516\nCLR 32").run().clean();
    assert!(!ran.bit(32) && !ran.bit(516));
    assert_eq!(ran.milliseconds(), 1100.0);
}

#[test]
fn the_not_in_position_flag_is_set_until_the_axis_is_at_its_target() {
    let ran = Sim::program("X10\nINH -768\nPRINT P12290").run().clean();
    assert_eq!((ran.record.output[0].milliseconds, &*ran.record.output[0].text), (1100.0, "10"));
    let ran = Sim::program("X10").until(0.5).run().clean();
    assert!(ran.bit(768) && !ran.bit(800), "Y does not move");
}

#[test]
fn moves_without_a_stop_ramp_blend() {
    // 0.1 s up, 19 units at 10 u/s, 0.1 s down.
    let ran = Sim::program("STP 0\nX10\nSTP 100\nX20\nINH -516").run().clean();
    assert_eq!((ran.milliseconds(), ran.position(0)), (2100.0, 20.0));
    assert_eq!(ran.notes(), [""; 0]);
}

#[test]
fn a_blended_move_takes_its_own_velocity() {
    let velocity = |seconds: f64| {
        let sim = Sim::program("STP 0\nX10\nVEL 20\nX20\nVEL 5\nX30\nPRINT 3").until(seconds);
        sim.run().controller.view().motion(0).0
    };
    assert_eq!(velocity(0.9), 10.0);
    assert_eq!(velocity(1.4), 20.0);
    assert_eq!(velocity(2.5), 5.0);
}

#[test]
fn the_last_move_without_a_stop_ramp_drops_its_velocity_and_the_run_says_so() {
    let ran = Sim::program("STP 0\nX10\nINH -516\nPRINT P12290").run().clean();
    assert_eq!(ran.record.output[0].text, "10");
    assert_eq!(
        ran.notes(),
        [
            "master 0: a move ended at 10 units/s with nothing to follow it, so its velocity dropped to zero at once (STP 0, FVEL, or a path too short to slow down)"
        ]
    );
}

#[test]
fn feedrate_override_acts_on_the_running_move() {
    let ran = Sim::program("X10\nDWL 0.5\nFOV 0.5\nINH -516").run().clean();
    // At 4.5 units, 0.05 s down to 5 u/s, 5 units at that, 0.05 s to the end.
    assert_eq!((ran.milliseconds(), ran.position(0)), (1600.0, 10.0));
    let held = Sim::program("FOV 0\nX10\nDWL 1\nPRINT P12288\nFOV 1\nINH -516\nPRINT P12288");
    assert_eq!(held.prints(), ["0", "10"]);
}

#[test]
fn a_slash_moves_from_the_target_before() {
    let ran = Sim::program("X10 Y5\nX/5\nX/-2 Y0\nINH -516").run().clean();
    assert_eq!((ran.position(0), ran.position(1)), (13.0, 0.0));
}

#[test]
fn axes_of_one_statement_start_and_finish_together() {
    let ran = Sim::program("X8 Y6\nINH -516").run().clean();
    // The path is 10 units long.
    assert_eq!((ran.position(0), ran.position(1), ran.milliseconds()), (8.0, 6.0, 1100.0));
    let half = Sim::program("X8 Y6").until(0.55).run().clean();
    assert_eq!((half.position(0), half.position(1)), (4.0, 3.0));
}

#[test]
fn an_axis_that_is_not_named_stays() {
    let ran = Sim::program("Y7\nX10\nINH -516").run().clean();
    assert_eq!((ran.position(0), ran.position(1)), (10.0, 7.0));
}

#[test]
fn targets_are_expressions_in_parentheses() {
    let ran = Sim::program("P0 = 4\nX(P0*2) Y/(P0+1)\nINH -516").run().clean();
    assert_eq!((ran.position(0), ran.position(1)), (8.0, 5.0));
}

#[test]
fn a_move_of_no_length_takes_no_time() {
    let ran = Sim::program("X0\nX0\nX0\nINH -516\nPRINT \"done\"").run().clean();
    assert!(ran.record.output[0].milliseconds <= 4.0, "{:?}", ran.record.output);
    assert_eq!(ran.controller.masters().len(), 1);
}

#[test]
fn a_move_without_velocity_is_refused() {
    let fault = "axis move: the velocity of master 0 is 0, so the move would never end; VEL sets it";
    assert_eq!(Sim::program("VEL 0\nX10\nPRINT 1").faults(), [fault]);
}

#[test]
fn a_move_without_a_master_is_refused() {
    let sim = Sim::new("PROG0\nPROGRAM\nX10\nENDP\n").start(&[0]);
    assert_eq!(sim.faults(), ["program 0 has no master: ATTACH MASTER comes first"]);
}

#[test]
fn an_axis_name_that_is_not_attached_is_refused_at_run_time() {
    assert_eq!(Sim::program("Z10").faults(), ["program 0 has no axis named Z"]);
}

#[test]
fn an_axis_takes_one_target_a_statement() {
    assert_eq!(Sim::program("X1 X2").faults(), ["axis move: the axis in SLAVE0 is given two targets"]);
}

#[test]
fn weights_of_zero_need_a_vector_length() {
    let faults = Sim::program("VECDEF X0 Y0\nX10").faults();
    assert_eq!(faults, ["every axis of the move has weight zero and the vector length is zero"]);
    let ran = Sim::program("VECDEF X0 Y1\nX3 Y10\nINH -516").run().clean();
    assert_eq!(ran.milliseconds(), 1100.0);
}

#[test]
fn a_weight_belongs_to_the_attachment() {
    // The move is given in the second slice.
    let sim = Sim::program("VECDEF X0 Y0\nDETACH\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nX10\nINH -516");
    assert_eq!(sim.run().clean().milliseconds(), 1102.0);
}

#[test]
fn kinds_of_moves_that_are_not_simulated_are_known_before_the_run() {
    for (statement, name) in [("SYNC PROG", "SYNC PROG"), ("PM ON X", "PM ON")] {
        let image = Sim::program(statement).image();
        let found = acrc_controller::Controller::unsupported(&image, &[0], &[]);
        let found: Vec<_> = found.iter().map(|item| (item.command.info().name, item.line)).collect();
        assert_eq!(found, [(name, Some(9))]);
    }
}

#[test]
fn what_is_not_simulated_is_refused_at_run_time_too() {
    assert_eq!(Sim::program("SYNC PROG").faults(), ["SYNC PROG is not simulated"]);
}

#[test]
fn flags_tell_what_the_velocity_along_the_path_does() {
    // Up from 10 to 20 u/s and down again for the second move, and down to rest at the end.
    let body = "STP 0\nX10\nVEL 20\nX30\nSTP 100 VEL 10\nX50";
    let phases = |seconds: f64| {
        let ran = Sim::program(body).until(seconds).run().clean();
        [512, 513, 514].map(|bit| ran.bit(bit))
    };
    let (rising, falling, stopping, steady) =
        ([true, false, false], [false, true, false], [false, false, true], [false, false, false]);
    for (seconds, expected) in [
        (0.05, rising),
        (0.5, steady),
        (1.1, rising),
        (1.5, steady),
        (2.08, falling),
        (3.0, steady),
        (4.02, stopping),
        (5.0, steady),
    ] {
        assert_eq!(phases(seconds), expected, "{seconds}");
    }
}

#[test]
fn settings_are_captured_with_the_move() {
    let ran: Ran = Sim::program("X10\nVEL 1 ACC 1 STP 1\nINH -516").run().clean();
    assert_eq!(ran.milliseconds(), 1100.0);
}

#[test]
fn values_per_minute_are_those_per_second_times_sixty() {
    assert_eq!(Sim::program("F 120\nVEL\nF").prints(), ["2", "120"]);
}

#[test]
fn a_master_may_be_named_by_number() {
    let text = format!("{TWO_AXES}SYS\nMASTER0 VEL 5\nMASTER0 VEL\nPROG3\nMASTER0 ACC\nMASTER0 VEL 7\nPROG0\nVEL\n");
    assert_eq!(Sim::new(&text).prints(), ["5", "100", "7"]);
}
