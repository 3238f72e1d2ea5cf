//! Inverse kinematics through a program (guide, "Inverse Kinematics").

use crate::support::{Sim, TWO_AXES};

/// Program 7 puts X and Y on a circle of 5 units, by the angle that the program gives as X.
fn on_a_circle(body: &str) -> Sim {
    with_equations("P12361 = 5 * SIN(P12360)\nP12617 = 5 * COS(P12360)", body)
}

fn with_equations(equations: &str, body: &str) -> Sim {
    Sim::new(&format!("PROG7\nPROGRAM\n{equations}\nENDP\n{TWO_AXES}INVK PROG7\nPROGRAM\n{body}\nENDP\n")).start(&[0])
}

#[test]
fn the_targets_of_moves_go_through_a_program() {
    let ran = on_a_circle("INVK ON\nX1\nINH -516\nPRINT P12360; P12361").run().clean();
    let near = |value: f64, expected: f64| assert!((value - expected).abs() < 1e-6, "{value} {expected}");
    near(ran.position(0), 5.0 * 1.0_f64.sin());
    near(ran.position(1), 5.0 * 1.0_f64.cos());
    assert_eq!(ran.record.output[0].text, "14.207355");
}

#[test]
fn a_line_in_cartesian_space_becomes_another_path() {
    // The listing of the guide: steps of 0.2 along X go around a circle.
    let body =
        "INVK ON\nSTP 0\nP0 = 0\n_start\nX/0.2\nP0 = P0 + 1\nIF (P0 < 32) THEN GOTO start\nSTP 100\nX/0.2\nINH -516";
    let ran = on_a_circle(body).run().clean();
    let angle = 0.2 * 33.0_f64;
    assert!((ran.position(0) - 5.0 * angle.sin()).abs() < 1e-6 && (ran.position(1) - 5.0 * angle.cos()).abs() < 1e-6);
    assert_eq!(ran.controller.masters()[0].statistics.moves, 33);
    // On the way the axes are on chords of the circle, which are 0.2 radians wide.
    let half = on_a_circle(body).until(2.0).run().clean();
    let radius = half.position(0).hypot(half.position(1));
    assert!((5.0 * 0.1_f64.cos() - 1e-6..=5.0 + 1e-6).contains(&radius), "{radius}");
}

#[test]
fn an_axis_without_an_equation_goes_where_the_move_says() {
    let ran = with_equations("P12361 = P12360 + P12616", "INVK ON\nX1 Y2\nINH -516").run().clean();
    assert_eq!((ran.position(0), ran.position(1)), (3.0, 2.0));
}

#[test]
fn the_equations_are_switched_off_and_reported() {
    let ran = with_equations("P12361 = 7", "INVK\nINVK ON\nINVK\nINVK OFF\nX1\nINH -516\nINVK").run().clean();
    let output: Vec<_> = ran.record.output.iter().map(|line| line.text.as_str()).collect();
    assert_eq!(output, ["INVK PROG7", "INVK OFF", "INVK PROG7", "INVK ON", "INVK PROG7", "INVK OFF"]);
    assert_eq!(ran.position(0), 1.0);
}

#[test]
fn skipping_does_not_change_when_targets_are_known() {
    let sim = on_a_circle("INVK ON\nX1\nINH -516\nPRINT 1\nX2\nINH -516\nPRINT 2");
    assert_eq!(
        sim.timed(),
        on_a_circle("INVK ON\nX1\nINH -516\nPRINT 1\nX2\nINH -516\nPRINT 2").watched(false).timed()
    );
}

#[test]
fn a_kill_forgets_a_move_whose_targets_are_computed() {
    let body = "INVK ON\nX1\nDWL 3\nINVK OFF\nCLR 522\nX4\nINH -516";
    let text = format!(
        "PROG7\nPROGRAM\nDWL 1\nP12361 = 9\nENDP\n{TWO_AXES}INVK PROG7\nPROGRAM\n{body}\nENDP\nPROG1\nPROGRAM\nDWL 0.5\nHALT PROG0\nENDP\n"
    );
    let ran = Sim::new(&text).start(&[0, 1]).run().clean();
    assert_eq!(ran.position(0), 0.0);
}

#[test]
fn what_cannot_be_transformed_is_refused() {
    for (body, fault) in [
        ("INVK ON\nCIRCW X(0, 5) Y(0, 0)", "CIRCW: INVK is on, which transforms the targets of straight moves only"),
        (
            "INVK ON\nX1 SINE Y(0, 0, 90, 1)",
            "axis move: INVK is on, which transforms the targets of straight moves only",
        ),
        ("INVK ON\nINT 5 X1", "INT: INVK is on, which transforms the targets of straight moves only"),
        ("INVK PROG3\nINVK ON\nX1", "axis move: PROG3 of INVK has no program"),
        ("INVK PROG0\nINVK ON\nX1", "axis move: PROG0 of INVK cannot move axes while it transforms their targets"),
        ("INVK PROG16", "PROG16 does not exist: this controller has PROG0 to PROG15"),
    ] {
        assert_eq!(on_a_circle(body).faults(), [fault], "{body}");
    }
    let fault = "INVK ON: INVK PROG comes first: it says which program has the equations";
    assert_eq!(Sim::program("INVK ON").faults(), [fault]);
    let faults = with_equations("P12361 = 1 / 0", "INVK ON\nX1").faults();
    assert_eq!(faults.len(), 2);
    assert_eq!(faults[1], "axis move: PROG7 of INVK has stopped with a run-time error");
}
