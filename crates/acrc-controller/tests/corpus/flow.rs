//! The tutorial and the programs that show program flow.

use acrc_controller::State;

use crate::bench::{Bench, Plan, image, near};
use crate::check::{Check, Check::Shows};
use crate::guide::{Fact, Listing};

/// Two axes that need 1.1 seconds for 10 units.
const QUICK: &str = "ACC 100 DEC 100 STP 100 VEL 10";

pub(crate) const CHECKS: &[(u8, &[Check])] = &[
    (
        1,
        &[
            Shows(gantry_first_move),
            Shows(gantry_legs),
            Shows(gantry_points),
            Shows(gantry_output),
            Shows(gantry_cycle),
            Shows(never_ends),
        ],
    ),
    (2, &[Shows(carriage_move), Shows(carriage_follows_input), Shows(input_reads)]),
    (9, &[Shows(prints_forever), Shows(labels_have_case), Shows(one_level_of_gosub)]),
    (16, &[Shows(one_line_if), Shows(one_line_if_counts)]),
    (17, &[Shows(block_if_taken), Shows(block_else_taken), Shows(second_element)]),
    (18, &[Shows(prints_once)]),
    (19, &[Shows(four_statements), Shows(goto_move), Shows(goto_period), Shows(goto_passes)]),
    (20, &[Shows(for_prints), Shows(for_dwells), Shows(for_counter), Shows(for_break)]),
    (21, &[Shows(while_passes), Shows(while_leaves), Shows(while_prints)]),
    (22, &[Shows(inh_holds)]),
    (23, &[Shows(ihpos_lines), Shows(ihpos_timeout), Shows(ihpos_at_zero)]),
    (29, &[Shows(starts_at_power_up), Shows(half_period), Shows(period), Shows(changes), Shows(not_toggles)]),
];

fn gantry(listing: &Listing) -> Bench {
    let mut bench = Bench::planned(listing, &Plan { flag: Some(34), ..Plan::default() });
    bench.pass(42.0).clean();
    bench
}

fn gantry_first_move(listing: &Listing, fact: &Fact) {
    fact.holds(gantry(listing).durations()[0], 0.0);
}

fn gantry_legs(listing: &Listing, fact: &Fact) {
    let durations = gantry(listing).durations();
    assert_eq!(durations.len(), 8);
    for duration in &durations[1..] {
        fact.holds(*duration, 0.0);
    }
}

fn gantry_points(listing: &Listing, fact: &Fact) {
    let bench = gantry(listing);
    let ends: Vec<_> = bench.motions().iter().map(|(_, end)| bench.at(*end).position[..2].to_vec()).collect();
    assert_eq!(ends[..7], fact.points());
}

fn gantry_output(listing: &Listing, fact: &Fact) {
    let bench = gantry(listing);
    let begins: Vec<f64> = bench.motions().iter().map(|(begin, _)| *begin).collect();
    // It goes off and on within one slice or two, with the move between.
    near(bench.settings()[0], begins[0], 0.001);
    bench.record.changes[1..].chunks(2).for_each(|pair| near(pair[1].0 - pair[0].0, 0.0, 0.0025));
    begins.windows(2).for_each(|pair| fact.holds(pair[1] - pair[0], 0.003));
}

fn gantry_cycle(listing: &Listing, fact: &Fact) {
    let motions = gantry(listing).motions();
    // The lines of the six legs take some milliseconds themselves.
    fact.holds(motions[6].0 - motions[0].0, 0.02);
}

fn never_ends(listing: &Listing, _: &Fact) {
    let mut bench = Bench::planned(listing, &Plan { unwatched: true, ..Plan::default() });
    bench.pass(300.0).clean();
    assert!(matches!(bench.state(0), State::Running | State::Waiting));
}

const CURTAIN: &[(f64, u32, bool)] = &[(1.0, 10, true), (5.0, 10, false)];

fn carriage_move(listing: &Listing, fact: &Fact) {
    let mut bench = Bench::planned(listing, &Plan { inputs: CURTAIN, ..Plan::default() });
    let durations = bench.pass(8.0).clean().durations();
    assert_eq!(durations.len(), 2);
    for duration in durations {
        fact.holds(duration, 0.0);
    }
}

fn carriage_follows_input(listing: &Listing, _: &Fact) {
    let mut bench = Bench::planned(listing, &Plan { inputs: CURTAIN, ..Plan::default() });
    bench.pass(8.0).clean();
    for (seconds, position) in [(0.5, 0.0), (0.999, 0.0), (2.1, 5.0), (4.999, 5.0), (6.1, 0.0), (7.9, 0.0)] {
        near(bench.at(seconds).position[2], position, 0.0);
    }
}

