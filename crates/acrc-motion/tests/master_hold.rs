//! Feedrate override, feedhold, stop and kill.

use acrc_motion::{HoldState, Master, Move, MoveSettings, Phase, PushError, Target};

const TICK: f64 = 0.0005;

fn settings() -> MoveSettings {
    MoveSettings { velocity: 20.0, acceleration: 10.0, deceleration: 40.0, stop: 10.0, ..MoveSettings::default() }
}

fn to(settings: MoveSettings, x: f64) -> Move {
    Move::new(settings).to(0, Target::Absolute(x))
}

/// A master on its way to 200 u, at 20 u/s and 40 u.
fn cruising() -> Master {
    let mut master = Master::new(2);
    master.push(&to(settings(), 200.0)).unwrap();
    master.advance(3.0);
    assert_eq!((master.position(0), master.vector_velocity()), (40.0, 20.0));
    master
}

#[track_caller]
fn assert_near(actual: f64, expected: f64) {
    assert!((actual - expected).abs() <= 1e-9 * expected.abs().max(1.0), "{actual} is not {expected}");
}

#[test]
fn the_override_changes_the_running_move_over_its_ramps() {
    let mut master = cruising();
    master.set_feedrate_override(0.5).unwrap();
    assert_eq!(master.vector_velocity(), 20.0);
    master.advance(0.125);
    assert_eq!((master.vector_velocity(), master.vector_acceleration()), (15.0, -40.0));
    master.advance(0.125);
    assert_eq!(master.vector_velocity(), 10.0);
    master.set_feedrate_override(1.0).unwrap();
    master.advance(0.5);
    assert_eq!((master.vector_velocity(), master.vector_acceleration()), (15.0, 10.0));
    master.advance(0.5);
    assert_eq!(master.vector_velocity(), 20.0);
    while master.in_motion() {
        master.advance(TICK);
    }
    assert_eq!(master.position(0), 200.0);
}

#[test]
fn the_override_holds_for_later_moves() {
    let mut master = Master::new(1);
    master.set_feedrate_override(0.5).unwrap();
    master.push(&to(settings(), 200.0)).unwrap();
    // 1 s and 5 u up, 190 u at 10 u/s, 1 s and 5 u down.
    assert_eq!(master.next_event(), Some(21.0));
}

#[test]
fn an_override_of_zero_stands_until_it_rises() {
    let mut master = cruising();
    master.set_feedrate_override(0.0).unwrap();
    assert_eq!(master.next_event(), Some(0.5));
    master.advance(10.0);
    assert_eq!((master.position(0), master.vector_velocity()), (45.0, 0.0));
    assert_eq!((master.in_motion(), master.next_event()), (true, None));
    master.set_feedrate_override(1.0).unwrap();
    // 2 s and 20 u up, 115 u across, 2 s and 20 u down.
    assert_near(master.next_event().unwrap(), 9.75);
}

#[test]
fn a_move_without_velocity_stands_at_its_start() {
    let mut master = Master::new(1);
    master.push(&to(MoveSettings { velocity: 0.0, ..settings() }, 10.0)).unwrap();
    master.advance(100.0);
    assert_eq!((master.in_motion(), master.position(0), master.next_event()), (true, 0.0, None));
}

#[test]
fn feedhold_and_cycle_start() {
    let mut master = cruising();
    master.feedhold();
    assert_eq!(master.hold_state(), HoldState::Feedholding);
    master.advance(0.25);
    assert_eq!((master.vector_velocity(), master.vector_acceleration()), (10.0, -40.0));
    master.advance(0.25);
    assert_eq!(master.hold_state(), HoldState::InFeedhold);
    assert_eq!((master.position(0), master.vector_velocity()), (45.0, 0.0));
    assert!(master.in_motion());
    master.advance(100.0);
    assert_eq!(master.position(0), 45.0);

    master.cycle_start();
    assert_eq!(master.hold_state(), HoldState::Released);
    master.advance(1.0);
    assert_eq!((master.vector_velocity(), master.vector_acceleration()), (10.0, 10.0));
    master.advance(10.0);
    assert_eq!((master.position(0), master.in_motion()), (200.0, false));
}

#[test]
fn a_hold_at_rest_keeps_moves_waiting() {
    let mut master = Master::new(1);
    master.feedhold();
    assert_eq!(master.hold_state(), HoldState::InFeedhold);
    master.push(&to(settings(), 10.0)).unwrap();
    assert!(!master.can_accept());
    assert_eq!(master.advance(1.0).started, 0);
    assert_eq!((master.in_motion(), master.position(0)), (true, 0.0));
    master.cycle_start();
    assert_eq!(master.advance(0.1).started, 1);
    assert_near(master.vector_velocity(), 1.0);
}

