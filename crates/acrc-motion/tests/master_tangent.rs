//! An axis that points along the path of two others.

use acrc_motion::{Arc, Master, Move, MoveSettings, SettingError, Tangent, Target, Turn};

const DEGREES: Tangent = Tangent { plane: [0, 1], axis: 2, turn: 360.0, offset: 0.0 };

fn settings() -> MoveSettings {
    MoveSettings { velocity: 1.0, ..MoveSettings::default() }
}

fn to(x: f64, y: f64) -> Move {
    Move::new(settings()).to(0, Target::Absolute(x)).to(1, Target::Absolute(y))
}

fn circle(turn: Turn) -> Move {
    Move::new(settings()).arc(Arc {
        slots: [0, 1],
        target: [0.0, 0.0],
        center: [0.0, 2.0],
        relative_target: false,
        relative_center: false,
        turn,
    })
}

fn master() -> Master {
    let mut master = Master::new(4);
    master.set_tangent(Some(DEGREES)).unwrap();
    master
}

#[track_caller]
fn assert_near(actual: f64, expected: f64) {
    assert!((actual - expected).abs() <= 1e-9 * expected.abs().max(1.0), "{actual} is not {expected}");
}

#[test]
fn straight_moves_point_along_themselves_the_short_way() {
    let mut master = master();
    for ([x, y], pointing) in
        [([1.0, 1.0], 45.0), ([1.0, 2.0], 90.0), ([0.0, 1.0], 225.0), ([0.0, 0.0], 270.0), ([1.0, 0.0], 360.0)]
    {
        master.push(&to(x, y)).unwrap();
        assert_near(master.target(2), pointing);
        master.advance(0.5);
        assert_near(master.position(2), pointing);
        assert_eq!((master.velocity(2), master.acceleration(2)), (0.0, 0.0));
        master.advance(10.0);
        assert_near(master.position(2), pointing);
    }
}

#[test]
fn the_axis_does_not_count_in_the_length() {
    let mut master = master();
    master.push(&to(0.0, 3.0)).unwrap();
    assert_eq!(master.next_event(), Some(3.0));
}

#[test]
fn on_a_circle_the_axis_turns_once() {
    for (turn, sign) in [(Turn::CounterClockwise, 1.0), (Turn::Clockwise, -1.0)] {
        let mut master = master();
        // Clockwise the circle begins toward negative X.
        let start = if sign > 0.0 { 0.0 } else { 180.0 };
        master.push(&circle(turn)).unwrap();
        let duration = master.next_event().unwrap();
        for step in 1..8 {
            master.advance(duration / 8.0);
            assert_near(master.position(2), start + sign * 45.0 * f64::from(step));
            assert_near(master.velocity(2), sign * 360.0 / duration);
            assert!(master.acceleration(2).abs() < 1e-3);
        }
        master.advance(duration);
        assert_near(master.position(2), start + sign * 360.0);
    }
}

#[test]
fn a_target_of_its_own_comes_first() {
    let mut master = master();
    master.push(&to(1.0, 0.0).to(2, Target::Absolute(77.0))).unwrap();
    assert_eq!(master.target(2), 77.0);
    master.push(&Move::new(settings()).to(3, Target::Absolute(1.0))).unwrap();
    assert_eq!(master.target(2), 77.0);
    master.set_tangent(None).unwrap();
    master.push(&to(5.0, 5.0)).unwrap();
    assert_eq!((master.target(2), master.tangent()), (77.0, None));
}

#[test]
fn an_offset_and_the_other_way_round() {
    let mut master = Master::new(1);
    master.set_tangent(Some(Tangent { turn: -4.0, offset: 0.5, ..DEGREES })).unwrap();
    master.push(&to(0.0, 1.0)).unwrap();
    assert_near(master.target(2), -0.5);
}

#[test]
fn axes_are_three_different_ones() {
    let mut master = Master::new(1);
    assert_eq!(master.set_tangent(Some(Tangent { axis: 1, ..DEGREES })), Err(SettingError::SameSlot(1)));
    assert_eq!(master.set_tangent(Some(Tangent { plane: [3, 3], ..DEGREES })), Err(SettingError::SameSlot(3)));
    assert_eq!(master.set_tangent(Some(Tangent { axis: 16, ..DEGREES })), Err(SettingError::NoSuchSlot(16)));
    assert_eq!(master.set_tangent(Some(Tangent { turn: 0.0, ..DEGREES })), Err(SettingError::ZeroTurn));
}
