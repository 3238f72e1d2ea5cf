//! Moves that wait, moves that are cut short or redirected, moves that begin together: `TRG`, `INT`, `TRJ`, `HSINT`, `SYNC`.

use crate::support::{Sim, TWO_AXES};

/// An input that changes after some seconds.
fn input(bit: u32, seconds: f64) -> String {
    format!("[[event]]\nat = {seconds}\nset = [{bit}]\n")
}

#[test]
fn a_triggered_move_waits_for_its_flag() {
    let ran = Sim::program("TRG 5\nX10\nPRINT BIT(516)\nINH -516").world(&input(5, 2.0)).run().clean();
    assert_eq!((ran.record.output[0].text.as_str(), ran.milliseconds()), ("-1", 3100.0));
    let early = Sim::program("TRG 5\nX10").world(&input(5, 2.0)).until(1.9).run().clean();
    assert_eq!(early.position(0), 0.0);
    // A minus waits for a clear flag, which this is.
    assert_eq!(Sim::program("TRG -5\nX10\nINH -516").run().clean().milliseconds(), 1100.0);
}

#[test]
fn a_trigger_is_for_one_move() {
    let ran = Sim::program("TRG 5\nX10\nX20\nINH -516").world(&input(5, 2.0)).run().clean();
    assert_eq!((ran.position(0), ran.milliseconds()), (20.0, 4200.0));
}

#[test]
fn a_gate_behind_a_move_that_blends_takes_its_velocity_over_if_it_is_open() {
    let time = |world: &str| {
        let body = "STP 0\nX10\nTRG 5\nSTP 100 X20\nINH -516";
        Sim::program(body).world(world).run().clean().milliseconds()
    };
    assert_eq!(time(&input(5, 0.5)), 2100.0);
    assert_eq!(time(&input(5, 2.0)), 3100.0);
}

#[test]
fn a_waiting_move_is_not_slept_over() {
    // Nobody watches each tick, and the only program waits for the move.
    let sim = Sim::program("TRG 5\nX10\nINH -516\nPRINT \"done\"").world(&input(5, 30.0)).watched(false);
    assert_eq!(sim.timed(), ["31100 done"]);
    let text = "TRG 32\nX10\nDWL 3\nSET 32\nINH -516\nPRINT \"done\"";
    assert_eq!(Sim::program(text).watched(false).timed(), Sim::program(text).timed());
}

#[test]
fn kill_all_moves_forgets_a_trigger() {
    let ran = Sim::program("TRG 5\nSET 522\nCLR 522\nX10\nINH -516").run().clean();
    assert_eq!(ran.milliseconds(), 1100.0);
    let waiting = Sim::program("TRG 5\nX10\nDWL 1\nSET 523\nINH 522\nCLR 522\nX5\nINH -516").run().clean();
    assert_eq!(waiting.position(0), 5.0);
}

#[test]
fn feedhold_keeps_a_gate_shut() {
    let body = "TRG 5\nX10\nSET 520\nDWL 2\nSET 521\nINH -516";
    let ran = Sim::program(body).world(&input(5, 0.5)).run().clean();
    assert_eq!(ran.milliseconds(), 3102.0);
}

#[test]
fn an_interruptible_move_is_cut_short_with_dec() {
    let ran = Sim::program("INT 5 X10\nX/5\nINH -516").world(&input(5, 0.5)).run().clean();
    // 4.5 units at 0.5 s and 0.5 units of ramp; the next distance counts from there.
    assert!((ran.position(0) - 10.0).abs() < 0.02, "{}", ran.position(0));
    assert!((ran.milliseconds() - 1200.0).abs() < 5.0, "{}", ran.milliseconds());
    let through = Sim::program("INT 5 X10\nINH -516").run().clean();
    assert_eq!((through.position(0), through.milliseconds()), (10.0, 1100.0));
}

#[test]
fn the_move_behind_an_interruptible_one_is_given_when_that_has_ended() {
    let timed = Sim::program("INT -5 X10\nPRINT 1\nX20\nPRINT 2").world(&input(5, 0.0)).timed();
    assert_eq!(timed, ["0 1", "1100 2"]);
}

#[test]
fn a_new_trajectory_takes_the_place_of_all_moves() {
    let ran = Sim::program("X10\nX20\nDWL 0.5\nTRJ X5 Y3\nINH -516").run().clean();
    assert_eq!((ran.position(0), ran.position(1)), (5.0, 3.0));
    // From 4.5 units it goes on at 10 u/s, which is too fast for what is left: it comes to rest there.
    let ran = Sim::program("X10\nDWL 0.5\nTRJ X14.5\nINH -516").run().clean();
    assert!((ran.milliseconds() - 1550.0).abs() < 5.0, "{}", ran.milliseconds());
    assert_eq!(Sim::program("TRJ X/3\nINH -516").run().clean().position(0), 3.0);
}

