//! Moves through a master: targets, blending, vectors, the queue.

use acrc_motion::{AXES, InvalidValue, Master, Move, MoveSettings, PushError, Quantity, SettingError, Target};

const TICK: f64 = 0.0005;

/// Settings with the same value for every ramp.
fn ramps(velocity: f64, ramp: f64) -> MoveSettings {
    MoveSettings { velocity, acceleration: ramp, deceleration: ramp, stop: ramp, ..MoveSettings::default() }
}

fn to(settings: MoveSettings, x: f64) -> Move {
    Move::new(settings).to(0, Target::Absolute(x))
}

/// Ticks until no move runs, and gives the time that took.
fn run(master: &mut Master) -> f64 {
    let mut ticks = 0_u32;
    while master.in_motion() {
        master.advance(TICK);
        ticks += 1;
        assert!(ticks < 1_000_000, "the master never comes to rest");
    }
    f64::from(ticks) * TICK
}

#[track_caller]
fn assert_near(actual: f64, expected: f64) {
    assert!((actual - expected).abs() <= 1e-9 * expected.abs().max(1.0), "{actual} is not {expected}");
}

#[test]
fn a_move_takes_its_time_to_the_tick() {
    let mut master = Master::new(1);
    master.push(&to(ramps(20.0, 10.0), 200.0)).unwrap();
    assert_eq!(run(&mut master), 12.0);
    assert_eq!(master.position(0), 200.0);
    assert_eq!(master.velocity(0), 0.0);
}

#[test]
fn all_axes_start_and_finish_together() {
    let mut master = Master::new(1);
    let diagonal = Move::new(ramps(75.0, 750.0)).to(0, Target::Absolute(25.0)).to(1, Target::Absolute(15.0));
    master.push(&diagonal).unwrap();
    let length = 850.0_f64.sqrt();
    assert_near(master.next_event().unwrap(), length / 75.0 + 0.1);
    master.advance(0.2);
    assert_near(master.vector_velocity(), 75.0);
    assert_near(master.velocity(0), 75.0 * 25.0 / length);
    assert_near(master.velocity(1), 75.0 * 15.0 / length);
    assert_near(master.position(0) / master.position(1), 25.0 / 15.0);
    run(&mut master);
    assert_eq!((master.position(0), master.position(1)), (25.0, 15.0));
}

#[test]
fn accelerations_have_the_sign_of_the_axis() {
    let mut master = Master::new(1);
    master.push(&to(ramps(20.0, 10.0), -200.0)).unwrap();
    master.advance(1.0);
    assert_eq!((master.velocity(0), master.acceleration(0)), (-10.0, -10.0));
    assert_eq!((master.vector_velocity(), master.vector_acceleration()), (10.0, 10.0));
}

#[test]
fn relative_targets_add_to_the_target_before() {
    let mut master = Master::new(4);
    let relative = |x: f64| Move::new(ramps(100.0, 1000.0)).to(0, Target::Relative(x));
    for command in [relative(-400.0), to(ramps(100.0, 1000.0), 200.0), relative(50.0), relative(150.0)] {
        master.push(&command).unwrap();
    }
    assert_eq!(master.target(0), 400.0);
    let mut corners = Vec::new();
    while master.in_motion() {
        if master.advance(TICK).completed > 0 {
            corners.push(master.position(0).round());
        }
    }
    assert_eq!(corners, [-400.0, 200.0, 250.0, 400.0]);
}

#[test]
fn mixed_targets_in_one_move() {
    let mut master = Master::new(1);
    for slot in 0..3 {
        master.set_position(slot, 10.0).unwrap();
    }
    let mixed = Move::new(ramps(100.0, 1000.0))
        .to(0, Target::Relative(2.0))
        .to(1, Target::Absolute(2.0))
        .to(2, Target::Relative(-2.0));
    master.push(&mixed).unwrap();
    run(&mut master);
    assert_eq!([0, 1, 2, 3].map(|slot| master.position(slot)), [12.0, 2.0, 8.0, 0.0]);
}

#[test]
fn a_move_without_a_stop_ramp_hands_its_velocity_over() {
    let mut master = Master::new(1);
    master.push(&to(MoveSettings { stop: 0.0, ..ramps(10.0, 10.0) }, 55.0)).unwrap();
    master.push(&to(ramps(20.0, 10.0), 155.0)).unwrap();
    // 1 s and 5 u up, 5 s and 50 u across; 1 s and 15 u up, 65 u across, 2 s and 20 u down.
    assert_near(run(&mut master), 6.0 + 1.0 + 3.25 + 2.0);
}

