//! What the profilers of an axis, its servo loop and its machine cost in a tick.
//!
//! Goals: a jog planned below one microsecond and sampled below 20 nanoseconds; 16 axes with the full servo loop 300 times
//! faster than real time, which leaves 1.6 microseconds of each servo period of 500.

use std::hint::black_box;

use acrc_motion::axis::{AxisProfilers, CamSegment, Jog, JogSettings, Side, SourceCounts};
use acrc_motion::servo::{Dac, Drive, Encoder, Motor, MotorModel, Plant, Servo, ServoGains, ServoInputs, VelocityLoop};
use criterion::{Criterion, criterion_group, criterion_main};
use rsruckig::prelude::*;

const PERIOD: f64 = 0.0005;
const PULSES_PER_UNIT: f64 = 1000.0;

fn settings(jerk: f64) -> JogSettings {
    JogSettings { velocity: 20.0, acceleration: 100.0, deceleration: 100.0, jerk, ..JogSettings::default() }
}

/// A jog in the middle of its first ramp.
fn started(jerk: f64) -> Jog {
    let mut jog = Jog::new();
    jog.set_settings(settings(jerk)).expect("the values are valid");
    jog.run(Side::Positive);
    jog.advance(0.05);
    jog
}

fn plan(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("jog_plan");
    for (name, jerk, distance) in
        [("straight", 0.0, 50.0), ("from_an_s_curve", 1000.0, 50.0), ("short_from_an_s_curve", 1000.0, 1.0)]
    {
        let mut jog = started(jerk);
        let target = jog.offset() + distance;
        group.bench_function(name, |b| b.iter(|| black_box(&mut jog).to_offset(target)));
    }
    group.bench_function("rsruckig_short_from_an_s_curve", |b| {
        let state = started(1000.0).state();
        let mut planner = Ruckig::<1, ThrowErrorHandler>::new(None, 0.001);
        let mut input = InputParameter::new(None);
        input.current_velocity[0] = state.velocity;
        input.current_acceleration[0] = state.acceleration;
        input.target_position[0] = 1.0;
        input.max_velocity[0] = 20.0;
        input.max_acceleration[0] = 100.0;
        input.max_jerk[0] = 1000.0;
        let mut trajectory = Trajectory::new(None);
        b.iter(|| planner.calculate(black_box(&input), &mut trajectory).is_ok());
    });
    group.finish();
}

fn motor() -> Motor {
    Motor::new(MotorModel {
        inertia: 1e-4,
        torque_per_volt: 0.157,
        viscous_friction: 4e-4,
        coulomb_friction: 0.01,
        load_torque: 0.0,
        encoder: Encoder::new(1000.0, 4).expect("the values are valid"),
    })
    .expect("the values are valid")
}

/// Every term and both filters in use.
fn full_gains() -> ServoGains {
    ServoGains {
        proportional: 0.005,
        integral: 0.01,
        integral_limit: 1.0,
        derivative: 3e-5,
        velocity_feedforward: 1e-5,
        acceleration_feedforward: 1e-8,
        velocity_feedback: 1e-6,
        velocity_loop: VelocityLoop { proportional: 0.1, integral: 0.1, feedforward: 0.0 },
        notch: (200.0, 20.0),
        low_pass: 500.0,
        ..ServoGains::default()
    }
}

/// One axis as a controller has it.
struct Axis {
    profilers: AxisProfilers,
    servo: Servo,
    dac: Dac,
    plant: Plant,
}

impl Axis {
    fn new() -> Self {
        let mut profilers = AxisProfilers { jog: started(1000.0), ..AxisProfilers::default() };
        profilers.gear.on();
        profilers.cam.dim(1);
        profilers.cam.set_segment(0, CamSegment { length: 4000.0, points: 100 }).expect("the values are valid");
        profilers.cam.on();
        let mut servo = Servo::new(PERIOD).expect("the values are valid");
        servo.set_gains(full_gains()).expect("the values are valid");
        Self { profilers, servo, dac: Dac::default(), plant: Plant::Motor(motor()) }
    }

    fn tick(&mut self, coordinated: f64) -> f64 {
        let counts = SourceCounts { gear: 0.01, cam: 3.0, ..SourceCounts::clock(PERIOD) };
        self.profilers.advance(&counts, PERIOD, &|_, index| index as f64 / 100.0, &|_, _| 0.0);
        let actual = self.plant.counted();
        let registers = self.profilers.registers(coordinated, actual / PULSES_PER_UNIT);
        let setpoint = registers.secondary_setpoint() * PULSES_PER_UNIT;
        let output = self.servo.update(&ServoInputs { setpoint, actual, moving: true });
        self.plant.advance(&Drive { volts: self.dac.terminal(output.volts), setpoint, enabled: true }, PERIOD);
        output.following_error
    }
}

fn tick(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("axis_tick");
    let mut jog = started(1000.0);
    group.bench_function("jog", |b| b.iter(|| black_box(&mut jog).advance(PERIOD)));
    let mut servo = Servo::new(PERIOD).expect("the values are valid");
    servo.set_gains(full_gains()).expect("the values are valid");
    let inputs = ServoInputs { setpoint: 10.0, actual: 3.0, moving: true };
    group.bench_function("servo", |b| b.iter(|| black_box(&mut servo).update(black_box(&inputs))));
    let mut machine = motor();
    group.bench_function("motor", |b| b.iter(|| black_box(&mut machine).advance(black_box(Some(1.0)), PERIOD)));
    let mut axis = Axis::new();
    let counts = SourceCounts { gear: 1.0, cam: 3.0, ..SourceCounts::clock(PERIOD) };
    group.bench_function("profilers", |b| {
        b.iter(|| {
            let profilers = &mut black_box(&mut axis).profilers;
            profilers.advance(&counts, PERIOD, &|_, index| index as f64, &|_, _| 0.0);
            profilers.registers(1.0, 2.0).secondary_setpoint()
        });
    });
    let mut axes: Vec<Axis> = (0..16).map(|_| Axis::new()).collect();
    group.bench_function("sixteen_axes", |b| {
        b.iter(|| black_box(&mut axes).iter_mut().map(|axis| axis.tick(black_box(1.0))).sum::<f64>());
    });
    group.finish();
}

criterion_group!(benches, plan, tick);
criterion_main!(benches);
