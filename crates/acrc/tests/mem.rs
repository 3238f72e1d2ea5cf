//! `acrc mem`: what it prints, and that the dry run agrees with it to the byte.

mod common;

use common::{Bench, gantry};
use serde_json::Value;

impl Bench {
    /// The account as JSON; the status must be as given.
    #[track_caller]
    fn account(&self, project: &str, status: i32) -> Value {
        let run = self.acrc(["mem", project, "--format", "json"]).expect(status);
        serde_json::from_str(&run.stdout).expect("one JSON object")
    }
}

/// Setup code and program text with `#` in the place of a size.
struct Case {
    name: &'static str,
    text: &'static str,
    /// The size that is just enough.
    enough: u64,
}

/// The numbers are counted by hand: 4 a command, 8 an operand with its number, 4 a constant.
const CASES: [Case; 11] = [
    // SET 32 and CLR 32
    Case { name: "text", text: "PROGRAM\nSET 32\nCLR 32\nENDP\n", enough: 8 + 8 },
    // CLEAR, DIM LV(3), LV2 = 1: command, operand, constant; 3 longs
    Case { name: "LV", text: "PROGRAM\nCLEAR\nDIM LV(3)\nLV2 = 1\nENDP\n", enough: 4 + 8 + 16 + 3 * 4 },
    // CLEAR, DIM DV(2); 2 doubles
    Case { name: "DV", text: "PROGRAM\nCLEAR\nDIM DV(2)\nENDP\n", enough: 4 + 8 + 2 * 8 },
    // CLEAR, DIM $V(2,10): two constants; 2 strings of 4 + 10
    Case { name: "$V", text: "PROGRAM\nCLEAR\nDIM $V(2,10)\nENDP\n", enough: 4 + 12 + 2 * 14 },
    // CLEAR, DIM LA(2), DIM LA1(5); references 2 * 4 + 4, elements 5 * 4 + 4
    Case { name: "LA", text: "PROGRAM\nCLEAR\nDIM LA(2)\nDIM LA1(5)\nENDP\n", enough: 4 + 8 + 12 + 12 + 24 },
    // as before; elements 3 * 8 + 4
    Case { name: "DA", text: "PROGRAM\nCLEAR\nDIM DA(1)\nDIM DA0(3)\nENDP\n", enough: 4 + 8 + 12 + 8 + 28 },
    // DIM $A0(3,4): array, count, length; 3 * 4 characters
    Case { name: "$A", text: "PROGRAM\nCLEAR\nDIM $A(1)\nDIM $A0(3,4)\nENDP\n", enough: 4 + 8 + 16 + 8 + 12 },
    // GOSUB A 8, END 4, _A 9, GOSUB B 8, RETURN 4, _B 9, RETURN 4; two levels
    Case {
        name: "calls",
        text: "PROGRAM\nGOSUB A\nEND\n_A\nGOSUB B\nRETURN\n_B\nRETURN\nENDP\n",
        enough: 8 + 4 + 9 + 8 + 4 + 9 + 4 + 2 * 4,
    },
    // CLEAR, DIM MBUF(2); 2 moves
    Case { name: "MBUF", text: "PROGRAM\nCLEAR\nDIM MBUF(2)\nENDP\n", enough: 4 + 8 + 2 * 136 },
    // CLEAR, DIM MBUF(2), CLEAR MBUF, DIM MBUF(3): not both at once
    Case {
        name: "CLEAR MBUF",
        text: "PROGRAM\nCLEAR\nDIM MBUF(2)\nCLEAR MBUF\nDIM MBUF(3)\nENDP\n",
        enough: 4 + 8 + 4 + 8 + 3 * 136,
    },
    // variables that are given at the prompt, after the text was stored: LV1 = 5; 2 longs
    Case { name: "prompt", text: "PROGRAM\nLV1 = 5\nENDP\nDIM LV(2)\n", enough: 16 + 8 },
];

#[test]
fn what_is_just_enough_runs_and_a_byte_less_does_not() {
    let bench = Bench::new();
    for Case { name, text, enough } in CASES {
        for (size, status) in [(enough, 0), (enough - 1, 1)] {
            bench.file("test.8K", format!("SYS\nCLEAR\nDIM PROG0({size})\nPROG0\n{text}"));
            let account = bench.account("test.8K", status);
            assert_eq!(account["programs"][0]["needed"], enough, "{name}");
            assert_eq!(account["over"], status == 1, "{name}");
            let run = bench.acrc(["sim", "test.8K", "--run", "PROG0", "--format", "json"]);
            assert_eq!(run.status, Some(status), "{name} with {size}: {}{}", run.stdout, run.stderr);
        }
    }
}

