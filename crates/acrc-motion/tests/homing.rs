//! The homing figures A to J and what happens at limits, on a machine with a home region and two limit switches.

use acrc_motion::axis::{HomeInputs, Homing, HomingOptions, HomingStatus, Jog, JogSettings, Side};

const TICK: f64 = 0.0005;
/// The home region, u.
const REGION: (f64, f64) = (100.0, 112.0);
/// Where the limit switches are, u.
const TRAVEL: (f64, f64) = (0.0, 200.0);

fn inputs(position: f64) -> HomeInputs {
    HomeInputs {
        home: (REGION.0..=REGION.1).contains(&position),
        positive_limit: position >= TRAVEL.1,
        negative_limit: position <= TRAVEL.0,
    }
}

/// What a homing did.
#[derive(Debug)]
struct Trip {
    status: HomingStatus,
    /// Where it ended, u.
    end: f64,
    /// Its stretches in one direction: `+` or `-`, with the greatest speed of each.
    legs: Vec<(char, f64)>,
}

/// Homes from `start` with JOG VEL 20, JOG HOMVF 0.5, JOG ACC and DEC 100, HLDEC 400.
fn home_from(start: f64, side: Side, options: HomingOptions) -> Trip {
    let mut jog = Jog::new();
    let settings = JogSettings {
        velocity: 20.0,
        acceleration: 100.0,
        deceleration: 100.0,
        home_velocity: 0.5,
        ..JogSettings::default()
    };
    jog.set_settings(settings).unwrap();
    let mut homing = Homing::default();
    homing.start(&mut jog, side, options, inputs(start), 400.0).unwrap();
    let mut legs: Vec<(char, f64)> = Vec::new();
    for _ in 0..400_000 {
        jog.advance(TICK);
        let state = jog.state();
        if state.velocity != 0.0 {
            let sign = if state.velocity > 0.0 { '+' } else { '-' };
            match legs.last_mut() {
                Some((last, speed)) if *last == sign => *speed = speed.max(state.velocity.abs()),
                _ => legs.push((sign, state.velocity.abs())),
            }
        }
        let status = homing.update(&mut jog, inputs(start + state.position));
        if status != HomingStatus::Running {
            assert_eq!(status, homing.status());
            assert!(!jog.active(), "it ends at rest");
            return Trip { status, end: start + jog.offset(), legs };
        }
    }
    panic!("homing does not end: {legs:?}");
}

fn options(bits: [u8; 3]) -> HomingOptions {
    let [backup, negative_edge, negative_final] = bits.map(|bit| bit != 0);
    HomingOptions { backup, negative_edge, negative_final }
}

fn assert_legs(trip: &Trip, expected: &[(char, f64)]) {
    let rounded: Vec<(char, f64)> =
        trip.legs.iter().map(|(sign, speed)| (*sign, (speed * 1e6).round() / 1e6)).collect();
    assert_eq!(rounded, expected);
}

#[test]
fn without_backup_the_axis_stops_behind_any_edge() {
    // Braking from 20 with 100 takes 2 units.
    for (figure, start, side, end) in [
        ('A', 50.0, Side::Positive, REGION.0 + 2.0),
        ('A', 105.0, Side::Positive, REGION.1 + 2.0),
        ('B', 150.0, Side::Negative, REGION.1 - 2.0),
        ('B', 105.0, Side::Negative, REGION.0 - 2.0),
    ] {
        let trip = home_from(start, side, options([0, 0, 0]));
        assert_eq!(trip.status, HomingStatus::Found, "{figure}");
        assert!((trip.end - end).abs() <= 20.0 * TICK + 1e-9, "{figure} {trip:?}");
        assert_eq!(trip.legs.len(), 1, "{figure}");
    }
}

/// A figure of homing with backup.
struct Figure {
    name: char,
    side: Side,
    /// Bits 24 to 26.
    bits: [u8; 3],
    /// The edge it ends at, u.
    end: f64,
    /// The directions it moves in.
    directions: &'static str,
}

const FIGURES: [Figure; 8] = [
    Figure { name: 'C', side: Side::Positive, bits: [1, 0, 0], end: REGION.1, directions: "+-+" },
    Figure { name: 'D', side: Side::Positive, bits: [1, 1, 0], end: REGION.0, directions: "+-+" },
    Figure { name: 'E', side: Side::Positive, bits: [1, 0, 1], end: REGION.1, directions: "+-" },
    Figure { name: 'F', side: Side::Positive, bits: [1, 1, 1], end: REGION.0, directions: "+-" },
    Figure { name: 'G', side: Side::Negative, bits: [1, 1, 1], end: REGION.0, directions: "-+-" },
    Figure { name: 'H', side: Side::Negative, bits: [1, 0, 1], end: REGION.1, directions: "-+-" },
    Figure { name: 'I', side: Side::Negative, bits: [1, 1, 0], end: REGION.0, directions: "-+" },
    Figure { name: 'J', side: Side::Negative, bits: [1, 0, 0], end: REGION.1, directions: "-+" },
];