fn input_reads(listing: &Listing, _: &Fact) {
    let mut bench = Bench::planned(listing, &Plan { inputs: CURTAIN, ..Plan::default() });
    assert_eq!(bench.pass(0.9).number("?BIT10"), 0.0);
    assert_eq!(bench.pass(1.0).number("?BIT10"), -1.0);
    assert_eq!(bench.pass(4.0).number("?BIT10"), 0.0);
}

fn prints_forever(listing: &Listing, fact: &Fact) {
    let mut bench = Bench::of(listing);
    bench.pass(1.0).clean();
    let lines = bench.printed(0);
    assert!(lines.len() > 100 && lines.iter().all(|line| line == fact.text()), "{}", lines.len());
    bench.ask("PROG0");
    bench.ask("HALT");
    let count = bench.printed(0).len();
    assert_eq!(bench.pass(1.0).printed(0).len(), count);
}

fn labels_have_case(listing: &Listing, _: &Fact) {
    let text = listing.project();
    image(&text, &listing.model).expect("it compiles as it is");
    for other in ["GOTO Start", "GOTO _START"] {
        let refusal = image(&text.replace("GOTO START", other), &listing.model);
        assert!(refusal.is_err(), "{other}");
    }
    assert!(image(&text.replace("GOSUB Label1", "GOSUB LABEL1"), &listing.model).is_err());
}

fn one_level_of_gosub(listing: &Listing, _: &Fact) {
    let mut bench = Bench::planned(listing, &Plan { idle: true, ..Plan::default() });
    bench.ask("PROG0");
    let text = 65_536.0 - bench.number("MEM");
    // A level of `GOSUB` takes 4 bytes: a space for the text and one level is enough for ever.
    for (space, enough) in [(text + 4.0, true), (text, false)] {
        let before = format!("SYS\nCLEAR\nDIM PROG0({space})\nPROG0");
        let mut bench = Bench::planned(listing, &Plan { before: &before, unwatched: true, ..Plan::default() });
        bench.pass(2.0);
        assert_eq!(bench.record.faults.is_empty(), enough, "{:?}", bench.record.faults);
    }
}

/// With a subroutine at line 100.
fn one_line(listing: &Listing, before: f64, input: bool) -> (f64, bool) {
    let before = format!("P0 = {before}");
    let plan = Plan {
        before: &before,
        behind: "END\n100 SET 33\nRETURN",
        inputs: if input { &[(0.0, 24, true)] } else { &[] },
        ..Plan::default()
    };
    let mut bench = Bench::planned(listing, &plan);
    bench.pass(0.1).clean();
    (bench.number("?P0"), bench.bit(33))
}

fn one_line_if(listing: &Listing, _: &Fact) {
    assert_eq!(one_line(listing, 4000.0, false), (4000.0, false));
    assert_eq!(one_line(listing, 4001.0, false), (4000.0, true));
    assert_eq!(one_line(listing, 5000.0, false), (4999.0, true));
}

fn one_line_if_counts(listing: &Listing, _: &Fact) {
    assert_eq!(one_line(listing, 7.0, true), (8.0, false));
    assert_eq!(one_line(listing, 7.0, false), (7.0, false));
}

fn block_if(listing: &Listing, input: bool) -> (f64, f64, f64) {
    let before = format!("{QUICK}\nRES X3 Y1\nLA0(1) = 10");
    let inputs: &[_] = if input { &[(0.0, 24, true)] } else { &[] };
    let mut bench = Bench::planned(listing, &Plan { before: &before, inputs, ..Plan::default() });
    bench.pass(5.0).clean();
    bench.ask("PROG0");
    (bench.number("?LA0(1)"), bench.position(0), bench.position(1))
}

fn block_if_taken(listing: &Listing, _: &Fact) {
    assert_eq!(block_if(listing, true), (11.0, 28.0, 1.0));
}

fn block_else_taken(listing: &Listing, _: &Fact) {
    assert_eq!(block_if(listing, false), (9.0, 3.0, 5.0));
}

fn second_element(listing: &Listing, _: &Fact) {
    let plan = Plan { before: QUICK, replaced: &[("LA0(2)", "LA0(1)")], ..Plan::default() };
    let mut bench = Bench::planned(listing, &plan);
    bench.pass(1.0);
    assert_eq!(bench.record.faults.len(), 1, "{:?}", bench.record.faults);
}

fn prints_once(listing: &Listing, fact: &Fact) {
    let mut bench =
        Bench::planned(listing, &Plan { replaced: &[("GOSUB Label1\n", "GOSUB Label1\nEND\n")], ..Plan::default() });
    assert_eq!(bench.pass(1.0).clean().printed(0), [fact.text()]);
}

