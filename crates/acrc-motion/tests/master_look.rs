//! Looking ahead over moves and over the pieces of a curve.

use acrc_motion::{ControlPoint, CurveBuilder, Lookahead, Master, Move, MoveSettings, Target};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

const TICK: f64 = 0.0005;

/// No stop ramp: moves merge.
fn merging(velocity: f64, ramp: f64) -> MoveSettings {
    MoveSettings { velocity, acceleration: ramp, deceleration: ramp, ..MoveSettings::default() }
}

fn to(settings: MoveSettings, [x, y]: [f64; 2]) -> Move {
    Move::new(settings).to(0, Target::Absolute(x)).to(1, Target::Absolute(y))
}

fn looking(full: f64, stop: f64) -> Master {
    let mut master = Master::new(64);
    master.set_lookahead(Some(Lookahead { full, stop })).unwrap();
    master
}

/// Ticks to the end. The velocity along the path in each tick in which a move ended, and the time it took.
fn run(master: &mut Master) -> (Vec<f64>, f64) {
    let mut corners = Vec::new();
    let mut ticks = 0_u32;
    while master.in_motion() {
        let advanced = master.advance(TICK);
        assert!(advanced.dropped_velocity < 1e-9);
        if advanced.completed > 0 {
            corners.push(master.vector_velocity());
        }
        ticks += 1;
        assert!(ticks < 1_000_000);
    }
    assert_eq!(master.advance(TICK).dropped_velocity, 0.0);
    (corners, f64::from(ticks) * TICK)
}

#[track_caller]
fn assert_near(actual: f64, expected: f64, tolerance: f64) {
    assert!((actual - expected).abs() <= tolerance, "{actual} is not {expected}");
}

#[test]
fn moves_straight_on_are_like_one() {
    for jerk in [0.0, 200.0] {
        let mut master = looking(10.0, 90.0);
        let settings = MoveSettings { jerk, ..merging(20.0, 10.0) };
        for step in 1..=40_u8 {
            master.push(&to(settings, [f64::from(step) * 5.0, 0.0])).unwrap();
        }
        let (_, time) = run(&mut master);
        // Twelve seconds for 200 u as for one move, a little more where S-curves begin anew with each move.
        assert!((12.0..12.0 + if jerk > 0.0 { 2.0 } else { 2.0 * TICK }).contains(&time), "{time}");
        assert_eq!(master.position(0), 200.0);
    }
}

#[test]
fn a_sharp_corner_is_a_stop() {
    let mut master = looking(10.0, 90.0);
    master.push(&to(merging(20.0, 10.0), [200.0, 0.0])).unwrap();
    master.push(&to(merging(20.0, 10.0), [200.0, 200.0])).unwrap();
    let (corners, time) = run(&mut master);
    assert_near(corners[0], 0.0, 10.0 * TICK);
    assert_near(time, 24.0, 2.0 * TICK);
}

#[test]
fn a_corner_between_the_angles_slows_down() {
    let mut master = looking(0.0, 180.0);
    master.push(&to(merging(20.0, 10.0), [200.0, 0.0])).unwrap();
    master.push(&to(merging(20.0, 10.0), [200.0, 200.0])).unwrap();
    let (corners, _) = run(&mut master);
    assert_near(corners[0], 10.0, 10.0 * TICK);
}

#[test]
fn the_next_velocity_is_reached_before_the_corner() {
    let mut master = looking(10.0, 90.0);
    master.push(&to(merging(20.0, 10.0), [200.0, 0.0])).unwrap();
    master.push(&to(merging(5.0, 10.0), [300.0, 0.0])).unwrap();
    let (corners, _) = run(&mut master);
    assert_near(corners[0], 5.0, 1e-6);
}

#[test]
fn what_comes_behind_the_next_corner_counts() {
    let mut master = looking(10.0, 90.0);
    master.push(&to(merging(20.0, 10.0), [200.0, 0.0])).unwrap();
    master.push(&to(merging(20.0, 10.0), [201.25, 0.0])).unwrap();
    master.push(&to(merging(20.0, 10.0), [201.25, 50.0])).unwrap();
    let (corners, _) = run(&mut master);
    // From 5 u/s it comes to rest on 1.25 u.
    assert_near(corners[0], 5.0, 10.0 * TICK);
    assert_near(corners[1], 0.0, 10.0 * TICK);
}

#[test]
fn a_move_queued_in_time_is_merged() {
    let mut master = looking(10.0, 90.0);
    master.push(&to(merging(20.0, 10.0), [200.0, 0.0])).unwrap();
    master.advance(11.0);
    assert_near(master.vector_velocity(), 10.0, 1e-6);
    master.push(&to(merging(20.0, 10.0), [400.0, 0.0])).unwrap();
    master.advance(1.0);
    assert!(master.vector_velocity() > 15.0);
    run(&mut master);
}

#[test]
fn a_stop_ramp_keeps_its_meaning() {
    let mut master = looking(10.0, 90.0);
    let stopping = MoveSettings { stop: 10.0, final_velocity: 4.0, ..merging(20.0, 10.0) };
    master.push(&to(stopping, [200.0, 0.0])).unwrap();
    master.push(&to(merging(20.0, 10.0), [400.0, 0.0])).unwrap();
    let (corners, _) = run(&mut master);
    assert_near(corners[0], 4.0, 10.0 * TICK);
}

