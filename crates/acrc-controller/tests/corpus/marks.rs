//! Homing with the search for the marks of the encoders, on machines with switches and marks.

use acrc_controller::State;

use crate::bench::{Bench, Plan, near};
use crate::check::{Check, Check::Shows};
use crate::guide::{Fact, Listing};

pub(crate) const CHECKS: &[(u8, &[Check])] = &[
    (49, &[Shows(directions), Shows(waits_for_both), Shows(both_found), Shows(x_fails), Shows(home_inputs)]),
    (54, &[Shows(both_found_at_once), Shows(y_is_first), Shows(y_fails), Shows(y_flag), Shows(whole_search)]),
    (
        55,
        &[
            Shows(order),
            Shows(homing_bits),
            Shows(failures),
            Shows(wait_for_servos),
            Shows(last_way),
            Shows(counters_are_zero),
            Shows(settings_at_the_end),
        ],
    ),
];

const X_FOUND: u32 = 16_134;
const Y_FOUND: u32 = 16_166;
const MARK: &str = "marker = { every = 1, at = 0.4 }\n";

/// An axis that begins at zero, with limits at both ends of its way and a home switch, wired to three inputs.
fn axis(number: u32, home: (f64, f64), normally: &str, more: &str) -> String {
    let [positive, negative, switch] = [0, 1, 2].map(|place| number * 3 + place);
    let rest = format!("normally = \"{normally}\"");
    format!(
        "[axis.{number}]\n{more}switches = [\n{{ input = {positive}, above = 200, {rest} }},\n\
         {{ input = {negative}, below = -200, {rest} }},\n{{ input = {switch}, from = {}, to = {} }},\n]\n",
        home.0, home.1
    )
}

/// The file on a machine.
fn on(listing: &Listing, axes: &str, seconds: f64) -> Bench {
    let mut bench = Bench::planned(listing, &Plan { axes, ..Plan::default() });
    bench.pass(seconds).clean();
    bench
}

/// A machine for the first two files: the homes are in the directions of the searches. Limit switches open at the ends, as the levels are inverted.
fn two(x: f64, y: f64, x_more: &str) -> String {
    axis(0, (-x - 2.0, -x), "closed", x_more) + &axis(1, (y, y + 2.0), "closed", "")
}

fn directions(listing: &Listing, _: &Fact) {
    let bench = on(listing, &two(3.0, 3.0, MARK), 1.0);
    let begin = bench.record.samples.iter().find(|sample| sample.velocity[..2] != [0.0; 2]).expect("it moves");
    assert!(begin.velocity[0] < 0.0 && begin.velocity[1] > 0.0, "{begin:?}");
}

fn waits_for_both(listing: &Listing, _: &Fact) {
    for (x, y, last) in [(3.0, 30.0, Y_FOUND), (30.0, 3.0, X_FOUND)] {
        let axes = two(x, y, MARK);
        let mut bench = Bench::planned(listing, &Plan { axes: &axes, flag: Some(last), ..Plan::default() });
        bench.pass(20.0).clean();
        let found = bench.settings()[0];
        assert!(bench.record.lines.iter().all(|line| line.seconds >= found), "{:?}", bench.record.lines);
        assert_eq!(bench.printed(0).len(), 2);
    }
}

fn both_found(listing: &Listing, fact: &Fact) {
    let bench = on(listing, &two(3.0, 4.0, MARK), 20.0);
    assert_eq!(bench.printed(0).join(" and then "), fact.text().trim_start_matches("prints "));
}

fn x_fails(listing: &Listing, _: &Fact) {
    // Its home switch is beyond the limits.
    let bench = on(listing, &two(500.0, 4.0, MARK), 90.0);
    assert!(bench.bit(16_135) && !bench.bit(777) && bench.motions().is_empty());
    assert_eq!(bench.printed(0), ["Y HOMING SUCCESSFUL"]);
}

fn home_inputs(listing: &Listing, _: &Fact) {
    for (input, found) in [("input = 2", 16_134), ("input = 5", 16_166)] {
        let axes = two(3.0, 4.0, MARK);
        assert!(on(listing, &axes, 3.0).bit(found));
        assert!(!on(listing, &axes.replace(input, "input = 12"), 3.0).bit(found));
    }
}

/// A machine for the second file, whose limits are not enabled.
fn slow(x: f64, y: f64, x_more: &str) -> String {
    axis(0, (-x - 2.0, -x), "open", x_more) + &axis(1, (y, y + 2.0), "open", "")
}

fn both_found_at_once(listing: &Listing, fact: &Fact) {
    let bench = on(listing, &slow(3.0, 3.0, MARK), 20.0);
    assert_eq!(bench.printed(0), fact.texts());
    assert!(bench.bit(128) && bench.bit(129));
}

fn y_is_first(listing: &Listing, fact: &Fact) {
    let bench = on(listing, &slow(30.0, 3.0, MARK), 20.0);
    assert_eq!(bench.printed(0), fact.texts());
    assert!(bench.state(listing.program()) == State::Ended && !bench.bit(16_134) && !bench.bit(16_135));
}

fn y_fails(listing: &Listing, fact: &Fact) {
    let plan = Plan { before: "HLIM Y3\nHLDEC Y1000\n", axes: &slow(900.0, 500.0, MARK), ..Plan::default() };
    let mut bench = Bench::planned(listing, &plan);
    bench.pass(700.0).clean();
    assert_eq!(bench.printed(0), fact.texts());
}

