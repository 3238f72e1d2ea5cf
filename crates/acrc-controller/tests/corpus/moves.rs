//! Coordinated moves.

use crate::bench::{Bench, Plan, Sample, near};
use crate::check::{Check, Check::Shows};
use crate::guide::{Fact, Listing};

pub(crate) const CHECKS: &[(u8, &[Check])] = &[
    (
        25,
        &[
            Shows(square_sides),
            Shows(square_lap),
            Shows(square_corners),
            Shows(square_feedhold),
            Shows(square_registers),
        ],
    ),
    (32, &[Shows(mov_is_optional), Shows(two_axes_together), Shows(one_line_one_move)]),
    (33, &[Shows(incremental_points), Shows(incremental_order)]),
    (34, &[Shows(targets), Shows(end_position)]),
    (35, &[Shows(targets), Shows(end_position)]),
    (36, &[Shows(mixed_targets), Shows(end_position)]),
    (37, &[Shows(line_and_sine_together), Shows(sine_starts), Shows(sine_ends)]),
    (38, &[Shows(override_speeds), Shows(override_keeps_velocity)]),
    (
        40,
        &[Shows(revolutions_time), Shows(revolutions_phases), Shows(revolutions_counts), Shows(counts_of_a_revolution)],
    ),
    (43, &[Shows(first_duration), Shows(peak_speeds)]),
    (44, &[Shows(first_duration), Shows(other_axis_rests)]),
];

/// The file for some seconds.
fn ran(listing: &Listing, seconds: f64) -> Bench {
    let mut bench = Bench::of(listing);
    bench.pass(seconds).clean();
    bench
}

/// Corners of two laps.
fn corners() -> Vec<Vec<f64>> {
    [[5.0, 0.0], [5.0, 5.0], [0.0, 5.0], [0.0, 0.0]].map(Vec::from).into_iter().cycle().take(8).collect()
}

fn square_sides(listing: &Listing, fact: &Fact) {
    let times = ran(listing, 10.0).visits(&corners());
    times.windows(2).for_each(|pair| fact.holds(pair[1] - pair[0], 0.0));
}

fn square_lap(listing: &Listing, fact: &Fact) {
    let times = ran(listing, 10.0).visits(&corners());
    fact.holds(times[7] - times[3], 0.0);
}

fn square_corners(listing: &Listing, fact: &Fact) {
    ran(listing, 5.0).visits(&fact.points());
}

fn square_feedhold(listing: &Listing, fact: &Fact) {
    let mut bench = ran(listing, 0.5);
    let hold = bench.controller.seconds();
    bench.ask("SET 520");
    bench.pass(2.0);
    let begin = bench.record.samples.iter().find(|sample| sample.seconds > hold && sample.speed() < 5.0 - 1e-6);
    let end = bench.record.samples.iter().find(|sample| sample.seconds > hold && sample.speed() == 0.0);
    let (begin, end) = (begin.expect("it slows down"), end.expect("it stops"));
    let stopping = end.seconds - begin.seconds;
    assert!(stopping <= fact.number() + 0.0005, "{stopping}");
    near(stopping, fact.number(), 0.001);
    near(end.position[0] - begin.position[0], 0.25, 0.003);
}

fn square_registers(listing: &Listing, _: &Fact) {
    let mut bench = Bench::planned(listing, &Plan { before: "RES X3 Y4\nENC0 RES 7", ..Plan::default() });
    bench.pass(0.0015).clean();
    let registers = (12_288..=12_291).chain([12_294, 12_295]);
    for register in registers.filter(|register| *register != 12_289) {
        for axis in 0..2 {
            assert_eq!(bench.number(&format!("?P{}", register + 256 * axis)).abs(), 0.0, "P{register}, axis {axis}");
        }
    }
}

/// Position and velocity from the first tick of motion.
fn shape(bench: &Bench) -> Vec<([f64; 3], [f64; 3])> {
    let (begin, end) = bench.motions()[0];
    let inside = |sample: &&Sample| (begin..=end).contains(&sample.seconds);
    bench.record.samples.iter().filter(inside).map(|sample| (sample.position, sample.velocity)).collect()
}

/// One line of a file, as the program.
fn one_move(listing: &Listing, line: usize) -> Bench {
    let move_line = listing.text.lines().nth(line).expect("a line");
    let mut bench = Bench::planned(listing, &Plan { replaced: &[(&listing.text, move_line)], ..Plan::default() });
    bench.pass(120.0).clean();
    bench
}

fn mov_is_optional(listing: &Listing, _: &Fact) {
    assert_eq!(shape(&one_move(listing, 2)), shape(&one_move(listing, 3)));
}

fn two_axes_together(listing: &Listing, _: &Fact) {
    let bench = one_move(listing, 4);
    let share = |sample: &Sample| (sample.position[0] / 20.0, sample.position[1] / -30.0);
    assert_eq!(bench.motions().len(), 1);
    for sample in &bench.record.samples {
        let (x, y) = share(sample);
        near(x, y, 1e-12);
    }
    assert_eq!((bench.position(0), bench.position(1)), (20.0, -30.0));
}

fn one_line_one_move(listing: &Listing, _: &Fact) {
    let bench = one_move(listing, 1);
    near(bench.durations()[0], 500.0_f64.hypot(100.0) / 5.0 + 5.0 / 10.0, 0.001);
    let text = listing.text.lines().nth(1).expect("a line").replace(' ', "\n");
    let mut bench = Bench::planned(listing, &Plan { replaced: &[(&listing.text, &text)], ..Plan::default() });
    bench.pass(130.0).clean();
    near(bench.durations()[0], (500.0 + 100.0) / 5.0 + 2.0 * 0.5, 0.001);
    bench.visits(&[vec![500.0, 0.0], vec![500.0, 100.0]]);
}

