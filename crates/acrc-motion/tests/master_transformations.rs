//! ROTARY, SCALE, ROTATE, OFFSET and FLZ.

use acrc_motion::{Arc, Master, Move, MoveSettings, SettingError, Sine, Target, Turn};
use proptest::prelude::*;

fn ramps(velocity: f64, ramp: f64) -> MoveSettings {
    MoveSettings { velocity, acceleration: ramp, deceleration: ramp, stop: ramp, ..MoveSettings::default() }
}

fn line(targets: &[Target]) -> Move {
    targets.iter().enumerate().fold(Move::new(ramps(10.0, 100.0)), |line, (slot, target)| line.to(slot, *target))
}

fn targets(master: &Master) -> [f64; 2] {
    [master.target(0), master.target(1)]
}

#[track_caller]
fn assert_near(actual: [f64; 2], expected: [f64; 2]) {
    let near = |i: usize| (actual[i] - expected[i]).abs() <= 1e-12 * expected[i].abs().max(1.0);
    assert!(near(0) && near(1), "{actual:?} is not {expected:?}");
}

#[test]
fn a_rotary_axis_takes_the_short_way() {
    for (from, to, end) in [
        (350.0, 10.0, 370.0),
        (10.0, 350.0, -10.0),
        (0.0, 180.0, 180.0),
        (0.0, -180.0, -180.0),
        (0.0, 181.0, -179.0),
        (725.0, 0.0, 720.0),
        (0.0, 720.0, 0.0),
    ] {
        let mut master = Master::new(1);
        master.set_rotary(0, 360.0).unwrap();
        master.set_position(0, from).unwrap();
        master.push(&line(&[Target::Absolute(to)])).unwrap();
        assert_eq!(master.target(0), end, "{from} to {to}");
    }
}

#[test]
fn a_relative_move_of_a_rotary_axis_goes_all_the_way() {
    let mut master = Master::new(1);
    master.set_rotary(0, 360.0).unwrap();
    master.push(&line(&[Target::Relative(1000.0)])).unwrap();
    assert_eq!(master.target(0), 1000.0);
}

#[test]
fn a_scale_acts_about_its_centre_and_on_relative_targets() {
    let mut master = Master::new(4);
    master.set_scale(0, 2.0, 10.0).unwrap();
    master.push(&line(&[Target::Absolute(11.0)])).unwrap();
    assert_eq!(master.target(0), 12.0);
    master.push(&line(&[Target::Relative(1.0)])).unwrap();
    assert_eq!((master.target(0), master.programmed_target(0)), (14.0, 12.0));
    assert_eq!(master.set_scale(0, 0.0, 0.0), Err(SettingError::ZeroScale));
}

#[test]
fn a_rotation_turns_the_path_of_two_axes() {
    let mut master = Master::new(4);
    master.set_rotation([0, 1], 90.0, [0.0, 0.0]).unwrap();
    master.push(&line(&[Target::Absolute(5.0)])).unwrap();
    assert_eq!(targets(&master), [0.0, 5.0]);
    master.push(&line(&[Target::Relative(0.0), Target::Relative(2.0)])).unwrap();
    assert_eq!(targets(&master), [-2.0, 5.0]);
    master.set_rotation([0, 1], 0.0, [0.0, 0.0]).unwrap();
    master.push(&line(&[Target::Absolute(5.0)])).unwrap();
    assert_eq!(targets(&master), [5.0, 5.0]);
    assert_eq!(master.set_rotation([1, 1], 5.0, [0.0; 2]), Err(SettingError::SameSlot(1)));
}

#[test]
fn shifts_move_absolute_targets_only() {
    let mut master = Master::new(4);
    master.set_offset(0, 100.0).unwrap();
    master.push(&line(&[Target::Absolute(5.0), Target::Absolute(1.0)])).unwrap();
    assert_eq!(targets(&master), [105.0, 1.0]);
    master.push(&line(&[Target::Relative(5.0)])).unwrap();
    assert_eq!(targets(&master), [110.0, 1.0]);
}

