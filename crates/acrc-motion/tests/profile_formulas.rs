//! Profiles against formulas that can be worked out by hand.

use acrc_motion::{InvalidValue, Profile, ProfileError, ProfileRequest, Quantity};

fn plan(request: ProfileRequest) -> Profile {
    Profile::plan(&request).expect("the values are valid")
}

/// A request whose three ramps are alike.
fn ramps(length: f64, velocity: f64, ramp: f64) -> ProfileRequest {
    ProfileRequest { length, velocity, acceleration: ramp, deceleration: ramp, stop: ramp, ..ProfileRequest::default() }
}

#[track_caller]
fn assert_near(actual: f64, expected: f64) {
    assert!((actual - expected).abs() <= 1e-12 * expected.abs().max(1.0), "{actual} is not {expected}");
}

#[test]
fn two_hundred_revolutions_take_twelve_seconds() {
    let profile = plan(ramps(200.0, 20.0, 10.0));
    assert_eq!(profile.duration(), 12.0); // 200 / 20 + 20 / 10
    assert_eq!(profile.peak_velocity(), 20.0);
    assert_eq!(profile.peak_acceleration(), 10.0);
    // 2 s and 20 u up, 8 s and 160 u across, 2 s and 20 u down.
    for (time, position, velocity, acceleration) in [
        (0.0, 0.0, 0.0, 10.0),
        (1.0, 5.0, 10.0, 10.0),
        (2.0, 20.0, 20.0, 0.0),
        (6.0, 100.0, 20.0, 0.0),
        (10.0, 180.0, 20.0, -10.0),
        (11.0, 195.0, 10.0, -10.0),
        (12.0, 200.0, 0.0, 0.0),
    ] {
        let state = profile.sample(time);
        assert_eq!((state.position, state.velocity, state.acceleration), (position, velocity, acceleration));
    }
}

#[test]
fn a_vector_of_two_axes() {
    let length = (25.0_f64 * 25.0 + 15.0 * 15.0).sqrt();
    let profile = plan(ramps(length, 75.0, 750.0));
    assert_near(profile.duration(), length / 75.0 + 75.0 / 750.0);
    assert_eq!((profile.duration() * 1e5).round() / 1e5, 0.48873);
}

#[test]
fn a_triangle_touches_the_velocity() {
    assert_eq!(plan(ramps(5.0, 10.0, 20.0)).duration(), 1.0);
}

#[test]
fn a_short_path_has_a_lower_peak() {
    let request = ProfileRequest { acceleration: 2.0, stop: 6.0, ..ramps(3.0, 100.0, 1.0) };
    let profile = plan(request);
    // v²/(2·2) + v²/(2·6) = 3
    assert_near(profile.peak_velocity(), 3.0);
    assert_near(profile.duration(), 3.0 / 2.0 + 3.0 / 6.0);
}

#[test]
fn the_start_velocity_is_raised_with_acceleration() {
    let profile = plan(ProfileRequest { start_velocity: 5.0, stop: 0.0, ..ramps(100.0, 10.0, 5.0) });
    // 1 s and 7.5 u up, the rest at 10 u/s, no ramp at the end.
    assert_near(profile.duration(), 1.0 + 92.5 / 10.0);
    assert_eq!(profile.end_velocity(), 10.0);
}

#[test]
fn the_start_velocity_is_lowered_with_deceleration() {
    let request = ProfileRequest {
        start_velocity: 20.0,
        acceleration: 1000.0,
        deceleration: 5.0,
        stop: 20.0,
        ..ramps(100.0, 10.0, 0.0)
    };
    let profile = plan(request);
    // 2 s and 30 u down to 10 u/s, 67.5 u across, 0.5 s and 2.5 u to rest.
    assert_near(profile.duration(), 2.0 + 6.75 + 0.5);
    assert_eq!(profile.sample(1.0).acceleration, -5.0);
    assert_eq!(profile.sample(9.0).acceleration, -20.0);
}

#[test]
fn the_final_velocity_only_slows() {
    let slowed = plan(ProfileRequest { final_velocity: 4.0, ..ramps(100.0, 10.0, 10.0) });
    assert_eq!(slowed.end_velocity(), 4.0);
    // 1 s and 5 u up, 90.8 u across, 0.6 s and 4.2 u down.
    assert_near(slowed.duration(), 1.0 + 9.08 + 0.6);

    let not_raised = plan(ProfileRequest { final_velocity: 40.0, ..ramps(100.0, 10.0, 10.0) });
    assert_eq!(not_raised.end_velocity(), 10.0);
}

#[test]
fn the_final_velocity_needs_a_stop_ramp() {
    let profile = plan(ProfileRequest { final_velocity: 4.0, stop: 0.0, ..ramps(100.0, 10.0, 10.0) });
    assert_eq!(profile.end_velocity(), 10.0);
}

#[test]
fn a_ramp_of_zero_is_a_step() {
    let profile = plan(ramps(30.0, 10.0, 0.0));
    assert_eq!(profile.duration(), 3.0);
    assert_eq!(profile.sample(0.0).velocity, 10.0);
    assert_eq!(profile.end_velocity(), 10.0);
}

#[test]
fn a_step_up_and_a_ramp_down_on_a_short_path() {
    let profile = plan(ProfileRequest { acceleration: 0.0, ..ramps(2.0, 100.0, 4.0) });
    assert_near(profile.peak_velocity(), 4.0); // v²/(2·4) = 2
    assert_near(profile.duration(), 1.0);
}

#[test]
fn too_short_to_stop_brakes_all_the_way() {
    let profile = plan(ProfileRequest { start_velocity: 10.0, ..ramps(3.2, 10.0, 10.0) });
    assert_near(profile.end_velocity(), 6.0); // √(100 − 2·10·3.2)
    assert_near(profile.duration(), 0.4);
}

