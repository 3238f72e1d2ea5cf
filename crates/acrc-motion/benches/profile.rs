//! What planning, sampling and a tick cost, beside an independent planner.
//!
//! Goals: a plan below one microsecond, a sample below 20 nanoseconds.

use std::hint::black_box;

use acrc_motion::{
    Arc, ControlPoint, CurveBuilder, Lookahead, Master, Move, MoveSettings, Profile, ProfileRequest, Span, Target, Turn,
};
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

/// Moves of the kinds that bend, in a queue of 64.
fn curves(criterion: &mut Criterion) {
    let settings = MoveSettings { velocity: 20.0, acceleration: 10.0, deceleration: 10.0, ..MoveSettings::default() };
    let circle = Arc {
        slots: [0, 1],
        target: [0.0, 0.0],
        center: [10.0, 0.0],
        relative_target: false,
        relative_center: false,
        turn: Turn::Clockwise,
    };
    let line = Move::new(settings).to(0, Target::Relative(1.0)).to(1, Target::Relative(0.1));
    let mut group = criterion.benchmark_group("push");
    let one = |looks: bool, jerk: f64| {
        let mut master = Master::new(64);
        master.set_lookahead(looks.then_some(Lookahead { full: 10.0, stop: 90.0 })).expect("the values are valid");
        let mut line = line;
        line.settings.jerk = jerk;
        move |command: Option<&Move>| {
            if !master.can_accept() {
                master.kill();
            }
            master.push(command.unwrap_or(&line))
        }
    };
    let mut plain = one(false, 0.0);
    group.bench_function("line", |b| b.iter(|| plain(None)));
    let arc = Move::new(settings).arc(circle);
    group.bench_function("arc", |b| b.iter(|| plain(Some(black_box(&arc)))));
    let mut looking = one(true, 0.0);
    group.bench_function("line_looking_ahead", |b| b.iter(|| looking(None)));
    let mut bending = one(true, 100.0);
    group.bench_function("s_curve_looking_ahead", |b| b.iter(|| bending(None)));
    let span = span();
    let mut master = Master::new(64);
    group.bench_function("piece_of_a_curve", |b| {
        b.iter(|| {
            if !master.can_accept() {
                master.kill();
            }
            master.push_span(&Move::new(settings), black_box(&span))
        });
    });
    group.finish();

    let mut group = criterion.benchmark_group("tick");
    let slow = MoveSettings { velocity: 1e-9, ..MoveSettings::default() };
    let mut arcs = Master::new(1);
    arcs.push(&Move::new(slow).arc(circle)).expect("the values are valid");
    let mut spans = Master::new(1);
    spans.push_span(&Move::new(slow), &span).expect("the values are valid");
    for (name, master) in [("arc_read", &mut arcs), ("piece_of_a_curve_read", &mut spans)] {
        group.bench_function(name, |b| {
            b.iter(|| {
                let master = black_box(&mut *master);
                master.advance(0.0005);
                (0..2).map(|slot| master.position(slot) + master.velocity(slot)).sum::<f64>()
            });
        });
    }
    group.finish();
}

/// One piece of a spline in two axes.
fn span() -> Span {
    let mut curve = CurveBuilder::spline();
    for (x, y) in [(0.0, 0.0), (5.0, 3.0), (9.0, -2.0)] {
        curve.push(None, Some(&ControlPoint::new().at(0, x).at(1, y))).expect("the values are valid");
    }
    curve.finish().expect("the curve has pieces")
}

criterion_group!(benches, plan, sample, tick, curves);
criterion_main!(benches);