#[test]
fn a_capture_redirects_a_move() {
    // One unit is one pulse; the capture happens at 5.
    let world = "[[event]]\nat = 0.6\nset = [777]\nparameters = { P12292 = 5 }\n";
    let body = "HSINT X(0, 20, 4)\nINH -516\nPRINT BIT(798); BIT(799)";
    let ran = Sim::program(body).world(world).run().clean();
    assert_eq!((ran.position(0), ran.record.output[0].text.as_str()), (9.0, "-10"));
    let missed = Sim::program(body).run().clean();
    assert_eq!((missed.position(0), missed.record.output[0].text.as_str()), (20.0, "00"));
}

#[test]
fn a_capture_redirects_no_move_but_its_own() {
    // The first move is redirected from 5 to 9; nothing is captured during the second one, which waits for the first.
    let world = "[[event]]\nat = 0.6\nset = [777]\nparameters = { P12292 = 5 }\n";
    let body = "HSINT X(0, 20, 4)\nHSINT X(0, 30, 4)\nINH 516\nPRINT BIT(798)\nINH -516\nPRINT BIT(798); BIT(799)";
    let ran = Sim::program(body).world(world).run().clean();
    assert_eq!((ran.position(0), ran.record.output[1].text.as_str()), (30.0, "00"));
    // A move of 9 units and one of 21.
    assert!((ran.milliseconds() - 3200.0).abs() < 5.0, "{}", ran.milliseconds());
}

#[test]
fn a_move_that_was_not_redirected_leaves_nothing_behind() {
    let ran = Sim::program("HSINT X(0, 10, 4)\nINT 5 X30\nINH -516").world(&input(5, 2.0)).run().clean();
    // 1.1 s for the first move; the second one is at 18.5 at 2 s, and rests half a unit later.
    assert!((ran.position(0) - 19.0).abs() < 0.02, "{}", ran.position(0));
}

#[test]
fn captures_count_inside_their_window() {
    let world = "[[event]]\nat = 0.6\nset = [777]\nparameters = { P12292 = 5 }\n";
    let end = |window: &str| {
        let ran = Sim::program(&format!("HSINT X(0, 20, 4, {window})\nINH -516")).world(world).run().clean();
        ran.position(0)
    };
    assert_eq!([end("4, 2"), end("6"), end("1, 3"), end("0, 5")], [9.0, 20.0, 20.0, 9.0]);
}

#[test]
fn an_abort_flag_ends_a_move_that_waits_for_a_capture() {
    let ran = Sim::program("HSINT X(0, 20, 4, 0, 0, 0, 5)\nINH -516\nPRINT BIT(798); BIT(799)")
        .world(&input(5, 0.5))
        .run()
        .clean();
    assert!((ran.position(0) - 5.0).abs() < 0.02, "{}", ran.position(0));
    assert_eq!(ran.record.output[0].text, "0-1");
}

/// Programs 0 and 1 with a master and an axis each.
fn two_masters(first: &str, second: &str) -> Sim {
    let attach = "ATTACH MASTER1\nATTACH SLAVE0 AXIS2 \"A\"\nACC 100 DEC 100 STP 100 VEL 10\n";
    let text = format!("{TWO_AXES}PROGRAM\n{first}\nENDP\nPROG1\n{attach}PROGRAM\n{second}\nENDP\n");
    Sim::new(&text).start(&[0, 1])
}

#[test]
fn synchronised_masters_begin_their_moves_together() {
    let ran = two_masters("SYNC ON MASTER0 MASTER1\nX10\nX30\nINH -516\nPRINT 0", "DWL 1\nA20\nA30\nINH -548\nPRINT 1");
    let ran = ran.run().clean();
    assert_eq!([ran.position(0), ran.position(2)], [30.0, 30.0]);
    // The first pair begins at 1 s and the longer one takes 2.1 s, so does the longer one of the second pair.
    assert!((ran.milliseconds() - 5200.0).abs() < 5.0, "{}", ran.milliseconds());
    let early = two_masters("SYNC ON MASTER0 MASTER1\nX10", "DWL 1\nA20").until(0.9).run().clean();
    assert_eq!((early.position(0), early.bit(516)), (0.0, true));
}

#[test]
fn masters_join_and_leave_a_group() {
    let bare = two_masters("SYNC ON\nDWL 0.5\nX10\nINH -516", "SYNC ON\nDWL 1\nA20").run().clean();
    assert!((bare.milliseconds() - 3100.0).abs() < 8.0, "{}", bare.milliseconds());
    let left = two_masters("SYNC ON MASTER0 MASTER1\nX10\nDWL 0.5\nSYNC OFF MASTER1\nINH -516\nPRINT 0", "DWL 9").run();
    let left = left.clean();
    // Alone it waits for nobody.
    assert!((left.record.output[0].milliseconds - 1600.0).abs() < 10.0, "{:?}", left.record.output);
    assert_eq!(Sim::program("SYNC ON MASTER99").faults().len(), 1);
}
