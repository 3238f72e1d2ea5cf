//! Highest velocities of single axes (MAXVEL): no move makes an axis faster, and none is slower than it has to be.

use acrc_motion::{AXES, Arc, ControlPoint, CurveBuilder, Master, Move, MoveSettings, Sine, Target, Turn};
use proptest::prelude::*;

const PERIOD: f64 = 0.001;

fn settings() -> MoveSettings {
    MoveSettings { velocity: 10.0, acceleration: 100.0, deceleration: 100.0, stop: 100.0, ..MoveSettings::default() }
}

/// Seconds until a master rests, and the highest speed of its first three slots on the way.
fn run(master: &mut Master) -> (f64, [f64; 3]) {
    let (mut ticks, mut peaks) = (0_u32, [0.0_f64; 3]);
    while master.in_motion() && ticks < 400_000 {
        master.advance(PERIOD);
        ticks += 1;
        for (slot, peak) in peaks.iter_mut().enumerate() {
            *peak = peak.max(master.velocity(slot).abs());
        }
    }
    (f64::from(ticks) * PERIOD, peaks)
}

fn near(value: f64, expected: f64) {
    assert!((value - expected).abs() <= PERIOD, "{value} is not {expected}");
}

#[test]
fn a_straight_move_is_as_fast_as_its_slowest_axis_allows() {
    let mut master = Master::new(1);
    master.set_ceiling(1, 4.0).unwrap();
    master.push(&Move::new(settings()).to(0, Target::Absolute(6.0)).to(1, Target::Absolute(8.0))).unwrap();
    let (seconds, peaks) = run(&mut master);
    // Y has 4/5 of the velocity along the path of 10 units, which is 5 u/s then.
    near(seconds, 10.0 / 5.0 + 5.0 / 100.0);
    assert!((peaks[1] - 4.0).abs() < 1e-9 && (peaks[0] - 3.0).abs() < 1e-9, "{peaks:?}");
    // An axis that does not move slows nothing down.
    master.push(&Move::new(settings()).to(0, Target::Absolute(16.0))).unwrap();
    near(run(&mut master).0, 10.0 / 10.0 + 10.0 / 100.0);
}

#[test]
fn no_override_lifts_a_ceiling() {
    let mut master = Master::new(1);
    master.set_ceiling(0, 12.0).unwrap();
    master.set_feedrate_override(2.0).unwrap();
    master.push(&Move::new(settings()).to(0, Target::Absolute(10.0))).unwrap();
    assert!((run(&mut master).1[0] - 12.0).abs() < 1e-9);
    master.set_feedrate_override(0.5).unwrap();
    master.push(&Move::new(settings()).to(0, Target::Absolute(0.0))).unwrap();
    assert!((run(&mut master).1[0] - 5.0).abs() < 1e-9);
}

#[test]
fn a_circle_is_followed_at_the_lower_ceiling_of_its_axes() {
    let mut master = Master::new(1);
    master.set_ceiling(0, 2.0).unwrap();
    let arc = Arc {
        slots: [0, 1],
        target: [0.0, 0.0],
        center: [5.0, 0.0],
        relative_target: false,
        relative_center: false,
        turn: Turn::CounterClockwise,
    };
    master.push(&Move::new(settings()).arc(arc)).unwrap();
    let (seconds, peaks) = run(&mut master);
    near(seconds, 10.0 * core::f64::consts::PI / 2.0 + 2.0 / 100.0);
    assert!(peaks[0] <= 2.0 + 1e-9 && peaks[0] > 1.999, "{peaks:?}");
}

#[test]
fn a_blended_move_is_slowed_down_to_before_it_begins() {
    let mut master = Master::new(1);
    master.set_ceiling(1, 4.0).unwrap();
    let through = MoveSettings { stop: 0.0, ..settings() };
    master.push(&Move::new(through).to(0, Target::Absolute(10.0))).unwrap();
    master.push(&Move::new(settings()).to(1, Target::Absolute(10.0))).unwrap();
    let (seconds, peaks) = run(&mut master);
    assert!(peaks[1] <= 4.0 + 1e-9, "{peaks:?}");
    // Up to 10 u/s over 0.5 units, down to 4 u/s over 0.42, and 4 u/s from there on to a ramp of 0.04 s.
    let first = 0.1 + (10.0 - 0.5 - 0.42) / 10.0 + 0.06;
    near(seconds, first + (10.0 - 0.08) / 4.0 + 0.04);
}

#[test]
fn what_is_no_velocity_is_refused() {
    let mut master = Master::new(1);
    assert!(master.set_ceiling(0, -1.0).is_err());
    assert!(master.set_ceiling(0, f64::NAN).is_err());
    assert!(master.set_ceiling(AXES, 1.0).is_err());
}

fn kinds() -> impl Strategy<Value = Move> {
    let number = || -20.0..20.0_f64;
    prop_oneof![
        (number(), number(), number()).prop_map(|(x, y, z)| {
            let to = |next: Move, (slot, at)| next.to(slot, Target::Absolute(at));
            [(0, x), (1, y), (2, z)].into_iter().fold(Move::new(settings()), to)
        }),
        (number(), number(), -300.0..300.0_f64, 0.1..9.0_f64).prop_map(|(x, target, sweep, amplitude)| {
            let sine = Sine { target, phase: 30.0, sweep, amplitude };
            Move::new(settings()).to(0, Target::Absolute(x)).to(1, Target::Sine(sine))
        }),
        (number(), number(), any::<bool>(), number()).prop_map(|(x, y, left, z)| {
            let turn = if left { Turn::CounterClockwise } else { Turn::Clockwise };
            let (target, center) = ([x + 30.0, y], [x, y]);
            let arc = Arc { slots: [0, 1], target, center, relative_target: true, relative_center: true, turn };
            Move::new(settings()).arc(arc).to(2, Target::Relative(z))
        }),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_axis_is_faster_than_its_ceiling(
        command in kinds(),
        ceilings in prop::array::uniform3(2.0..30.0_f64),
        degrees in -180.0..180.0_f64,
        factor in 0.2..3.0_f64,
    ) {
        let mut master = Master::new(1);
        for (slot, ceiling) in ceilings.into_iter().enumerate() {
            master.set_ceiling(slot, ceiling).unwrap();
        }
        master.set_rotation([0, 1], degrees, [1.0, 2.0]).unwrap();
        master.set_scale(1, factor, 0.0).unwrap();
        prop_assume!(master.push(&command).is_ok());
        let (_, peaks) = run(&mut master);
        for (peak, ceiling) in peaks.into_iter().zip(ceilings) {
            prop_assert!(peak <= ceiling * (1.0 + 1e-9), "{} {}", peak, ceiling);
        }
    }

    #[test]
    fn no_axis_is_faster_on_a_curve(points in prop::collection::vec((-20.0..20.0_f64, -20.0..20.0_f64), 3..5), ceiling in 2.0..8.0_f64) {
        let mut master = Master::new(16);
        master.set_ceiling(0, ceiling).unwrap();
        let mut builder = CurveBuilder::spline();
        let mut spans = vec![builder.push(None, Some(&ControlPoint::new().at(0, 0.0).at(1, 0.0))).unwrap()];
        for (x, y) in points {
            spans.push(builder.push(None, Some(&ControlPoint::new().at(0, x).at(1, y))).unwrap());
        }
        while let Some(span) = builder.finish() {
            spans.push(Some(span));
        }
        for span in spans.into_iter().flatten() {
            master.push_span(&Move::new(settings()), &span).unwrap();
        }
        prop_assert!(run(&mut master).1[0] <= ceiling * (1.0 + 1e-6));
    }
}
