//! The servo loop term by term, its filters, and the machines it drives against their exact solutions.

use std::f64::consts::TAU;

use acrc_motion::axis::Window;
use acrc_motion::servo::{
    Dac, DeadZone, Drive, Encoder, Motor, MotorModel, Plant, Servo, ServoGains, ServoInputs, ServoOutput, Stepper,
    VelocityLoop,
};
use proptest::prelude::*;

const PERIOD: f64 = 0.0005;
/// A loop with nothing in it.
const OFF: f64 = 0.0;

fn off() -> ServoGains {
    ServoGains { proportional: OFF, ..ServoGains::default() }
}

fn servo(gains: ServoGains) -> Servo {
    let mut servo = Servo::new(PERIOD).unwrap();
    servo.set_gains(gains).unwrap();
    servo
}

fn at(setpoint: f64, actual: f64) -> ServoInputs {
    ServoInputs { setpoint, actual, moving: false }
}

fn close(a: f64, b: f64, slack: f64) -> bool {
    (a - b).abs() <= slack * a.abs().max(b.abs()).max(1.0)
}

#[test]
fn every_term_has_its_gain() {
    let gains = ServoGains {
        proportional: 0.01,
        derivative: 0.001,
        velocity_feedforward: 0.002,
        acceleration_feedforward: 1e-6,
        velocity_feedback: 0.004,
        ..off()
    };
    let mut x = servo(gains);
    let first = x.update(&at(10.0, 0.0));
    let expected = ServoOutput { following_error: 10.0, proportional: 0.1, volts: 0.1, ..ServoOutput::default() };
    assert_eq!(first, expected, "nothing is known of the past");
    // In one period: setpoint 20, actual 1. Velocities 20,000 and 2,000, acceleration 4e7, change of the error 18,000.
    let next = x.update(&at(20.0, 1.0));
    assert_eq!(next.following_error, 19.0);
    for (term, expected) in [
        (next.proportional, 0.19),
        (next.derivative, 18.0),
        (next.velocity_feedforward, 40.0),
        (next.acceleration_feedforward, 40.0),
        (next.velocity_feedback, 8.0),
    ] {
        assert!(close(term, expected, 1e-12), "{next:?}");
    }
    assert!(next.limited && next.volts == 10.0);
    x.reset();
    assert_eq!(x.update(&at(10.0, 0.0)), expected);
}

#[test]
fn the_integral_waits_for_the_end_of_motion_and_keeps_its_limit() {
    let gains = ServoGains { integral: 2.0, integral_limit: 0.5, integral_delay: 0.01, ..off() };
    let mut x = servo(gains);
    let moving = ServoInputs { moving: true, ..at(10.0, 0.0) };
    assert_eq!((0..100).map(|_| x.update(&moving).integral).fold(0.0, f64::max), 0.0);
    let waits = (0..100).take_while(|_| x.update(&at(10.0, 0.0)).integral == 0.0).count();
    assert_eq!(waits, 20);
    let grown = (0..10).map(|_| x.update(&at(10.0, 0.0)).integral).last().unwrap();
    assert!(close(grown, 11.0 * 2.0 * 10.0 * PERIOD, 1e-12), "{grown}");
    let limited = (0..1000).map(|_| x.update(&at(10.0, 0.0)).integral).last();
    assert_eq!(limited, Some(0.5));
    let mut without_limit = servo(ServoGains { integral: 2.0, ..off() });
    assert_eq!(without_limit.update(&at(10.0, 0.0)).integral, 0.0);
}

#[test]
fn the_derivative_is_sampled_at_its_width() {
    let mut x = servo(ServoGains { derivative: 1e-3, derivative_width: 0.002, ..off() });
    let terms: Vec<f64> = (0..9).map(|tick| x.update(&at(f64::from(tick), 0.0)).derivative).collect();
    // Four periods a sample, and the first of them begins with the first period.
    let expected = [0.0, 0.0, 0.0, 1.5, 1.5, 1.5, 1.5, 2.0, 2.0];
    assert!(terms.iter().zip(expected).all(|(term, expected)| close(*term, expected, 1e-9)), "{terms:?}");
}

