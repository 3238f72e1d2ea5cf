//! Programs that poll cost nothing while nothing changes, and all they do is what it would be if each of their lines were executed.

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;

use crate::support::{Ran, Sim};

/// Programs of a project: 8, 9 and 10 share a slice.
const PROGRAMS: [u8; 6] = [0, 1, 2, 8, 9, 10];

/// Lines that go round in a circle until a flag of the world (0-3) or of the programs (128-131) changes, or for a while.
fn polling() -> BoxedStrategy<String> {
    let flag = || prop_oneof![3 => 0..4_u32, 1 => 128..132_u32];
    let lines = (
        flag(),
        0..9_usize,
        select(&["", "-"]),
        select(&["LV1 = LV0", "REM", "SV0 = 0.1", "IF (BIT 5) THEN P3 = 1", "P4 = 7", "LA0(1) = LV1", "CLR 140"]),
        select(&[
            "LV1 = 1 - LV1",
            "LV2 = (LV2 + 1) MOD 7",
            "REM",
            "REM",
            "DV0 = -DV0",
            "P5 = P5 + 1",
            "$V0 = $V0 + \"\"",
        ]),
    );
    lines
        .prop_map(|(flag, count, sign, one, other)| {
            let condition = if sign.is_empty() { format!("NOT BIT {flag}") } else { format!("BIT {flag}") };
            let body: Vec<&str> = [one, other, "REM", "GOSUB Sub"].into_iter().cycle().take(count).collect();
            format!("WHILE ({condition})\n{}\nWEND", body.join("\n"))
        })
        .boxed()
}

fn statement() -> BoxedStrategy<String> {
    let other = prop_oneof![
        4 => (0..200_u32).prop_map(|time| format!("DWL {}", f64::from(time) / 1000.0)),
        3 => Just("PRINT P6916, P3, P5, LV0, LV1, LV2, DV0, P4100, P4128, P4144".to_owned()),
        4 => (128..132_u32, select(&["SET", "CLR"])).prop_map(|(bit, word)| format!("{word} {bit}")),
        1 => (0..4_u32).prop_map(|input| format!("INH {input}")),
        2 => Just("P3 = P3 + 1".to_owned()),
        2 => Just("FOR LV0 = 0 TO 50\nLV3 = LV3 + RND(3)\nNEXT".to_owned()),
        2 => Just("FOR LV0 = 0 TO 70\nLV3 = LV3 + LV0\nNEXT".to_owned()),
        2 => (select(&PROGRAMS), select(&["RUN", "PAUSE", "RESUME", "HALT"]))
            .prop_map(|(program, word)| format!("{word} PROG{program}")),
        1 => select(&["RUN PLC0", "HALT PLC0", "RUN PLC1"]).prop_map(str::to_owned),
        1 => Just("WHILE (P3 < 3)\nWEND".to_owned()),
        2 => waiting(),
    ];
    prop_oneof![2 => polling(), 3 => other].boxed()
}

/// Waits for the clock, for what other programs write, or for characters.
fn waiting() -> BoxedStrategy<String> {
    let texts = select(&[
        "IHPOS P3 (2, 0.3)",
        "IHPOS -P5 (LV1, 0.15)",
        "IHPOS P4 (P3, 0)",
        "IHPOS P4100 (3, 0.25)",
        "WHILE (NOT KBHIT(1))\nLV1 = 1 - LV1\nWEND",
        "LV2 = GETCH(1)\nPRINT LV2",
        "INPUT #1, LV2\nPRINT LV2",
    ]);
    prop_oneof![
        2 => texts.prop_map(str::to_owned),
        1 => (0..1500_u32).prop_map(|time| format!("IHPOS P6916 ({time}, 0)")),
        1 => (0..1500_u32).prop_map(|time| format!("WHILE (P6916 < {time})\nWEND")),
    ]
    .boxed()
}

fn program() -> impl Strategy<Value = String> {
    vec(statement(), 0..7).prop_map(|lines| {
        format!(
            "PROGRAM\nCLEAR\nOPEN \"COM1:\" AS #1\nDIM LV(4)\nDIM SV(1)\nDIM DV(1)\nDIM LA(1)\nDIM LA0(3)\nDIM $V(1, 9)\nDV0 = 1\n{}\nEND\n_Sub\nRETURN\nENDP\n",
            lines.join("\n")
        )
    })
}

/// Rungs over inputs and flags.
fn rungs() -> impl Strategy<Value = String> {
    let flag = || prop_oneof![0..4_u32, 128..132_u32];
    let contact =
        (select(&["AND", "OR", "AND NOT", "OR NOT"]), flag()).prop_map(|(word, flag)| format!("{word} {flag}"));
    let end = prop_oneof![
        4 => (128..134_u32).prop_map(|flag| format!("OUT {flag}")),
        2 => (0..3_u32, 0..400_u32).prop_map(|(timer, preset)| format!("TIM {timer} {preset}\nOUT 133")),
        2 => (flag(), 0..3_u32, 1..4_u32).prop_map(|(reset, counter, preset)| format!("LD {reset}\nCNT {counter} {preset}\nOUT 132")),
        1 => flag().prop_map(|reset| format!("LD {reset}\nKR 131")),
        1 => Just("P5 = P5 + BIT 3".to_owned()),
    ];
    let rung = (select(&["LD", "LD NOT"]), flag(), vec(contact, 0..3), end)
        .prop_map(|(word, flag, contacts, end)| format!("{word} {flag}\n{}\n{end}", contacts.join("\n")));
    vec(rung, 0..4).prop_map(|rungs| rungs.join("\n"))
}

