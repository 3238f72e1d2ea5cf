//! Setup code and what is typed at the prompts.

use acrc_controller::State;

use crate::bench::{Bench, Plan, near};
use crate::check::{
    Check,
    Check::{Later, Shows},
};
use crate::guide::{Fact, Listing};

pub(crate) const CHECKS: &[(u8, &[Check])] = &[
    (7, &[Shows(names_of_a_program), Shows(halt_of_the_prompt), Shows(attach_report)]),
    (8, &[Shows(memory_reports), Shows(erase_and_clear), Shows(dimensioned_again), Shows(memory_of_the_factory)]),
    (10, &[Shows(remarks_are_stored)]),
    (12, &[Shows(pairs), Shows(two_axes), Shows(halting)]),
    (13, &[Shows(velocity_report), Shows(first_output)]),
    (14, &[Shows(line_is_stored), Shows(line_numbers), Shows(line_is_lost)]),
    (15, &[Shows(pause_and_resume)]),
    (30, &[Shows(back_to_the_factory), Shows(no_model_takes_all)]),
    (
        31,
        &[
            Shows(wizard_masters),
            Later("nothing shows whether an axis is on: servo loop"),
            Shows(wizard_window),
            Shows(wizard_limits),
            Shows(wizard_scale),
            Shows(wizard_prompts),
        ],
    ),
    (39, &[Shows(velocity_from_elsewhere)]),
    (58, &[Later("the modes act on binary packets only"), Shows(default_modes)]),
];

fn names_of_a_program(listing: &Listing, _: &Fact) {
    let (mut bench, answers) = Bench::typed(listing);
    assert!(answers.iter().all(String::is_empty), "{answers:?}");
    assert_eq!(bench.ask("RES X Y"), "");
    for prompt in ["PROG1", "SYS"] {
        bench.ask(prompt);
        assert_ne!(bench.ask("RES X"), "");
        assert_eq!(bench.ask("X5"), "Unknown Command\n");
        assert_eq!(bench.ask("RES AXIS0 : RES AXIS1"), "");
    }
}

fn halt_of_the_prompt(listing: &Listing, _: &Fact) {
    let program = "PROGRAM\n_Again\nDWL 1\nGOTO Again\nENDP\n";
    let mut bench = Bench::terminal_with(listing, &format!("PROG0\n{program}PROG1\n{program}PROG0\n"));
    for line in ["RUN PROG0", "RUN PROG1"] {
        bench.ask(line);
    }
    bench.pass(0.5);
    for line in listing.text.lines().take(2) {
        bench.ask(line);
    }
    assert_eq!((bench.state(0), bench.state(1)), (State::Ended, State::Waiting));
}

fn attach_report(listing: &Listing, _: &Fact) {
    let (mut bench, _) = Bench::typed(listing);
    let attached: String = listing.text.split_inclusive('\n').skip(3).collect();
    assert_eq!(bench.ask("ATTACH"), attached);
}

fn memory_reports(_: &Listing, _: &Fact) {
    let mut bench = Bench::setup("");
    let (first, free) = (bench.ask("DIM"), bench.number("MEM"));
    assert!(first.contains("PROG0") && free > 0.0);
    assert_eq!((bench.ask("DIM"), bench.number("MEM")), (first, free));
}

fn erase_and_clear(listing: &Listing, _: &Fact) {
    let mut bench = Bench::setup("PROG0\nPROGRAM\nPRINT 1\nENDP\nPROG2\nPROGRAM\nPRINT 2\nENDP\nPLC1\nPROGRAM\nENDP\n");
    bench.ask("PROG2");
    assert_eq!(bench.ask("LIST"), "PRINT 2\n");
    bench.ask("SYS");
    let before = bench.number("MEM");
    for line in listing.text.lines().skip(2) {
        assert_eq!(bench.ask(line), "", "{line}");
    }
    assert_eq!(bench.ask("DIM"), "");
    assert_eq!(bench.number("MEM"), before + 8.0 * 65_536.0);
    bench.ask("PROG2");
    assert_eq!(bench.ask("LIST"), "");
}

fn dimensioned_again(_: &Listing, _: &Fact) {
    let mut bench = Bench::setup("");
    assert!(bench.ask("DIM PROG0(4000)").starts_with("Re-dimensioned block"));
    bench.ask("CLEAR");
    assert_eq!(bench.ask("DIM PROG0(4000)"), "");
    assert!(bench.ask("DIM PROG0(4000)").starts_with("Re-dimensioned block"));
}

fn memory_of_the_factory(_: &Listing, _: &Fact) {
    let mut bench = Bench::setup("");
    let blocks = [0, 1, 2, 3, 4, 5, 6, 7].map(|program| format!("DIM PROG{program}({})\n", 512 * 1024 / 8)).concat();
    assert_eq!(bench.ask("DIM"), blocks);
    assert_ne!(bench.ask("P0 = 1"), "");
    assert_ne!(bench.ask("#DEFINE door BIT10"), "");
    bench.ask("PROG0");
    assert_ne!(bench.ask("LV0 = 1"), "");
    // A stream buffer that is too small by one character is noted.
    let setup = "PROG0\nPROGRAM\nOPEN \"COM2:\" AS #1\nDWL 5\nENDP\n";
    for (length, notes) in [(256, 0), (257, 1)] {
        let text = "x".repeat(length);
        let mut bench = Bench::powered_with(setup, &Plan { typed: &[(1.0, "COM2", &text)], ..Plan::default() });
        assert_eq!(bench.pass(2.0).controller.notes().count(), notes);
    }
}

