//! What planning, sampling and a tick cost, beside an independent planner.
//!
//! Goals: a plan below one microsecond, a sample below 20 nanoseconds.

use std::hint::black_box;

use acrc_motion::{Master, Move, MoveSettings, Profile, ProfileRequest, Target};
use criterion::{Criterion, criterion_group, criterion_main};
use rsruckig::prelude::*;

const STRAIGHT: ProfileRequest = ProfileRequest {
    length: 200.0,
    start_velocity: 0.0,
    velocity: 20.0,
    acceleration: 10.0,
    deceleration: 10.0,
    stop: 10.0,
    final_velocity: 0.0,
    jerk: 0.0,
};

fn requests() -> [(&'static str, ProfileRequest); 5] {
    let short = ProfileRequest { length: 3.0, ..STRAIGHT };
    [
        ("trapezoid", STRAIGHT),
        ("triangle", short),
        ("s_curve", ProfileRequest { jerk: 100.0, ..STRAIGHT }),
        ("short_s_curve", ProfileRequest { jerk: 100.0, ..short }),
        ("short_blended_s_curve", ProfileRequest { jerk: 100.0, start_velocity: 2.0, final_velocity: 1.0, ..short }),
    ]
}

fn plan(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("plan");
    for (name, request) in requests() {
        group.bench_function(name, |b| b.iter(|| Profile::plan(black_box(&request))));
    }
    let short = ProfileRequest { jerk: 100.0, length: 3.0, ..STRAIGHT };
    group.bench_function("rsruckig_short_s_curve", |b| {
        let mut planner = Ruckig::<1, ThrowErrorHandler>::new(None, 0.001);
        let mut input = InputParameter::new(None);
        input.target_position[0] = short.length;
        input.max_velocity[0] = short.velocity;
        input.max_acceleration[0] = short.acceleration;
        input.max_jerk[0] = short.jerk;
        let mut trajectory = Trajectory::new(None);
        b.iter(|| planner.calculate(black_box(&input), &mut trajectory).is_ok());
    });
    group.finish();
}

fn sample(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("sample");
    for (name, request) in requests() {
        let profile = Profile::plan(&request).expect("the values are valid");
        let step = profile.duration() / 1009.0;
        let mut time = 0.0;
        group.bench_function(name, |b| {
            b.iter(|| {
                time = if time > profile.duration() { 0.0 } else { time + step };
                profile.sample(black_box(time))
            });
        });
    }
    group.finish();
}

/// A master with eight axes on a move that outlasts the measurement.
fn eight_axes() -> Master {
    let mut master = Master::new(1);
    let settings = MoveSettings { velocity: 1.0, acceleration: 1.0, stop: 1.0, ..MoveSettings::default() };
    let command = (0_u8..8).fold(Move::new(settings), |command, slot| {
        command.to(usize::from(slot), Target::Absolute(1e9 * f64::from(slot + 1)))
    });
    master.push(&command).expect("the values are valid");
    master
}

fn tick(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("tick");
    let mut master = eight_axes();
    group.bench_function("eight_axes", |b| b.iter(|| black_box(&mut master).advance(0.0005)));
    group.bench_function("eight_axes_read", |b| {
        b.iter(|| {
            let master = black_box(&mut master);
            master.advance(0.0005);
            (0..8).map(|slot| master.position(slot) + master.velocity(slot)).sum::<f64>()
        });
    });
    group.finish();
}

criterion_group!(benches, plan, sample, tick);
criterion_main!(benches);