fn project() -> impl Strategy<Value = String> {
    (vec(program(), PROGRAMS.len()), rungs(), rungs()).prop_map(|(programs, one, two)| {
        let spaces = [8, 9, 10].map(|number| format!("DIM PROG{number}(4000)\n")).concat();
        let plcs = format!("PLC0\nPROGRAM\n{one}\nENDP\nPLC1\nPROGRAM\n{two}\nENDP\n");
        let texts = PROGRAMS.iter().zip(programs).map(|(number, text)| format!("PROG{number}\n{text}"));
        let texts: String = texts.collect();
        format!("SYS\nDIM P(10)\nDIM PLC0(2000)\nDIM PLC1(2000)\n{spaces}{plcs}SYS\nRUN PLC0\n{texts}")
    })
}

fn events() -> impl Strategy<Value = String> {
    let input = |word: &'static str| (0..4_u32).prop_map(move |input| format!("{word} = [{input}]"));
    let what = prop_oneof![
        3 => input("set"),
        3 => input("clear"),
        2 => select(&["7\\r", "x", "1\\r2\\r"]).prop_map(|text| format!("stream = \"COM1\"\ntext = \"{text}\"")),
    ];
    vec((0..2000_u32, what), 0..6).prop_map(|events| {
        let one = |(time, what): &(u32, String)| format!("[[event]]\nat = \"{time}ms\"\n{what}\n");
        events.iter().map(one).collect::<Vec<_>>().concat()
    })
}

/// An event in every tick, at an input that nobody looks at: nothing can be skipped.
fn events_in_every_tick(seconds: u32) -> String {
    let one = |tick: u32| format!("[[event]]\nat = \"{}ms\"\nset = [31]\nnote = \"tick\"\n", f64::from(tick) / 2.0);
    (0..2000 * seconds).map(one).collect()
}

/// Everything that a run shows, but for what [`events_in_every_tick`] adds.
fn shown(ran: &Ran) -> String {
    let controller = &ran.controller;
    let events: Vec<_> = ran.record.events.iter().filter(|(_, note)| note != "tick").collect();
    let values: Vec<_> = (0..10).map(|number| controller.parameter(number)).collect();
    format!(
        "{:?} {:#?} {:#?} {:#?} {:#?} {:?} {:?}",
        controller.seconds(),
        ran.record.output,
        ran.record.faults,
        events,
        controller.programs(),
        values,
        ran.notes(),
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 80, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn skipping_is_the_same_as_stepping(text in project(), world in events(), scan in select(&[0.001, 0.003, 0.0005])) {
        // Something that outlasts the run, so that both end at the same time.
        let text = format!("{text}PROG3\nPROGRAM\nDWL 10\nENDP\n");
        let programs: Vec<u8> = PROGRAMS.into_iter().chain([3]).collect();
        let run = |world: &str| {
            Sim::new(&text).start(&programs).world(world).until(2.0).watched(false).plc_scan(scan).run()
        };
        let stepped = format!("{world}{}", events_in_every_tick(3));
        prop_assert_eq!(shown(&run(&world)), shown(&run(&stepped)));
    }
}

/// Programs that poll, all of them in circles of other lengths.
fn pollers(programs: std::ops::Range<u8>, flag: u32) -> String {
    let one = |number: u8| {
        let lines = "REM\n".repeat(usize::from(number % 5));
        format!("PROG{number}\nPROGRAM\nWHILE (NOT BIT {flag})\n{lines}WEND\nENDP\n")
    };
    programs.map(one).collect()
}

fn spaces() -> String {
    let space = |number: u8| format!("DIM PROG{number}(1000)\n");
    (8..16).map(space).collect()
}

#[test]
fn an_hour_of_polling_is_counted_line_by_line() {
    let text = "PROG0\nPROGRAM\nWHILE (BIT10=0) : WEND\nENDP\n";
    let ran = Sim::new(text).start(&[0]).until(3600.0).watched(false).run().clean();
    // Two slices a round, one of them of the program: 4 lines of 2 statements; and the slice at the end of the run.
    assert_eq!(ran.controller.programs()[0].statements, 1800 * 1000 * 8 + 8);
    assert_eq!(ran.milliseconds(), 3_600_000.0);
}

#[test]
fn an_input_ends_an_hour_of_polling_in_the_slice_that_sees_it() {
    let world = "[[event]]\nat = \"1h\"\nset = [10]\n";
    for programs in [0..1, 0..16] {
        let text = format!("SYS\n{}{}", spaces(), pollers(programs.clone(), 10));
        let started: Vec<u8> = programs.collect();
        let ran = Sim::new(&text).start(&started).world(world).until(4000.0).watched(false).run().clean();
        assert!((3_600_000.0..3_600_100.0).contains(&ran.milliseconds()), "{}", ran.milliseconds());
    }
}

#[test]
fn a_program_computes_beside_programs_that_poll() {
    let text = format!(
        "SYS\nDIM P(1)\n{}PROG0\nPROGRAM\nDIM LV(1)\nFOR LV0 = 1 TO 100000\nNEXT\nP0 = 1\nSET 128\nENDP\n",
        pollers(1..3, 128)
    );
    let ran = Sim::new(&text).start(&[0, 1, 2]).until(3600.0).watched(false).run().clean();
    assert!((100_000.0..100_020.0).contains(&ran.milliseconds()), "{}", ran.milliseconds());
}
