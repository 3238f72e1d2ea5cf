//! Moves that are not straight, alone and together (guide, "Combining Types of Motion").

use std::f64::consts::PI;

use crate::support::Sim;

/// Where X and Y are after some seconds, to a millionth.
fn at(body: &str, seconds: f64) -> (f64, f64) {
    let ran = Sim::program(body).until(seconds).run().clean();
    (ran.position(0), ran.position(1))
}

/// A point on the circle about (5, 0) through the origin.
fn on_circle(radians: f64) -> (f64, f64) {
    let rounded = |value: f64| (value * 1e6).round() / 1e6 + 0.0;
    (rounded(5.0 + 5.0 * radians.cos()), rounded(5.0 * radians.sin()))
}

/// Milliseconds at which a program notices what happens after so many seconds: every other slice is that of communication.
fn seen(seconds: f64) -> f64 {
    (seconds * 500.0).ceil() * 2.0
}

#[test]
fn an_arc_without_a_way_is_a_full_circle() {
    let ran = Sim::program("CIRCCW X(0, 5) Y(0, 0)\nINH -516").run().clean();
    assert_eq!((ran.position(0), ran.position(1)), (0.0, 0.0));
    // The way around is 10 pi, at 10 units/s, and 0.1 s for the ramps.
    assert_eq!(ran.milliseconds(), seen(PI + 0.1));
    // 4.5 units are covered at 0.5 s: 0.9 of a radian from where the origin is seen.
    assert_eq!(at("CIRCCW X(0, 5) Y(0, 0)", 0.5), on_circle(PI + 0.9));
    assert_eq!(at("CIRCW X(0, 5) Y(0, 0)", 0.5), on_circle(PI - 0.9));
}

#[test]
fn the_first_axis_named_is_the_primary_one() {
    let (x, y) = on_circle(PI - 0.9);
    assert_eq!(at("CIRCCW Y(0, 0) X(0, 5)", 0.5), (x, y));
}

#[test]
fn an_arc_ends_at_its_target() {
    let ran = Sim::program("CIRCW X(5, 5) Y(5, 0)\nINH -516").run().clean();
    assert_eq!((ran.position(0), ran.position(1)), (5.0, 5.0));
    assert_eq!(ran.milliseconds(), seen(PI / 4.0 + 0.1));
}

#[test]
fn every_tick_of_an_arc_is_on_its_circle() {
    for part in 0..30 {
        let ran = Sim::program("CIRCCW X(0, 5) Y(0, 0)").until(f64::from(part) * 0.107).run().clean();
        let view = ran.controller.view();
        let radius = (view.position(0) - 5.0).hypot(view.position(1));
        assert!((radius - 5.0).abs() < 5e-9, "{radius}");
    }
}

#[test]
fn other_axes_of_an_arc_go_straight() {
    let body = "CIRCCW X(0, 5) Y(0, 0) Z3";
    let ran = Sim::in_space(&format!("{body}\nINH -516")).run().clean();
    assert_eq!((ran.position(0), ran.position(2)), (0.0, 3.0));
    // A helix: the length is that of its unrolled cylinder.
    let length = (10.0 * PI).hypot(3.0);
    assert_eq!(ran.milliseconds(), seen(length / 10.0 + 0.1));
    let early = Sim::in_space(body).until(0.5).run().clean();
    let part = 4.5 / length;
    assert_eq!(early.position(2), (3.0 * part * 1e6).round() / 1e6);
    assert_eq!((early.position(0), early.position(1)), on_circle(PI + 2.0 * PI * part));
}

#[test]
fn kinds_of_moves_share_a_statement() {
    let ran = Sim::in_space("Z2 CIRCCW X(0, 5) Y(0, 0) MOV Z2").run();
    assert_eq!(ran.record.faults[0].message, "MOV: the axis in SLAVE2 is given two targets");
    let body = "CIRCCW X(0, 5) Y(0, 0) SINE Z(0, 0, 180, 4)";
    let ran = Sim::in_space(&format!("{body}\nINH -516")).run().clean();
    assert_eq!([0, 1, 2].map(|axis| ran.position(axis)), [0.0, 0.0, 0.0]);
    let seconds = ran.milliseconds() / 2000.0;
    let half = Sim::in_space(body).until(seconds).run().clean();
    assert!((half.position(2) - 4.0).abs() < 1e-4 && (half.position(0) - 10.0).abs() < 1e-3);
}