fn y_flag(listing: &Listing, _: &Fact) {
    let bench = on(listing, &slow(3.0, 30.0, MARK), 20.0);
    assert!(!bench.bit(128) && bench.bit(129), "{:?}", bench.printed(0));
}

fn whole_search(listing: &Listing, fact: &Fact) {
    let bench = on(listing, &slow(3.0, 3.0, ""), 20.0);
    assert!(!bench.bit(777) && bench.printed(0) == ["Y HOMING SUCCESSFUL"]);
    fact.holds(bench.durations()[0], 0.002);
}

/// The machine of the third file. The homes lie a little on in the directions of the searches, and each encoder has a mark a turn.
const HOMES: [(f64, f64); 3] = [(50.0, 60.0), (-60.0, -50.0), (-20.0, -10.0)];

fn three(homes: [(f64, f64); 3]) -> String {
    let marks = ["marker = { every = 10, at = 3 }\n", "marker = { every = 10, at = 4 }\n", "marker = { every = 5 }\n"];
    (0..).zip(homes).zip(marks).map(|((number, home), mark)| axis(number, home, "open", mark)).collect()
}

/// Which axes move at some time, and in which direction.
fn signs(velocity: [f64; 3]) -> [i8; 3] {
    velocity.map(|velocity| if velocity == 0.0 { 0 } else { velocity.signum() as i8 })
}

/// Where the coordinated moves began and ended, split where everything stands.
fn ways(bench: &Bench) -> Vec<(f64, f64)> {
    let start = bench.motions()[0].0;
    let mut ways = Vec::new();
    let mut begin = start;
    for sample in bench.record.samples.iter().filter(|sample| sample.seconds > start && sample.speed() == 0.0) {
        if sample.seconds - begin > 0.001 {
            ways.push((begin, sample.seconds));
        }
        begin = sample.seconds;
    }
    ways
}

fn order(listing: &Listing, _: &Fact) {
    let bench = on(listing, &three(HOMES), 60.0);
    let samples = &bench.record.samples;
    let z = samples.iter().position(|sample| sample.velocity[2] != 0.0).expect("Z moves");
    let xy = samples.iter().position(|sample| sample.velocity[..2] != [0.0; 2]).expect("X and Y move");
    assert_eq!(signs(samples[z].velocity), [0, 0, -1]);
    assert_eq!(signs(samples[xy].velocity), [1, -1, 0]);
    assert!(z < xy && samples[z..xy].iter().all(|sample| sample.velocity[..2] == [0.0; 2]));
    let first: Vec<[i8; 3]> = ways(&bench).iter().map(|(begin, _)| signs(bench.at(*begin + 0.001).velocity)).collect();
    // Behind its mark each axis returns to it.
    let marks = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
    assert_eq!((&first[..6], &first[6..]), (&marks[..], &[[-1, -1, -1]][..]));
    assert!([777, 809, 841].iter().all(|flag| bench.bit(*flag)));
}

fn homing_bits(listing: &Listing, fact: &Fact) {
    let bench = on(listing, &three(HOMES), 60.0);
    let word = |set: bool| if set { "negative" } else { "positive" };
    let axes = ["X", "Y", "Z"].iter().zip([16_152, 16_184, 16_216]).map(|(name, first)| {
        let [backup, edge, last] = [0, 1, 2].map(|place| bench.bit(first + place));
        assert!(backup);
        format!("{name} backup, {} edge, {} final", word(edge), word(last))
    });
    assert_eq!(axes.collect::<Vec<_>>().join("; "), fact.text());
}

fn failures(listing: &Listing, fact: &Fact) {
    let program = listing.program();
    for (text, failing) in fact.texts().into_iter().zip([2, 0, 1]) {
        let mut homes = HOMES;
        homes[failing] = (500.0, 510.0);
        let bench = on(listing, &three(homes), 90.0);
        assert_eq!(bench.printed(0), [text]);
        assert_eq!(bench.state(program), State::Ended);
    }
}

fn wait_for_servos(listing: &Listing, fact: &Fact) {
    let axes = three(HOMES);
    let mut bench = Bench::planned(listing, &Plan { axes: &axes, flag: Some(8465), ..Plan::default() });
    bench.pass(2.0).clean();
    let moving = bench.record.samples.iter().find(|sample| sample.velocity[2] != 0.0).expect("Z moves").seconds;
    // Some slices of four lines lie between the wait and the first move.
    near(moving - bench.settings()[0], fact.number(), 0.02);
}

fn last_way(listing: &Listing, fact: &Fact) {
    let bench = on(listing, &three(HOMES), 60.0);
    let (begin, end) = ways(&bench)[6];
    let (from, to) = (bench.at(begin).position, bench.at(end).position);
    let length = (0..3).map(|axis| (to[axis] - from[axis]).powi(2)).sum::<f64>().sqrt();
    fact.holds(length, 0.001);
}

fn counters_are_zero(listing: &Listing, fact: &Fact) {
    let mut bench = on(listing, &three(HOMES), 60.0);
    for axis in 0..3 {
        for register in [12_288, 12_289, 12_290, 12_294, 12_295] {
            assert_eq!(bench.number(&format!("?P{}", register + 256 * axis)), fact.number());
        }
    }
}

fn settings_at_the_end(listing: &Listing, fact: &Fact) {
    let mut bench = on(listing, &three(HOMES), 60.0);
    bench.ask(&format!("PROG{}", listing.program()));
    let words: Vec<&str> = fact.fact.split_whitespace().skip(3).collect();
    for pair in words.chunks_exact(2).take(5) {
        assert_eq!(bench.ask(pair[0]).trim(), pair[1], "{}", pair[0]);
    }
}