#[test]
fn the_velocity_loop_goes_at_the_velocity_it_is_told() {
    let velocity_loop = VelocityLoop { proportional: 0.001, integral: 0.02, feedforward: 1.0 };
    let mut x = servo(ServoGains { proportional: 50.0, velocity_loop, ..off() });
    x.update(&at(0.0, 0.0));
    // Setpoint velocity 2,000, actual velocity 1,000, position part 50 * 0.5.
    let output = x.update(&at(1.0, 0.5));
    let error = 25.0 + 2000.0 - 1000.0;
    assert!(close(output.volts, 0.001 * error + 0.02 * error * PERIOD, 1e-12), "{output:?}");
}

#[test]
fn outside_the_dead_zone_volts_are_added() {
    let dead_zone = DeadZone { inner: 2.0, outer: 6.0, positive: 1.0, negative: 0.5 };
    let mut x = servo(ServoGains { dead_zone, ..off() });
    let volts = [0.0, 2.0, 4.0, 6.0, 9.0, -2.0, -4.0, -7.0].map(|error| x.update(&at(error, 0.0)).volts);
    assert_eq!(volts, [0.0, 0.0, 0.5, 1.0, 1.0, 0.0, -0.25, -0.5]);
    let mut step = servo(ServoGains { dead_zone: DeadZone { inner: 2.0, outer: 0.0, ..dead_zone }, ..off() });
    assert_eq!([2.0, 2.1].map(|error| step.update(&at(error, 0.0)).volts), [0.0, 1.0]);
}

/// Gain of a loop with a proportional gain of one for a sine of a frequency, once it has settled.
fn gain_at(gains: ServoGains, frequency: f64) -> f64 {
    let mut x = servo(ServoGains { proportional: 1.0, torque_limit: Window::symmetric(1e9), ..gains });
    let volts = (0..40_000_u32).map(|tick| {
        let time = f64::from(tick) * PERIOD;
        x.update(&at((TAU * frequency * time).sin(), 0.0)).volts
    });
    volts.skip(20_000).fold(0.0, |peak: f64, volts| peak.max(volts.abs()))
}

#[test]
fn filters_pass_and_stop_what_they_say() {
    let low = ServoGains { low_pass: 100.0, ..off() };
    assert!(close(gain_at(low, 1.0), 1.0, 1e-3));
    assert!(close(gain_at(low, 100.0), 0.5_f64.sqrt(), 1e-3));
    assert!(gain_at(low, 400.0) < 0.06);
    let notch = ServoGains { notch: (100.0, 20.0), ..off() };
    assert!(gain_at(notch, 100.0) < 1e-3);
    assert!(close(gain_at(notch, 10.0), 1.0, 1e-2) && close(gain_at(notch, 401.0), 1.0, 1e-2));
    // The half-power points lie a width apart, the centre at their geometric mean.
    let half = 100.0 * (0.1 + 1.01_f64.sqrt());
    assert!(close(gain_at(notch, half), 0.5_f64.sqrt(), 1e-2), "{}", gain_at(notch, half));
    let beyond = ServoGains { low_pass: 1000.0, notch: (5.0, 0.0), ..off() };
    assert_eq!(gain_at(beyond, 1.0), gain_at(off(), 1.0));
}

#[test]
fn the_output_is_converted_and_the_encoder_counts() {
    let dac = Dac::default();
    assert_eq!(
        [0.0, 1.0, -1.0, 10.0, 11.0, -11.0].map(|volts| dac.counts(volts)),
        [0, 3277, -3277, 32767, 32767, -32768]
    );
    assert!(close(dac.terminal(5.0), 5.0, 1e-4));
    let turned = Dac { gain: -3276.8, offset: 0.5 };
    assert_eq!(turned.counts(1.0), -4915);
    let encoder = Encoder::new(1000.0, 4).unwrap();
    assert_eq!(encoder.pulses_per_turn(), 4000.0);
    assert_eq!([0.0, 0.000_26, -0.000_01, 1.0].map(|turns| encoder.count(turns)), [0.0, 1.0, -1.0, 4000.0]);
    assert_eq!(Encoder::new(1000.0, -4).unwrap().count(1.0), -4000.0);
    let message = Encoder::new(1000.0, 3).unwrap_err().to_string();
    assert_eq!(message, "encoder multiplier is 3, but has to be -4, -2, -1, 0, 1, 2 or 4");
}