#[test]
fn a_slower_successor_slows_down_after_the_corner() {
    let mut master = Master::new(1);
    master.push(&to(MoveSettings { stop: 0.0, ..ramps(20.0, 20.0) }, 110.0)).unwrap();
    master.push(&to(MoveSettings { deceleration: 5.0, ..ramps(10.0, 10.0) }, 200.0)).unwrap();
    let mut ended = 0;
    while ended == 0 {
        ended = master.advance(TICK).completed;
    }
    assert_near(master.vector_velocity(), 20.0);
    master.advance(1.0);
    assert_near(master.vector_velocity(), 15.0);
    assert_near(master.vector_acceleration(), -5.0);
}

#[test]
fn a_corner_keeps_the_velocity_along_the_path() {
    let mut master = Master::new(1);
    let blend = MoveSettings { stop: 0.0, ..ramps(10.0, 0.0) };
    master.push(&Move::new(blend).to(0, Target::Absolute(10.0))).unwrap();
    master.push(&Move::new(blend).to(1, Target::Absolute(10.0))).unwrap();
    master.advance(0.9);
    assert_eq!((master.velocity(0), master.velocity(1)), (10.0, 0.0));
    master.advance(0.2);
    assert_eq!((master.velocity(0), master.velocity(1)), (0.0, 10.0));
    assert_eq!((master.position(0), master.vector_velocity()), (10.0, 10.0));
    assert_near(master.position(1), 1.0);
}

#[test]
fn many_short_moves_in_one_tick() {
    let mut master = Master::new(100);
    let blend = MoveSettings { stop: 0.0, ..ramps(1000.0, 0.0) };
    for step in 1..=100 {
        master.push(&to(blend, f64::from(step) * 0.1)).unwrap();
    }
    // 5 u in a tick of 5 ms, 0.1 u each.
    let advanced = master.advance(0.005);
    assert!((49..=50).contains(&advanced.completed), "{advanced:?}");
    assert_near(master.position(0), 5.0);
}

#[test]
fn the_velocity_drops_when_nothing_follows() {
    let mut master = Master::new(1);
    master.push(&to(MoveSettings { stop: 0.0, ..ramps(10.0, 0.0) }, 1.0)).unwrap();
    let advanced = master.advance(0.15);
    assert_eq!((advanced.started, advanced.completed, advanced.dropped_velocity), (1, 1, 0.0));
    assert_eq!((master.in_motion(), master.vector_velocity(), master.position(0)), (false, 0.0, 1.0));
    assert_eq!(master.advance(TICK).dropped_velocity, 10.0);
    assert_eq!(master.advance(TICK).dropped_velocity, 0.0);

    // Too late for the velocity: from rest.
    master.push(&to(ramps(10.0, 10.0), 100.0)).unwrap();
    assert_eq!(master.vector_velocity(), 0.0);
}

#[test]
fn a_successor_queued_in_the_tick_of_the_end_blends_as_if_it_had_been_waiting() {
    let blend = MoveSettings { stop: 0.0, ..ramps(10.0, 0.0) };
    let mut late = Master::new(1);
    late.push(&to(blend, 1.04)).unwrap();
    late.advance(0.11);
    assert!(!late.in_motion());
    late.push(&to(blend, 3.0)).unwrap();

    let mut early = Master::new(1);
    early.push(&to(blend, 1.04)).unwrap();
    early.push(&to(blend, 3.0)).unwrap();
    early.advance(0.11);
    assert_eq!(late.position(0), early.position(0));
    assert_eq!(late.advance(0.1).dropped_velocity, 0.0);
    early.advance(0.1);
    assert_eq!(late.position(0), early.position(0));
}

#[test]
fn the_initial_velocity_begins_a_move_from_rest() {
    let settings = MoveSettings { initial_velocity: 4.0, ..ramps(10.0, 10.0) };
    let mut master = Master::new(1);
    master.push(&to(settings, 100.0)).unwrap();
    assert_eq!(master.vector_velocity(), 4.0);

    let mut slow = Master::new(1);
    slow.push(&to(MoveSettings { velocity: 3.0, ..settings }, 100.0)).unwrap();
    assert_eq!(slow.vector_velocity(), 3.0);
}