/// 1,048,576 bytes in all. `DIM DEF(10)` takes 10 * 48 + 16, `DIM P(100)` 100 * 8.
#[test]
fn system_memory_is_given_away_to_the_last_byte() {
    let bench = Bench::new();
    for (what, rest) in
        [("DIM DEF(10)", 1_048_576 - 496), ("DIM P(100)", 1_048_576 - 800), ("DIM PROG9(4096)", 1_044_480)]
    {
        for (size, status) in [(rest, 0), (rest + 1, 1)] {
            bench.file("test.8K", format!("SYS\nCLEAR\nDIM PROG0({size})\n{what}\nPROG0\nPROGRAM\nSET 32\nENDP\n"));
            let account = bench.account("test.8K", status);
            assert_eq!(account["system"]["total"], 1_048_576);
            assert_eq!(account["refused"].as_array().map(Vec::len), Some(status as usize), "{what}");
            let run = bench.acrc(["sim", "test.8K", "--run", "PROG0"]);
            assert_eq!(run.status, Some(status), "{what} beside {size}: {}", run.stdout);
        }
    }
}

#[test]
fn a_block_that_has_memory_is_refused_by_both() {
    let bench = Bench::new();
    for (text, status) in [
        ("SYS\nDIM PROG0(100)\nPROG0\nPROGRAM\nSET 32\nENDP\n", 1),
        ("SYS\nCLEAR\nDIM PROG0(100)\nPROG0\nPROGRAM\nSET 32\nENDP\n", 0),
        ("PROG0\nDIM LV(2)\nDIM LV(3)\nPROGRAM\nSET 32\nENDP\n", 1),
        ("PROG0\nDIM LV(2)\nPROGRAM\nDIM LV(3)\nENDP\n", 1),
        ("PROG0\nDIM LV(2)\nPROGRAM\nCLEAR\nDIM LV(3)\nENDP\n", 0),
        ("PROG0\nPROGRAM\nDIM LA0(3)\nENDP\n", 1),
        ("PROG0\nPROGRAM\nDIM LA(1)\nDIM LA1(3)\nENDP\n", 1),
        ("PROG9\nPROGRAM\nSET 32\nENDP\n", 1),
    ] {
        bench.file("test.8K", text);
        bench.account("test.8K", status);
        let program = if text.starts_with("PROG9") { "PROG9" } else { "PROG0" };
        let run = bench.acrc(["sim", "test.8K", "--run", program]);
        assert_eq!(run.status, Some(status), "{text}: {}", run.stdout);
    }
}

#[test]
fn the_exact_statements_are_exact() {
    let bench = Bench::new();
    let program = "PROGRAM\nCLEAR\nDIM LV(2)\nGOSUB Count\nEND\n_Count\nTotal = Total + LV1\nP7 = 1\nRETURN\nENDP\n";
    let setup = |dims: &str| format!("SYS\nCLEAR\n{dims}#DEFINE Total P3\nPROG0\n");
    bench.file("test.8K", setup("DIM PROG0(9000)\nDIM P(50)\nDIM DEF(9)\n") + program);
    let account = bench.account("test.8K", 0);
    let exact = account["exact"].as_array().expect("a list");
    let statements = exact.iter().map(|dim| dim["statement"].as_str().expect("a text"));
    let dims: String = statements.flat_map(|statement| [statement, "\n"]).collect();
    assert!(dims.ends_with("DIM P(8)\nDIM DEF(1)\n"), "{dims}");
    bench.file("test.8K", setup(&dims) + program);
    let account = bench.account("test.8K", 0);
    assert_eq!(account["programs"][0]["needed"], account["programs"][0]["space"]);
    bench.acrc(["lint", "test.8K"]).expect(0);
    bench.acrc(["sim", "test.8K", "--run", "PROG0"]).expect(0);
}

#[test]
fn an_account_as_a_person_sees_it() {
    let bench = Bench::new();
    bench.file(
        "Setup.8K",
        "SYS\nCLEAR\nDIM PROG0(300)\nDIM PROG1(64)\nDIM PROG2(1000)\nDIM PROG3(1000)\nDIM PROG4(1000)\nDIM PROG15(28672)\n\
         DIM P(100)\nDIM DEF(1)\nDIM P(200)\n#DEFINE Lamp BIT33\n#DEFINE Count P(7)\n",
    );
    bench.file(
        "Prog0.8K",
        "PROGRAM\nREM teaches points\nCLEAR\nDIM LV(2)\nDIM $V(1,10)\nDIM DA(1)\nGOSUB Teach\nEND\n\n_Teach\nLV1 = 12\n\
         DIM DA0(LV1)\nPRINT \"points: \"; LV1\nRETURN\nENDP\n",
    );
    bench.file(
        "Prog1.8K",
        "PROGRAM\n_Blink\nSET Lamp\nDWL 0.25\nCLR Lamp\nDWL 0.25\nCount = Count + 1\nGOTO Blink\nENDP\n",
    );
    let run = bench.acrc(["mem", "."]).expect(1);
    assert!(run.stdout.lines().all(|line| line.chars().count() <= 80), "{}", run.stdout);
    assert!(!run.stdout.contains('\u{1b}'), "{}", run.stdout);
    // The first line begins with the name of the temporary folder.
    let shown = run.stdout.split_once('\n').map_or("", |(_, rest)| rest);
    insta::assert_snapshot!(shown);
}

