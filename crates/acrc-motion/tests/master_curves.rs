//! Arcs, helices, arcs in space, sinusoids, and all of them in one move.

use std::f64::consts::{FRAC_PI_2, PI};

use acrc_motion::{Arc, Master, Move, MoveSettings, PushError, Sine, SpaceArc, Target, Turn};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

const TICK: f64 = 0.0005;

fn ramps(velocity: f64, ramp: f64) -> MoveSettings {
    MoveSettings { velocity, acceleration: ramp, deceleration: ramp, stop: ramp, ..MoveSettings::default() }
}

fn arc(target: [f64; 2], center: [f64; 2], turn: Turn) -> Arc {
    Arc { slots: [0, 1], target, center, relative_target: false, relative_center: false, turn }
}

/// A master whose first axes are at these positions.
fn master_at(positions: &[f64]) -> Master {
    let mut master = Master::new(4);
    for (slot, position) in positions.iter().enumerate() {
        master.set_position(slot, *position).unwrap();
    }
    master
}

fn point<const N: usize>(master: &Master) -> [f64; N] {
    std::array::from_fn(|slot| master.position(slot))
}

fn distance<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

#[track_caller]
fn assert_near(actual: f64, expected: f64) {
    assert!((actual - expected).abs() <= 1e-9 * expected.abs().max(1.0), "{actual} is not {expected}");
}

#[test]
fn a_quarter_circle_takes_its_length() {
    let mut master = master_at(&[10.0, 0.0]);
    let quarter = Move::new(ramps(5.0, 10.0)).arc(arc([0.0, 10.0], [0.0, 0.0], Turn::CounterClockwise));
    master.push(&quarter).unwrap();
    let duration = 10.0 * FRAC_PI_2 / 5.0 + 0.5;
    assert_near(master.next_event().unwrap(), duration);
    master.advance(duration / 2.0);
    let diagonal = 10.0 / 2.0_f64.sqrt();
    assert_near(master.position(0), diagonal);
    assert_near(master.position(1), diagonal);
    assert_near(master.velocity(0), -5.0 / 2.0_f64.sqrt());
    assert_near(master.velocity(1), 5.0 / 2.0_f64.sqrt());
    // v²/r toward the centre.
    assert_near(master.acceleration(0), -2.5 / 2.0_f64.sqrt());
    assert_near(master.acceleration(1), -2.5 / 2.0_f64.sqrt());
    master.advance(duration);
    assert_eq!(point(&master), [0.0, 10.0]);
}

#[test]
fn the_other_way_round_is_three_quarters() {
    let mut master = master_at(&[10.0, 0.0]);
    master.push(&Move::new(ramps(5.0, 0.0)).arc(arc([0.0, 10.0], [0.0, 0.0], Turn::Clockwise))).unwrap();
    assert_near(master.next_event().unwrap(), 30.0 * FRAC_PI_2 / 5.0);
    master.advance(10.0 * FRAC_PI_2 / 5.0);
    assert!(distance(point(&master), [0.0, -10.0]) < 1e-12);
}

#[test]
fn an_end_at_the_start_is_a_full_circle() {
    for (turn, quarter) in [(Turn::CounterClockwise, [0.0, 3.0]), (Turn::Clockwise, [0.0, -3.0])] {
        let mut master = master_at(&[3.0, 0.0]);
        master.push(&Move::new(ramps(PI, 0.0)).arc(arc([3.0, 0.0], [0.0, 0.0], turn))).unwrap();
        assert_near(master.next_event().unwrap(), 6.0);
        master.advance(1.5);
        assert!(distance(point(&master), quarter) < 1e-12, "{:?}", point::<2>(&master));
    }
}

#[test]
fn a_start_beside_the_circle_jumps_onto_it() {
    let mut master = master_at(&[12.0, 0.0]);
    master.push(&Move::new(ramps(5.0, 10.0)).arc(arc([0.0, 10.0], [0.0, 0.0], Turn::CounterClockwise))).unwrap();
    assert_eq!(point(&master), [10.0, 0.0]);
}

