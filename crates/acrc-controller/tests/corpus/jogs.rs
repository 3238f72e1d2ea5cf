//! Jogs, and the registers that they share with coordinated moves.

use acrc_controller::State;

use crate::bench::{Bench, Plan, Sample, near};
use crate::check::{Check, Check::Shows};
use crate::guide::{Fact, Listing};

pub(crate) const CHECKS: &[(u8, &[Check])] = &[
    (
        41,
        &[
            Shows(diamonds_close),
            Shows(diamond_shifts),
            Shows(diamond_corners),
            Shows(diamond_corners),
            Shows(diamond_corners),
            Shows(diamond_corners),
            Shows(diamond_ends),
        ],
    ),
    (
        42,
        &[
            Shows(match_position),
            Shows(preload_all),
            Shows(zero_all),
            Shows(coordinated_to_jog),
            Shows(coordinated_preload),
            Shows(jog_to_coordinated),
            Shows(jog_preload),
        ],
    ),
    (45, &[Shows(independent_axes)]),
    (46, &[Shows(first_axis), Shows(second_axis), Shows(second_ends_first)]),
    (
        47,
        &[
            Shows(before_the_change),
            Shows(slowing_down),
            Shows(jog_time),
            Shows(jog_end),
            Shows(unchanged_time),
            Shows(program_goes_on),
        ],
    ),
    (48, &[Shows(first_axis), Shows(second_axis), Shows(one_behind_the_other), Shows(active_bit)]),
    (
        51,
        &[
            Shows(tour),
            Shows(tour),
            Shows(tour),
            Shows(tour),
            Shows(tour),
            Shows(tour),
            Shows(tour_end),
            Shows(tour_minimum),
            Shows(tour_ends_itself),
        ],
    ),
];

/// Registers of axis 0: coordinated position, primary and secondary setpoint, actual position, jog offset.
const REGISTERS: [&str; 5] = ["P12288", "P12294", "P12295", "P12290", "P12297"];
/// Gear and cam offset of the figures.
const GEAR: i32 = 3;
const CAM: i32 = 4;

/// The file for some seconds.
fn ran(listing: &Listing, seconds: f64) -> Bench {
    let mut bench = Bench::of(listing);
    bench.pass(seconds).clean();
    bench
}

/// When an axis left its rest, and when it had come back to it.
#[track_caller]
fn stretch(bench: &Bench, axis: usize) -> (f64, f64) {
    let samples = &bench.record.samples;
    let moves = |index: &usize| samples[*index].velocity[axis] != 0.0;
    let first = (0..samples.len()).find(moves).expect("it moves");
    let last = (0..samples.len()).rfind(moves).expect("it moves");
    (samples[first - 1].seconds, samples[last + 1].seconds)
}

/// The four diamonds one behind the other: shifts wait for the moves before, and moves for the shifts. Behind each shift the jog offsets are printed,
/// behind each diamond coordinated positions and setpoints.
fn diamonds(listing: &Listing) -> Bench {
    let end = "INH -516\nPRINT P12288, P12544, P12294, P12550";
    let shift = |jog: &str| format!("{end}\n{jog}\nINH -792\nINH -824\nPRINT P12297, P12553");
    let jogs = ["JOG ABS Y3", "JOG ABS X5", "JOG ABS Y0"].map(|jog| (jog, shift(jog)));
    let replaced: Vec<(&str, &str)> = jogs.iter().map(|(jog, shift)| (*jog, shift.as_str())).collect();
    let plan = Plan { before: "PPU X1000 Y1000", behind: end, replaced: &replaced, ..Plan::default() };
    let mut bench = Bench::planned(listing, &plan);
    bench.pass(60.0).clean();
    bench
}

/// Lines of so many numbers, in thousandths of units, that the diamonds have printed.
fn printed(bench: &Bench, columns: usize) -> Vec<Vec<f64>> {
    let lines = bench.printed(0).into_iter().map(|line| {
        let numbers = line.split_whitespace().map(|number| number.parse::<f64>().expect("a number") / 1000.0);
        numbers.collect::<Vec<f64>>()
    });
    lines.filter(|line| line.len() == columns).collect()
}

fn diamonds_close(listing: &Listing, fact: &Fact) {
    let ends = printed(&diamonds(listing), 4);
    assert_eq!(ends.len(), 4);
    assert!(ends.iter().all(|end| end[..2] == fact.points()[0]), "{ends:?}");
    // As the file is printed, jogs and moves overlap, but end in the same places.
    let mut bench = ran(listing, 60.0);
    assert_eq!((bench.number("?P12288"), bench.number("?P12544")), (0.0, 0.0));
    assert_eq!((bench.position(0), bench.position(1)), (5.0, 0.0));
}

fn diamond_shifts(listing: &Listing, fact: &Fact) {
    let mut shifts = printed(&diamonds(listing), 2);
    shifts.insert(0, vec![0.0, 0.0]);
    assert_eq!(shifts, fact.points());
}

