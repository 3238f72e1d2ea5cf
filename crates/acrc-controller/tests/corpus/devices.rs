//! Drives, operator dialogues and networks.

use acrc_controller::State;

use crate::bench::{Bench, Plan, near};
use crate::check::{Check, Check::Shows};
use crate::guide::{Fact, Listing};

pub(crate) const CHECKS: &[(u8, &[Check])] = &[
    (52, &[Shows(drive_dwell), Shows(drive_messages), Shows(bit_in_any_case)]),
    (
        56,
        &[
            Shows(|listing, fact| fruit(listing, fact, "aA")),
            Shows(|listing, fact| fruit(listing, fact, "bB")),
            Shows(|listing, fact| fruit(listing, fact, "cC")),
            Shows(fruit_ends),
            Shows(fruit_asks_again),
            Shows(fruit_line_stays_open),
        ],
    ),
    (53, &[Shows(epl_operational), Shows(epl_second_start), Shows(epl_problem), Shows(epl_alias)]),
    (
        57,
        &[
            Shows(teach_three),
            Shows(teach_message),
            Shows(teach_refuses),
            Shows(teach_indices),
            Shows(teach_runs),
            Shows(teach_dwell),
        ],
    ),
    (
        59,
        &[
            Shows(can_dwell),
            Shows(can_input),
            Shows(can_output),
            Shows(can_output),
            Shows(can_analog),
            Shows(can_analog_follows),
        ],
    ),
    (60, &[Shows(can_operational), Shows(can_problem), Shows(can_reset_is_remembered)]),
    (62, &[Shows(drive_talk_flags), Shows(drive_talk_values)]),
];

fn drive_dwell(listing: &Listing, fact: &Fact) {
    let mut bench = Bench::planned(listing, &Plan { flag: Some(8465), ..Plan::default() });
    bench.pass(1.0).clean();
    fact.holds(bench.record.lines[0].seconds - bench.settings()[0], 0.002);
}

fn drive_messages(listing: &Listing, fact: &Fact) {
    let mut bench = Bench::of(listing);
    assert_eq!(bench.pass(1.0).clean().printed(0), fact.texts());
    assert!(bench.bit(8465) && bench.bit(8497) && !bench.bit(8467));
}

fn bit_in_any_case(_: &Listing, _: &Fact) {
    let mut bench = Bench::setup("SET 40\n");
    assert_eq!(["?bit 40", "?Bit40", "?BIT40"].map(|line| bench.number(line)), [-1.0; 3]);
}

/// What is printed with a network whose flags change like this; its card answers at once.
fn powerlink(listing: &Listing, changes: &[(f64, u32, bool)]) -> Bench {
    let inputs: Vec<_> = [(0.0, 16_648, true)].iter().chain(changes).copied().collect();
    let mut bench = Bench::planned(listing, &Plan { inputs: &inputs, unwatched: true, ..Plan::default() });
    bench.pass(5.0).clean();
    assert_eq!(bench.state(0), State::Ended);
    bench
}

fn epl_operational(listing: &Listing, fact: &Fact) {
    let starts = [(0.0, 16_640, true), (0.5, 16_649, true), (0.6, 16_640, false)];
    assert_eq!(powerlink(listing, &starts).printed(0), fact.texts());
}

fn epl_second_start(listing: &Listing, fact: &Fact) {
    let told = powerlink(listing, &[(0.1, 16_650, true)]).record.lines[0].seconds;
    // The network comes up while the program has it reset and started again.
    let fails = [(0.1, 16_650, true), (told + 0.001, 16_649, true)];
    assert_eq!(powerlink(listing, &fails).printed(0), fact.texts());
}

fn epl_problem(listing: &Listing, fact: &Fact) {
    assert_eq!(powerlink(listing, &[(0.1, 16_650, true)]).printed(0), fact.texts());
}

fn epl_alias(listing: &Listing, _: &Fact) {
    assert!(powerlink(listing, &[(0.1, 16_650, true)]).bit(150));
    assert!(!powerlink(listing, &[(0.1, 16_649, true)]).bit(150));
}

/// The dialogue with keys typed, half a second apart.
fn dialogue(listing: &Listing, keys: &str) -> Bench {
    let typed: Vec<String> = keys.chars().map(String::from).collect();
    let typed: Vec<(f64, &str, &str)> =
        typed.iter().enumerate().map(|(index, key)| (0.5 + 0.5 * index as f64, "STREAM3", key.as_str())).collect();
    let mut bench = Bench::planned(listing, &Plan { typed: &typed, unwatched: true, ..Plan::default() });
    bench.pass(1.0 + 0.5 * keys.len() as f64).clean();
    bench
}