#[test]
fn relative_points_of_an_arc_count_from_the_move_before() {
    let mut master = master_at(&[100.0, 50.0]);
    let relative = Arc {
        relative_target: true,
        relative_center: true,
        ..arc([-10.0, 10.0], [-10.0, 0.0], Turn::CounterClockwise)
    };
    master.push(&Move::new(ramps(5.0, 10.0)).arc(relative)).unwrap();
    assert_eq!((master.target(0), master.target(1)), (90.0, 60.0));
    assert_near(master.next_event().unwrap(), 10.0 * FRAC_PI_2 / 5.0 + 0.5);
}

#[test]
fn a_helix_has_the_length_of_a_helix() {
    let mut master = master_at(&[3.0, 0.0, 1.0]);
    let helix = Move::new(ramps(2.0, 0.0))
        .arc(arc([3.0, 0.0], [0.0, 0.0], Turn::CounterClockwise))
        .to(2, Target::Relative(8.0 * PI));
    master.push(&helix).unwrap();
    // Root of (6π)² and (8π)².
    assert_near(master.next_event().unwrap(), 5.0 * PI);
    master.advance(2.5 * PI);
    assert!(distance(point(&master), [-3.0, 0.0, 1.0 + 4.0 * PI]) < 1e-12);
}

#[test]
fn an_arc_in_space_goes_through_its_point() {
    let mut master = master_at(&[1.0, 0.0, 0.0]);
    // The great circle through these three has its centre in the origin.
    let s = 0.5_f64.sqrt();
    let through = SpaceArc { slots: [0, 1, 2], via: [0.0, s, s], target: [-1.0, 0.0, 0.0] };
    master.push(&Move::new(ramps(1.0, 0.0)).space_arc(through)).unwrap();
    assert_near(master.next_event().unwrap(), PI);
    master.advance(FRAC_PI_2);
    assert!(distance(point(&master), [0.0, s, s]) < 1e-12);
    assert_near(master.velocity(0), -1.0);
    master.advance(FRAC_PI_2);
    assert_eq!(point(&master), [-1.0, 0.0, 0.0]);
}

#[test]
fn an_arc_in_space_may_be_more_than_half_a_circle() {
    let mut master = master_at(&[1.0, 0.0, 5.0]);
    let through = SpaceArc { slots: [0, 1, 2], via: [-1.0, 0.0, 5.0], target: [0.0, -1.0, 5.0] };
    master.push(&Move::new(ramps(1.0, 0.0)).space_arc(through)).unwrap();
    assert_near(master.next_event().unwrap(), 1.5 * PI);
}

#[test]
fn a_line_and_a_sinusoid_end_together() {
    // The guide's example: X to 2 while Y comes from the crest of a sinusoid down to its zero.
    let mut master = master_at(&[0.0, 100.0]);
    let sine = Sine { target: 0.0, phase: 90.0, sweep: 90.0, amplitude: 100.0 };
    let both = Move::new(ramps(10.0, 10.0)).to(0, Target::Absolute(2.0)).to(1, Target::Sine(sine));
    master.push(&both).unwrap();
    assert_eq!(point(&master), [0.0, 100.0]);
    while master.in_motion() {
        let [x, y] = point(&master);
        assert_near(y, 100.0 * (FRAC_PI_2 * (1.0 + x / 2.0)).sin());
        assert_eq!(master.velocity(0) == 0.0, master.velocity(1) == 0.0);
        master.advance(TICK);
    }
    assert_eq!(point(&master), [2.0, 0.0]);
}

#[test]
fn the_length_of_a_sinusoid_is_its_mean_square() {
    let mut master = Master::new(1);
    let sine = Sine { target: 0.0, phase: 0.0, sweep: 360.0, amplitude: 5.0 };
    master.push(&Move::new(ramps(1.0, 0.0)).to(0, Target::Sine(sine))).unwrap();
    assert_near(master.next_event().unwrap(), 2.0 * PI * 5.0 / 2.0_f64.sqrt());
}