fn diamond_corners(listing: &Listing, fact: &Fact) {
    let bench = diamonds(listing);
    let all: Vec<Vec<f64>> = listing.facts[2..6].iter().flat_map(Fact::points).collect();
    let times = bench.visits(&all);
    let number = listing.facts.iter().position(|other| other.fact == fact.fact).expect("a fact of the file") - 2;
    let lap = &times[number * 4..number * 4 + 4];
    // Sides of equal length.
    for side in lap.windows(2) {
        near(side[1] - side[0], 5.0_f64.sqrt() / 5.0 + 5.0 / 10.0, 0.003);
    }
}

fn diamond_ends(listing: &Listing, fact: &Fact) {
    let ends: Vec<Vec<f64>> = printed(&diamonds(listing), 4).iter().map(|end| end[2..].to_vec()).collect();
    assert_eq!(ends, fact.points());
}

/// A terminal with the coordinated position and the offsets of X.
fn registers(listing: &Listing, [coordinated, jog, gear, cam]: [i32; 4]) -> Bench {
    let mut bench = Bench::terminal(listing);
    let offsets = [format!("GEAR RES X{gear}"), format!("CAM RES X{cam}")];
    for line in offsets.into_iter().chain([format!("P12288={coordinated}"), format!("P12297={jog}")]) {
        assert_eq!(bench.ask(&line), "");
    }
    bench
}

/// Types a line of the file and compares the [`REGISTERS`] behind it.
#[track_caller]
fn command(bench: &mut Bench, listing: &Listing, line: &str, expected: [f64; 5]) {
    assert!(line == "REN X" || listing.text.lines().any(|other| other == line), "{line}");
    assert_eq!(bench.ask(line), "");
    assert_eq!(REGISTERS.map(|register| bench.number(&format!("?{register}"))), expected, "{line}");
    assert_eq!(bench.number("?P12291"), 0.0, "the following error");
}

fn match_position(listing: &Listing, _: &Fact) {
    let mut bench = registers(listing, [0, 2, GEAR, CAM]);
    assert_eq!(bench.ask("P12290=11"), "");
    command(&mut bench, listing, "REN X", [2.0, 11.0, 11.0, 11.0, 2.0]);
}

fn preload_all(listing: &Listing, _: &Fact) {
    command(&mut registers(listing, [2, 2, GEAR, CAM]), listing, "RES X10", [10.0, 10.0, 10.0, 10.0, 0.0]);
}

fn zero_all(listing: &Listing, fact: &Fact) {
    command(&mut registers(listing, [2, 2, GEAR, CAM]), listing, "RES", [fact.number(); 5]);
}

fn coordinated_to_jog(listing: &Listing, _: &Fact) {
    command(&mut registers(listing, [2, 2, GEAR, CAM]), listing, "JOG REN X", [0.0, 11.0, 11.0, 11.0, 4.0]);
}

fn coordinated_preload(listing: &Listing, _: &Fact) {
    command(&mut registers(listing, [5, 1, 0, 0]), listing, "JOG REN X2", [2.0, 6.0, 6.0, 6.0, 4.0]);
}

fn jog_to_coordinated(listing: &Listing, _: &Fact) {
    command(&mut registers(listing, [2, 2, GEAR, CAM]), listing, "JOG RES X", [4.0, 11.0, 11.0, 11.0, 0.0]);
}

fn jog_preload(listing: &Listing, _: &Fact) {
    command(&mut registers(listing, [1, 5, 0, 0]), listing, "JOG RES X2", [4.0, 6.0, 6.0, 6.0, 2.0]);
}

fn independent_axes(listing: &Listing, _: &Fact) {
    let bench = ran(listing, 6.0);
    let (x, y) = (stretch(&bench, 0), stretch(&bench, 1));
    assert_eq!(x.0, y.0);
    near(x.1 - x.0, 500.0 / 100.0 + 100.0 / 1000.0, 0.0006);
    near(y.1 - y.0, 1.0 + 100.0 / 1000.0, 0.0006);
    assert_eq!((bench.position(0), bench.position(1)), (500.0, 100.0));
}

fn first_axis(listing: &Listing, fact: &Fact) {
    let (begin, end) = stretch(&ran(listing, 2.0), 0);
    fact.holds(end - begin, 0.0);
}

fn second_axis(listing: &Listing, fact: &Fact) {
    let (begin, end) = stretch(&ran(listing, 2.0), 1);
    fact.holds(end - begin, 0.0);
}

fn second_ends_first(listing: &Listing, _: &Fact) {
    let bench = ran(listing, 2.0);
    let (x, y) = (stretch(&bench, 0), stretch(&bench, 1));
    assert_eq!(x.0, y.0);
    assert!(y.1 < x.1);
    let apart = |sample: &Sample| (sample.position[0] - sample.position[1]).abs();
    assert!(bench.record.samples.iter().map(apart).fold(0.0, f64::max) > 1.0);
    assert_eq!((bench.position(0), bench.position(1)), (10.0, 10.0));
}

