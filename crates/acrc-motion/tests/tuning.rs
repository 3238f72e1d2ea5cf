//! The guide's tuning example in shape, with its gains: how the motor goes to a setpoint that it is a step away from, at
//! nine stages of tuning, first bare, then with a load of nine times its inertia.
//!
//! The guide says no more of the motor than this ratio. The torque per volt is chosen so that the gains of its third stage
//! damp a little more than needed, as it says; what the other stages show follows from that.

use acrc_motion::servo::{Dac, Drive, Encoder, Motor, MotorModel, Plant, Servo, ServoGains, ServoInputs};

const PERIOD: f64 = 0.0005;
/// Height of the step, pulses.
const STEP: f64 = 100.0;

/// How the motor answered a step.
#[derive(Clone, Copy, Debug)]
struct Response {
    /// Time to nine tenths of the step, s.
    rise: f64,
    /// How far it went beyond, as a part of the step.
    overshoot: f64,
    /// When it was within a twentieth of the step for good, s.
    settled: f64,
}

/// Steps with a proportional and a derivative gain, and a load of some times the motor's inertia.
fn step(proportional: f64, derivative: f64, load: f64) -> Response {
    let motor = MotorModel {
        inertia: 2e-5 * (1.0 + load),
        torque_per_volt: 0.157,
        viscous_friction: 4e-4,
        coulomb_friction: 0.0,
        load_torque: 0.0,
        encoder: Encoder::new(4000.0, 4).unwrap(),
    };
    let mut plant = Plant::Motor(Motor::new(motor).unwrap());
    let mut servo = Servo::new(PERIOD).unwrap();
    servo.set_gains(ServoGains { proportional, derivative, ..ServoGains::default() }).unwrap();
    let dac = Dac::default();
    let mut response = Response { rise: f64::INFINITY, overshoot: 0.0, settled: 0.0 };
    for tick in 0..4000_u32 {
        let time = f64::from(tick) * PERIOD;
        let actual = plant.counted();
        if actual >= 0.9 * STEP {
            response.rise = response.rise.min(time);
        }
        response.overshoot = response.overshoot.max(actual / STEP - 1.0);
        if (actual - STEP).abs() > 0.05 * STEP {
            response.settled = time;
        }
        let output = servo.update(&ServoInputs { setpoint: STEP, actual, moving: false });
        plant.advance(&Drive { volts: dac.terminal(output.volts), setpoint: STEP, enabled: true }, PERIOD);
    }
    response
}

#[test]
fn raising_pgain_is_faster_and_rings_and_dgain_damps() {
    let first = step(0.0003, 0.0, 0.0);
    let second = step(0.0005, 0.0, 0.0);
    assert!(second.rise < 0.9 * first.rise, "responds faster: {first:?} {second:?}");
    assert!(second.overshoot > 0.5, "and is under-damped: {second:?}");

    let third = step(0.0005, 0.000_01, 0.0);
    assert!(third.overshoot == 0.0 && third.settled < second.settled / 2.0, "slightly over-damped: {third:?}");

    let fourth = step(0.001, 0.000_01, 0.0);
    assert!(fourth.rise < third.rise && fourth.settled < third.settled, "faster: {third:?} {fourth:?}");
    assert!(fourth.overshoot < 0.1, "with settling as good: {fourth:?}");

    let fifth = step(0.005, 0.000_01, 0.0);
    assert!(fifth.rise < fourth.rise, "faster again: {fourth:?} {fifth:?}");
    assert!(fifth.overshoot > 3.0 * fourth.overshoot, "with more oscillation: {fourth:?} {fifth:?}");

    let sixth = step(0.005, 0.000_03, 0.0);
    assert!(sixth.overshoot < fifth.overshoot / 3.0, "damped: {fifth:?} {sixth:?}");
    assert!(
        sixth.settled < fourth.settled && sixth.settled < fifth.settled,
        "response and damping look good: {sixth:?}"
    );
}

#[test]
fn a_load_slows_the_response_and_weakens_the_damping_until_it_is_tuned_again() {
    let sixth = step(0.005, 0.000_03, 0.0);
    let seventh = step(0.005, 0.000_03, 9.0);
    assert!(seventh.rise > 1.4 * sixth.rise, "slower: {sixth:?} {seventh:?}");
    assert!(seventh.overshoot > 2.0 * sixth.overshoot, "damped less: {sixth:?} {seventh:?}");

    let eighth = step(0.02, 0.000_03, 9.0);
    assert!(eighth.rise < 0.7 * seventh.rise, "faster: {seventh:?} {eighth:?}");
    assert!(eighth.overshoot > seventh.overshoot, "still oscillating: {seventh:?} {eighth:?}");

    let ninth = step(0.02, 0.000_15, 9.0);
    assert!(ninth.overshoot < eighth.overshoot / 3.0, "{eighth:?} {ninth:?}");
    assert!(ninth.settled < eighth.settled / 3.0, "fast and stable: {eighth:?} {ninth:?}");
}