fn model() -> MotorModel {
    MotorModel {
        inertia: 1e-4,
        torque_per_volt: 0.1,
        viscous_friction: 0.0,
        coulomb_friction: 0.0,
        load_torque: 0.0,
        encoder: Encoder::new(1000.0, 4).unwrap(),
    }
}

#[test]
fn a_motor_without_friction_accelerates_evenly() {
    let mut motor = Motor::new(model()).unwrap();
    for _ in 0..1000 {
        motor.advance(Some(2.0), PERIOD);
    }
    // 0.2 N m at 1e-4 kg m² is 2,000 rad/s²; half a second.
    assert!(close(motor.velocity() * TAU, 1000.0, 1e-9));
    assert!(close(motor.angle() * TAU, 250.0, 1e-9));
    motor.advance(None, 1.0);
    assert!(close(motor.velocity() * TAU, 1000.0, 1e-9), "it coasts");
}

#[test]
fn viscous_friction_leads_to_a_final_velocity() {
    let viscous_friction = 1e-3;
    let mut motor = Motor::new(MotorModel { viscous_friction, ..model() }).unwrap();
    let time_constant = 1e-4 / viscous_friction;
    for tick in 1..=1000_u32 {
        motor.advance(Some(1.0), PERIOD);
        let part = 1.0 - (-f64::from(tick) * PERIOD / time_constant).exp();
        assert!(close(motor.velocity() * TAU, 100.0 * part, 1e-9));
    }
}

#[test]
fn dry_friction_holds_and_brakes() {
    let mut motor = Motor::new(MotorModel { coulomb_friction: 0.05, ..model() }).unwrap();
    motor.advance(Some(0.4), PERIOD);
    assert_eq!(motor.velocity(), 0.0);
    for _ in 0..200 {
        motor.advance(Some(1.0), PERIOD);
    }
    // (0.1 - 0.05) / 1e-4 = 500 rad/s² for 0.1 s: 50 rad/s and 2.5 rad; the same again to stop.
    assert!(close(motor.velocity() * TAU, 50.0, 1e-9));
    motor.advance(None, 1.0);
    assert_eq!(motor.velocity(), 0.0);
    assert!(close(motor.angle() * TAU, 5.0, 1e-9), "{}", motor.angle() * TAU);
}

#[test]
fn a_weight_turns_a_motor_whose_drive_goes_off() {
    let weight = MotorModel { load_torque: -0.1, ..model() };
    let mut plant = Plant::Motor(Motor::new(weight).unwrap());
    let on = Drive { volts: 1.0, setpoint: 0.0, enabled: true };
    plant.advance(&on, 1.0);
    assert_eq!(plant.counted(), 0.0);
    plant.advance(&Drive { enabled: false, ..on }, 0.1);
    assert_eq!(plant.counted(), (-0.5 * 1000.0 * 0.01 / TAU * 4000.0).floor());
}

#[test]
fn ideal_axes_and_steppers_follow_their_setpoint() {
    let mut ideal = Plant::default();
    ideal.advance(&Drive { setpoint: 12.5, ..Drive::default() }, PERIOD);
    assert_eq!(ideal.counted(), 12.5);
    let mut stepper = Plant::Stepper(Stepper::new(10_000.0).unwrap());
    let counts = [3.4, 5.0, 5.6, 20.0, 21.0].map(|setpoint| {
        stepper.advance(&Drive { setpoint, volts: 0.0, enabled: true }, PERIOD);
        stepper.counted()
    });
    assert_eq!(counts, [3.0, 5.0, 6.0, 11.0, 12.0], "14 steps in a period are 9 too many");
    stepper.advance(&Drive { setpoint: 25.0, volts: 0.0, enabled: false }, PERIOD);
    stepper.advance(&Drive { setpoint: 26.0, volts: 0.0, enabled: true }, PERIOD);
    assert_eq!(stepper.counted(), 13.0);
}