fn before_the_change(listing: &Listing, fact: &Fact) {
    let bench = ran(listing, 2.0);
    let sample = bench.at(stretch(&bench, 0).0 + 1.0);
    let [position, speed] = fact.numbers()[..] else { panic!("two numbers") };
    near(sample.position[0], position, 1e-9);
    near(sample.velocity[0], speed, 1e-9);
}

fn slowing_down(listing: &Listing, fact: &Fact) {
    let bench = ran(listing, 2.0);
    let (begin, _) = stretch(&bench, 0);
    let behind = |seconds: f64| bench.record.samples.iter().filter(move |sample| sample.seconds >= begin + seconds);
    let first = behind(0.9).find(|sample| sample.velocity[0] < 10.0).expect("it slows down");
    let last = behind(0.9).find(|sample| sample.velocity[0] <= 5.0).expect("it has slowed down");
    // The first sample that is slower lies one tick behind the change.
    fact.holds(last.seconds - first.seconds, 0.0006);
    // The program has its slices every 2 ms.
    near(last.seconds - begin, 1.2, 0.0021);
    near(last.position[0], 9.0, 0.021);
    near(last.velocity[0], 5.0, 1e-9);
}

fn jog_time(listing: &Listing, fact: &Fact) {
    let (begin, end) = stretch(&ran(listing, 2.0), 0);
    fact.holds(end - begin, 0.0);
}

fn jog_end(listing: &Listing, fact: &Fact) {
    let mut bench = ran(listing, 2.0);
    fact.holds(bench.position(0), 0.0);
    fact.holds(bench.number("?P12297"), 0.0);
}

fn unchanged_time(listing: &Listing, fact: &Fact) {
    let replaced = [("\nJOG VEL X5", "")];
    let mut bench = Bench::planned(listing, &Plan { replaced: &replaced, ..Plan::default() });
    bench.pass(2.0).clean();
    let (begin, end) = stretch(&bench, 0);
    fact.holds(end - begin, 0.0006);
}

fn program_goes_on(listing: &Listing, _: &Fact) {
    let plan = Plan { behind: "SET 128", flag: Some(128), ..Plan::default() };
    let mut bench = Bench::planned(listing, &plan);
    bench.pass(2.0).clean();
    let begin = stretch(&bench, 0).0;
    near(bench.settings()[0] - begin, 1.0, 0.0021);
}

fn one_behind_the_other(listing: &Listing, fact: &Fact) {
    let bench = ran(listing, 2.0);
    let (x, y) = (stretch(&bench, 0), stretch(&bench, 1));
    assert!(y.0 >= x.1);
    fact.holds(y.1 - x.0, 0.0);
}

fn active_bit(listing: &Listing, _: &Fact) {
    let mut bench = Bench::planned(listing, &Plan { flag: Some(792), ..Plan::default() });
    bench.pass(2.0).clean();
    let (begin, end) = stretch(&bench, 0);
    let [(set, true), (clear, false)] = bench.record.changes[..] else { panic!("{:?}", bench.record.changes) };
    near(set, begin, 0.0006);
    near(clear, end, 0.0006);
    assert!(clear <= stretch(&bench, 1).0);
}

/// The program of all kinds of moves, which takes less than 40 seconds.
fn toured(listing: &Listing) -> Bench {
    ran(listing, 40.0)
}

/// The places to which the first `count` parts of the tour go.
fn stops(listing: &Listing, count: usize) -> Vec<Vec<f64>> {
    // The jogs come on top of the coordinated position that the moves have left behind.
    let parts = [0.0, 0.0, 0.0, 400.0, 400.0, 400.0].into_iter().zip(&listing.facts).take(count);
    parts.flat_map(|(base, fact)| fact.numbers().into_iter().map(move |place| vec![base + place])).collect()
}

fn tour(listing: &Listing, fact: &Fact) {
    let number = listing.facts.iter().position(|other| other.fact == fact.fact).expect("a fact of the file");
    toured(listing).visits(&stops(listing, number + 1));
}

fn tour_end(listing: &Listing, _: &Fact) {
    let mut bench = toured(listing);
    assert_eq!(REGISTERS.map(|register| bench.number(&format!("?{register}"))), [400.0, 400.0, 400.0, 400.0, 0.0]);
}

fn tour_minimum(listing: &Listing, fact: &Fact) {
    let bench = toured(listing);
    let jogs = bench.visits(&stops(listing, 4)).last().copied().expect("times");
    let behind = bench.record.samples.iter().filter(|sample| sample.seconds >= jogs);
    let lowest = behind.map(|sample| sample.position[0]).fold(f64::INFINITY, f64::min);
    fact.holds(lowest, 1e-9);
}

fn tour_ends_itself(listing: &Listing, _: &Fact) {
    let bench = toured(listing);
    assert_eq!(bench.state(0), State::Ended);
    // Ends of the six parts, and nothing behind them.
    let last = bench.visits(&stops(listing, 6)).last().copied().expect("times");
    near(stretch(&bench, 0).1, last, 0.0006);
}