fn four_statements(listing: &Listing, _: &Fact) {
    let mut bench = Bench::of(listing);
    bench.pass(0.1).clean();
    bench.ask("PROG0");
    let settings = ["ACC", "DEC", "STP", "VEL"].map(|name| bench.number(name));
    assert_eq!(settings, [10.0, 10.0, 10.0, 1.0]);
}

fn goto_move(listing: &Listing, fact: &Fact) {
    fact.holds(Bench::of(listing).pass(2.0).durations()[0], 0.0);
}

fn goto_period(listing: &Listing, fact: &Fact) {
    let mut bench = Bench::planned(listing, &Plan { flag: Some(32), ..Plan::default() });
    bench.pass(20.0).clean();
    let starts = bench.settings();
    starts.windows(2).for_each(|pair| fact.holds(pair[1] - pair[0], 0.0));
    bench.set_times().iter().for_each(|time| near(*time, 1.1, 0.01));
    assert_eq!(starts.len(), 7);
}

fn goto_passes(listing: &Listing, _: &Fact) {
    let mut bench = Bench::planned(listing, &Plan { flag: Some(32), ..Plan::default() });
    bench.pass(31.5).clean();
    let starts = bench.settings();
    for (pass, start) in starts.iter().enumerate() {
        near(bench.at(*start).position[0], pass as f64, 0.01);
    }
    assert_eq!((starts.len(), bench.at(30.9).position[0]), (11, 10.0));
}

/// The loop from the first to the last print, with input 24 off or on.
fn for_loop(listing: &Listing, input: bool) -> Bench {
    let inputs: &[_] = if input { &[(0.0, 24, true)] } else { &[] };
    let mut bench = Bench::planned(listing, &Plan { inputs, flag: Some(1032), ..Plan::default() });
    bench.pass(8.0).clean();
    assert_eq!(bench.state(0), State::Ended);
    bench.ask("PROG0");
    bench
}

fn for_prints(listing: &Listing, fact: &Fact) {
    fact.holds(for_loop(listing, false).printed(0).len() as f64, 0.0);
}

fn for_dwells(listing: &Listing, fact: &Fact) {
    let bench = for_loop(listing, false);
    let pauses: Vec<f64> = bench.record.lines.windows(2).map(|pair| pair[1].seconds - pair[0].seconds).collect();
    // The lines of a pass take less than 3 ms.
    assert!(pauses.iter().all(|pause| (0.01..0.013).contains(pause)));
    let dwells: f64 = pauses.iter().map(|_| 0.01).sum::<f64>() + 0.01;
    fact.holds(dwells, 1e-9);
}

fn for_counter(listing: &Listing, fact: &Fact) {
    fact.holds(for_loop(listing, false).number("?LV0"), 0.0);
}

fn for_break(listing: &Listing, _: &Fact) {
    let mut bench = for_loop(listing, true);
    assert_eq!((bench.printed(0).len(), bench.number("?LV0")), (1, 0.0));
}

fn while_loop(listing: &Listing, inputs: &[(f64, u32, bool)]) -> Bench {
    Bench::planned(listing, &Plan { before: "ACC 1000 DEC 1000 STP 1000 VEL 100", inputs, ..Plan::default() })
}

fn while_passes(listing: &Listing, _: &Fact) {
    let mut bench = while_loop(listing, &[]);
    bench.pass(10.0).clean();
    bench.ask("PROG0");
    let prints: Vec<f64> = bench.record.lines.iter().map(|line| line.seconds).collect();
    assert_eq!((prints.len(), bench.number("?LA0(1)")), (6, 7.0));
    for (pass, (begin, _)) in bench.motions().iter().enumerate() {
        near(bench.at(*begin).position[0], 25.0 * pass as f64, 0.1);
        if let Some(print) = prints.get(pass) {
            near(print - begin, 1.5, 0.003);
        }
    }
}

fn while_leaves(listing: &Listing, _: &Fact) {
    let mut bench = while_loop(listing, &[]);
    bench.pass(4.0);
    bench.ask("P6176 = 1499");
    assert_ne!(bench.pass(2.0).state(0), State::Ended);
    bench.ask("P6176 = 1500");
    assert_eq!(bench.pass(2.0).clean().state(0), State::Ended);
    let mut bench = while_loop(listing, &[(4.0, 24, true)]);
    bench.pass(8.0).clean();
    assert_eq!((bench.state(0), bench.printed(0)), (State::Ended, vec!["1".into(), "2".into(), "3".into()]));
}