#[test]
fn too_short_to_slow_down_first_stops_later_and_harder() {
    // Coming down to 10 u/s with 1 u/s² takes 150 u; the stop ramp alone takes 20 u.
    let profile =
        plan(ProfileRequest { start_velocity: 20.0, deceleration: 1.0, stop: 10.0, ..ramps(40.0, 10.0, 0.0) });
    assert_eq!(profile.end_velocity(), 0.0);
    // (400 − v²)/2 + v²/20 = 40
    let switch = (3200.0_f64 / 9.0).sqrt();
    assert_near(profile.duration(), (20.0 - switch) + switch / 10.0);
}

#[test]
fn too_short_with_a_stronger_deceleration_uses_it_down_to_the_velocity() {
    let profile =
        plan(ProfileRequest { start_velocity: 20.0, deceleration: 30.0, stop: 1.0, ..ramps(15.0, 10.0, 0.0) });
    // 5 u from 20 to 10 u/s, then 10 u with 1 u/s².
    assert_near(profile.end_velocity(), 80.0_f64.sqrt());
}

#[test]
fn a_full_s_curve() {
    let profile = plan(ProfileRequest { jerk: 100.0, ..ramps(200.0, 20.0, 10.0) });
    // Each ramp takes v/a + a/j.
    assert_near(profile.duration(), 200.0 / 20.0 + 20.0 / 10.0 + 10.0 / 100.0);
    assert_near(profile.peak_acceleration(), 10.0);
    let state = profile.sample(0.1);
    assert_near(state.acceleration, 10.0);
    assert_near(state.velocity, 0.5);
    assert_near(state.position, 0.1 / 6.0);
}

#[test]
fn an_s_curve_without_constant_acceleration() {
    let profile = plan(ProfileRequest { jerk: 10.0, ..ramps(100.0, 10.0, 1000.0) });
    // Each ramp takes 2·√(v/j) and peaks at √(v·j).
    assert_near(profile.duration(), 100.0 / 10.0 + 2.0);
    assert_near(profile.peak_acceleration(), 10.0);
}

#[test]
fn a_path_of_four_equal_stretches_of_jerk() {
    let profile = plan(ProfileRequest { jerk: 32.0, ..ramps(1.0, 1000.0, 1000.0) });
    assert_near(profile.duration(), 4.0 * 0.25); // L = 2·j·t³
}

#[test]
fn no_length_takes_no_time() {
    let profile = plan(ProfileRequest { start_velocity: 3.0, ..ramps(0.0, 10.0, 10.0) });
    assert_eq!((profile.duration(), profile.length(), profile.end_velocity()), (0.0, 0.0, 3.0));
}

#[test]
fn a_hold_stops_on_the_way() {
    let request = ProfileRequest { start_velocity: 10.0, ..ramps(100.0, 10.0, 10.0) };
    let hold = Profile::plan_hold(&request).expect("the values are valid");
    assert_eq!((hold.duration(), hold.length(), hold.end_velocity()), (1.0, 5.0, 0.0));
}

#[test]
fn a_hold_too_late_to_stop_on_the_way_ends_with_the_stop_ramp() {
    let request = ProfileRequest { start_velocity: 10.0, deceleration: 1.0, ..ramps(10.0, 10.0, 10.0) };
    let hold = Profile::plan_hold(&request).expect("the values are valid");
    assert_eq!((hold.length(), hold.end_velocity()), (10.0, 0.0));
}

#[test]
fn a_timed_move_keeps_the_shape_of_the_profile() {
    let request = ProfileRequest { jerk: 100.0, ..ramps(200.0, 20.0, 10.0) };
    let shortest = plan(request);
    let timed = Profile::plan_timed(&request, 2.0 * shortest.duration()).expect("the values are valid");
    for step in 0..=100 {
        let time = shortest.duration() * f64::from(step) / 100.0;
        assert_near(timed.sample(2.0 * time).position, shortest.sample(time).position);
    }
}

#[test]
fn a_timed_move_at_speed_goes_slower() {
    let request = ProfileRequest { start_velocity: 10.0, stop: 0.0, ..ramps(20.0, 10.0, 10.0) };
    let timed = Profile::plan_timed(&request, 5.0).expect("the values are valid");
    assert_near(timed.duration(), 5.0);
    assert!(timed.end_velocity() < 4.0);
}

#[test]
fn errors_name_the_value() {
    let refused = |request: ProfileRequest| Profile::plan(&request).expect_err("the value is invalid");
    let valid = ramps(1.0, 1.0, 1.0);
    let error = refused(ProfileRequest { velocity: f64::NAN, ..valid });
    assert_eq!(error.to_string(), "velocity is not a number (NaN)");
    let error = refused(ProfileRequest { stop: -1.5, ..valid });
    assert_eq!(error.to_string(), "stop ramp is negative (-1.5)");
    let expected = InvalidValue { quantity: Quantity::Stop, value: -1.5 };
    assert_eq!(error, ProfileError::Invalid(expected));
    let error = refused(ProfileRequest { length: f64::INFINITY, ..valid });
    assert_eq!(error.to_string(), "path length is infinite (inf)");
    assert_eq!(refused(ProfileRequest { velocity: 0.0, ..valid }), ProfileError::ZeroVelocity);
    let error = refused(ProfileRequest { length: 1e300, velocity: 1e-300, ..valid });
    assert_eq!(error, ProfileError::OutOfRange);
    let error = Profile::plan_timed(&valid, -1.0).expect_err("the time is invalid");
    assert_eq!(error.to_string(), "move time is negative (-1)");
}
