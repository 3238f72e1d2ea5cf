//! Which rules are heard: `acrc.toml`, the command line, comments.

use super::{Bench, THREE, lint};

fn project(config: &str) -> Bench {
    let bench = Bench::new();
    bench.file("acrc.toml", config);
    bench.file("Prog0.8K", THREE.replace("PROG0\n", ""));
    bench.file("src/Prog1.8K", THREE.replace("PROG0\n", ""));
    bench
}

fn with(config: &str, arguments: &[&str]) -> Vec<String> {
    lint(&project(config), arguments)
}

const P0: [&str; 3] = ["Prog0.8K:2 ACR103", "Prog0.8K:3 ACR101", "Prog0.8K:4 ACR007"];
const P1: [&str; 3] = ["src/Prog1.8K:2 ACR103", "src/Prog1.8K:3 ACR101", "src/Prog1.8K:4 ACR007"];

#[test]
fn the_more_exact_selector_counts() {
    for (config, of_each) in [
        ("", &[0, 1, 2][..]),
        ("[lint]\nselect = [\"flow\"]", &[0, 1]),
        ("[lint]\nselect = [\"ALL\"]\nignore = [\"ACR1\"]", &[2]),
        ("[lint]\nselect = [\"ACR101\"]\nignore = [\"flow\"]", &[1]),
        ("[lint]\nselect = [\"ACR10\"]\nignore = [\"ACR1\"]", &[0, 1]),
        ("[lint]\nselect = [\"undefined-label\"]\nignore = [\"acr101\"]", &[]),
        ("[lint]\nselect = []\nextend-select = [\"Unused-Label\"]", &[0]),
        ("[lint.severity]\nflow = \"off\"\nACR101 = \"warning\"", &[1, 2]),
        ("[lint.severity]\nALL = \"off\"", &[]),
    ] {
        let expected: Vec<_> = [P0, P1].iter().flat_map(|all| of_each.iter().map(|place| all[*place])).collect();
        assert_eq!(with(config, &[]), expected, "{config}");
    }
}

#[test]
fn files_have_their_own_choices() {
    let ignores = "[lint.per-file-ignores]\n\"Prog1*.8K\" = [\"flow\"]\n";
    assert_eq!(with(ignores, &[]), [P0[0], P0[1], P0[2], P1[2]]);
    assert_eq!(with(ignores, &["--select", "ACR101"]), [P0[1]], "the ignores of a file hold in any case");
    let other = "[[lint.override]]\nfiles = [\"src/**\"]\nselect = [\"ACR101\"]\n\
                 [[lint.override]]\nfiles = [\"*.8K\"]\nextend-select = [\"ACR007\"]\nignore = [\"ACR103\"]\n";
    assert_eq!(with(other, &[]), [P0[1], P0[2], P1[1], P1[2]]);
    assert_eq!(with("[lint]\nexclude = [\"src/*\"]\n", &[]), P0);
    let silent = "[lint.severity]\nACR103 = \"off\"\n[[lint.override]]\nfiles = [\"src/*\"]\nseverity = { ACR103 = \"advice\" }\n";
    assert_eq!(with(silent, &["--select", "ACR103"]), [P0[0], P1[0]], "the command line comes last");
    assert_eq!(with(silent, &[]), [P0[1], P0[2], P1[0], P1[1], P1[2]]);
}

#[test]
fn the_command_line_comes_last() {
    let config = "[lint]\nselect = [\"names\"]\nignore = [\"ACR103\"]\n";
    assert_eq!(with(config, &["--select", "ACR007,flow"]), [P0, P1].concat());
    assert_eq!(with(config, &["--extend-select", "ACR101"]), [P0[1], P1[1]]);
    assert_eq!(with("", &["--ignore", "flow"]), [P0[2], P1[2]]);
}