/// Questions asked on the stream.
fn questions(bench: &Bench) -> usize {
    bench.printed(1).iter().filter(|line| line.ends_with('?')).count()
}

fn fruit(listing: &Listing, fact: &Fact, keys: &str) {
    for key in keys.chars() {
        let bench = dialogue(listing, &key.to_string());
        assert_eq!(bench.printed(0)[0], fact.text());
        assert_eq!(questions(&bench), 2);
    }
}

fn fruit_ends(listing: &Listing, _: &Fact) {
    for key in ["x", "X", "\u{1b}"] {
        let mut bench = dialogue(listing, key);
        assert_eq!(bench.printed(1).last().map(String::as_str), Some("Program terminated"));
        assert_eq!(bench.state(0), State::Ended);
        // The device is free again.
        bench.ask("PROG0");
        assert_eq!(bench.ask("OPEN \"COM2:\" AS #1"), "");
    }
}

fn fruit_asks_again(listing: &Listing, _: &Fact) {
    let bench = dialogue(listing, "q7");
    assert_eq!(questions(&bench), 3);
    assert_eq!(bench.printed(0), ["I would like to have a".repeat(3)]);
    assert_eq!(bench.state(0), State::Running);
}

fn fruit_line_stays_open(listing: &Listing, _: &Fact) {
    let bench = dialogue(listing, "");
    let text: String =
        bench.record.lines.iter().filter(|line| line.device == 0).map(|line| line.text.as_str()).collect();
    assert_eq!(text, "I would like to have a");
}

/// Presses of input 24 at some times, each for 0.2 seconds.
fn presses(times: &[f64]) -> Vec<(f64, u32, bool)> {
    times.iter().flat_map(|at| [(*at, 24, true), (at + 0.2, 24, false)]).collect()
}

/// Teaching behind an answer, with the axis turned to 10, 20 and 30 counts before each press, at 2, 3 and 4 seconds.
fn teach(listing: &Listing, answer: &str) -> Bench {
    let inputs = presses(&[2.0, 3.0, 4.0, 6.0, 12.0]);
    let plan = Plan {
        before: "PPU X10",
        inputs: &inputs,
        typed: &[(0.5, "PROG0", answer)],
        flag: Some(8465),
        ..Plan::default()
    };
    let mut bench = Bench::planned(listing, &plan);
    for point in 1..=3 {
        let now = bench.controller.seconds();
        bench.pass(f64::from(point) + 0.7 - now);
        bench.ask(&format!("P12290 = {}", 10 * point));
    }
    bench
}

fn teach_three(listing: &Listing, _: &Fact) {
    let mut bench = teach(listing, "3\n");
    bench.pass(1.5).clean();
    bench.ask("PROG0");
    assert_eq!(bench.number("?LV1"), 3.0);
    assert_eq!([0, 1, 2].map(|point| bench.number(&format!("?DA0({point})"))), [1.0, 2.0, 3.0]);
}

fn teach_message(listing: &Listing, fact: &Fact) {
    let mut bench = teach(listing, "3\n");
    let printed = bench.pass(1.5).printed(0);
    let words = fact.text().trim_start_matches('^').split(" ?").next().expect("words").to_owned();
    assert!(printed.iter().any(|line| line.strip_prefix(&words).is_some_and(|rest| rest.trim() == "3")), "{printed:?}");
}

fn teach_refuses(listing: &Listing, _: &Fact) {
    for answer in ["0", "-1", "three"] {
        let mut bench = teach(listing, &format!("{answer}\n"));
        bench.pass(0.1).clean();
        let text = bench.printed(0).join("\n");
        assert_eq!(text.matches("must greater than 0").count(), 2, "{text}");
        assert_eq!(text.matches("NOT VALID").count(), 1, "{text}");
        assert_eq!(text.matches("must be a number").count(), 1, "{text}");
    }
}

fn teach_indices(listing: &Listing, fact: &Fact) {
    assert_eq!(fact.text(), "0 to LV1-1");
    let mut bench = teach(listing, "2\n");
    bench.pass(0.5).clean();
    bench.ask("PROG0");
    assert_eq!((bench.number("?DA0(0)"), bench.number("?DA0(1)"), bench.number("?LV0")), (1.0, 2.0, 2.0));
    assert_ne!(bench.ask("?DA0(2)"), "");
    assert!(bench.ask("?DA0(2)").trim().parse::<f64>().is_err());
}