fn remarks_are_stored(listing: &Listing, _: &Fact) {
    let mut bench = Bench::planned(listing, &Plan { idle: true, ..Plan::default() });
    bench.ask("PROG0");
    let lines: Vec<&str> = listing.text.lines().collect();
    assert_eq!(bench.ask("LIST"), format!("{}\n{}\n", lines[0], lines[2]));
    let with = bench.number("MEM");
    let statement = lines[2].split(" : ").next().expect("a statement");
    let plain = [(lines[0], ""), (lines[2], statement)];
    let mut bench = Bench::planned(listing, &Plan { replaced: &plain, idle: true, ..Plan::default() });
    bench.ask("PROG0");
    let remarks = lines[0].len() + lines[2].len() - statement.len();
    assert!(bench.number("MEM") - with > remarks as f64 - 16.0);
}

fn pairs(listing: &Listing, _: &Fact) {
    let (mut bench, _) = Bench::typed(listing);
    let sides = |axis: u32| (12_330 + 256 * axis, 12_331 + 256 * axis);
    for (axis, expected) in [(0, (0.05, -0.05)), (1, (3.0, -1.0))] {
        let (positive, negative) = sides(axis);
        let found = (bench.number(&format!("?P{positive}")), bench.number(&format!("?P{negative}")));
        assert_eq!(found, expected);
    }
}

fn two_axes(listing: &Listing, _: &Fact) {
    let (mut bench, _) = Bench::typed(listing);
    assert_eq!((bench.number("FBVEL X"), bench.number("FBVEL Y")), (0.0001, 0.0002));
}

fn halting(listing: &Listing, _: &Fact) {
    let program = "PROGRAM\n_Again\nDWL 1\nGOTO Again\nENDP\n";
    let programs = [0, 1, 2].map(|number| format!("PROG{number}\n{program}")).concat();
    let mut bench = Bench::terminal_with(listing, &format!("{programs}PROG0\n"));
    bench.ask("RUN ALL");
    bench.pass(0.1);
    let states = |bench: &Bench| [0, 1, 2].map(|program| bench.state(program) == State::Waiting);
    assert_eq!(states(&bench), [true; 3]);
    let halts: Vec<&str> = listing.text.lines().filter(|line| line.starts_with("HALT")).collect();
    for (line, expected) in halts.iter().zip([[false, true, true], [false, true, true], [false; 3]]) {
        assert_eq!((bench.ask(line), states(&bench)), (String::new(), expected), "{line}");
    }
}

fn velocity_report(listing: &Listing, _: &Fact) {
    let mut bench = Bench::terminal(listing);
    bench.ask("VEL 7");
    assert_eq!(bench.number("VEL"), 7.0);
    for line in listing.text.lines().take(2) {
        bench.ask(line);
    }
    assert_eq!(bench.number("VEL"), 1000.0);
}

fn first_output(listing: &Listing, _: &Fact) {
    let (mut bench, _) = Bench::typed(listing);
    assert_eq!(bench.number("?P4097"), 1.0);
}

fn line_is_stored(listing: &Listing, _: &Fact) {
    let (mut bench, answers) = Bench::typed(listing);
    assert_eq!((answers.concat(), bench.number("VEL")), (String::new(), 0.0));
    assert!(bench.ask("LIST").ends_with("VEL 1000\n"));
    bench.ask("RUN");
    assert_eq!(bench.pass(0.1).number("VEL"), 1000.0);
}

fn line_numbers(listing: &Listing, _: &Fact) {
    let (mut bench, _) = Bench::typed(listing);
    bench.ask("SET 5651");
    assert_eq!(bench.ask("LIST"), listing.text);
}

fn line_is_lost(listing: &Listing, _: &Fact) {
    for (save, left) in [("", ""), ("FLASH SAVE", listing.text.as_str())] {
        let mut bench = Bench::terminal_planned(listing, &Plan { no_battery: true, ..Plan::default() });
        for line in [listing.text.trim_end(), save, "REBOOT"] {
            bench.ask(line);
        }
        bench.pass(1.0);
        for line in ["PROG0", "SET 5651"] {
            bench.ask(line);
        }
        assert_eq!(bench.ask("LIST"), left);
    }
}

