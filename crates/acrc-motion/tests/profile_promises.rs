//! The promises of the profile module, held to on random requests.

use acrc_motion::{Profile, ProfileRequest};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// Samples taken of each profile.
const SAMPLES: u32 = 400;

/// A number whose size is spread evenly over the powers of ten.
fn sized(powers: std::ops::Range<i32>) -> impl Strategy<Value = f64> {
    (powers, 1.0..10.0_f64).prop_map(|(power, digits)| digits * power_of_ten(power))
}

/// Zero with the given probability.
fn or_zero(probability: f64, value: impl Strategy<Value = f64>) -> impl Strategy<Value = f64> {
    (prop::bool::weighted(probability), value).prop_map(|(zero, value)| if zero { 0.0 } else { value })
}

fn power_of_ten(power: i32) -> f64 {
    let magnitude = (0..power.abs()).fold(1.0, |product, _| product * 10.0);
    if power < 0 { 1.0 / magnitude } else { magnitude }
}

prop_compose! {
    fn request()(
        length in or_zero(0.02, sized(-5..5)),
        start_velocity in or_zero(0.3, sized(-3..4)),
        velocity in sized(-3..4),
        acceleration in or_zero(0.1, sized(-2..5)),
        deceleration in or_zero(0.1, sized(-2..5)),
        stop in or_zero(0.2, sized(-2..5)),
        final_velocity in or_zero(0.5, sized(-3..4)),
        jerk in or_zero(0.4, sized(-2..7)),
    ) -> ProfileRequest {
        ProfileRequest {
            length, start_velocity, velocity, acceleration, deceleration, stop, final_velocity, jerk,
        }
    }
}

/// Times worth looking at: evenly spread, and close to both ends.
fn times(profile: &Profile) -> Vec<f64> {
    let duration = profile.duration();
    let mut times: Vec<f64> = (0..=SAMPLES).map(|i| duration * f64::from(i) / f64::from(SAMPLES)).collect();
    times.extend([1e-12, 1e-9, 1e-6].iter().flat_map(|part| [duration * part, duration * (1.0 - part)]));
    times.sort_by(f64::total_cmp);
    times
}

/// The same cases in every run.
fn config() -> ProptestConfig {
    ProptestConfig { cases: 2000, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..ProptestConfig::default() }
}

/// How finely a number can tell the times of a profile apart.
fn time_resolution(profile: &Profile) -> f64 {
    4.0 * f64::EPSILON * profile.duration()
}

fn highest_velocity(request: &ProfileRequest) -> f64 {
    request.velocity.max(request.start_velocity)
}

