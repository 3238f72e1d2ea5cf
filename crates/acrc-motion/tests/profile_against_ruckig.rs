//! Jerk-limited profiles from rest to rest against an independent, time-optimal planner.

use acrc_motion::{Profile, ProfileRequest};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use rsruckig::prelude::*;

/// A trajectory of the other planner for the same limits.
fn independent(request: &ProfileRequest) -> Trajectory<1> {
    let mut planner = Ruckig::<1, ThrowErrorHandler>::new(None, 0.001);
    let mut input = InputParameter::new(None);
    input.target_position[0] = request.length;
    input.max_velocity[0] = request.velocity;
    input.max_acceleration[0] = request.acceleration;
    input.max_jerk[0] = request.jerk;
    let mut trajectory = Trajectory::new(None);
    planner.calculate(&input, &mut trajectory).expect("the limits are valid");
    trajectory
}

/// The same cases in every run.
fn config() -> ProptestConfig {
    ProptestConfig { cases: 5000, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..ProptestConfig::default() }
}

prop_compose! {
    fn point_to_point()(
        length in 0.001..1000.0_f64,
        velocity in 0.1..500.0_f64,
        ramp in 0.1..5000.0_f64,
        jerk in 1.0..50_000.0_f64,
    ) -> ProfileRequest {
        ProfileRequest {
            length, velocity, jerk, acceleration: ramp, stop: ramp, ..ProfileRequest::default()
        }
    }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn durations_and_positions_agree(request in point_to_point()) {
        let ours = Profile::plan(&request).unwrap();
        let theirs = independent(&request);
        let duration = theirs.get_duration();
        prop_assert!((ours.duration() - duration).abs() <= 1e-6 * duration, "{} {duration}", ours.duration());
        for part in [0.1, 0.25, 0.5, 0.6, 0.9] {
            let (mut position, mut velocity, mut acceleration) =
                (daov_stack![0.0], daov_stack![0.0], daov_stack![0.0]);
            theirs.at_time(
                part * duration,
                &mut Some(&mut position),
                &mut Some(&mut velocity),
                &mut Some(&mut acceleration),
                &mut None,
                &mut None,
            );
            let state = ours.sample(part * duration);
            prop_assert!((state.position - position[0]).abs() <= 1e-6 * request.length);
            prop_assert!((state.velocity - velocity[0]).abs() <= 1e-6 * ours.peak_velocity());
        }
    }
}