fn while_prints(listing: &Listing, _: &Fact) {
    let mut bench = while_loop(listing, &[]);
    let printed = bench.pass(20.0).clean().printed(0);
    assert_eq!(printed, (1..=printed.len()).map(|number| number.to_string()).collect::<Vec<_>>());
}

fn inh_holds(listing: &Listing, _: &Fact) {
    let plan = Plan {
        before: QUICK,
        replaced: &[("INH 2 ", "X10\nINH 2 ")],
        behind: "PRINT \"through\"",
        inputs: &[(0.5, 2, true)],
        ..Plan::default()
    };
    let mut bench = Bench::planned(listing, &plan);
    bench.pass(3.0).clean();
    // The input comes on while the axis still moves, for 1.1 seconds.
    near(bench.record.lines[0].seconds, bench.motions()[0].1, 0.002);
    near(bench.record.lines[0].seconds, 1.1, 0.003);
    let plan = Plan { behind: "PRINT \"through\"", inputs: &[(0.5, 2, true)], ..Plan::default() };
    let mut bench = Bench::planned(listing, &plan);
    bench.pass(3.0).clean();
    near(bench.record.lines[0].seconds, 0.5, 0.002);
}

/// Times at which the lines are through, from power-up; the count of encoder 1 changes to what is typed.
fn ihpos(listing: &Listing, counts: &[(f64, i32)], until: f64) -> Vec<f64> {
    let marked: Vec<(String, String)> = (1..=3)
        .zip(listing.text.lines())
        .map(|(number, line)| (line.to_owned(), format!("{line}\nPRINT {number}")))
        .collect();
    let replaced: Vec<(&str, &str)> = marked.iter().map(|(from, to)| (from.as_str(), to.as_str())).collect();
    let mut bench = Bench::planned(listing, &Plan { replaced: &replaced, unwatched: true, ..Plan::default() });
    for (at, count) in counts {
        let now = bench.controller.seconds();
        bench.pass(at - now);
        bench.ask(&format!("P6160 = {count}"));
    }
    let now = bench.controller.seconds();
    bench.pass(until - now).clean();
    bench.record.lines.iter().map(|line| line.seconds).collect()
}

#[track_caller]
fn all_near(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len(), "{found:?}");
    found.iter().zip(expected).for_each(|(found, expected)| near(*found, *expected, 0.005));
}

fn ihpos_lines(listing: &Listing, _: &Fact) {
    all_near(&ihpos(listing, &[(1.0, 40_000), (2.0, 40_001)], 20.0), &[2.0, 7.5, 7.5]);
    all_near(&ihpos(listing, &[(1.0, 40_001), (3.0, 40_000), (4.0, 39_999)], 20.0), &[1.0, 4.0]);
    all_near(&ihpos(listing, &[(10.0, 50_000)], 20.0), &[5.5, 5.5, 10.0]);
}

fn ihpos_timeout(listing: &Listing, fact: &Fact) {
    fact.holds(ihpos(listing, &[], 20.0)[0], 0.003);
}

fn ihpos_at_zero(listing: &Listing, _: &Fact) {
    all_near(&ihpos(listing, &[], 3600.0), &[5.5, 5.5]);
}

fn flashing(listing: &Listing) -> Vec<(f64, bool)> {
    let programs =
        acrc_controller::Controller::boot_programs(&image(&listing.project(), &listing.model).expect("it compiles"));
    assert_eq!(programs, [0]);
    let mut bench = Bench::planned(listing, &Plan { flag: Some(32), ..Plan::default() });
    bench.pass(9.9995).clean();
    bench.record.changes
}

fn starts_at_power_up(listing: &Listing, _: &Fact) {
    near(flashing(listing)[0].0, 0.0, 0.002);
}

fn half_period(listing: &Listing, fact: &Fact) {
    flashing(listing).windows(2).for_each(|pair| fact.holds(pair[1].0 - pair[0].0, 0.0025));
}

fn period(listing: &Listing, fact: &Fact) {
    flashing(listing).windows(3).for_each(|pair| fact.holds(pair[2].0 - pair[0].0, 0.003));
}

fn changes(listing: &Listing, _: &Fact) {
    let changes = flashing(listing);
    assert_eq!((changes.len(), changes[0].1, changes[1].1), (40, true, false));
}

fn not_toggles(_: &Listing, _: &Fact) {
    let mut bench = Bench::setup("SYS\n");
    assert_eq!(bench.number("?NOT BIT32"), -1.0);
    bench.ask("SET 32");
    assert_eq!((bench.number("?BIT32"), bench.number("?NOT BIT32")), (-1.0, 0.0));
}