#[test]
fn a_hold_goes_on_into_the_next_move() {
    let mut master = Master::new(1);
    master.push(&to(MoveSettings { stop: 0.0, ..settings() }, 40.0)).unwrap();
    master.push(&to(settings(), 100.0)).unwrap();
    master.advance(2.95);
    assert_near(master.position(0), 39.0);
    master.feedhold();
    master.advance(1.0);
    assert_near(master.position(0), 44.0); // 20² / (2·40) further
    assert_eq!(master.hold_state(), HoldState::InFeedhold);
}

#[test]
fn a_hold_in_the_stop_ramp_ends_at_the_target_and_no_further() {
    let mut master = Master::new(1);
    let weak = MoveSettings { deceleration: 0.5, ..settings() };
    master.push(&to(weak, 200.0)).unwrap();
    master.push(&to(weak, 400.0)).unwrap();
    master.advance(11.0);
    master.feedhold();
    master.advance(5.0);
    assert_eq!((master.position(0), master.hold_state()), (200.0, HoldState::InFeedhold));
    assert_eq!(master.waiting(), 1);
    master.cycle_start();
    master.advance(12.0);
    assert_eq!(master.position(0), 400.0);
}

#[test]
fn stop_ramps_down_and_drops_everything() {
    let mut master = cruising();
    master.push(&to(settings(), 300.0)).unwrap();
    master.stop();
    assert_eq!(master.push(&to(settings(), 400.0)), Err(PushError::Stopping));
    assert!(!master.can_accept());
    assert!(!master.advance(0.25).stopped);
    assert!(master.advance(0.25).stopped);
    assert_eq!((master.position(0), master.target(0)), (45.0, 45.0));
    assert_eq!((master.in_motion(), master.can_accept()), (false, true));
}

#[test]
fn stop_at_rest_is_over_in_the_next_tick() {
    let mut master = Master::new(1);
    master.stop();
    assert!(master.advance(TICK).stopped);
    assert!(!master.advance(TICK).stopped);
}

#[test]
fn kill_stops_without_a_ramp() {
    let mut master = cruising();
    master.push(&to(settings(), 300.0)).unwrap();
    master.kill();
    assert_eq!((master.position(0), master.target(0), master.velocity(0)), (40.0, 40.0, 0.0));
    assert_eq!((master.in_motion(), master.waiting()), (false, 0));
    master.push(&Move::new(settings()).to(0, Target::Relative(200.0))).unwrap();
    assert_eq!((master.target(0), master.next_event()), (240.0, Some(12.0)));
}

#[test]
fn a_change_while_an_s_curve_cruises_keeps_the_curve() {
    let mut master = Master::new(1);
    master.push(&to(MoveSettings { jerk: 100.0, ..settings() }, 200.0)).unwrap();
    master.advance(4.0);
    master.set_feedrate_override(0.5).unwrap();
    assert_eq!(master.vector_acceleration(), 0.0);
    master.advance(0.05);
    assert_near(master.vector_acceleration(), -5.0);
}

#[test]
fn a_change_in_the_last_ramp_of_an_s_curve_leaves_it_alone() {
    let mut master = Master::new(1);
    master.push(&to(MoveSettings { jerk: 10.0, ..settings() }, 200.0)).unwrap();
    let end = master.next_event().unwrap();
    master.advance(end - 1.5);
    let mut untouched = master.clone();
    master.set_feedrate_override(1.5).unwrap();
    for _ in 0..10 {
        master.advance(0.1);
        untouched.advance(0.1);
        assert_eq!(master.path_state(), untouched.path_state());
    }
}

#[test]
fn the_phase_tells_what_the_velocity_does() {
    let mut master = Master::new(1);
    assert_eq!(master.phase(), Phase::Steady);
    master.push(&to(settings(), 200.0)).unwrap();
    master.advance(1.0);
    assert_eq!(master.phase(), Phase::Accelerating);
    master.advance(2.0);
    assert_eq!(master.phase(), Phase::Steady);
    master.set_feedrate_override(0.5).unwrap();
    master.advance(0.125);
    assert_eq!(master.phase(), Phase::Decelerating);
    let end = master.next_event().unwrap();
    master.advance(end - 0.5);
    assert_eq!(master.phase(), Phase::Stopping);
}
