//! The promises of virtual time: a run can be repeated, and a jump over time in which nothing happens changes nothing.

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;

use crate::support::{Ran, Sim, TWO_AXES};

/// Programs of a project: 0 and 8 have an axis each, 8 and 9 share a slice.
const PROGRAMS: [u8; 4] = [0, 1, 8, 9];

/// Programs that compute: they run ahead of their slices when nobody else would notice.
const LOOPS: &[&str] = &[
    "FOR P1 = 1 TO 40\nP2 = P2 + P1\nNEXT",
    "FOR P3 = 1 TO 400 : P2 = P2 + 1 : NEXT",
    "FOR P4 = 1 TO 9\nPRINT P6916, P2\nP2 = P2 * 0.5\nNEXT",
    "FOR P5 = 1 TO 30\nBIT 140 = NOT BIT 140\nIF (BIT 3) THEN BREAK\nNEXT",
    "P6 = P6916\nWHILE (P6916 < P6 + 50)\nP2 = P2 + 1\nWEND",
    "FOR P7 = 1 TO 50\nP2 = P2 + RND(9)\nIF (P7 = 33) THEN P38912 = P7 : PRINT 1 / (P2 MOD 2)\nNEXT",
];

/// What bends moves, stretches their time, or lets them wait for each other.
const PATHS: &[&str] = &[
    "ROTATE 30",
    "ROTATE 0",
    "LOOK ON",
    "LOOK OFF",
    "TOV 0.5",
    "TOV 1",
    "SRC P2",
    "SRC CLOCK",
    "SYNC ON MASTER0 MASTER1",
    "SYNC OFF MASTER0 MASTER1",
    "SPLINE END",
    "TARC OFF",
];

fn program() -> impl Strategy<Value = u8> {
    select(&PROGRAMS)
}

/// A statement that a program with or without an axis can execute. User flags 128-131 are what programs tell each other.
fn statement(axis: Option<&'static str>) -> BoxedStrategy<String> {
    let quiet = prop_oneof![
        8 => (0..300_u32).prop_map(|time| format!("DWL {}", f64::from(time) / 1000.0)),
        8 => Just("PRINT P6916, P12294, P12297, P12806, P12809, P4120, P4122, P4360, P4600, P4602, P4100, P4128, P4136".to_owned()),
        3 => (128..132_u32, select(&["SET", "CLR"])).prop_map(|(bit, word)| format!("{word} {bit}")),
        1 => (128..132_u32, select(&["", "-"])).prop_map(|(bit, sign)| format!("INH {sign}{bit}")),
        1 => (0..4_u32).prop_map(|input| format!("INH -{input}")),
        3 => program().prop_map(|program| format!("INH -{}", 1024 + 32 * u32::from(program))),
        4 => (program(), select(&["RUN", "RUN", "PAUSE", "RESUME", "HALT"]))
            .prop_map(|(program, word)| format!("{word} PROG{program}")),
        4 => select(LOOPS).prop_map(str::to_owned),
        1 => select(&["SET 520", "SET 521", "SET 523", "CLR 522", "MASTER1 FOV 0.5", "MASTER1 FOV 2"]).prop_map(str::to_owned),
    ];
    // Other programs meddle with the axes of programs 0 and 8.
    let quiet = prop_oneof![6 => quiet, 1 => meddling()];
    let Some(axis) = axis else { return quiet.boxed() };
    let moving = prop_oneof![
        6 => jogging(axis),
        4 => (-20..20_i32, select(&["", "/"])).prop_map(move |(to, slash)| format!("{axis}{slash}{to}")),
        1 => Just("INH -516".to_owned()),
        1 => (0..3_u32).prop_map(|stop| format!("STP {}", stop * 50)),
        4 => special(axis),
    ];
    prop_oneof![quiet, moving].boxed()
}