#[test]
fn the_override_counts() {
    let mut master = looking(10.0, 90.0);
    master.push(&to(merging(20.0, 10.0), [200.0, 0.0])).unwrap();
    master.push(&to(merging(5.0, 10.0), [300.0, 0.0])).unwrap();
    master.set_feedrate_override(2.0).unwrap();
    let (corners, _) = run(&mut master);
    assert_near(corners[0], 10.0, 1e-6);
}

#[test]
fn without_lookahead_nothing_changes() {
    let mut master = looking(10.0, 90.0);
    master.push(&to(merging(20.0, 10.0), [200.0, 0.0])).unwrap();
    master.set_lookahead(None).unwrap();
    assert_near(master.next_event().unwrap(), 2.0 + 9.0, 1e-9);
    assert_eq!(master.lookahead(), None);
    let error = master.set_lookahead(Some(Lookahead { full: -1.0, stop: 90.0 })).unwrap_err();
    assert_eq!(error.to_string(), "corner angle is negative (-1)");
}

#[test]
fn a_curve_comes_to_rest_at_its_end() {
    let mut curve = CurveBuilder::spline();
    let mut master = Master::new(64);
    let settings = MoveSettings { stop: 5.0, ..merging(10.0, 5.0) };
    let mut pieces = Vec::new();
    for (index, height) in (0_u8..).zip([0.0, 1.0, 0.5, -1.0, 0.0, 2.0, 1.0, 0.0]) {
        let point = ControlPoint::new().at(0, f64::from(index)).at(1, height);
        pieces.extend(curve.push(None, Some(&point)).unwrap());
    }
    pieces.extend(std::iter::from_fn(|| curve.finish()));
    for piece in &pieces {
        master.push_span(&Move::new(settings), piece).unwrap();
    }
    let mut fastest: f64 = 0.0;
    while master.in_motion() {
        let advanced = master.advance(TICK);
        fastest = fastest.max(master.vector_velocity());
        assert!(master.vector_acceleration() >= -5.0 * (1.0 + 1e-9));
        assert_eq!(advanced.dropped_velocity, 0.0);
    }
    assert_eq!(master.advance(TICK).dropped_velocity, 0.0);
    assert!(fastest > 5.0, "{fastest}");
    assert_eq!([master.position(0), master.position(1)], [7.0, 0.0]);
}

prop_compose! {
    fn legs()(corners in prop::collection::vec(([-10.0..10.0_f64, -10.0..10.0_f64], 1.0..30.0_f64), 2..20)) -> Vec<([f64; 2], f64)> {
        corners
    }
}

fn direction(from: [f64; 2], to: [f64; 2]) -> f64 {
    (to[1] - from[1]).atan2(to[0] - from[0]).to_degrees()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn corners_are_met_with_the_ramps(
        legs in legs(), ramps in [1.0..200.0_f64, 1.0..200.0_f64], jerk in prop_oneof![Just(0.0), 10.0..5000.0_f64],
        full in 0.0..60.0_f64, more in 1.0..120.0_f64, depth in 1..20_usize, seconds in 0.001..1.0_f64,
    ) {
        let [acceleration, deceleration] = ramps;
        let stop = full + more;
        let mut master = Master::new(depth);
        master.set_lookahead(Some(Lookahead { full, stop })).unwrap();
        let mut waiting = legs.iter();
        let mut next = waiting.next();
        let mut ended = 0;
        let mut time = 0.0;
        let mut due = 0.0;
        loop {
            // As a program does: a move when there is room, and not before some time has passed.
            if let Some((end, velocity)) = next && master.can_accept() && time >= due {
                let settings = MoveSettings { jerk, velocity: *velocity, acceleration, deceleration, ..MoveSettings::default() };
                master.push(&to(settings, *end)).unwrap();
                next = waiting.next();
                due = time + seconds * 0.01;
            }
            if !master.in_motion() && next.is_none() {
                break;
            }
            let event = master.next_event().unwrap_or(TICK).clamp(1e-6, TICK);
            let advanced = master.advance(event);
            time += event;
            prop_assert!(advanced.dropped_velocity <= 1e-6, "{advanced:?}");
            prop_assert!(master.vector_acceleration() >= -deceleration * (1.0 + 1e-9));
            prop_assert!(master.vector_acceleration() <= acceleration * (1.0 + 1e-9));
            for _ in 0..advanced.completed {
                let start = if ended == 0 { [0.0, 0.0] } else { legs[ended - 1].0 };
                if let Some((after, velocity)) = legs.get(ended + 1) {
                    let (corner, before) = legs[ended];
                    let turn = (direction(corner, *after) - direction(start, corner)).rem_euclid(360.0);
                    let turn = turn.min(360.0 - turn);
                    let share = ((stop - turn) / (stop - full)).clamp(0.0, 1.0);
                    let most = share * velocity.min(before);
                    let slack = event * acceleration + 1e-6;
                    prop_assert!(master.vector_velocity() <= most + slack, "{} at a corner of {turn}, {most}", master.vector_velocity());
                }
                ended += 1;
            }
            prop_assert!(time < 10_000.0);
        }
        prop_assert_eq!([master.position(0), master.position(1)], legs[legs.len() - 1].0);
    }
}