#[test]
fn a_sinusoid_runs_with_the_straight_axes() {
    // At a quarter of the way of X the sinusoid has turned by a quarter of its sweep.
    let ran = Sim::program("X8 SINE Y(0, 0, 360, 2)").until(60.0).run().clean();
    assert_eq!((ran.position(0), ran.position(1)), (8.0, 0.0));
    for seconds in [0.1, 0.3, 0.6, 0.9] {
        let (x, y) = at("X8 SINE Y(0, 0, 360, 2)", seconds);
        assert!((y - 2.0 * (x / 8.0 * 2.0 * PI).sin()).abs() < 2e-6, "{x} {y}");
    }
}

#[test]
fn an_arc_in_space_passes_its_point_on_the_way() {
    // A half circle about (5, 0, 0), over (5, 0, 5).
    let body = "TARC X(10, 5) Y(0, 0) Z(0, 5)";
    let ran = Sim::in_space(&format!("{body}\nINH -516")).run().clean();
    assert_eq!([0, 1, 2].map(|axis| ran.position(axis)), [10.0, 0.0, 0.0]);
    assert_eq!(ran.milliseconds(), seen(PI / 2.0 + 0.1));
    let half = Sim::in_space(body).until(0.5).run().clean();
    let (x, z) = on_circle(PI - 0.9);
    assert_eq!([0, 1, 2].map(|axis| half.position(axis)), [x, 0.0, z]);
}

#[test]
fn tarc_on_makes_arcs_of_two_moves() {
    let ran =
        Sim::in_space("TARC ON X Y Z\nX5 Y0 Z5\nPRINT BIT(516)\nX10 Z0\nTARC OFF X Y Z\nX20\nINH -516").run().clean();
    assert_eq!(ran.record.output[0].text, "0", "the first point alone is no move");
    assert_eq!([0, 1, 2].map(|axis| ran.position(axis)), [20.0, 0.0, 0.0]);
    // An arc of half a circle, then ten units straight.
    let end = seen(PI / 2.0 + 0.1 + 1.1);
    assert!((ran.milliseconds() - end).abs() < 3.0, "{}", ran.milliseconds());
    let half = Sim::in_space("TARC ON X Y Z\nX5 Y0 Z5\nX10 Z0").until(0.8).run().clean();
    assert!((half.position(0) - 5.0).hypot(half.position(2)) - 5.0 < 1e-6 && half.position(2) > 4.0);
}

#[test]
fn relative_points_of_tarc_on_follow_each_other() {
    let ran = Sim::in_space("TARC ON X Y Z\nX/5 Z/5\nX/5 Z/-5\nINH -516").run().clean();
    assert_eq!([0, 1, 2].map(|axis| ran.position(axis)), [10.0, 0.0, 0.0]);
}

#[test]
fn an_arc_of_tarc_on_needs_its_second_point() {
    let faults = Sim::in_space("TARC ON X Y Z\nX5 Y0 Z5\nTARC OFF X Y Z").faults();
    assert_eq!(faults, ["TARC OFF: the arc has a point on its way but no end: a second move gives it"]);
}

#[test]
fn arcs_that_make_no_circle_are_refused() {
    for (body, fault) in [
        ("CIRCW X(5, 0) Y(0, 0)", "the points of the arc do not make a circle"),
        ("CIRCW X(5, 0)", "CIRCW expects two axes for an arc, each with its end and its centre"),
        ("CIRCW X(5, 0) X(5, 0)", "CIRCW: the axis in SLAVE0 is given two targets"),
        ("TARC X(5, 1) Y(5, 1) Z(5, 1)", "the points of the arc do not make a circle"),
    ] {
        assert_eq!(Sim::in_space(body).faults(), [fault], "{body}");
    }
}

#[test]
fn feedhold_stays_on_the_circle() {
    let body = "CIRCCW X(0, 5) Y(0, 0)\nDWL 0.5\nSET 520\nINH 519\nDWL 1\nSET 521\nINH -516";
    let held = Sim::program(body).until(1.0).run().clean();
    assert!(held.bit(519));
    let radius = (held.controller.view().position(0) - 5.0).hypot(held.controller.view().position(1));
    assert!((radius - 5.0).abs() < 1e-9);
    // 4.5 units at 0.5 s, then 0.5 units of ramp; the hold comes a slice later.
    assert!((held.position(1) - on_circle(PI + 1.0).1).abs() < 0.05);
    let ran = Sim::program(body).run().clean();
    assert_eq!((ran.position(0), ran.position(1)), (0.0, 0.0));
}
