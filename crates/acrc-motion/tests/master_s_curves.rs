//! Changes in the midst of S-curves, and the overrides of feeding and rapid moves.

use acrc_motion::{Master, Move, MoveSettings, Override, Target};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

fn settings() -> MoveSettings {
    MoveSettings {
        velocity: 20.0,
        acceleration: 10.0,
        deceleration: 40.0,
        stop: 10.0,
        jerk: 10.0,
        ..MoveSettings::default()
    }
}

fn to(settings: MoveSettings, x: f64) -> Move {
    Move::new(settings).to(0, Target::Absolute(x))
}

fn started(settings: MoveSettings, x: f64) -> Master {
    let mut master = Master::new(2);
    master.push(&to(settings, x)).unwrap();
    master
}

#[track_caller]
fn assert_near(actual: f64, expected: f64) {
    assert!((actual - expected).abs() <= 1e-9 * expected.abs().max(1.0), "{actual} is not {expected}");
}

#[test]
fn a_hold_in_a_bend_ends_the_acceleration_first() {
    let mut master = started(settings(), 200.0);
    master.advance(0.5);
    assert_near(master.vector_acceleration(), 5.0);
    assert_near(master.vector_velocity(), 1.25);
    master.feedhold();
    assert_near(master.vector_acceleration(), 5.0);
    master.advance(0.25);
    assert_near(master.vector_acceleration(), 2.5);
    assert_near(master.vector_velocity(), 1.25 + 0.25 * 3.75);
    master.advance(0.25);
    // 2.5 u/s come down in two bends of half a second.
    assert_near(master.vector_velocity(), 2.5);
    assert_near(master.next_event().unwrap(), 1.0);
    master.advance(0.5);
    assert_near(master.vector_acceleration(), -5.0);
    assert_near(master.vector_velocity(), 1.25);
    master.advance(0.5);
    assert_eq!(master.vector_velocity(), 0.0);
}

#[test]
fn a_higher_override_in_a_ramp_goes_on_as_if_it_had_been_so_from_the_start() {
    for seconds in [0.3, 0.9] {
        let mut slow = Master::new(1);
        slow.set_feedrate_override(0.6).unwrap();
        slow.push(&to(settings(), 200.0)).unwrap();
        let mut fast = started(settings(), 200.0);
        slow.advance(seconds);
        fast.advance(seconds);
        slow.set_feedrate_override(1.0).unwrap();
        assert_near(slow.next_event().unwrap(), fast.next_event().unwrap());
        for _ in 0..12 {
            slow.advance(1.0);
            fast.advance(1.0);
            assert_near(slow.position(0), fast.position(0));
            assert_near(slow.vector_velocity(), fast.vector_velocity());
        }
    }
}

#[test]
fn rapid_moves_have_their_own_override() {
    let straight = MoveSettings { jerk: 0.0, ..settings() };
    let rapid = to(straight, 200.0).overridden_by(Override::Rapid);
    let mut master = Master::new(2);
    master.set_rapid_override(0.5).unwrap();
    master.push(&rapid).unwrap();
    master.advance(2.0);
    assert_near(master.vector_velocity(), 10.0);
    master.set_feedrate_override(0.1).unwrap();
    master.advance(0.5);
    assert_near(master.vector_velocity(), 10.0);
    master.set_rapid_override(0.25).unwrap();
    master.advance(0.0625);
    assert_near(master.vector_velocity(), 7.5);
    master.advance(0.0625);
    assert_near(master.vector_velocity(), 5.0);
    assert_eq!((master.feedrate_override(), master.rapid_override()), (0.1, 0.25));
}

#[test]
fn a_locked_move_keeps_its_velocity() {
    let mut master = Master::new(2);
    master.set_feedrate_override(0.0).unwrap();
    let locked = to(MoveSettings { jerk: 0.0, ..settings() }, 200.0).overridden_by(Override::Locked);
    master.push(&locked).unwrap();
    assert_eq!(master.next_event(), Some(12.0));
}

#[derive(Clone, Debug)]
enum Change {
    Feedrate(f64),
    Hold,
    Start,
}

fn change() -> impl Strategy<Value = Change> {
    prop_oneof![
        3 => (0.0..2.0_f64).prop_map(Change::Feedrate),
        1 => Just(Change::Feedrate(0.0)),
        1 => Just(Change::Hold),
        2 => Just(Change::Start),
    ]
}

fn config() -> ProptestConfig {
    ProptestConfig { cases: 2000, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn changes_keep_to_the_jerk_and_the_target(
        changes in prop::collection::vec((change(), 0.0..1.0_f64), 1..12),
        velocity in 1.0..30.0_f64, ramps in prop::array::uniform3(1.0..50.0_f64), jerk in 5.0..500.0_f64,
        length in 1.0..100.0_f64,
    ) {
        let [acceleration, deceleration, stop] = ramps;
        let settings = MoveSettings { velocity, acceleration, deceleration, stop, jerk, ..MoveSettings::default() };
        let mut master = started(settings, length);
        let dt = 0.001;
        let braking = deceleration.max(stop);
        let mut before = master.path_state();
        let mut ticks = 0;
        let mut changes = changes.into_iter();
        let mut until = 0.0;
        while master.in_motion() && ticks < 400_000 {
            if f64::from(ticks) * dt >= until {
                match changes.next() {
                    Some((change, seconds)) => {
                        until += seconds;
                        match change {
                            Change::Feedrate(factor) => master.set_feedrate_override(factor).unwrap(),
                            Change::Hold => master.feedhold(),
                            Change::Start => master.cycle_start(),
                        }
                    }
                    None => {
                        until = f64::INFINITY;
                        master.cycle_start();
                        master.set_feedrate_override(1.0).unwrap();
                    }
                }
                let now = master.path_state();
                prop_assert!((now.position - before.position).abs() <= 1e-9 * length, "{before:?} {now:?}");
                prop_assert!((now.velocity - before.velocity).abs() <= 1e-9 * velocity, "{before:?} {now:?}");
                prop_assert!((now.acceleration - before.acceleration).abs() <= 1e-6 * braking.max(acceleration), "{before:?} {now:?}");
            }
            let advanced = master.advance(dt);
            ticks += 1;
            let now = master.path_state();
            prop_assert_eq!(advanced.dropped_velocity, 0.0);
            prop_assert!(now.velocity <= 2.0 * velocity * (1.0 + 1e-9));
            prop_assert!((-braking * (1.0 + 1e-9)..=acceleration * (1.0 + 1e-9)).contains(&now.acceleration), "{now:?}");
            let change = (now.acceleration - before.acceleration).abs();
            prop_assert!(change <= jerk * dt * (1.0 + 1e-6) + 1e-6 * braking.max(acceleration), "{before:?} {now:?} at {ticks}");
            before = now;
        }
        prop_assert!(!master.in_motion());
        prop_assert_eq!(master.position(0), length);
    }
}