fn greatest_limit(request: &ProfileRequest) -> f64 {
    request.acceleration.max(request.deceleration).max(request.stop)
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn limits_are_kept(request in request()) {
        let profile = Profile::plan(&request).unwrap();
        for t in times(&profile) {
            let state = profile.sample(t);
            prop_assert!((0.0..=request.length).contains(&state.position), "{state:?} at {t}");
            prop_assert!(state.velocity >= 0.0);
            prop_assert!(state.velocity <= highest_velocity(&request) * (1.0 + 1e-9), "{state:?} at {t}");
            prop_assert!(state.acceleration <= request.acceleration * (1.0 + 1e-9), "{state:?} at {t}");
            let braking = request.deceleration.max(request.stop);
            prop_assert!(-state.acceleration <= braking * (1.0 + 1e-9), "{state:?} at {t}");
            prop_assert!(state.velocity <= profile.peak_velocity() * (1.0 + 1e-12));
            prop_assert!(state.acceleration.abs() <= profile.peak_acceleration() * (1.0 + 1e-12));
        }
    }

    #[test]
    fn the_end_is_reached(request in request()) {
        let profile = Profile::plan(&request).unwrap();
        let end = profile.sample(profile.duration());
        prop_assert_eq!(end.position, request.length);
        prop_assert_eq!(end.velocity, profile.end_velocity());
        prop_assert_eq!(end.acceleration, 0.0);
        prop_assert_eq!(profile.sample(2.0 * profile.duration() + 1.0), end);
        if profile.duration() > 0.0 {
            let just_before = profile.sample(profile.duration().next_down());
            let v = profile.peak_velocity();
            prop_assert!((just_before.position - request.length).abs() <= 1e-12 * request.length + v * time_resolution(&profile), "{just_before:?}");
            let tolerance = 1e-9 * v + profile.peak_acceleration() * time_resolution(&profile);
            prop_assert!((just_before.velocity - end.velocity).abs() <= tolerance, "{just_before:?} {end:?}");
        }
    }

    #[test]
    fn nothing_jumps(request in request()) {
        let profile = Profile::plan(&request).unwrap();
        let (v, a) = (profile.peak_velocity(), profile.peak_acceleration());
        let times = times(&profile);
        for (&t, &u) in times.iter().zip(times.iter().skip(1)) {
            let (now, then, dt) = (profile.sample(t), profile.sample(u), (u - t) + time_resolution(&profile));
            prop_assert!(now.position <= then.position * (1.0 + 1e-12), "{now:?} {then:?}");
            prop_assert!(then.position - now.position <= v * dt + 1e-9 * request.length);
            // A ramp that is switched off is a step, but only at the very start.
            prop_assert!((then.velocity - now.velocity).abs() <= a * dt + 1e-9 * v, "{now:?} {then:?}");
            if request.jerk > 0.0 {
                let change = (then.acceleration - now.acceleration).abs();
                let tolerance = 1e-6 * greatest_limit(&request);
                prop_assert!(change <= request.jerk * dt + tolerance, "{now:?} {then:?} {t} {u}");
            }
        }
    }

    #[test]
    fn the_start_is_taken_over(request in request()) {
        let profile = Profile::plan(&request).unwrap();
        let start = profile.sample(0.0);
        prop_assert!(start.position == 0.0 || request.length == 0.0 || profile.duration() == 0.0);
        let stepped = start.velocity > request.start_velocity && request.acceleration == 0.0
            || start.velocity < request.start_velocity && request.deceleration == 0.0;
        prop_assert!(start.velocity == request.start_velocity || stepped, "{start:?}");
    }

    #[test]
    fn the_end_velocity_is_the_final_velocity_where_that_is_possible(request in request()) {
        let profile = Profile::plan(&request).unwrap();
        if request.stop > 0.0 && profile.end_velocity() > request.final_velocity && request.length > 0.0 {
            // Too short: it never goes faster than it started, and never stops braking.
            prop_assert!(profile.peak_velocity() <= request.start_velocity);
            prop_assert!(profile.end_velocity() <= request.start_velocity);
        }
    }

    #[test]
    fn a_hold_comes_to_rest_or_ends_like_the_move(request in request()) {
        let hold = Profile::plan_hold(&request).unwrap();
        prop_assert!(hold.length() <= request.length);
        prop_assert!(hold.peak_velocity() <= request.start_velocity);
        if hold.length() < request.length {
            prop_assert_eq!(hold.end_velocity(), 0.0);
            if request.jerk == 0.0 && request.deceleration > 0.0 {
                let expected = request.start_velocity / request.deceleration;
                prop_assert!((hold.duration() - expected).abs() <= 1e-12 * expected);
            }
        }
    }

    #[test]
    fn a_timed_profile_takes_its_time_within_the_limits(request in request(), stretch in 1.0..50.0_f64) {
        let shortest = Profile::plan(&request).unwrap().duration();
        if shortest == 0.0 {
            return Ok(());
        }
        let seconds = shortest * stretch;
        let lowered = request.lowered_to(seconds).unwrap();
        let timed = Profile::plan(&lowered).unwrap();
        prop_assert_eq!(timed, Profile::plan_timed(&request, seconds).unwrap());
        prop_assert!(lowered.velocity <= request.velocity && lowered.acceleration <= request.acceleration);
        prop_assert!(lowered.stop <= request.stop && lowered.jerk <= request.jerk);
        if request.start_velocity == 0.0 || request.jerk == 0.0 {
            prop_assert!(timed.duration() <= seconds * (1.0 + 1e-9));
        }
        // A moving start is free to take its time unless it would have to brake harder than it can.
        if request.start_velocity == 0.0 || request.jerk == 0.0 && request.deceleration == 0.0 && request.stop == 0.0 {
            prop_assert!((timed.duration() - seconds).abs() <= 1e-9 * seconds);
        }
    }

    #[test]
    fn any_bits_are_planned_or_refused(bits in proptest::array::uniform8(proptest::num::f64::ANY), time in proptest::num::f64::ANY) {
        let [length, start_velocity, velocity, acceleration, deceleration, stop, final_velocity, jerk] = bits;
        let request = ProfileRequest {
            length, start_velocity, velocity, acceleration, deceleration, stop, final_velocity, jerk,
        };
        let planned = [Profile::plan(&request), Profile::plan_hold(&request), Profile::plan_timed(&request, time)];
        for profile in planned.into_iter().flatten() {
            prop_assert!(profile.duration() >= 0.0 && profile.duration().is_finite());
            prop_assert!(profile.sample(time).velocity >= 0.0);
        }
    }

    #[test]
    fn any_size_is_planned_or_refused(bits in proptest::array::uniform8(proptest::num::f64::POSITIVE | proptest::num::f64::ZERO), t in 0.0..1.0_f64) {
        let [length, start_velocity, velocity, acceleration, deceleration, stop, final_velocity, jerk] = bits;
        let request = ProfileRequest {
            length, start_velocity, velocity, acceleration, deceleration, stop, final_velocity, jerk,
        };
        if let Ok(profile) = Profile::plan(&request) {
            let state = profile.sample(t * profile.duration());
            prop_assert!((0.0..=length).contains(&state.position) && state.velocity >= 0.0);
        }
    }
}