#[test]
fn two_sinusoids_make_a_circle() {
    let mut master = master_at(&[0.0, 5.0]);
    let x = Sine { target: 0.0, phase: 0.0, sweep: 360.0, amplitude: 5.0 };
    let y = Sine { target: 5.0, phase: 90.0, ..x };
    master.push(&Move::new(ramps(PI, 0.0)).to(0, Target::Sine(x)).to(1, Target::Sine(y))).unwrap();
    assert_near(master.next_event().unwrap(), 10.0);
    for _ in 0..100 {
        master.advance(0.1);
        assert_near(distance(point(&master), [0.0, 0.0]), 5.0);
    }
}

#[test]
fn a_sinusoid_begins_where_the_axis_is() {
    let mut master = master_at(&[7.0]);
    let sine = Sine { target: 1.0, phase: 0.0, sweep: 180.0, amplitude: 2.0 };
    master.push(&Move::new(ramps(1.0, 0.0)).to(0, Target::Sine(sine))).unwrap();
    assert_eq!(master.position(0), 7.0);
    master.advance(master.next_event().unwrap() / 2.0);
    assert_near(master.position(0), 4.0 + 2.0);
    master.advance(100.0);
    assert_eq!(master.position(0), 1.0);
}

#[test]
fn arcs_that_are_none_are_refused() {
    let at = |target, center| Move::new(ramps(1.0, 1.0)).arc(arc(target, center, Turn::Clockwise));
    let mut master = master_at(&[1.0, 0.0]);
    assert_eq!(master.push(&at([5.0, 5.0], [5.0, 5.0])), Err(PushError::NoRadius));
    assert_eq!(master.push(&at([5.0, 5.0], [1.0, 0.0])), Err(PushError::NoRadius));
    let line = SpaceArc { slots: [0, 1, 2], via: [2.0, 0.0, 0.0], target: [3.0, 0.0, 0.0] };
    let error = master.push(&Move::new(ramps(1.0, 1.0)).space_arc(line)).unwrap_err();
    assert_eq!(error.to_string(), "the points of the arc do not make a circle");
    assert!(!master.in_motion());
}

#[test]
fn an_axis_has_one_target_in_a_move() {
    let mut master = master_at(&[1.0, 0.0]);
    let circle = arc([1.0, 0.0], [0.0, 0.0], Turn::Clockwise);
    let twice = Move::new(ramps(1.0, 1.0)).arc(circle).to(1, Target::Absolute(3.0));
    assert_eq!(master.push(&twice), Err(PushError::SlotTwice(1)));
    let many = (0..9).fold(Move::new(ramps(1.0, 1.0)), |many, _| many.arc(circle));
    assert_eq!(master.push(&many), Err(PushError::SlotTwice(0)));
    let missing = Move::new(ramps(1.0, 1.0)).arc(Arc { slots: [0, 16], ..circle });
    assert_eq!(master.push(&missing).unwrap_err().to_string(), "slot 16 does not exist: a master has 16");
}

fn size() -> impl Strategy<Value = f64> {
    -1000.0..1000.0_f64
}

