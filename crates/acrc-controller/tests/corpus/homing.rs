//! Homing by the home switch.

use crate::bench::{Bench, Plan, near};
use crate::check::{Check, Check::Shows};
use crate::guide::{Fact, Figure, Listing};

pub(crate) const CHECKS: &[(u8, &[Check])] = &[(
    50,
    &[
        Shows(stops_behind_any_edge),
        Shows(backs_up_to_the_edge),
        Shows(limits_reverse_once),
        Shows(refused_in_motion),
        Shows(default_acceleration),
    ],
)];

const TICK: f64 = 0.0005;
/// Ticks of half a minute.
const LONGEST: u32 = 60_000;
const FOUND: i64 = 16_134;
const FAILED: i64 = 16_135;

/// Where the switches of X are: positive limit, negative limit, home region.
#[derive(Clone, Copy)]
struct Machine {
    limits: (f64, f64),
    home: (f64, f64),
}

impl Machine {
    /// The inputs 0, 1 and 2 at a place.
    fn inputs(&self, place: f64) -> [bool; 3] {
        [place >= self.limits.0, place <= self.limits.1, (self.home.0..=self.home.1).contains(&place)]
    }
}

/// A way home.
#[derive(Debug, Default)]
struct Trip {
    /// Where it ended, from the start.
    end: f64,
    /// Its stretches in one direction, with the greatest speed of each.
    legs: Vec<(f64, f64)>,
    found: bool,
    failed: bool,
    /// The absolute position at the end.
    position: f64,
}

/// Looks for home. The inputs come from outside: the way is gone again and again, each time with the change that was missing.
fn trip(listing: &Listing, figure: &Figure, before: &str, machine: Machine) -> (Bench, Trip) {
    let mut inputs = Vec::new();
    loop {
        let mut bench = prepared(listing, figure, &Plan { before, inputs: &inputs, ..Plan::default() });
        match go(&mut bench, &figure.statement, machine) {
            Ok(trip) => return (bench, trip),
            Err(missing) => inputs.push(missing),
        }
    }
}

/// Types a statement and follows the axis, until it is home or an input is not what it has to be.
fn go(bench: &mut Bench, statement: &str, machine: Machine) -> Result<Trip, (f64, u32, bool)> {
    let mut trip = Trip::default();
    assert_eq!(bench.ask(statement), "");
    for _ in 0..LONGEST {
        let (velocity, _) = bench.controller.view().motion(0);
        if velocity != 0.0 {
            match trip.legs.last_mut() {
                Some((direction, speed)) if *direction == velocity.signum() => *speed = speed.max(velocity.abs()),
                _ => trip.legs.push((velocity.signum(), velocity.abs())),
            }
        }
        (trip.found, trip.failed) = (bench.bit(FOUND), bench.bit(FAILED));
        trip.position = bench.controller.view().position(0);
        if trip.found || trip.failed {
            break;
        }
        trip.end = trip.position;
        for (input, active) in (0..).zip(machine.inputs(trip.position)) {
            if bench.bit(i64::from(input)) != active {
                return Err((bench.controller.seconds(), input, active));
            }
        }
        bench.pass(TICK);
    }
    Ok(trip)
}

/// A terminal of the file with the homing bits of a figure.
fn prepared(listing: &Listing, figure: &Figure, plan: &Plan) -> Bench {
    let before = format!("HLBIT X0\nHLDEC X1000\n{}\n", plan.before);
    let mut bench = Bench::terminal_planned(listing, &Plan { before: &before, ..*plan });
    let bits = [figure.backup, figure.negative_edge, figure.negative_final];
    for (bit, state) in (16_152..).zip(bits) {
        assert_eq!(bench.ask(&format!("{} {bit}", if state == 0 { "CLR" } else { "SET" })), "");
    }
    bench
}

/// Looks for home as a figure does. The home region is 2 units long and begins 4 units away.
fn drawn(listing: &Listing, figure: &Figure) -> Trip {
    let home = if direction(figure) > 0.0 { (4.0, 6.0) } else { (-6.0, -4.0) };
    let machine = Machine { limits: (100.0, -100.0), home };
    trip(listing, figure, "", machine).1
}

