//! Troubleshooting and the generic error handler.

use crate::bench::{Bench, Plan};
use crate::check::{Check, Check::Shows};
use crate::guide::{Fact, Listing};

pub(crate) const CHECKS: &[(u8, &[Check])] = &[
    (64, &[Shows(torque_limit), Shows(latch_is_cleared)]),
    (
        65,
        &[
            Shows(alias_count),
            Shows(two_word_else_if),
            Shows(no_errors),
            Shows(user_kill),
            Shows(software_limit),
            Shows(hardware_limit),
            Shows(clock),
            Shows(exact_divisions),
            Shows(codes_are_cleared),
        ],
    ),
];

fn torque_limit(listing: &Listing, fact: &Fact) {
    let mut bench = Bench::of(listing);
    bench.pass(0.1).clean();
    bench.ask("PROG0");
    let limit = bench.ask("TLM X").lines().next().expect("the positive side").parse::<f64>().expect("a number");
    // Of 10 V.
    fact.holds(limit / 10.0 * 100.0, 0.0);
}

fn latch_is_cleared(listing: &Listing, _: &Fact) {
    let mut bench = Bench::planned(listing, &Plan { inputs: &[(0.0, 5645, true)], ..Plan::default() });
    bench.pass(0.1).clean();
    assert!(!bench.bit(5645) && !bench.bit(5647));
}

/// The handler, with what is typed a second after its start, and what happens outside.
fn handler(listing: &Listing, typed: &[&str], plan: &Plan) -> Bench {
    let mut bench = Bench::planned(listing, &Plan { before: MACHINE, unwatched: true, ..*plan });
    bench.pass(1.0);
    for line in typed {
        assert_eq!(bench.ask(line), "", "{line}");
    }
    bench.pass(1.0).clean();
    bench.ask("PROG1");
    bench
}

/// Two axes of program 0, enabled, as the handler supposes.
const MACHINE: &str = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"\nACC 100 DEC 100 STP 100 VEL 10\nDRIVE ON X Y\n\
                       PROGRAM\n_Again\nDWL 0.1\nGOTO Again\nENDP\nRUN\nPROG1\n";

fn alias_count(listing: &Listing, fact: &Fact) {
    let mut bench = handler(listing, &[], &Plan::default());
    fact.holds(bench.ask("DEF").lines().count() as f64, 0.0);
}

fn two_word_else_if(listing: &Listing, _: &Fact) {
    // The Motion Enable Input opens and closes again: the second branch of the chain.
    let inputs = &[(1.0, 5646, true), (2.5, 5646, false)];
    let mut bench = handler(listing, &[], &Plan { inputs, ..Plan::default() });
    assert_eq!(bench.ask("?$V0"), "Motion Enable Input is open\n");
    assert_eq!(bench.number("?P50"), 1.0);
    bench.pass(1.0).clean();
    assert_eq!(bench.ask("?$V0"), "Motion Enable Input is good\n");
    assert_eq!(bench.number("?P50"), 0.0);
}

fn no_errors(listing: &Listing, _: &Fact) {
    let mut bench = handler(listing, &[], &Plan::default());
    assert!(bench.printed(1).is_empty());
    assert_eq!(
        (bench.ask("?$V2"), bench.ask("?$V3")),
        ("No errors on axis 0\n".into(), "No errors on Axis 1\n".into())
    );
}

/// Whether a line fits the pattern of a fact, whose blanks before question marks may be missing.
fn fits(line: &str, pattern: &str) -> bool {
    let pattern = pattern.trim_start_matches('^').trim_end_matches('$').replace(" ?", " ").replace('\\', "");
    let plain = |text: &str| text.replace(' ', "");
    plain(line) == plain(&pattern)
}

#[track_caller]
fn error_line(bench: &Bench, fact: &Fact) {
    let printed = bench.printed(1);
    let place = printed.iter().position(|line| fits(line, fact.text()));
    let place = place.unwrap_or_else(|| panic!("{printed:?} lacks {}", fact.text()));
    assert!(printed[place - 1].starts_with("Approximate Time Running"), "{printed:?}");
}

fn user_kill(listing: &Listing, fact: &Fact) {
    let bench = handler(listing, &["SET 8467"], &Plan::default());
    error_line(&bench, fact);
    assert!(bench.printed(1).contains(&String::new()));
    assert!(!bench.bit(8467) && !bench.bit(522));
    assert_eq!(bench.state(0), acrc_controller::State::Paused);
}

fn software_limit(listing: &Listing, fact: &Fact) {
    error_line(&handler(listing, &["SET 16140"], &Plan::default()), fact);
}

fn hardware_limit(listing: &Listing, fact: &Fact) {
    error_line(&handler(listing, &["SET 16165 : SET 8499"], &Plan::default()), fact);
}

fn parts(bench: &mut Bench) -> Vec<f64> {
    ["days", "ExcHours", "ExcMinutes", "ExcSeconds", "ms"].map(|name| bench.number(&format!("?{name}"))).to_vec()
}

fn clock(listing: &Listing, fact: &Fact) {
    // Written at the moment of the error; the handler reads the clock some milliseconds later.
    let mut bench = handler(listing, &["P6916 = 90061001 : SET 8467"], &Plan::default());
    let found = parts(&mut bench);
    assert_eq!(found[..4], fact.numbers()[..4]);
    assert!((fact.numbers()[4]..150.0).contains(&found[4]), "{found:?}");
}

fn exact_divisions(listing: &Listing, _: &Fact) {
    for milliseconds in [0, 999, 59_999, 3_599_999, 86_399_999, 2_000_000_000] {
        let line = format!("P6916 = {milliseconds} : SET 8467");
        let mut bench = handler(listing, &[&line], &Plan::default());
        let found = parts(&mut bench);
        let total = (((found[0] * 24.0 + found[1]) * 60.0 + found[2]) * 60.0 + found[3]) * 1000.0 + found[4];
        assert_eq!(bench.number("?Time"), total);
        assert!((f64::from(milliseconds)..f64::from(milliseconds) + 150.0).contains(&total), "{total}");
    }
}

fn codes_are_cleared(listing: &Listing, _: &Fact) {
    // The input opens when the kill is over: while it is latched, the program leaves kills alone.
    let plan = Plan { inputs: &[(2.5, 5646, true)], parameters: &[(1.0, "P32779", 3.0)], ..Plan::default() };
    let mut bench = handler(listing, &["SET 8467"], &plan);
    bench.pass(1.0).clean();
    assert_eq!(
        ["XErrorCode", "YErrorCode", "MEIErrorCode", "CANopenErrorCode"].map(|name| bench.number(&format!("?{name}"))),
        [0.0, 0.0, 1.0, 3.0]
    );
    assert!(bench.printed(1).iter().any(|line| line.starts_with("Axis 0 Error")));
}