fn config() -> ProptestConfig {
    ProptestConfig { cases: 500, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn arcs_stay_on_their_circle(start in [size(), size()], target in [size(), size()], center in [size(), size()], left in any::<bool>(), jerk in prop_oneof![Just(0.0), Just(5000.0)]) {
        let radius = distance(target, center);
        prop_assume!(radius > 1.0 && distance(start, center) > 1.0);
        let turn = if left { Turn::CounterClockwise } else { Turn::Clockwise };
        let mut master = master_at(&start);
        let settings = MoveSettings { jerk, ..ramps(500.0, 2000.0) };
        master.push(&Move::new(settings).arc(arc(target, center, turn))).unwrap();
        let length = master.profile().unwrap().length();
        prop_assert!(length <= 2.0 * PI * radius * (1.0 + 1e-12));
        let mut before: [f64; 2] = point(&master);
        while master.in_motion() {
            master.advance(0.01);
            let now = point(&master);
            prop_assert!((distance(now, center) - radius).abs() <= 1e-9 * radius);
            // The arc bends to the side that was asked for.
            let cross = (before[0] - center[0]) * (now[1] - center[1]) - (before[1] - center[1]) * (now[0] - center[0]);
            let side = if left { cross } else { -cross };
            prop_assert!(side >= -1e-6);
            let speed = (master.velocity(0).powi(2) + master.velocity(1).powi(2)).sqrt();
            prop_assert!((speed - master.vector_velocity()).abs() <= 1e-9 * 500.0);
            before = now;
        }
        prop_assert_eq!(before, target);
    }

    #[test]
    fn arcs_in_space_stay_on_their_circle(start in [size(), size(), size()], via in [size(), size(), size()], target in [size(), size(), size()]) {
        let [a, b, c] = [distance(via, target), distance(start, target), distance(start, via)];
        let half = (a + b + c) / 2.0;
        let area = (half * (half - a) * (half - b) * (half - c)).max(0.0).sqrt();
        prop_assume!(area > 1.0);
        let radius = a * b * c / (4.0 * area);
        prop_assume!(radius < 1e4);
        let mut master = master_at(&start);
        let through = SpaceArc { slots: [0, 1, 2], via, target };
        master.push(&Move::new(ramps(500.0, 0.0)).space_arc(through)).unwrap();
        let length = master.profile().unwrap().length();
        // The angles over the chords, from the law of sines.
        let inside = |near: f64, far: f64, other: f64| ((near * near + far * far - other * other) / (2.0 * near * far)).clamp(-1.0, 1.0).acos();
        let sweep = 2.0 * (inside(b, a, c) + inside(b, c, a));
        prop_assert!((length - radius * sweep).abs() <= 1e-6 * length, "{length} {}", radius * sweep);
        let mut nearest = f64::INFINITY;
        let dt = length / 500.0 / 1000.0;
        let mut before: [f64; 3] = point(&master);
        prop_assert!(distance(before, start) <= 1e-9 * radius);
        for _ in 0..1000 {
            master.advance(dt);
            let now = point(&master);
            nearest = nearest.min(distance(now, via));
            prop_assert!(distance(now, before) <= 500.0 * dt * (1.0 + 1e-6));
            before = now;
        }
        prop_assert!(nearest <= length / 1000.0);
        prop_assert!(distance(before, target) <= 1e-9 * radius);
    }

    #[test]
    fn all_axes_of_a_move_start_and_stop_in_the_same_tick(x in 1.0..50.0_f64, z in -50.0..-1.0_f64, sweep in 30.0..720.0_f64, turn in 0.1..6.0_f64) {
        let mut master = master_at(&[10.0, 0.0]);
        let end = [10.0 * turn.cos(), 10.0 * turn.sin()];
        let sine = Sine { target: 3.0, phase: 20.0, sweep, amplitude: 4.0 };
        let mixed = Move::new(MoveSettings { jerk: 900.0, ..ramps(30.0, 100.0) })
            .arc(arc(end, [0.0, 0.0], Turn::CounterClockwise))
            .to(2, Target::Relative(z)).to(3, Target::Absolute(x)).to(4, Target::Sine(sine));
        master.push(&mixed).unwrap();
        let mut before: [f64; 5] = point(&master);
        let mut ticks = 0;
        while master.in_motion() {
            master.advance(TICK);
            let now: [f64; 5] = point(&master);
            for slot in 0..5 {
                prop_assert_eq!(master.velocity(slot) != 0.0, master.in_motion(), "slot {} in tick {}", slot, ticks);
                // What the axis covered is its velocity, up to what that changes in a tick.
                let mean = (now[slot] - before[slot]) / TICK;
                prop_assert!(!master.in_motion() || (mean - master.velocity(slot)).abs() <= 1.0, "slot {slot}");
            }
            before = now;
            ticks += 1;
        }
        prop_assert_eq!(before, [end[0], end[1], z, x, 3.0]);
    }
}