/// Orders to the jog profiler of an axis, and settings of it.
fn jogging(axis: &'static str) -> impl Strategy<Value = String> {
    let number = || -20..20_i32;
    // Jog and coordinated motion of the axis are over.
    let rest = if axis == "X" { "INH -792\nINH -516" } else { "INH -856\nINH -548" };
    prop_oneof![
        2 => number().prop_map(move |to| format!("JOG ABS {axis}{to}")),
        2 => number().prop_map(move |by| format!("JOG INC {axis}{by}")),
        2 => select(&["FWD", "REV", "OFF"]).prop_map(move |word| format!("JOG {word} {axis}")),
        3 => select(&["1", "-1"]).prop_map(move |side| format!("{rest}\nJOG HOME {axis}{side}")),
        2 => (select(&["VEL", "ACC", "DEC", "JRK", "HOMVF"]), 0..4_u32)
            .prop_map(move |(word, value)| format!("JOG {word} {axis}{}", value * 50)),
        1 => (select(&["HLIM", "SLIM"]), 0..4_u32).prop_map(move |(word, value)| format!("{word} {axis}{value}")),
        1 => (select(&["HLDEC", "SLDEC", "SLM", "JLM"]), 0..3_u32)
            .prop_map(move |(word, value)| format!("{word} {axis}{}", value * 9)),
        1 => select(&["RES", "REN", "JOG REN", "JOG RES"]).prop_map(move |word| format!("{rest}\n{word} {axis}")),
        1 => select(&["INH -792", "INH -768", "INH 794"]).prop_map(str::to_owned),
        1 => Just(RECOVERY.to_owned()),
    ]
}

/// Lets axes 0 to 2 move again.
const RECOVERY: &str = "CLR 8467 : CLR 8499 : CLR 522 : CLR 8531 : CLR 554";

/// Kills, recoveries, jogs by flag, homing bits and levels of switches, for axes 0 and 2.
fn meddling() -> impl Strategy<Value = String> {
    let flag =
        (select(&[796_u32, 797, 795, 8467, 16_144, 16_132, 16_152, 16_154, 17_160]), select(&["SET", "CLR"]), 0..2_u32)
            .prop_map(|(flag, word, second)| format!("{word} {}", flag + 64 * second));
    prop_oneof![
        3 => flag,
        2 => Just(RECOVERY.to_owned()),
        1 => Just("AXIS2 JOG INC 3".to_owned()),
    ]
}

/// Moves that bend, wait or are cut short, and what bends others.
fn special(axis: &'static str) -> impl Strategy<Value = String> {
    prop_oneof![
        select(PATHS).prop_map(str::to_owned),
        (0..4_u32, select(&["", "-"])).prop_map(|(input, sign)| format!("TRG {sign}{input}")),
        (0..4_u32, 0..20_u32).prop_map(move |(input, to)| format!("INT {input} {axis}{to}")),
        (0..20_u32).prop_map(move |to| format!("TRJ {axis}{to}")),
        (1..20_u32).prop_map(move |to| format!("HSINT {axis}(0, {to}, 2, 1, 3, 0, 2)")),
        (-9..9_i32).prop_map(move |phase| format!("SINE {axis}(4, {phase}, 300, 3)")),
        (0..9_i32).prop_map(move |shift| format!("OFFSET {axis}{shift}\nSCALE {axis}2\nROTARY {axis}9")),
        (1..9_i32).prop_map(move |to| format!("SPLINE MODE 0\n{axis}/{to}\n{axis}/5\n{axis}/-3\nSPLINE END")),
        Just("CIRCCW X(0, 5) Y(0, 0)".to_owned()),
    ]
}

fn body(axis: Option<&'static str>) -> impl Strategy<Value = String> {
    vec(statement(axis), 0..15).prop_map(|lines| lines.join("\n"))
}

fn events() -> impl Strategy<Value = String> {
    vec((0..2000_u32, 0..4_u32, any::<bool>()), 0..8).prop_map(|events| {
        let one = |(time, input, set): &(u32, u32, bool)| {
            format!("[[event]]\nat = \"{time}ms\"\n{} = [{input}]\n", if *set { "set" } else { "clear" })
        };
        events.iter().map(one).collect::<Vec<_>>().concat()
    })
}

