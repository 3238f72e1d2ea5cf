//! Curves from points: `SPLINE`, `NURB`, `K`.

use std::f64::consts::PI;

use crate::support::{Ran, Sim, TWO_AXES};

/// A quarter of a circle of 10 units about the origin, from (10, 0) to (0, 10).
const QUARTER: &str =
    "X10 Y0\nNURB MODE 3\nNURB RANK 3\nK 0 X10 Y0 W1\nK 0 X10 Y10 W(SQRT(0.5))\nK 0 X0 Y10 W1\nK 1\nK 1\nK 1\nNURB END";

fn ended(body: &str) -> Ran {
    Sim::program(&format!("{body}\nINH -516")).run().clean()
}

/// Where X and Y are, to a millionth.
fn at(body: &str, seconds: f64) -> (f64, f64) {
    let ran = Sim::program(body).until(seconds).run().clean();
    (ran.position(0), ran.position(1))
}

#[test]
fn a_spline_through_points_on_a_line_is_the_line() {
    let ran = ended("SPLINE MODE 0\nX10\nX20\nX30\nSPLINE END");
    assert_eq!(ran.position(0), 30.0);
    // One path of 30 units, without a stop on the way.
    assert!((ran.milliseconds() - 3100.0).abs() < 8.0, "{}", ran.milliseconds());
    assert_eq!(ran.notes(), [""; 0]);
}

#[test]
fn a_spline_passes_its_points() {
    let body = "SPLINE MODE 1\nK 0 X0 Y0\nK 1 X5 Y5\nK 2 X10 Y0\nSPLINE END";
    let ran = ended(body);
    assert_eq!((ran.position(0), ran.position(1)), (10.0, 0.0));
    // Both halves are alike, so half of the time is half of the way.
    let (x, y) = at(body, ran.milliseconds() / 2000.0);
    assert!((x - 5.0).abs() < 0.02 && (y - 5.0).abs() < 0.001, "{x} {y}");
    assert!(at(body, ran.milliseconds() / 4000.0).0 < 2.6);
}

#[test]
fn a_nurbs_curve_with_weights_is_a_circle() {
    let ran = ended(QUARTER);
    assert_eq!((ran.position(0), ran.position(1)), (0.0, 10.0));
    // The way to the start takes 1.1 s, the quarter is 5 pi long.
    assert!((ran.milliseconds() - (1100.0 + (PI / 2.0 + 0.1) * 1000.0)).abs() < 8.0, "{}", ran.milliseconds());
    for seconds in [1.2, 1.5, 1.9, 2.3] {
        let (x, y) = at(QUARTER, seconds);
        assert!((x.hypot(y) - 10.0).abs() < 2e-6, "{x} {y}");
    }
}

#[test]
fn a_knot_of_minus_one_ends_a_curve() {
    let body = QUARTER.replace("NURB END", "K -1");
    assert_eq!((ended(&body).position(0), ended(&body).position(1)), (0.0, 10.0));
    assert_eq!(ended(&format!("{body}\nNURB END")).position(1), 10.0, "and an END behind it has nothing to end");
}

#[test]
fn points_may_be_relative() {
    let ran = ended("SPLINE MODE 0\nX/10\nX/10 Y/5\nSPLINE END");
    assert_eq!((ran.position(0), ran.position(1)), (20.0, 5.0));
}

#[test]
fn a_curve_is_queued_while_it_is_given() {
    // One piece runs, one waits: the program is held up until the first has ended.
    let timed = Sim::program("SPLINE MODE 0\nX10\nX20\nX30\nX40\nPRINT 1\nSPLINE END\nPRINT 2").timed();
    let times: Vec<f64> = timed.iter().filter_map(|line| line.split(' ').next()?.parse().ok()).collect();
    assert!(times[0] < 10.0 && times[1] > 1000.0, "{timed:?}");
}

#[test]
fn a_curve_that_begins_elsewhere_jumps_and_the_run_says_so() {
    let ran = ended("NURB MODE 0\nX5 Y0\nX6 Y5\nX7 Y5\nX10 Y0\nNURB END");
    assert_eq!(ran.notes(), ["master 0: a curve does not begin where the axes are, so they jump to its first point"]);
}

#[test]
fn kill_all_moves_forgets_an_open_curve() {
    let ran = Sim::program("SPLINE MODE 0\nX10\nX20\nX30\nSET 522\nCLR 522\nX5\nINH -516").run().clean();
    assert_eq!(ran.position(0), 5.0);
}

#[test]
fn another_run_of_the_program_begins_without_the_curve_of_the_one_before() {
    let text = format!("{TWO_AXES}PROGRAM\nSPLINE MODE 0\nX1\nENDP\nPROG1\nPROGRAM\nDWL 1\nRUN PROG0\nENDP\n");
    assert_eq!(Sim::new(&text).start(&[0, 1]).faults(), [""; 0]);
}

#[test]
fn what_does_not_fit_a_curve_is_refused() {
    for (body, fault) in [
        ("K 0 X5", "K: no curve is open: SPLINE MODE or NURB MODE comes first"),
        ("SPLINE MODE 0\nSPLINE MODE 0", "SPLINE MODE: a curve is open: its END comes first"),
        ("SPLINE MODE 0\nCIRCW X(0, 5) Y(0, 0)", "CIRCW: a curve is open: its END comes first"),
        ("SPLINE MODE 0\nINT 5 X5", "INT: a curve is open: its END comes first"),
        ("NURB RANK 7", "rank 7 of a curve is not 2 to 5"),
        ("NURB MODE 0\nX0\nNURB RANK 3", "NURB RANK: the curve has points already: the rank comes before them"),
        ("SPLINE MODE 1\nK 1 X0\nK 0 X5", "knot 0 does not lie above the knot before, 1"),
        ("NURB MODE 2\nK 0 X0 W0", "weight of a control point is zero (0)"),
    ] {
        assert_eq!(Sim::program(body).faults(), [fault], "{body}");
    }
}
