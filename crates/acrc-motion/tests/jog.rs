//! The jog profiler against hand formulas and the guide's jog examples.

use acrc_motion::axis::{AxisState, Jog, JogSettings, Side, Window};

const TICK: f64 = 0.0005;

fn settings(velocity: f64, acceleration: f64, deceleration: f64) -> JogSettings {
    JogSettings { velocity, acceleration, deceleration, ..JogSettings::default() }
}

fn jog(settings: JogSettings) -> Jog {
    let mut jog = Jog::new();
    jog.set_settings(settings).unwrap();
    jog
}

/// Ticks until the jog ends, as seconds.
fn time_to_end(jog: &mut Jog) -> f64 {
    for tick in 1..200_000_u32 {
        if jog.advance(TICK).finished {
            return f64::from(tick) * TICK;
        }
    }
    panic!("the jog does not end: {:?}", jog.state());
}

fn pass(jog: &mut Jog, seconds: f64) {
    for _ in 0..(seconds / TICK).round() as u32 {
        jog.advance(TICK);
    }
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * a.abs().max(b.abs()).max(1.0)
}

#[test]
fn two_axes_of_one_statement_end_at_their_own_times() {
    let mut x = jog(settings(25.0, 1000.0, 1000.0));
    let mut y = jog(settings(50.0, 500.0, 500.0));
    x.by_distance(10.0).unwrap();
    y.by_distance(10.0).unwrap();
    assert!(close(x.remaining().unwrap(), 0.425));
    assert!(close(y.remaining().unwrap(), 0.3));
    assert!(close(time_to_end(&mut x), 0.425));
    assert!(close(time_to_end(&mut y), 0.3));
    assert_eq!((x.offset(), y.offset()), (10.0, 10.0));
}

#[test]
fn a_lower_velocity_takes_effect_on_the_fly() {
    let mut x = jog(settings(10.0, 20.0, 25.0));
    x.by_distance(10.0).unwrap();
    assert!(close(x.remaining().unwrap(), 1.45));
    pass(&mut x, 1.0);
    assert!(close(x.offset(), 7.5) && close(x.state().velocity, 10.0));
    x.set_settings(settings(5.0, 20.0, 25.0)).unwrap();
    pass(&mut x, 0.2);
    assert!(close(x.offset(), 9.0) && close(x.state().velocity, 5.0), "{:?}", x.state());
    assert!(close(1.2 + time_to_end(&mut x), 1.5));
    assert_eq!(x.offset(), 10.0);
}

#[test]
fn targets_are_offsets_and_distances_count_from_the_present_one() {
    let mut x = jog(settings(100.0, 1000.0, 1000.0));
    for target in [-400.0, -300.0, -200.0, -100.0, 0.0] {
        x.to_offset(target).unwrap();
        time_to_end(&mut x);
        assert_eq!(x.offset(), target);
    }
    for (distance, offset) in [(-800.0, -800.0), (500.0, -300.0), (200.0, -100.0), (100.0, 0.0)] {
        x.by_distance(distance).unwrap();
        time_to_end(&mut x);
        assert_eq!(x.offset(), offset);
    }
}

#[test]
fn the_flags_follow_a_continuous_jog() {
    let mut x = jog(settings(10.0, 20.0, 25.0));
    let shown = |x: &Jog| {
        let f = x.flags();
        [f.active, f.negative, f.at_speed, f.stopping, f.forward, f.reverse].map(u8::from)
    };
    assert_eq!(shown(&x), [0, 0, 0, 0, 0, 0]);
    x.run(Side::Positive);
    assert_eq!(shown(&x), [1, 0, 0, 0, 1, 0]);
    pass(&mut x, 0.4);
    assert_eq!(shown(&x), [1, 0, 0, 0, 1, 0]);
    pass(&mut x, 0.2);
    assert_eq!(shown(&x), [1, 0, 1, 0, 1, 0]);
    x.set_settings(settings(5.0, 20.0, 25.0)).unwrap();
    assert_eq!(shown(&x), [1, 0, 0, 0, 1, 0]);
    pass(&mut x, 0.2);
    assert_eq!(shown(&x), [1, 0, 1, 0, 1, 0]);
    x.off();
    assert_eq!(shown(&x), [1, 0, 0, 1, 0, 0]);
    pass(&mut x, 0.2);
    assert_eq!(shown(&x), [0, 0, 0, 0, 0, 0]);
    x.run(Side::Negative);
    assert_eq!(shown(&x), [1, 1, 0, 0, 0, 1]);
    pass(&mut x, 1.0);
    assert_eq!(shown(&x), [1, 1, 1, 0, 0, 1]);
}