#[test]
fn colours_only_when_asked_for() {
    let bench = Bench::new();
    bench.file("test.8K", "SYS\nCLEAR\nDIM PROG0(8)\nPROG0\nPROGRAM\nSET 32\nCLR 32\nENDP\n");
    assert!(!bench.acrc(["mem", "test.8K"]).expect(1).stdout.contains('\u{1b}'));
    let run = bench.acrc(["mem", "test.8K", "--color", "always"]).expect(1);
    let excess = run.stdout.lines().find(|line| line.contains("8 bytes too many")).expect("the excess");
    assert!(excess.starts_with("\u{1b}[1;31m"), "{excess:?}");
}

#[test]
fn the_example_fits() {
    let bench = Bench::new();
    let run = bench.acrc(["mem".as_ref(), gantry().as_os_str()]).expect(0);
    assert!(run.stdout.contains("DIM statements that fit exactly"), "{}", run.stdout);
}

#[test]
fn the_form_of_the_json() {
    let bench = Bench::new();
    bench.file("test.8K", "SYS\nCLEAR\nDIM PROG0(8)\nPROG0\nPROGRAM\nSET 32\n_Label\nCLR 32\nENDP\n");
    let run = bench.acrc(["mem", "test.8K", "--format", "json"]).expect(1);
    insta::assert_snapshot!(run.stdout);
}

#[test]
fn what_cannot_be_counted() {
    let bench = Bench::new();
    bench.acrc(["mem", "missing"]).expect(2);
    bench.file("bad.8K", "PROG0\nPROGRAM\nGOTO Nowhere\nENDP\n");
    let run = bench.acrc(["mem", "bad.8K"]).expect(1);
    assert!(run.stderr.contains("undefined-label") || run.stderr.contains("Nowhere"), "{}", run.stderr);
    assert_eq!(run.stdout, "");
    bench.file("empty.8K", "");
    bench.acrc(["mem", "empty.8K"]).expect(0);
}

#[test]
fn what_is_used_without_memory_does_not_fit() {
    let bench = Bench::new();
    bench.file("p/Setup.8K", "CLEAR\nDIM PROG0(1000)\nDIM P(4)\n");
    bench.file("p/Prog0.8K", "PROGRAM\nP9 = 1\nLV0 = 1\nENDP\n");
    let account = bench.account("p", 1);
    assert_eq!(account["over"], true);
    let reasons: Vec<_> = account["refused"].as_array().expect("a list").iter().map(|one| &one["reason"]).collect();
    assert_eq!(reasons, ["index-outside-dim", "undimensioned-variable"]);
    let run = bench.acrc(["mem", "p"]).expect(1);
    assert!(run.stdout.contains("Prog0.8K:2: P9 is outside DIM P(4)"), "{}", run.stdout);
}

#[test]
fn a_computed_size_is_not_zero() {
    let bench = Bench::new();
    bench.file("p/Setup.8K", "SYS\nCLEAR\nDIM PROG0(P0)\nDIM PROG1(4000)\nDIM P(10)\nDIM DEF(0)\n#DEFINE Lamp BIT32\n");
    bench.file("p/Prog0.8K", "PROGRAM\nSET Lamp\nENDP\n");
    bench.file("p/Prog1.8K", "PROGRAM\nCLR Lamp\nENDP\n");
    let text = bench.acrc(["mem", "p"]).expect(1).stdout;
    assert!(text.contains("  programs                ?  at least 4,000: PROG0, PROG1\n"), "{text}");
    assert!(text.contains("at most; sizes are computed\n"), "{text}");
    assert!(text.contains(": 1 alias, DEF has room for 0\n"), "{text}");
    let json = bench.acrc(["mem", "p", "--format", "json"]).expect(1).stdout;
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert!(json["system"]["used"].is_null() && json["system"]["free"].is_null());
}

#[test]
fn what_keeps_a_project_from_being_counted_is_shown() {
    let bench = Bench::new();
    bench.file("p/Prog0.8K", "PROGRAM\n' acrc: allow(ACR101)\nGOTO Nowhere\nENDP\n");
    let run = bench.acrc(["mem", "p"]).expect(1);
    assert!(run.stderr.contains("p/Prog0.8K:3:6"), "{}", run.stderr);
    assert!(
        run.stderr.ends_with("p/Prog0.8K has no account of its memory before these are mended: 1 error in 1 file\n"),
        "{}",
        run.stderr
    );
}
