//! End-of-travel limits, bands, capture, and how a killed axis stops.

use acrc_motion::axis::{
    AxisProfilers, Bands, Capture, CaptureMode, CaptureSource, GearSettings, HomeInputs, HomingOptions, HomingStatus,
    JogSettings, LimitFlags, LimitKind, LimitSettings, LimitStop, MarkerSeek, SeekStep, Side, Sides, SourceCounts,
    TravelLimits, Window, limit_inputs,
};

const TICK: f64 = 0.0005;
const BOTH: Sides = Sides { positive: true, negative: true };
const NONE: Sides = Sides { positive: false, negative: false };

fn limits(settings: LimitSettings) -> TravelLimits {
    let mut limits = TravelLimits::default();
    limits.set_settings(settings).unwrap();
    limits
}

fn level(positive_limit: bool, negative_limit: bool) -> HomeInputs {
    HomeInputs { home: false, positive_limit, negative_limit }
}

#[test]
fn a_hardware_limit_stops_motion_towards_it_and_latches() {
    let mut x = limits(LimitSettings { hardware: BOTH, hardware_deceleration: 500.0, ..LimitSettings::default() });
    assert_eq!(x.update(level(false, false), 0.0, 5.0, false), None);
    let stop = LimitStop { kind: LimitKind::Hardware, side: Side::Positive, deceleration: 500.0 };
    assert_eq!(x.update(level(true, false), 0.0, 5.0, false), Some(stop));
    // Still slowing down on it, then away from it, then into it again.
    assert_eq!(x.update(level(true, false), 0.0, 4.0, false), None);
    assert_eq!(x.update(level(true, false), 0.0, 0.0, false), None);
    assert_eq!(x.update(level(true, false), 0.0, -1.0, false), None);
    let positive = Sides { positive: true, negative: false };
    assert_eq!(x.flags(), LimitFlags { inputs: positive, hardware: positive, ..LimitFlags::default() });
    assert_eq!(x.update(level(true, false), 0.0, 1.0, false), Some(stop));
    assert_eq!(x.update(level(false, false), 0.0, 0.0, false), None);
    assert_eq!(x.flags().hardware, positive);
    x.set_latched(NONE);
    assert_eq!(x.flags(), LimitFlags::default());
}

#[test]
fn levels_can_be_inverted_and_limits_switched_off() {
    let settings = LimitSettings { inverted: BOTH, home_inverted: true, ..LimitSettings::default() };
    let mut x = limits(settings);
    assert_eq!(x.update(level(true, false), 0.0, -5.0, false), None);
    assert_eq!(x.flags().inputs, Sides { positive: false, negative: true });
    assert!(x.flags().home);
    assert_eq!(x.homing_inputs(), HomeInputs { home: true, positive_limit: false, negative_limit: false });
    x.set_settings(LimitSettings { hardware: BOTH, ..settings }).unwrap();
    assert!(x.update(level(true, false), 0.0, -5.0, false).is_some_and(|stop| stop.side == Side::Negative));
    assert!(x.homing_inputs().negative_limit);
    assert_eq!(x.update(level(false, false), 0.0, 5.0, true), None, "homing reverses by itself");
}

#[test]
fn a_software_limit_clears_itself() {
    let travel = Window { positive: 100.0, negative: -20.0 };
    let mut x =
        limits(LimitSettings { software: BOTH, travel, software_deceleration: 200.0, ..LimitSettings::default() });
    assert_eq!(x.update(level(false, false), 99.9, 5.0, false), None);
    let stop = LimitStop { kind: LimitKind::Software, side: Side::Positive, deceleration: 200.0 };
    assert_eq!(x.update(level(false, false), 100.1, 5.0, false), Some(stop));
    assert_eq!(x.update(level(false, false), 100.2, 0.0, false), None);
    assert!(x.flags().software.positive && !x.flags().hardware.positive);
    assert_eq!(x.update(level(false, false), 100.1, -5.0, false), None);
    assert_eq!(x.update(level(false, false), 99.0, -5.0, false), None);
    assert_eq!(x.flags(), LimitFlags::default());
}

#[test]
fn values_and_inputs_are_read_as_the_commands_have_them() {
    for code in 0..4 {
        assert_eq!(Sides::from_code(code).map(Sides::code), Some(code));
    }
    assert_eq!(Sides::from_code(4), None);
    assert_eq!(limit_inputs(3), [Some(3), Some(4), Some(5)]);
    assert_eq!(limit_inputs(31), [Some(31), None, None]);
    assert_eq!(limit_inputs(62), [Some(62), Some(63), None]);
}

