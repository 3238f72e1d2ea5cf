//! Bits, expressions and random numbers.

use acrc_controller::State;

use crate::bench::{Bench, Plan};
use crate::check::{Check, Check::Shows};
use crate::guide::{Fact, Listing};

pub(crate) const CHECKS: &[(u8, &[Check])] = &[
    (24, &[Shows(bit_is_set), Shows(bit_is_clear), Shows(question_mark_prints)]),
    (
        26,
        &[
            Shows(expression),
            Shows(expression),
            Shows(expression),
            Shows(expression),
            Shows(expression),
            Shows(move_to_a_sum),
            Shows(strings_join),
        ],
    ),
    (27, &[Shows(draws_are_counted), Shows(at_least_one_draw), Shows(draws_are_even), Shows(same_seed)]),
    (28, &[Shows(patterns_change), Shows(half_of_the_outputs)]),
];

/// What bit 32 reads behind each of some lines, typed from the opposite state.
fn bit_behind(listing: &Listing, lines: std::ops::Range<usize>, before: &str, fact: &Fact) {
    for line in listing.text.lines().skip(lines.start).take(lines.len()) {
        let mut bench = Bench::setup("PROG0\n");
        bench.ask(before);
        assert_eq!(bench.ask(line), "");
        fact.holds(bench.number("?BIT32"), 0.0);
    }
}

fn bit_is_set(listing: &Listing, fact: &Fact) {
    bit_behind(listing, 0..3, "CLR 32", fact);
}

fn bit_is_clear(listing: &Listing, fact: &Fact) {
    bit_behind(listing, 3..6, "SET 32", fact);
}

fn question_mark_prints(listing: &Listing, _: &Fact) {
    let plan = Plan { before: "P6144 = 1234", inputs: &[(0.0, 24, true)], ..Plan::default() };
    let mut bench = Bench::planned(listing, &plan);
    assert_eq!(bench.pass(0.1).clean().printed(0), ["1234", "-1", "1234", "-1"]);
    assert_eq!(Bench::of(listing).pass(0.1).clean().printed(0), ["0", "0", "0", "0"]);
}

/// The expression is what the fact says.
fn expression(listing: &Listing, fact: &Fact) {
    let mut bench = Bench::terminal(listing);
    fact.holds(bench.number(&format!("? {}", fact.fact)), 0.0);
}

fn move_to_a_sum(listing: &Listing, fact: &Fact) {
    let before = "ACC 100 DEC 100 STP 100 VEL 10\nP0 = 1 : P2 = 2 : P30 = 3";
    let mut bench = Bench::planned(listing, &Plan { before, ..Plan::default() });
    bench.pass(5.0).clean();
    fact.holds(bench.position(0), 0.0);
    assert!(bench.printed(0).is_empty());
}

fn strings_join(listing: &Listing, _: &Fact) {
    let before = "VEL 10\nP0 = 1234\n$V1 = \"left \" : $V2 = \"right\"";
    let mut bench = Bench::planned(listing, &Plan { before, ..Plan::default() });
    assert_eq!(bench.pass(1.0).clean().printed(0), ["ok"]);
    bench.ask("PROG0");
    assert_eq!(bench.ask("?$V0"), "left right\n");
}

/// The count that the loop prints.
fn draws(listing: &Listing, seed: u64) -> u64 {
    let mut bench = Bench::planned(listing, &Plan { seed, unwatched: true, ..Plan::default() });
    bench.pass(60.0).clean();
    assert_eq!(bench.state(0), State::Ended);
    bench.ask("PROG0");
    assert_eq!(bench.number("?LV1"), 123.0);
    let printed = bench.printed(0);
    let count = printed[0].strip_prefix("Done in").and_then(|rest| rest.strip_suffix("tries"));
    assert_eq!(printed.len(), 1);
    count.expect("the count between the words").trim().parse().expect("a number")
}

fn draws_are_counted(listing: &Listing, fact: &Fact) {
    // `draws` looks for what the pattern of the fact says.
    assert!(fact.text().starts_with("^Done in") && fact.text().ends_with("tries$"));
    let count = draws(listing, 1);
    // The same numbers drawn by a loop that counts in another way.
    let loops = "PROG0\nDIM LV(2)\nPROGRAM\nFOR LV0 = 1 TO 100000\nLV1 = RND(1000)\nIF (LV1 = 123)\nBREAK\nENDIF\nNEXT\nPRINT LV0\nENDP\n";
    let mut bench = Bench::powered_with(loops, &Plan { seed: 1, unwatched: true, ..Plan::default() });
    assert_eq!(bench.pass(60.0).clean().printed(0), [count.to_string()]);
}

fn at_least_one_draw(listing: &Listing, fact: &Fact) {
    assert!((0..20).all(|seed| draws(listing, seed) as f64 >= fact.number()));
}

fn draws_are_even(listing: &Listing, _: &Fact) {
    let counts: Vec<u64> = (0..60).map(|seed| draws(listing, seed)).collect();
    let mean = counts.iter().sum::<u64>() as f64 / counts.len() as f64;
    // The mean of 60 such counts has a standard deviation of 130.
    assert!((600.0..1400.0).contains(&mean), "{mean}");
    let program = "PROG0\nDIM LV(4)\nPROGRAM\nLV2 = 5000\nFOR LV0 = 1 TO 20000\nLV1 = RND(1000)\nIF (LV1 < LV2) THEN LV2 = LV1\n\
                   IF (LV1 > LV3) THEN LV3 = LV1\nNEXT\nPRINT LV2; \" \"; LV3\nENDP\n";
    let mut bench = Bench::powered_with(program, &Plan { unwatched: true, ..Plan::default() });
    assert_eq!(bench.pass(60.0).clean().printed(0), ["0 999"]);
}

fn same_seed(listing: &Listing, _: &Fact) {
    assert_eq!(draws(listing, 7), draws(listing, 7));
    assert!((0..5).any(|seed| draws(listing, seed) != draws(listing, 7)));
}

/// The outputs of many passes.
fn patterns(listing: &Listing) -> Vec<u32> {
    let mut bench = Bench::planned(listing, &Plan { unwatched: true, ..Plan::default() });
    let read = |bench: &Bench| match bench.controller.parameter(4097) {
        Ok(acrc_vm::Value::Long(word)) => word as u32,
        other => panic!("{other:?}"),
    };
    let patterns = (0..1000).map(|_| read(bench.pass(0.002))).collect();
    assert_eq!(bench.clean().state(0), State::Running);
    patterns
}

fn patterns_change(listing: &Listing, _: &Fact) {
    let patterns = patterns(listing);
    assert!(patterns.windows(2).all(|pair| pair[0] != pair[1]));
}

fn half_of_the_outputs(listing: &Listing, _: &Fact) {
    let patterns = patterns(listing);
    for output in 0..32 {
        let on = patterns.iter().filter(|pattern| *pattern >> output & 1 == 1).count();
        assert!((400..600).contains(&on), "output {output} was on in {on} of 1000 passes");
    }
}