#[test]
fn a_severity_is_what_the_project_says() {
    let bench = project("[lint]\nfail-on = \"error\"\n[lint.severity]\nflow = \"advice\"\nACR007 = \"error\"\n");
    let run = bench.acrc(["lint", "--format", "concise"]).expect(1);
    assert!(run.stdout.contains("Prog0.8K:3:6: advice[ACR101]"), "{}", run.stdout);
    assert!(run.stdout.contains("Prog0.8K:4:15: error[ACR007]"), "{}", run.stdout);
    bench.acrc(["lint", "--ignore", "ACR007"]).expect(0);
    bench.acrc(["lint", "--ignore", "ACR007", "--fail-on", "advice"]).expect(1);
}

#[test]
fn what_the_controller_refuses_is_always_heard() {
    let bench = Bench::new();
    bench.file("bad.8K", "' acrc: allow-file(ACR001)\nP0 = (1\nPRINT \"a\n");
    let found = lint(&bench, &["bad.8K", "--select", "ACR103"]);
    assert_eq!(found, ["bad.8K:2 ACR001", "bad.8K:3 ACR005"]);
    assert!(lint(&bench, &["bad.8K"]).contains(&"bad.8K:1 ACR902".to_owned()));
    for arguments in [["--ignore", "ACR001"], ["--ignore", "unterminated-string"]] {
        let run = bench.acrc(["lint", "bad.8K"].iter().chain(&arguments)).expect(2);
        assert!(run.stderr.contains("always on"), "{}", run.stderr);
    }
}

#[test]
fn an_unknown_selector_is_named() {
    for (config, arguments, expected) in [
        (
            "[lint]\nselect = [\"flwo\"]",
            &[][..],
            "lint.select names `flwo`, which is no rule, group or beginning of a code: did you mean `flow`?",
        ),
        ("[lint.severity]\nundefined_label = \"off\"", &[], "did you mean `undefined-label`?"),
        ("[lint.per-file-ignores]\n\"*\" = [\"ACR9999\"]", &[], "lint.per-file-ignores, `*`, names `ACR9999`"),
        ("[[lint.override]]\nfiles = []", &[], "lint.override 1, files is empty"),
        ("[lint.per-file-ignores]\n\"[\" = []", &[], "`[` is no pattern of files"),
        ("[lint.severity]\nflow = \"loud\"", &[], "loud"),
        ("", &["--ignore", "nothing"], "--ignore names `nothing`"),
    ] {
        let run = project(config).acrc(["lint"].iter().chain(arguments)).expect(2);
        assert!(run.stderr.starts_with("error: ") && run.stderr.contains(expected), "{}", run.stderr);
        assert_eq!(run.stdout, "");
    }
}

#[test]
fn comments_suppress_findings() {
    let bench = Bench::new();
    for (text, expected) in [
        ("' acrc: allow(undefined-label)\nGOTO A\nGOTO A\n", &["t.8K:3 ACR101"][..]),
        ("rem acrc: allow(ACR101) -- the host knows\n\nREM about\nGOTO A\n", &[]),
        ("GOTO A : REM acrc: allow(undefined-label)\nGOTO A\n", &["t.8K:2 ACR101"]),
        ("GOTO A\nGOTO B\n' acrc: allow-file(undefined-label): all of it\n", &[]),
        ("' acrc: allow(unused-label, undefined-label)\nGOTO A\n", &["t.8K:1 ACR901"]),
        ("' acrc: allow(no-such-rule)\nGOTO A\n", &["t.8K:1 ACR902", "t.8K:2 ACR101"]),
        ("' acrc: allow(flow)\nSET 32\n", &["t.8K:1 ACR902"]),
        ("' acrc: allow(ACR021)\nSET 32\n", &["t.8K:1 ACR902"]),
        ("' acrc: permit(ACR101)\nSET 32\n", &["t.8K:1 ACR902"]),
        (
            "' acrc: fmt offf\n' acrc: alow(ACR101)\n' acrc: allow(ACR101\nSET 32\n",
            &["t.8K:1 ACR902", "t.8K:2 ACR902", "t.8K:3 ACR902"],
        ),
        ("SET 32 : REM acrc: fmt off\nREM acrc fmt on\n", &["t.8K:1 ACR902", "t.8K:2 ACR902"]),
        ("' acrc: fmt off\n' about acrc: allow(\nSET 32\n", &[]),
        ("' acrc: allow(ACR101)\n' acrc: allow(ACR007)\nCLEAR : DIM LV10 : GOTO A\n", &[]),
        ("' acrc: allow(ACR101)\nGOTO A : REM acrc: allow(ACR101)\n", &["t.8K:1 ACR901"]),
        ("' acrc: allow-file(ACR101, ACR901)\n' acrc: allow(ACR103)\nGOTO A\n", &[]),
        ("' acrc: allow(ACR101)\nGOTO A(\n' acrc: allow-file(ACR103)\n", &["t.8K:2 ACR001"]),
        ("SET 32 ' acrc: allow(comment-after-statement)\n", &[]),
        ("PROG0\nPROGRAM\n' acrc: allow(ACR110)\nIF (BIT 1)\nSET 32\nENDP\n", &[]),
    ] {
        bench.file("t.8K", text);
        assert_eq!(lint(&bench, &["t.8K"]), expected, "{text}");
    }
    bench.file("t.8K", "' acrc: allow(ACR101)\nSET 32\n");
    assert_eq!(lint(&bench, &["t.8K", "--ignore", "ACR101"]), [""; 0], "a rule that is off finds nothing anyway");
}