#[test]
fn bands_include_their_ends() {
    let bands = Bands {
        in_position: Window::symmetric(0.1),
        excess_error: Window { positive: 0.2, negative: -0.2 },
        ..Bands::default()
    };
    let flags = bands.flags(0.1, 0.0, 0.0);
    assert!(flags.in_position && flags.error_allowed && flags.in_torque_band);
    let flags = bands.flags(-0.3, 1.0, 1.0);
    assert!(!(flags.in_position || flags.error_allowed || flags.in_torque_band || flags.in_stroke_a));
}

#[test]
fn a_marker_is_captured_once_and_becomes_zero() {
    let mode = CaptureMode::from_number(0).unwrap();
    assert_eq!(mode, CaptureMode { source: CaptureSource::FirstMarker, rising: true });
    assert_eq!(CaptureMode::from_number(7).map(|mode| mode.rising), Some(false));
    assert_eq!(CaptureMode::from_number(8), None);
    let mut capture = Capture::default();
    assert!(!capture.see(mode, 1.0));
    capture.arm(mode);
    let mut seek = MarkerSeek::new();
    assert_eq!(seek.update(&mut capture, true), SeekStep::Wait);
    assert!(!capture.see(CaptureMode { rising: false, ..mode }, 2.0));
    assert!(capture.see(mode, 3.0));
    assert!(!capture.see(mode, 4.0));
    assert_eq!(seek.update(&mut capture, true), SeekStep::StopMove);
    assert_eq!(seek.update(&mut capture, true), SeekStep::Wait);
    assert_eq!(seek.update(&mut capture, false), SeekStep::ReturnTo(3.0));
    assert_eq!(seek.update(&mut capture, true), SeekStep::Wait);
    assert_eq!(seek.update(&mut capture, false), SeekStep::ZeroAt(3.0));
    assert!(seek.is_over() && seek.update(&mut capture, false) == SeekStep::Wait);
    assert_eq!(capture.captured(), Some(3.0));
}

#[test]
fn a_move_that_ends_without_a_marker_has_missed_it() {
    let mut capture = Capture::default();
    capture.arm(CaptureMode::from_number(0).unwrap());
    let mut seek = MarkerSeek::new();
    assert_eq!(seek.update(&mut capture, false), SeekStep::Missed);
    assert!(!capture.see(CaptureMode::from_number(0).unwrap(), 1.0));
    assert_eq!(capture.captured(), None);
}

#[test]
fn a_killed_axis_ramps_down_through_its_jog_offset() {
    let mut x = AxisProfilers::default();
    let settings = JogSettings { velocity: 10.0, ..JogSettings::default() };
    x.jog.set_settings(settings).unwrap();
    x.jog.run(Side::Positive);
    x.gear.set_settings(GearSettings { pulses_per_unit: 1000.0, ..GearSettings::default() }).unwrap();
    x.gear.on();
    let none = |_: usize, _: usize| 0.0;
    let counts = SourceCounts { gear: 10.0, ..SourceCounts::clock(TICK) };
    let mut coordinated = 0.0;
    let mut last = 0.0;
    for _ in 0..1000 {
        coordinated += 30.0 * TICK;
        x.advance(&counts, TICK, &none, &none);
        last = x.registers(coordinated, 0.0).primary_setpoint();
    }
    // 10 by jog, 20 by gear and 30 by its master: 60 u/s, stopped with 100 u/s² in 0.6 s over 18 u.
    assert!((x.velocity() - 30.0).abs() < 1e-9 && (last - 30.0).abs() < 1e-9, "{last}");
    assert!(x.active());
    x.stop(30.0, 100.0).unwrap();
    let jog = x.jog.offset();
    for tick in 1..=1200_u32 {
        x.advance(&counts, TICK, &none, &none);
        let setpoint = x.registers(coordinated, 0.0).primary_setpoint();
        let expected = 60.0 - 100.0 * (f64::from(tick) - 0.5) * TICK;
        assert!(((setpoint - last) / TICK - expected).abs() < 1e-6, "tick {tick}");
        last = setpoint;
    }
    assert!(!x.active());
    assert!((last - 48.0).abs() < 1e-9 && (x.jog.offset() - jog - 18.0).abs() < 1e-9);
}

#[test]
fn a_kill_ends_a_homing_as_failed() {
    let mut x = AxisProfilers::default();
    let inputs = HomeInputs::default();
    x.homing.start(&mut x.jog, Side::Positive, HomingOptions::default(), inputs, 100.0).unwrap();
    x.stop(0.0, 0.0).unwrap();
    assert_eq!(x.homing.status(), HomingStatus::Failed);
}
