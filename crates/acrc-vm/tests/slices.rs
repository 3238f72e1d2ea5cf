//! What a program does, and what it takes from its budget, is the same whether its statements are counted one by one,
//! as for somebody who watches them, or accounted for from jump to jump.

mod support;

use acrc_vm::{Budget, Run, Snapshot, Stop};
use proptest::prelude::*;
use support::{Machine, try_load};

/// Statements without parts.
const PLAIN: &[&str] = &[
    "LV0 = LV0 + 1",
    "LV1 = LV1 + LV0 MOD 7",
    "DV0 = DV0 + LV0 * 0.5",
    "LA0(LV0 MOD 5) = LA0(LV0 MOD 5) + 1",
    "P0 = P0 + 1",
    "PRINT LV0;",
    "BIT 40 = NOT BIT 40",
    "DV1 = SQRT(DV0)",
    "P38912 = P38912 + 1",
    "GOSUB Sub",
    "IF (BIT 40) THEN GOSUB Sub : LV1 = LV1 + 1",
    "IF (LV0 MOD 3 = 0) THEN DV1 = DV1 + 1 : LV1 = 0",
    "IF (P0 > 5) THEN GOSUB Twice",
    "REM",
    // Faults, now and then.
    "DV1 = 1 / (LV0 MOD 9)",
    "LA0(LV0) = 1",
];

/// Statements, each with what stands in front of it: a new line or not.
fn body(depth: usize) -> BoxedStrategy<String> {
    let separator = prop_oneof![2 => Just("\n"), 1 => Just(" : ")];
    let plain = prop::sample::select(PLAIN).prop_map(str::to_owned);
    let statement = if depth == 0 {
        plain.boxed()
    } else {
        // Every nesting has a counter of its own, so that each loop ends.
        let counter = format!("LV{}", 1 + depth);
        let again = counter.clone();
        let inner = || body(depth - 1);
        prop_oneof![
            4 => plain,
            1 => (1..9u32, inner(), separator.clone()).prop_map(move |(times, body, end)| {
                format!("{counter} = 0 : WHILE ({counter} < {times}){body} : {counter} = {counter} + 1{end}WEND")
            }),
            1 => (1..400u32, inner(), separator.clone())
                .prop_map(move |(times, body, end)| format!("FOR {again} = 1 TO {times}{body}{end}NEXT")),
            1 => (inner(), inner()).prop_map(|(first, second)| format!("IF (LV0 > 9){first}\nELSE{second}\nENDIF")),
        ]
        .boxed()
    };
    prop::collection::vec((separator, statement), 1..5)
        .prop_map(|statements| {
            statements.into_iter().flat_map(|(separator, text)| [separator.to_owned(), text]).collect()
        })
        .boxed()
}

/// Goes on behind a fault, as a controller does with a statement that it refuses.
fn go_on(machine: &mut Machine, run: &Run) {
    if matches!(run.stop, Stop::Fault(_)) {
        machine.frame.skip_statement(&machine.code);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn accounting_is_counting(body in body(3), lines in prop::collection::vec(prop_oneof![0..9u32, 0..900u32], 1..9)) {
        let text = format!(
            "DIM LV(6)\nDIM DV(2)\nDIM LA(1) : DIM LA0(20){body}\nEND\n_Sub\nLV0 = LV0 + 1 : DV0 = 2\nRETURN\n\
             _Twice\nGOSUB Sub : GOSUB Sub : RETURN"
        );
        // A block behind THEN has to end on its line.
        let Ok(code) = try_load(&text) else { return Err(TestCaseError::reject("does not load")) };
        let (mut plain, mut watched) = (Machine::with(code.clone()), Machine::with(code));
        for budget in lines.iter().cycle().take(60).map(|lines| Budget::lines(*lines)) {
            let (run, counted) = (plain.run(budget), watched.run_watched(budget));
            prop_assert_eq!(&run, &counted, "{}", text);
            prop_assert_eq!(plain.frame.pc(), watched.frame.pc());
            go_on(&mut plain, &run);
            go_on(&mut watched, &counted);
            let alike = Snapshot::take(&plain.frame, &plain.locals)
                .is_some_and(|snapshot| snapshot.matches(&watched.frame, &watched.locals));
            prop_assert!(alike, "{}", text);
            if run.stop == Stop::Ended {
                break;
            }
        }
        prop_assert_eq!(plain.bench.output, watched.bench.output);
        prop_assert!(plain.bench.trace.is_empty());
    }
}