fn back_to_the_factory(listing: &Listing, _: &Fact) {
    let reports = ["DIM", "MEM", "ATTACH", "CONFIG", "DEF", "AXIS0 PPU"];
    let factory = reports.map(|report| Bench::setup("").ask(report));
    let used = "SYS\nCLEAR\nDIM PROG0(4000)\nDIM P(10)\nDIM DEF(4)\n#DEFINE door BIT10\nCONFIG ENC4 DAC4 NONE NONE\n\
                ATTACH AXIS0 ENC2 DAC2 ENC2\nAXIS0 PPU 4000\nESAVE\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n\
                PROGRAM\n_Again\nDWL 1\nGOTO Again\nENDP\nFLASH SAVE\nRUN\nSYS\n";
    let mut bench = Bench::setup(used);
    bench.pass(0.5).clean();
    assert!(reports.iter().zip(&factory).all(|(report, factory)| bench.ask(report) != *factory));
    for line in listing.text.lines().filter(|line| !["CLEAR DPCB", "CLEAR FIFO"].contains(line)) {
        assert_eq!(bench.ask(line), "", "{line}");
    }
    bench.pass(1.0).switch_off_and_on();
    bench.ask("SYS");
    assert_eq!(reports.map(|report| bench.ask(report)), factory);
    bench.ask("PROG0");
    assert_eq!(bench.ask("LIST"), "");
}

fn no_model_takes_all(listing: &Listing, _: &Fact) {
    for model in acrc_catalog::models() {
        let mut bench = Bench::of_model(model.name);
        let answers: Vec<String> = listing.text.lines().map(|line| bench.ask(line)).collect();
        assert!(answers.iter().any(|answer| !answer.is_empty()), "{}", model.name);
    }
}

fn pause_and_resume(listing: &Listing, _: &Fact) {
    let program = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nACC 100 DEC 100 STP 100 VEL 10\nDIM LV(1)\n\
                   PROGRAM\nX50\n_Count\nLV0 = LV0 + 1\nGOTO Count\nENDP\n";
    let mut bench = Bench::terminal_with(listing, program);
    bench.ask("PROG0");
    bench.ask("RUN PROG0");
    bench.pass(1.0);
    bench.ask("PAUSE PROG0");
    bench.pass(0.2);
    let held = (bench.position(0), bench.number("?LV0"));
    assert!(held.0 > 5.0 && held.0 < 15.0 && bench.bit(516), "{held:?}");
    bench.pass(3.0);
    assert_eq!((bench.position(0), bench.number("?LV0"), bench.state(0)), (held.0, held.1, State::Paused));
    bench.ask("RESUME PROG0");
    bench.pass(6.0);
    assert_eq!((bench.position(0), bench.state(0)), (50.0, State::Running));
    assert!(bench.number("?LV0") > held.1);
}

fn wizard(listing: &Listing) -> Bench {
    let bench = Bench::planned(listing, &Plan { idle: true, ..Plan::default() });
    bench.clean();
    bench
}

fn wizard_masters(listing: &Listing, _: &Fact) {
    let mut bench = wizard(listing);
    let expected = [
        (
            "PROG0",
            "ATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"\n",
            [10.0, 10.0, 10.0, 5.0, 0.0],
        ),
        ("PROG1", "ATTACH MASTER1\nATTACH SLAVE0 AXIS2 \"Z\"\n", [20.0, 20.0, 20.0, 10.0, 0.0]),
    ];
    for (prompt, attached, settings) in expected {
        bench.ask(prompt);
        assert_eq!(bench.ask("ATTACH"), attached);
        assert_eq!(["ACC", "DEC", "STP", "VEL", "JRK"].map(|name| bench.number(name)), settings);
    }
}

fn wizard_window(listing: &Listing, fact: &Fact) {
    let mut bench = wizard(listing);
    for axis in 0..3 {
        let sides = [12_328, 12_329].map(|first| bench.number(&format!("?P{}", first + 256 * axis)));
        assert_eq!(sides.to_vec(), fact.numbers());
    }
}

fn wizard_limits(listing: &Listing, _: &Fact) {
    let bench = wizard(listing);
    for axis in 0..3 {
        for (index, state) in [(16, true), (17, true), (20, true), (21, true), (22, false), (23, false)] {
            assert_eq!(bench.bit(16_128 + 32 * axis + index), state, "axis {axis}, index {index}");
        }
    }
}

fn wizard_scale(listing: &Listing, _: &Fact) {
    let mut bench = wizard(listing);
    near(bench.number("AXIS0 PPU"), 40_000.0, 0.001);
}

fn wizard_prompts(listing: &Listing, _: &Fact) {
    // Line by line at a terminal: the prompt behind each line that switches it.
    let mut bench = Bench::setup("");
    let mut levels = Vec::new();
    for line in listing.text.lines() {
        assert_eq!(bench.ask(line), "", "{line}");
        let level = bench.level();
        if levels.last() != Some(&level) {
            levels.push(level);
        }
    }
    assert_eq!(levels, ["SYS", "PROG0", "PROG1"]);
}

fn velocity_from_elsewhere(listing: &Listing, fact: &Fact) {
    let mut bench = Bench::terminal(listing);
    bench.ask("PROG3");
    assert_eq!(bench.ask(listing.text.trim_end()), "");
    bench.ask("PROG0");
    assert_eq!(bench.number("VEL"), fact.number());
}

fn default_modes(_: &Listing, _: &Fact) {
    assert_eq!(Bench::setup("").number("MODE"), 1.0);
    assert_eq!(Bench::of_model("ACR8000").number("MODE"), 0.0);
}