fn incremental_points(listing: &Listing, fact: &Fact) {
    let bench = ran(listing, 20.0);
    bench.visits(&fact.points());
}

fn incremental_order(listing: &Listing, _: &Fact) {
    let bench = ran(listing, 20.0);
    let times = bench.visits(&[vec![20.0, 0.0], vec![20.0, -30.0], vec![22.0, 2.0, -2.0]]);
    // 20, 30, and the diagonal of 2, 32 and 2, each with its ramps.
    let path = (2.0_f64.powi(2) * 2.0 + 32.0_f64.powi(2)).sqrt();
    for (time, length) in [times[0], times[1] - times[0], times[2] - times[1]].iter().zip([20.0, 30.0, path]) {
        near(*time, length / 5.0 + 0.5, 0.002);
    }
}

fn points(targets: &[f64]) -> Vec<Vec<f64>> {
    targets.iter().map(|target| vec![*target]).collect()
}

fn targets(listing: &Listing, fact: &Fact) {
    ran(listing, 300.0).visits(&points(&fact.numbers()));
}

fn mixed_targets(listing: &Listing, _: &Fact) {
    for start in [0.0, 37.5, -120.0] {
        let before = format!("RES X{start}");
        let mut bench = Bench::planned(listing, &Plan { before: &before, ..Plan::default() });
        bench.pass(300.0).clean();
        bench.visits(&points(&[start - 400.0, 200.0, 250.0, 400.0]));
        assert_eq!(bench.motions().len(), 1);
    }
}

fn end_position(listing: &Listing, fact: &Fact) {
    let bench = ran(listing, 300.0);
    fact.holds(bench.position(0), 0.0);
    assert!(!bench.bit(516));
}

/// The file from where the sinusoid begins.
fn line_and_sine(listing: &Listing) -> Bench {
    let mut bench = Bench::planned(listing, &Plan { before: "RES Y100", ..Plan::default() });
    bench.pass(60.0).clean();
    bench
}

fn line_and_sine_together(listing: &Listing, _: &Fact) {
    let bench = line_and_sine(listing);
    assert_eq!(bench.motions().len(), 1);
    let begin = bench.motions()[0].0;
    for sample in bench.record.samples.iter().filter(|sample| sample.seconds >= begin) {
        // X says how much of the way is done.
        let degrees = 90.0 + 90.0 * sample.position[0] / 2.0;
        near(sample.position[1], 100.0 * degrees.to_radians().sin(), 1e-9);
    }
    assert_eq!(bench.position(0), 2.0);
}

fn sine_starts(listing: &Listing, fact: &Fact) {
    let bench = line_and_sine(listing);
    fact.holds(bench.at(bench.motions()[0].0).position[1], 0.1);
}

fn sine_ends(listing: &Listing, fact: &Fact) {
    fact.holds(line_and_sine(listing).position(1), 0.0);
}

fn override_speeds(listing: &Listing, fact: &Fact) {
    let mut bench = Bench::terminal(listing);
    bench.ask("X10000");
    bench.pass(5.0);
    for (line, speed) in listing.text.lines().zip(fact.numbers()) {
        let before = bench.controller.view().motion(0).0;
        bench.ask(line);
        bench.pass((speed - before).abs() / 10.0 / 2.0);
        let between = bench.controller.view().motion(0).0;
        near(between, f64::midpoint(before, speed), 0.1);
        bench.pass(2.0);
        near(bench.controller.view().motion(0).0, speed, 1e-9);
    }
}

fn override_keeps_velocity(listing: &Listing, _: &Fact) {
    let mut bench = Bench::terminal(listing);
    for line in listing.text.lines() {
        bench.ask(line);
        assert_eq!(bench.number("VEL"), 20.0);
    }
}

fn revolutions_time(listing: &Listing, fact: &Fact) {
    fact.holds(ran(listing, 13.0).durations()[0], 0.0);
}

fn revolutions_phases(listing: &Listing, _: &Fact) {
    let bench = ran(listing, 13.0);
    let begin = bench.motions()[0].0;
    for (seconds, position, speed) in [(2.0, 20.0, 20.0), (10.0, 180.0, 20.0), (12.0, 200.0, 0.0)] {
        let sample = bench.at(begin + seconds);
        near(sample.position[0], position, 0.011);
        near(sample.speed(), speed, 0.006);
    }
}

fn revolutions_counts(listing: &Listing, fact: &Fact) {
    let mut bench = ran(listing, 13.0);
    fact.holds(bench.number("?P12288"), 0.0);
}

fn counts_of_a_revolution(listing: &Listing, fact: &Fact) {
    let mut bench = ran(listing, 0.1);
    bench.ask("PROG0");
    fact.holds(1000.0 * bench.number("MULT X"), 0.0);
    fact.holds(bench.number("PPU X"), 0.0);
}

fn first_duration(listing: &Listing, fact: &Fact) {
    fact.holds(ran(listing, 2.0).durations()[0], 0.0);
}

fn peak_speeds(listing: &Listing, fact: &Fact) {
    let bench = ran(listing, 2.0);
    for (axis, peak) in fact.numbers().into_iter().enumerate() {
        let speeds = bench.record.samples.iter().map(|sample| sample.velocity[axis]);
        near(speeds.fold(0.0, f64::max), peak, 0.01);
    }
    for sample in &bench.record.samples {
        near(sample.position[0] / 25.0, sample.position[1] / 15.0, 1e-12);
    }
}

fn other_axis_rests(listing: &Listing, _: &Fact) {
    let bench = ran(listing, 2.0);
    assert!(bench.record.samples.iter().all(|sample| sample.position[1] == 0.0));
    near(bench.durations()[0], 25.0 / 75.0 + 75.0 / 750.0, 0.001);
}