fn teach_runs(listing: &Listing, _: &Fact) {
    let mut bench = teach(listing, "3\n");
    bench.pass(16.0).clean();
    let motions = bench.motions();
    // The drive at the second press behind teaching, then to zero, then to each point at the press behind that.
    let switched = bench.settings()[0];
    near(switched, 6.2, 0.003);
    near(motions[0].0, switched + 0.5, 0.003);
    let ends: Vec<f64> = motions.iter().map(|(_, end)| bench.at(*end).position[0]).collect();
    assert_eq!(ends, [0.0, 1.0, 2.0, 3.0]);
    near(motions[1].0, 12.0, 0.003);
    let prints: Vec<&str> = bench.record.lines.iter().rev().take(3).map(|line| line.text.trim_end()).collect();
    assert_eq!(prints, ["3", "2", "1"]);
    for (line, (_, end)) in bench.record.lines.iter().rev().zip(motions.iter().rev()).take(3) {
        assert!((0.0..0.004).contains(&(line.seconds - end)), "{} {end}", line.seconds);
    }
}

fn teach_dwell(listing: &Listing, fact: &Fact) {
    let mut bench = teach(listing, "3\n");
    bench.pass(6.0).clean();
    fact.holds(bench.motions()[0].0 - bench.settings()[0], 0.003);
}

/// With the first digital input of node 0 on from some time, for half a second, and a voltage at its first analog input.
fn network(listing: &Listing, on: f64, volts: f64) -> Bench {
    let plan = Plan {
        inputs: &[(on, 11_520, true), (on + 0.5, 11_520, false)],
        parameters: &[(0.5, "P33288", volts)],
        flag: Some(12_033),
        ..Plan::default()
    };
    let mut bench = Bench::planned(listing, &plan);
    bench.pass(on + 0.4).clean();
    bench
}

fn can_dwell(listing: &Listing, fact: &Fact) {
    // The lines before and behind take some milliseconds.
    fact.holds(network(listing, 0.8, 0.0).settings()[0], 0.02);
}

fn can_input(listing: &Listing, fact: &Fact) {
    let mut bench = network(listing, 2.0, 0.0);
    near(bench.settings()[0], 2.0, 0.003);
    assert_eq!(bench.number(&format!("?BIT{}", fact.number())), -1.0);
}

fn can_output(listing: &Listing, fact: &Fact) {
    let output = fact.number() as i64;
    let mut bench = network(listing, 2.0, 0.0);
    assert!(bench.bit(output));
    assert!(!bench.pass(0.2).bit(output));
}

fn can_analog(listing: &Listing, fact: &Fact) {
    let mut bench = network(listing, 2.0, 6.0);
    assert_eq!(bench.number(&format!("?{}", fact.text())), 2.5);
}

fn can_analog_follows(listing: &Listing, _: &Fact) {
    for (volts, output) in [(5.1, 2.5), (5.0, 0.0)] {
        let mut bench = network(listing, 2.0, volts);
        assert_eq!(bench.number("?P33792"), output, "{volts}");
        assert_eq!(bench.pass(0.2).number("?P33792"), 0.0);
    }
}

fn can_start(listing: &Listing, inputs: &[(f64, u32, bool)]) -> Bench {
    let mut bench = Bench::planned(listing, &Plan { inputs, unwatched: true, ..Plan::default() });
    bench.pass(2.0).clean();
    bench
}

fn can_operational(listing: &Listing, _: &Fact) {
    let bench = can_start(listing, &[(0.0, 11_269, true)]);
    assert_eq!((bench.printed(0), bench.bit(151), bench.state(0)), (vec![], false, State::Ended));
}

fn can_problem(listing: &Listing, fact: &Fact) {
    assert_eq!(can_start(listing, &[]).printed(0), fact.texts());
}

fn can_reset_is_remembered(listing: &Listing, _: &Fact) {
    let mut bench = can_start(listing, &[]);
    assert!(bench.bit(151));
    bench.pass(100.0);
    assert!(bench.bit(151));
}

fn drive_talk_flags(listing: &Listing, _: &Fact) {
    let mut bench = Bench::of(listing);
    bench.pass(0.5).clean();
    for axis in 0..2 {
        for index in [9, 4] {
            assert!(listing.text.contains(&format!("SET {}", 10_496 + 32 * axis + index)));
        }
        assert!(bench.bit(10_496 + 32 * axis + 9));
    }
}

fn drive_talk_values(listing: &Listing, fact: &Fact) {
    let names = fact.texts();
    let parameters = [(0.0, names[0], 12.0), (0.0, names[1], 34.0)];
    let mut bench = Bench::planned(listing, &Plan { parameters: &parameters, ..Plan::default() });
    assert_eq!(bench.pass(0.5).clean().printed(0), ["12", "34", "12", "34"]);
}
