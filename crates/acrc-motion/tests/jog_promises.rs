//! What the jog profiler promises, on random sequences of commands: nothing jumps, no limit is exceeded, targets are met.

use acrc_motion::axis::{AxisState, Jog, JogSettings, Side};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

#[derive(Clone, Copy, Debug)]
enum Command {
    To(f64),
    By(f64),
    Run(Side),
    Off,
    Set(JogSettings),
}

fn settings(jerk: impl Strategy<Value = f64>) -> impl Strategy<Value = JogSettings> {
    (0.5..30.0, 5.0..200.0, 5.0..200.0, jerk).prop_map(|(velocity, acceleration, deceleration, jerk)| JogSettings {
        velocity,
        acceleration,
        deceleration,
        jerk,
        ..JogSettings::default()
    })
}

fn jerk() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), 20.0..5000.0]
}

fn command(jerk: impl Strategy<Value = f64>) -> impl Strategy<Value = Command> {
    prop_oneof![
        (-50.0..50.0).prop_map(Command::To),
        (-20.0..20.0).prop_map(Command::By),
        prop_oneof![Just(Side::Positive), Just(Side::Negative)].prop_map(Command::Run),
        Just(Command::Off),
        settings(jerk).prop_map(Command::Set),
    ]
}

fn give(jog: &mut Jog, command: Command) {
    match command {
        Command::To(target) => jog.to_offset(target).unwrap(),
        Command::By(distance) => jog.by_distance(distance).unwrap(),
        Command::Run(side) => jog.run(side),
        Command::Off => jog.off(),
        Command::Set(settings) => jog.set_settings(settings).unwrap(),
    }
}

/// Checks one tick of `dt` seconds against the greatest ramps of the run.
fn check(from: AxisState, to: AxisState, dt: f64, greatest: &JogSettings) -> Result<(), TestCaseError> {
    let ramp = greatest.acceleration.max(greatest.deceleration);
    let step = to.velocity - from.velocity;
    prop_assert!(step.abs() <= ramp * dt * (1.0 + 1e-6) + 1e-7, "velocity jumps: {from:?} {to:?}");
    let mean = f64::midpoint(from.velocity, to.velocity) * dt;
    let bend = ramp * dt * dt;
    prop_assert!((to.position - from.position - mean).abs() <= bend + 1e-7, "position jumps: {from:?} {to:?}");
    prop_assert!(to.acceleration.abs() <= ramp * (1.0 + 1e-9), "acceleration: {to:?}");
    Ok(())
}

fn follow(first: JogSettings, commands: &[(Command, u32)], curved: bool) -> Result<(), TestCaseError> {
    let dt = 0.002;
    let mut greatest = first;
    for (command, _) in commands {
        if let Command::Set(next) = command {
            greatest.velocity = greatest.velocity.max(next.velocity);
            greatest.acceleration = greatest.acceleration.max(next.acceleration);
            greatest.deceleration = greatest.deceleration.max(next.deceleration);
            greatest.jerk = greatest.jerk.max(next.jerk);
        }
    }
    let mut jog = Jog::new();
    jog.set_settings(first).unwrap();
    for (command, ticks) in commands {
        give(&mut jog, *command);
        for _ in 0..*ticks {
            let from = jog.state();
            jog.advance(dt);
            let to = jog.state();
            check(from, to, dt, &greatest)?;
            if curved {
                let change = (to.acceleration - from.acceleration).abs();
                prop_assert!(change <= greatest.jerk * dt * (1.0 + 1e-6) + 1e-5, "acceleration jumps: {from:?} {to:?}");
            }
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(
        ProptestConfig { cases: 2000, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..ProptestConfig::default() }
    )]

    #[test]
    fn nothing_jumps_whatever_is_commanded(
        first in settings(jerk()),
        commands in prop::collection::vec((command(jerk()), 1..400_u32), 1..8),
    ) {
        follow(first, &commands, false)?;
    }

    #[test]
    fn with_a_jerk_the_acceleration_does_not_jump_either(
        first in settings(20.0..5000.0),
        commands in prop::collection::vec((command(20.0..5000.0), 1..400_u32), 1..8),
    ) {
        follow(first, &commands, true)?;
    }

    #[test]
    fn a_target_is_met_exactly_and_when_it_was_announced(
        first in settings(jerk()),
        second in settings(jerk()),
        side in prop_oneof![Just(Side::Positive), Just(Side::Negative)],
        before in 0..1500_u32,
        target in -50.0..50.0_f64,
    ) {
        let dt = 0.001;
        let mut jog = Jog::new();
        jog.set_settings(first).unwrap();
        jog.run(side);
        for _ in 0..before {
            jog.advance(dt);
        }
        jog.set_settings(second).unwrap();
        jog.to_offset(target).unwrap();
        let announced = jog.remaining().expect("it ends");
        let mut ticks = 0_u32;
        while !jog.advance(dt).finished {
            ticks += 1;
        }
        prop_assert_eq!(jog.state(), AxisState { position: target, ..AxisState::default() });
        let taken = f64::from(ticks + 1) * dt;
        prop_assert!(taken >= announced - 1e-9 && taken < announced + dt + 1e-9, "{} {}", taken, announced);
    }

    #[test]
    fn the_same_command_again_changes_nothing(
        first in settings(jerk()),
        distance in 0.5..50.0_f64,
        part in 0.01..0.99_f64,
    ) {
        let mut jog = Jog::new();
        jog.set_settings(first).unwrap();
        jog.to_offset(distance).unwrap();
        let whole = jog.remaining().expect("it ends");
        jog.advance(whole * part);
        let (before, left) = (jog.clone(), jog.remaining().expect("it ends"));
        jog.to_offset(distance).unwrap();
        prop_assert!((jog.remaining().expect("it ends") - left).abs() <= 1e-6 * whole, "{:?} {:?}", jog.remaining(), left);
        let (mut kept, mut again) = (before, jog);
        kept.advance(left / 2.0);
        again.advance(left / 2.0);
        prop_assert!((kept.offset() - again.offset()).abs() <= 1e-6 * distance);
    }
}