#[test]
fn a_timed_move_takes_its_time() {
    let mut master = Master::new(1);
    master.push(&to(MoveSettings { time: 20.0, ..ramps(20.0, 10.0) }, 200.0)).unwrap();
    assert_eq!(run(&mut master), 20.0);
    master.push(&to(MoveSettings { time: 1.0, ..ramps(20.0, 10.0) }, 0.0)).unwrap();
    assert_eq!(run(&mut master), 12.0);
}

#[test]
fn an_axis_without_weight_rides_along() {
    let mut master = Master::new(1);
    master.set_weight(1, 0.0).unwrap();
    let both = Move::new(ramps(20.0, 10.0)).to(0, Target::Absolute(200.0)).to(1, Target::Absolute(3600.0));
    master.push(&both).unwrap();
    assert_eq!(run(&mut master), 12.0);
    assert_eq!(master.position(1), 3600.0);
}

#[test]
fn an_axis_without_weight_needs_a_vector_to_move_alone() {
    let mut master = Master::new(1);
    master.set_weight(1, 0.0).unwrap();
    let alone = Move::new(ramps(20.0, 10.0)).to(1, Target::Absolute(3600.0));
    assert_eq!(master.push(&alone), Err(PushError::NoVectorLength));
    assert_eq!(master.target(1), 0.0);
    master.set_vector(200.0).unwrap();
    master.push(&alone).unwrap();
    assert_eq!(run(&mut master), 12.0);
}

#[test]
fn a_weight_scales_an_axis() {
    let mut master = Master::new(1);
    master.set_weight(0, 2.0).unwrap();
    master.push(&to(ramps(20.0, 10.0), 100.0)).unwrap();
    assert_eq!(run(&mut master), 12.0);
}

#[test]
fn a_move_to_where_the_axis_is_takes_no_time() {
    let mut master = Master::new(1);
    master.push(&to(ramps(20.0, 10.0), 0.0)).unwrap();
    assert_eq!(master.next_event(), Some(0.0));
    let advanced = master.advance(TICK);
    assert_eq!((advanced.started, advanced.completed), (1, 1));
    assert!(!master.in_motion());
}

#[test]
fn the_queue_holds_its_capacity_besides_the_running_move() {
    let mut master = Master::new(2);
    for x in [1.0, 2.0, 3.0] {
        assert!(master.can_accept());
        master.push(&to(ramps(1.0, 1.0), x)).unwrap();
    }
    assert!(!master.can_accept());
    assert_eq!(master.push(&to(ramps(1.0, 1.0), 4.0)), Err(PushError::Full));
    assert_eq!((master.target(0), master.waiting()), (3.0, 2));
    assert!(!master.set_queue_capacity(1));
    assert!(master.set_queue_capacity(3));
    master.push(&to(ramps(1.0, 1.0), 4.0)).unwrap();
    run(&mut master);
    assert_eq!(master.position(0), 4.0);
}

#[test]
fn positions_are_set_at_rest_only() {
    let mut master = Master::new(1);
    master.set_position(0, 5.0).unwrap();
    assert_eq!((master.position(0), master.target(0)), (5.0, 5.0));
    assert_eq!(master.set_position(AXES, 5.0), Err(SettingError::NoSuchSlot(AXES)));
    master.push(&to(ramps(1.0, 1.0), 6.0)).unwrap();
    assert_eq!(master.set_position(0, 0.0), Err(SettingError::InMotion));
    assert_eq!((master.position(AXES), master.target(AXES), master.velocity(AXES)), (0.0, 0.0, 0.0));
}

#[test]
fn errors_name_the_value() {
    let mut master = Master::new(1);
    let error = master.push(&to(MoveSettings { jerk: -1.0, ..ramps(1.0, 1.0) }, 1.0)).unwrap_err();
    assert_eq!(error, PushError::Invalid(InvalidValue { quantity: Quantity::Jerk, value: -1.0 }));
    assert_eq!(error.to_string(), "jerk is negative (-1)");
    let error = master.push(&to(ramps(1.0, 1.0), f64::NAN)).unwrap_err();
    assert_eq!(error.to_string(), "target is not a number (NaN)");
    let error = master.set_feedrate_override(-0.5).unwrap_err();
    assert_eq!(error.to_string(), "feedrate override is negative (-0.5)");
    let error = master.set_weight(16, 1.0).unwrap_err();
    assert_eq!(error.to_string(), "slot 16 does not exist: a master has 16");
    assert!(!master.in_motion());
}