fn direction(figure: &Figure) -> f64 {
    if figure.statement.contains('-') { -1.0 } else { 1.0 }
}

fn figures(listing: &Listing, backup: u8) -> impl Iterator<Item = &Figure> {
    listing.figures.iter().filter(move |figure| figure.backup == backup)
}

/// The legs with the numbers that a person reads.
fn rounded(trip: &Trip) -> Vec<(f64, f64)> {
    trip.legs.iter().map(|(direction, speed)| (*direction, (speed * 1e6).round() / 1e6)).collect()
}

fn stops_behind_any_edge(listing: &Listing, _: &Fact) {
    assert_eq!(figures(listing, 0).count(), 2);
    for figure in figures(listing, 0) {
        let trip = drawn(listing, figure);
        assert!(trip.found && !trip.failed, "{}: {trip:?}", figure.name);
        assert_eq!(rounded(&trip), [(direction(figure), 10.0)], "{}", figure.name);
        // A ramp from 10 with 100 takes 0.5 units.
        near(trip.end * direction(figure), 4.0 + 0.5, 10.0 * TICK + 1e-9);
        assert_eq!(trip.position, 0.0);
    }
}

fn backs_up_to_the_edge(listing: &Listing, _: &Fact) {
    assert_eq!(figures(listing, 1).count(), 8);
    for figure in figures(listing, 1) {
        let trip = drawn(listing, figure);
        assert!(trip.found && !trip.failed, "{}: {trip:?}", figure.name);
        let last = if figure.negative_final == 0 { 1.0 } else { -1.0 };
        // There at JOG VEL, back at JOG HOMVF, and once more if it came back in the wrong direction.
        let mut legs = vec![(direction(figure), 10.0), (-direction(figure), 0.1)];
        if last == direction(figure) {
            legs.push((last, 0.1));
        }
        assert_eq!(rounded(&trip), legs, "{}", figure.name);
        let edges = if direction(figure) > 0.0 { [6.0, 4.0] } else { [-4.0, -6.0] };
        near(trip.end, edges[usize::from(figure.negative_edge)], 0.1 * TICK + 1e-9);
        assert_eq!(trip.position, 0.0);
    }
}

fn limits_reverse_once(listing: &Listing, _: &Fact) {
    let figure = figures(listing, 0).next().expect("figure A");
    let limited = |machine: Machine| {
        let (mut bench, trip) = trip(listing, figure, "HLIM X3", machine);
        bench.pass(1.0);
        assert!(!bench.bit(8467), "no Kill All Motion Request");
        assert_eq!(bench.controller.view().motion(0).0, 0.0);
        trip
    };
    let behind = limited(Machine { limits: (3.0, -20.0), home: (-8.0, -6.0) });
    assert!(behind.found && !behind.failed, "{behind:?}");
    assert_eq!(rounded(&behind), [(1.0, 10.0), (-1.0, 10.0)]);
    near(behind.end, -6.0 - 0.5, 10.0 * TICK + 1e-9);
    let nowhere = limited(Machine { limits: (3.0, -3.0), home: (50.0, 51.0) });
    assert!(nowhere.failed && !nowhere.found, "{nowhere:?}");
    assert_eq!(rounded(&nowhere), [(1.0, 10.0), (-1.0, 10.0)]);
    // HLDEC takes 0.05 units.
    near(nowhere.end, -3.0 - 0.05, 10.0 * TICK + 1e-9);
}

fn refused_in_motion(listing: &Listing, _: &Fact) {
    for start in ["JOG INC X1", "ACC 10 STP 10 VEL 1 : X1"] {
        let mut bench = Bench::terminal(listing);
        assert_eq!(bench.ask(start), "");
        bench.pass(0.1);
        assert!(bench.ask("JOG HOME X1").contains("Not valid while in motion"));
        bench.pass(1.1);
        assert_eq!(bench.ask("JOG HOME X1"), "");
        bench.pass(0.1);
        assert!(bench.bit(792));
    }
}

fn default_acceleration(_: &Listing, fact: &Fact) {
    let mut bench = Bench::setup("PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n");
    bench.ask("PROG0");
    fact.holds(bench.number("JOG ACC X"), 0.0);
}