#[test]
fn a_floating_zero_lies_where_the_axis_is() {
    let mut master = Master::new(4);
    master.set_offset(0, 3.0).unwrap();
    master.set_position(0, 50.0).unwrap();
    master.float_zero(0, 0.0).unwrap();
    assert_eq!((master.programmed_target(0), master.float(0)), (0.0, 47.0));
    master.push(&line(&[Target::Absolute(5.0)])).unwrap();
    assert_eq!(master.target(0), 55.0);
    master.float_zero(0, 2.0).unwrap();
    master.push(&line(&[Target::Absolute(0.0)])).unwrap();
    assert_eq!(master.target(0), 57.0);
    master.set_float(0, 0.0).unwrap();
    assert_eq!(master.programmed_target(0), 54.0);
}

#[test]
fn a_mirrored_arc_runs_the_other_way_round() {
    let mut master = Master::new(1);
    master.set_position(0, -1.0).unwrap();
    master.set_scale(0, -1.0, 0.0).unwrap();
    let quarter = Arc {
        slots: [0, 1],
        target: [0.0, 1.0],
        center: [0.0, 0.0],
        relative_target: false,
        relative_center: false,
        turn: Turn::CounterClockwise,
    };
    master.push(&Move::new(ramps(1.0, 0.0)).arc(quarter)).unwrap();
    let quarter_turn = std::f64::consts::FRAC_PI_2;
    assert!((master.next_event().unwrap() - quarter_turn).abs() < 1e-12);
    master.advance(quarter_turn / 2.0);
    let s = 0.5_f64.sqrt();
    assert_near([master.position(0), master.position(1)], [-s, s]);
    master.advance(quarter_turn);
    assert_eq!([master.position(0), master.position(1)], [0.0, 1.0]);
}

proptest! {
    /// Where the axes go is the image of where they would go without a transformation.
    #[test]
    fn every_kind_of_path_is_transformed(
        factors in prop::array::uniform2(prop_oneof![0.2..4.0_f64, -4.0..-0.2_f64]), degrees in -400.0..400.0_f64,
        center in prop::array::uniform2(-5.0..5.0_f64), shift in prop::array::uniform2(-9.0..9.0_f64), kind in 0..3,
    ) {
        let command = match kind {
            0 => line(&[Target::Absolute(7.0), Target::Relative(-3.0)]),
            1 => Move::new(ramps(1.0, 0.0)).arc(Arc {
                slots: [0, 1], target: [-3.0, 4.0], center: [0.0, 0.0],
                relative_target: false, relative_center: false, turn: Turn::Clockwise,
            }),
            _ => line(&[
                Target::Sine(Sine { target: 2.0, phase: 30.0, sweep: 500.0, amplitude: 1.0 }),
                Target::Sine(Sine { target: -2.0, phase: 60.0, sweep: 200.0, amplitude: 3.0 }),
            ]),
        };
        let (sin, cos) = degrees.to_radians().sin_cos();
        let image = |[x, y]: [f64; 2]| {
            let [x, y] = [factors[0] * x - center[0], 1.0 + factors[1] * (y - 1.0) - center[1]];
            [center[0] + cos * x - sin * y + shift[0], center[1] + sin * x + cos * y + shift[1]]
        };
        let start = [5.0, 0.0];
        let (mut plain, mut transformed) = (Master::new(1), Master::new(1));
        transformed.set_scale(0, factors[0], 0.0).unwrap();
        transformed.set_scale(1, factors[1], 1.0).unwrap();
        transformed.set_rotation([0, 1], degrees, center).unwrap();
        for slot in 0..2 {
            transformed.set_offset(slot, shift[slot]).unwrap();
            plain.set_position(slot, start[slot]).unwrap();
            transformed.set_position(slot, image(start)[slot]).unwrap();
        }
        let even = {
            let mut even = command;
            even.settings = ramps(1.0, 0.0);
            even
        };
        plain.push(&even).unwrap();
        transformed.push(&even).unwrap();
        let ends = [plain.next_event().unwrap(), transformed.next_event().unwrap()];
        for _ in 0..50 {
            plain.advance(ends[0] / 50.0);
            transformed.advance(ends[1] / 50.0);
            let expected = image([plain.position(0), plain.position(1)]);
            for (slot, expected) in expected.into_iter().enumerate() {
                prop_assert!((transformed.position(slot) - expected).abs() <= 1e-9 * (1.0 + expected.abs()));
            }
        }
    }
}