#[test]
fn a_target_is_announced_by_the_stopping_flag() {
    let mut x = jog(settings(10.0, 20.0, 25.0));
    x.by_distance(10.0).unwrap();
    pass(&mut x, 1.04);
    assert!(x.flags().at_speed && !x.flags().stopping);
    pass(&mut x, 0.02);
    assert!(x.flags().stopping && !x.flags().at_speed);
}

#[test]
fn the_other_direction_is_taken_through_rest() {
    let mut x = jog(settings(10.0, 20.0, 25.0));
    x.run(Side::Positive);
    pass(&mut x, 1.0);
    x.run(Side::Negative);
    pass(&mut x, 0.4);
    assert!(close(x.state().velocity, 0.0), "{:?}", x.state());
    assert!(close(x.offset(), 2.5 + 5.0 + 2.0));
    pass(&mut x, 0.5);
    assert!(close(x.state().velocity, -10.0));
    assert!(close(x.offset(), 9.5 - 2.5));
}

#[test]
fn a_target_behind_is_come_back_to() {
    let mut x = jog(settings(10.0, 20.0, 25.0));
    x.run(Side::Positive);
    pass(&mut x, 1.0);
    x.to_offset(8.5).unwrap();
    // 2 units of braking end at 9.5; back is 1 unit: up with 20 and down with 25.
    let peak = (2.0_f64 / (1.0 / 20.0 + 1.0 / 25.0)).sqrt();
    assert!(close(x.remaining().unwrap(), 0.4 + peak / 20.0 + peak / 25.0));
    time_to_end(&mut x);
    assert_eq!(x.offset(), 8.5);
}

#[test]
fn without_a_velocity_a_target_is_waited_for() {
    let mut x = jog(settings(0.0, 20.0, 25.0));
    x.by_distance(5.0).unwrap();
    pass(&mut x, 1.0);
    assert!(x.active() && x.offset() == 0.0 && x.remaining().is_none());
    x.set_settings(settings(10.0, 0.0, 0.0)).unwrap();
    assert!(close(time_to_end(&mut x), 0.5));
    assert_eq!(x.offset(), 5.0);
}

#[test]
fn a_jog_limit_ends_a_jog_and_lets_it_leave_the_other_way() {
    let limits = Window { positive: 5.0, negative: -1.0 };
    let mut x = jog(JogSettings { limits, ..settings(10.0, 0.0, 25.0) });
    x.run(Side::Positive);
    let mut met = None;
    for _ in 0..4000 {
        met = met.or(x.advance(TICK).limit);
    }
    assert_eq!(met, Some(Side::Positive));
    assert!(!x.active() && x.offset() >= 7.0 && x.offset() < 7.01, "{}", x.offset());
    x.run(Side::Positive);
    let report = x.advance(TICK);
    assert!(report.finished && report.limit == Some(Side::Positive));
    assert!(x.offset() < 7.01);
    x.to_offset(0.0).unwrap();
    time_to_end(&mut x);
    assert_eq!(x.offset(), 0.0);
}

#[test]
fn a_stop_takes_over_the_velocity_of_the_axis() {
    let mut x = jog(settings(10.0, 20.0, 25.0));
    x.stop_from(-30.0, 100.0).unwrap();
    assert!(x.flags().stopping && x.flags().negative);
    // It stops already.
    x.off();
    assert!(close(time_to_end(&mut x), 0.3));
    assert!(close(x.offset(), -4.5));
    x.stop_from(30.0, 0.0).unwrap();
    x.advance(TICK);
    assert!(!x.active() && close(x.offset(), -4.5));
}

#[test]
fn an_offset_is_preloaded_at_rest_only() {
    let mut x = jog(settings(10.0, 20.0, 25.0));
    x.preload(4.0).unwrap();
    assert_eq!(x.offset(), 4.0);
    x.run(Side::Positive);
    assert!(x.preload(0.0).is_err());
    x.halt();
    assert_eq!(x.state(), AxisState { position: 4.0, ..AxisState::default() });
    assert!(x.set_settings(settings(-1.0, 0.0, 0.0)).unwrap_err().to_string().contains("velocity is negative"));
    assert!(x.to_offset(f64::NAN).is_err());
}

#[test]
fn counts_of_a_source_can_be_the_time() {
    let mut x = jog(settings(2.0, 0.0, 0.0));
    x.run(Side::Positive);
    let offsets = [3.0, 0.0, 5.0, -2.0, -9.0, 1.0].map(|counts| {
        x.advance(counts);
        x.offset()
    });
    assert_eq!(offsets, [6.0, 6.0, 16.0, 12.0, 0.0, 2.0]);
}