#[test]
fn a_loop_is_steady_when_another_period_would_change_nothing() {
    let gains = ServoGains { integral: 2.0, integral_limit: 5.0, derivative: 0.001, ..off() };
    let mut x = servo(gains);
    assert!(!x.is_steady(), "nothing is known yet");
    x.update(&at(0.0, 0.0));
    x.update(&at(0.0, 0.0));
    assert!(x.is_steady(), "no error, nothing moves");
    x.update(&at(1.0, 0.0));
    x.update(&at(1.0, 0.0));
    assert!(!x.is_steady(), "the integral grows");
    for _ in 0..6000 {
        x.update(&at(1.0, 0.0));
    }
    assert!(x.is_steady(), "it has met its limit");
    x.set_gains(ServoGains { derivative_width: 0.002, ..gains }).unwrap();
    assert!(!x.is_steady(), "gains have changed");
    for _ in 0..20 {
        x.update(&at(1.0, 0.0));
        assert!(!x.is_steady(), "when the change is sampled next depends on the period");
    }
    let mut y = servo(ServoGains { integral_delay: 0.01, ..gains });
    for period in 1..40 {
        y.update(&at(0.0, 0.0));
        assert_eq!(y.is_steady(), period > 20, "the integral does not grow before: {period}");
    }
}

#[test]
fn what_is_held_does_not_move() {
    let drive = Drive { volts: 3.0, setpoint: 40.0, enabled: true };
    let mut motor = Plant::Motor(Motor::new(model()).unwrap());
    (0..100).for_each(|_| motor.advance(&drive, PERIOD));
    let there = motor.counted();
    motor.jam(&drive);
    motor.advance(&Drive::default(), PERIOD);
    assert!(there > 0.0 && motor.counted() == there, "it stands");
    let mut stepper = Plant::Stepper(Stepper::new(0.0).unwrap());
    stepper.jam(&drive);
    stepper.advance(&Drive { setpoint: 45.0, ..drive }, PERIOD);
    assert_eq!(stepper.counted(), 5.0, "40 steps were lost");
    stepper.match_setpoint(5.0);
    stepper.advance(&Drive { setpoint: 5.0, ..drive }, PERIOD);
    assert_eq!(stepper.counted(), 5.0, "no step to get there");
}

#[test]
fn impossible_values_are_refused() {
    assert!(Servo::new(0.0).is_err());
    let mut x = Servo::new(PERIOD).unwrap();
    assert!(x.set_gains(ServoGains { proportional: f64::NAN, ..off() }).is_err());
    assert!(x.set_gains(ServoGains { low_pass: -1.0, ..off() }).is_err());
    assert_eq!(*x.gains(), ServoGains::default());
    let message = Motor::new(MotorModel { inertia: 0.0, ..model() }).unwrap_err().to_string();
    assert_eq!(message, "inertia is zero (0)");
}

proptest! {
    #[test]
    fn a_motor_does_not_care_how_time_is_cut(
        volts in -10.0..10.0_f64,
        before in -10.0..10.0_f64,
        viscous in prop_oneof![Just(0.0), 1e-7..1e-2_f64],
        coulomb in prop_oneof![Just(0.0), 0.0..0.5_f64],
        parts in 2..50_u32,
    ) {
        let model = MotorModel { viscous_friction: viscous, coulomb_friction: coulomb, ..model() };
        let mut whole = Motor::new(model).unwrap();
        whole.advance(Some(before), 0.01);
        let mut cut = whole;
        whole.advance(Some(volts), 0.02);
        for _ in 0..parts {
            cut.advance(Some(volts), 0.02 / f64::from(parts));
        }
        prop_assert!(close(whole.velocity(), cut.velocity(), 1e-9), "{} {}", whole.velocity(), cut.velocity());
        prop_assert!(close(whole.angle(), cut.angle(), 1e-9), "{} {}", whole.angle(), cut.angle());
    }
}