fn project() -> impl Strategy<Value = String> {
    (body(Some("X")), body(None), body(Some("A")), body(None)).prop_map(|(zero, one, eight, nine)| {
        format!(
            "{TWO_AXES}SYS\nDIM PROG8(2000)\nDIM PROG9(2000)\nPROG8\nATTACH MASTER1\nATTACH SLAVE0 AXIS2 \"A\"\n\
             ACC 500 STP 500 VEL 200\nJOG ACC A500\nJOG DEC A300\nJOG VEL A100\nHLBIT A1\nHLDEC A500\n\
             PROG0\nJOG ACC X200\nJOG DEC X300\nJOG VEL X20\nJOG HOMVF X2\nHLDEC X500\nSLM X15\nPROGRAM\n{zero}\nENDP\nPROG1\nPROGRAM\n{one}\nENDP\n\
             PROG8\nPROGRAM\n{eight}\nENDP\nPROG9\nPROGRAM\n{nine}\nENDP\n"
        )
    })
}

/// An event in every tick of the first second, at an input that no program looks at: time can't jump.
fn events_in_every_tick() -> String {
    let half_milliseconds = (0..2000_u32).map(|tick| f64::from(tick) / 2.0);
    half_milliseconds
        .map(|time| format!("[[event]]\nat = \"{time}ms\"\nset = [31]\nnote = \"tick\"\n"))
        .collect::<Vec<_>>()
        .concat()
}

/// Everything that a run shows, but for how often its observer was called and the events of [`events_in_every_tick`].
fn shown(ran: &Ran) -> String {
    let controller = &ran.controller;
    let events: Vec<_> = ran.record.events.iter().filter(|(_, note)| note != "tick").collect();
    let flags: Vec<i64> = (32..17_664).filter(|flag| ran.bit(*flag)).collect();
    format!(
        "{:?} {:?} {:?} {:#?} {:#?} {:#?} {:#?} {:#?} {:#?} {:?} {:?}",
        ran.stopped,
        controller.seconds(),
        flags,
        ran.record.output,
        ran.record.faults,
        events,
        controller.programs(),
        controller.axes(),
        controller.masters(),
        ran.notes(),
        [0, 1, 2].map(|axis| controller.view().motion(axis)),
    )
}

#[test]
fn a_program_that_runs_ahead_shows_the_same_as_slices() {
    for body in LOOPS {
        for second in ["END", "DWL 0.02\nPRINT P2", "INH -140\nPRINT P2"] {
            let text = format!("{TWO_AXES}PROGRAM\n{body}\n{body}\nENDP\nPROG1\nPROGRAM\n{second}\nENDP\n");
            for until in [0.0, 0.0075, 0.041, 60.0] {
                let world = "[[event]]\nat = \"35.5ms\"\nset = [3]\n";
                let run = |watched| Sim::new(&text).start(&[0, 1]).world(world).until(until).watched(watched).run();
                assert_eq!(shown(&run(true)), shown(&run(false)), "{text} until {until}");
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_jump_shows_the_same_to_those_who_watch(text in project(), world in events(), until in 0.0..4.0_f64) {
        let run = |watched: bool| Sim::new(&text).start(&PROGRAMS).world(&world).until(until).watched(watched).run();
        prop_assert_eq!(shown(&run(true)), shown(&run(false)));
    }

    #[test]
    fn a_jump_shows_the_same_as_steps(text in project(), world in events()) {
        let run = |world: &str| Sim::new(&text).start(&PROGRAMS).world(world).until(1.0).watched(false).run();
        let stepped = format!("{world}{}", events_in_every_tick());
        prop_assert_eq!(shown(&run(&world)), shown(&run(&stepped)));
    }

    #[test]
    fn a_run_can_be_repeated(text in project(), world in events(), seed: u64) {
        let run = || Sim::new(&text).start(&PROGRAMS).world(&world).seed(seed).until(2.0).watched(false).run();
        prop_assert_eq!(shown(&run()), shown(&run()));
    }
}