#[test]
fn explain_says_how_to_suppress() {
    let bench = Bench::new();
    let run = bench.acrc(["explain", "ACR101"]).expect(0);
    assert!(run.stdout.contains("' acrc: allow(undefined-label)"), "{}", run.stdout);
    assert!(run.stdout.contains("ignore = [\"undefined-label\"]"), "{}", run.stdout);
    assert!(bench.acrc(["explain", "ACR001"]).expect(0).stdout.contains("always on"));
}

#[test]
fn a_pattern_that_means_a_folder_means_what_is_below() {
    let bench = Bench::new();
    bench.file("src/Prog0.8K", "PROGRAM\ngoto Nowhere\nEND\nENDP\n");
    bench.file("Prog1.8K", "PROGRAM\ngoto Nowhere\nEND\nENDP\n");
    for pattern in ["src", "src/", "./src", "/src", "src/**", "s*"] {
        bench.file("acrc.toml", format!("[lint]\nexclude = [\"{pattern}\"]\n[fmt]\nexclude = [\"{pattern}\"]\n"));
        assert_eq!(lint(&bench, &["."]), ["Prog1.8K:2 ACR101"], "{pattern}");
        let run = bench.acrc(["fmt", "--check"]).expect(1);
        assert_eq!(run.stdout, "Prog1.8K is not formatted\n1 file would be reformatted, 0 left alone\n", "{pattern}");
        assert_eq!(run.stderr, "");
    }
}

#[test]
fn patterns_that_mean_no_file_are_told() {
    let bench = Bench::new();
    bench.file("p/src/Prog0.8K", "PROGRAM\nEND\nENDP\n");
    let config = "[lint]\nexclude = [\"scr\"]\n[lint.per-file-ignores]\n\"Prog9.8K\" = [\"ACR101\"]\n\"src\" = [\"ACR1\"]\n\
                  [[lint.override]]\nfiles = [\"Prog0.8K\", \"deep/**\"]\n[fmt]\nexclude = [\"old/\"]\n";
    bench.file("p/acrc.toml", config);
    let told =
        |key: &str, pattern: &str| format!("warning: `p/acrc.toml`: {key}: `{pattern}` means no file of the project\n");
    let lint = [("lint.exclude", "scr"), ("lint.override 1", "deep/**"), ("lint.per-file-ignores", "Prog9.8K")];
    let lint: String = lint.map(|(key, pattern)| told(key, pattern)).concat();
    assert_eq!(bench.acrc(["lint", "p", "--format", "json"]).expect(0).stderr, lint);
    assert_eq!(bench.acrc(["lint", "p", "--quiet"]).expect(0).stderr, "");
    assert_eq!(bench.acrc(["fmt", "p"]).expect(0).stderr, told("fmt.exclude", "old/"));
    assert_eq!(bench.acrc(["fmt", "p", "--quiet"]).expect(0).stderr, "");
}
