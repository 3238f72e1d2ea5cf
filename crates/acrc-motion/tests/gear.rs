//! The gear profiler and the hand wheel.

use acrc_motion::axis::{Gear, GearSettings, GearState, HandWheel, JogSettings, Window};
use proptest::prelude::*;

const TICK: f64 = 0.0005;

fn gear(settings: GearSettings) -> Gear {
    let mut gear = Gear::default();
    gear.set_settings(settings).unwrap();
    gear
}

#[test]
fn the_offset_is_the_source_over_its_ppu_times_the_ratio() {
    let mut x = gear(GearSettings { pulses_per_unit: 4000.0, ratio: -2.5, ..GearSettings::default() });
    x.advance(4000.0, TICK);
    assert_eq!((x.offset(), x.state()), (0.0, GearState::Off));
    x.on();
    for _ in 0..1000 {
        x.advance(8.0, TICK);
    }
    assert_eq!((x.offset(), x.state()), (-5.0, GearState::Engaged));
    assert_eq!(x.velocity(), -10.0);
    x.off();
    x.advance(8.0, TICK);
    x.advance(8.0, TICK);
    assert_eq!((x.offset(), x.velocity(), x.state()), (-5.0, 0.0, GearState::Off));
}

#[test]
fn engaging_and_disengaging_take_their_ramps() {
    let settings = GearSettings { acceleration: 100.0, deceleration: 200.0, ..GearSettings::default() };
    let mut x = gear(settings);
    x.on();
    // 20 units a second: 0.2 s and 2 units up, 0.1 s and 1 unit down.
    for _ in 0..400 {
        assert!(matches!(x.state(), GearState::Engaging));
        x.advance(0.01, TICK);
    }
    assert_eq!(x.state(), GearState::Engaged);
    assert!((x.offset() - 2.0).abs() < 1e-9 && (x.velocity() - 20.0).abs() < 1e-9);
    for _ in 0..100 {
        x.advance(0.01, TICK);
    }
    assert!((x.offset() - 3.0).abs() < 1e-9);
    x.off();
    for _ in 0..200 {
        assert_eq!(x.state(), GearState::Disengaging);
        x.advance(0.01, TICK);
    }
    x.advance(0.01, TICK);
    assert_eq!(x.state(), GearState::Off);
    assert!((x.offset() - 4.0).abs() < 1e-3, "{}", x.offset());
}

#[test]
fn a_new_ratio_counts_from_where_the_offset_is() {
    let mut x = gear(GearSettings::default());
    x.on();
    x.advance(10.0, TICK);
    x.set_settings(GearSettings { ratio: 3.0, ..GearSettings::default() }).unwrap();
    x.advance(10.0, TICK);
    assert_eq!(x.offset(), 40.0);
    x.preload(1.0).unwrap();
    x.advance(1.0, TICK);
    assert_eq!(x.offset(), 4.0);
    assert!(x.set_settings(GearSettings { pulses_per_unit: 0.0, ..GearSettings::default() }).is_err());
}

#[test]
fn the_offset_stands_at_its_ends() {
    let limits = Window { positive: 5.0, negative: -1.0 };
    let mut x = gear(GearSettings { limits, ..GearSettings::default() });
    x.on();
    let offsets = [4.0, 4.0, 4.0, -1.0, -7.0, 0.5].map(|counts| {
        x.advance(counts, TICK);
        x.offset()
    });
    assert_eq!(offsets, [4.0, 5.0, 5.0, 4.0, -1.0, -0.5]);
}

#[test]
fn a_hand_wheel_keeps_its_velocity_and_arrives() {
    let mut wheel = HandWheel::default();
    let settings = JogSettings { velocity: 10.0, acceleration: 100.0, deceleration: 100.0, ..JogSettings::default() };
    wheel.set_settings(settings, 0.01).unwrap();
    wheel.advance(100.0, TICK);
    assert_eq!(wheel.state().position, 0.0);
    wheel.on();
    let mut fastest = 0.0_f64;
    for tick in 0..2000 {
        // Turned in the first tenth of a second, at 50 units a second.
        wheel.advance(if tick < 200 { 2.5 } else { 0.0 }, TICK);
        fastest = fastest.max(wheel.state().velocity);
    }
    assert!(fastest <= 10.0 + 1e-9 && fastest > 9.99, "{fastest}");
    assert!((wheel.state().position - 5.0).abs() < 1e-9);
    wheel.set_settings(JogSettings::default(), 0.01).unwrap();
    wheel.advance(-100.0, TICK);
    assert!((wheel.state().position - 4.0).abs() < 1e-9);
    wheel.preload(0.0).unwrap();
    assert_eq!(wheel.state().position, 0.0);
}

proptest! {
    #[test]
    fn an_engaged_gear_does_not_drift(counts in prop::collection::vec(-500_i32..500, 1..2000), ratio in -10.0..10.0_f64) {
        let mut x = gear(GearSettings { pulses_per_unit: 4000.0, ratio, ..GearSettings::default() });
        x.on();
        for step in &counts {
            x.advance(f64::from(*step), TICK);
        }
        let total: i32 = counts.iter().sum();
        prop_assert_eq!(x.offset(), f64::from(total) * (ratio / 4000.0));
    }
}