#[test]
fn with_backup_the_axis_ends_at_the_selected_edge_in_the_selected_direction() {
    for figure in FIGURES {
        let start = if figure.side == Side::Positive { 50.0 } else { 150.0 };
        let trip = home_from(start, figure.side, options(figure.bits));
        assert_eq!(trip.status, HomingStatus::Found, "{}", figure.name);
        assert!((trip.end - figure.end).abs() <= 0.5 * TICK + 1e-9, "{} {trip:?}", figure.name);
        let expected: Vec<(char, f64)> = figure
            .directions
            .chars()
            .enumerate()
            .map(|(index, sign)| (sign, if index == 0 { 20.0 } else { 0.5 }))
            .collect();
        assert_legs(&trip, &expected);
    }
}

#[test]
fn an_active_home_input_turns_the_search_towards_the_selected_edge() {
    // All start inside the region, against the command.
    for (side, bits, end, directions) in [
        (Side::Negative, [1, 0, 0], REGION.1, "+-+"),
        (Side::Negative, [1, 0, 1], REGION.1, "+-"),
        (Side::Positive, [1, 1, 1], REGION.0, "-+-"),
        (Side::Positive, [1, 1, 0], REGION.0, "-+"),
    ] {
        let trip = home_from(105.0, side, options(bits));
        assert_eq!(trip.status, HomingStatus::Found);
        assert!((trip.end - end).abs() <= 0.5 * TICK + 1e-9, "{trip:?}");
        assert_eq!(trip.legs.iter().map(|leg| leg.0).collect::<String>(), directions);
    }
}

#[test]
fn a_limit_reverses_the_search() {
    // Away from home first; then the figures of the other direction.
    for (start, side, bits, end, directions) in [
        (150.0, Side::Positive, [1, 1, 1], REGION.0, "+-+-"),
        (150.0, Side::Positive, [1, 0, 0], REGION.1, "+-+"),
        (50.0, Side::Negative, [1, 0, 0], REGION.1, "-+-+"),
        (50.0, Side::Negative, [1, 1, 1], REGION.0, "-+-"),
        // On the limit already.
        (0.0, Side::Negative, [1, 1, 1], REGION.0, "-+-"),
    ] {
        let trip = home_from(start, side, options(bits));
        assert_eq!(trip.status, HomingStatus::Found);
        assert!((trip.end - end).abs() <= 0.5 * TICK + 1e-9, "{trip:?}");
        assert_eq!(trip.legs.iter().map(|leg| leg.0).collect::<String>(), directions);
    }
    let trip = home_from(150.0, Side::Positive, options([0, 0, 0]));
    assert_eq!(trip.status, HomingStatus::Found);
    assert!((trip.end - (REGION.1 - 2.0)).abs() <= 20.0 * TICK);
}

#[test]
fn a_second_limit_ends_it_as_failed() {
    // Nothing at home: only the limits show.
    let mut jog = Jog::new();
    let settings = JogSettings { velocity: 20.0, acceleration: 100.0, deceleration: 100.0, ..JogSettings::default() };
    jog.set_settings(settings).unwrap();
    let mut homing = Homing::default();
    homing.start(&mut jog, Side::Positive, options([1, 0, 0]), HomeInputs::default(), 400.0).unwrap();
    assert!(homing.start(&mut jog, Side::Positive, options([1, 0, 0]), HomeInputs::default(), 400.0).is_err());
    let mut furthest = 0.0_f64;
    while homing.status() == HomingStatus::Running {
        jog.advance(TICK);
        let position = 50.0 + jog.offset();
        furthest = furthest.max(position);
        homing.update(&mut jog, HomeInputs { home: false, ..inputs(position) });
    }
    assert_eq!(homing.status(), HomingStatus::Failed);
    // Braking from 20 with HLDEC 400 takes half a unit.
    assert!((furthest - 200.5).abs() <= 20.0 * TICK, "{furthest}");
    assert!((50.0 + jog.offset() + 0.5).abs() <= 20.0 * TICK, "{}", jog.offset());
    assert!(!jog.active());
}

#[test]
fn a_kill_is_a_failure() {
    let mut jog = Jog::new();
    let mut homing = Homing::default();
    homing.abort();
    assert_eq!(homing.status(), HomingStatus::Idle);
    homing.start(&mut jog, Side::Positive, options([0, 0, 0]), HomeInputs::default(), 0.0).unwrap();
    homing.abort();
    assert_eq!(homing.update(&mut jog, HomeInputs::default()), HomingStatus::Failed);
}
