//! The command line: formats, exit status, bad input, output files.

mod common;

use common::{Bench, gantry};

const CLEAN: &str = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nACC 10 DEC 10 STP 10 VEL 5\nPROGRAM\nX5\nENDP\n";
const BROKEN: &str = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nGOTO Nowhere\nPRNT \"x\"\nENDP\n";

#[test]
fn the_example_is_clean() {
    let bench = Bench::new();
    let run = bench.acrc(["lint".as_ref(), gantry().as_os_str()]).expect(0);
    assert!(run.stdout.contains("no problems in 3 files"), "{}", run.stdout);
}

#[test]
fn lint_reports_in_json() {
    let bench = Bench::new();
    bench.file("bad.8K", BROKEN);
    let run = bench.acrc(["lint", "bad.8K", "--format", "json"]).expect(1);
    let report: serde_json::Value = serde_json::from_str(&run.stdout).expect("one JSON object");
    let found = report["diagnostics"].as_array().expect("a list");
    assert_eq!(found.len(), 2, "{}", run.stdout);
    assert_eq!(found[0]["name"], "undefined-label");
    assert_eq!(found[0]["severity"], "error");
    assert_eq!(found[0]["file"], "bad.8K");
    assert_eq!(found[0]["range"]["start"], serde_json::json!({ "line": 5, "column": 6 }));
    assert_eq!(found[0]["range"]["end"], serde_json::json!({ "line": 5, "column": 13 }));
    for key in ["code", "message", "help", "fixes"] {
        assert!(found[0].get(key).is_some(), "{key}");
    }
    assert_eq!(report["summary"]["errors"], 2);
}

#[test]
fn fail_on_decides_the_exit_status_of_lint() {
    let bench = Bench::new();
    bench.file("warn.8K", "PROG0\nPROGRAM\nDIM LV10\nLV0 = 1\nENDP\n");
    bench.acrc(["lint", "warn.8K"]).expect(1);
    bench.acrc(["lint", "warn.8K", "--fail-on", "error"]).expect(0);
    bench.file("bad.8K", BROKEN);
    bench.acrc(["lint", "bad.8K", "--fail-on", "error"]).expect(1);
    bench.acrc(["lint", "bad.8K", "--fail-on", "never"]).expect(0);
    bench.file("clean.8K", CLEAN);
    bench.acrc(["lint", "clean.8K"]).expect(0);
}

#[test]
fn aliases_that_name_each_other_are_refused() {
    let bench = Bench::new();
    bench.file("loop.8K", "#DEFINE First Second\n#DEFINE Second First\nPROG0\nPROGRAM\nFirst = 5\nENDP\n");
    let run = bench.acrc(["lint", "loop.8K"]).expect(1);
    assert!(run.stdout.contains("2 errors in 1 file"), "{}", run.stdout);
    assert!(run.stdout.contains("stands for another name"), "{}", run.stdout);
}

#[test]
fn colour_only_when_asked_for() {
    let bench = Bench::new();
    bench.file("bad.8K", BROKEN);
    assert!(!bench.acrc(["lint", "bad.8K"]).stdout.contains('\u{1b}'));
    assert!(bench.acrc(["lint", "bad.8K", "--color", "always"]).stdout.contains('\u{1b}'));
    assert!(!bench.acrc(["lint", "bad.8K", "--color", "never"]).stdout.contains('\u{1b}'));
}

#[test]
fn what_cannot_be_read_gets_one_clear_message() {
    let bench = Bench::new();
    std::fs::create_dir(bench.path("empty")).expect("writable");
    bench.file("image.8K", [0_u8, 1, 2, 3, 0, 255, 0, 0]);
    bench.file("bad/acrc.toml", "[project\n");
    bench.file("model/acrc.toml", "[project]\nmodel = \"ACR900\"\nfiles = [\"a.8K\"]\n");
    bench.file("model/a.8K", CLEAN);
    bench.file("listed/acrc.toml", "[project]\nfiles = [\"gone.8K\"]\n");
    bench.file("bare/acrc.toml", "");
    bench.file("folder/acrc.toml", "[project]\nfiles = [\"src\"]\n");
    bench.file("folder/src/a.8K", CLEAN);
    bench.file("pattern/acrc.toml", "[project]\nfiles = [\"*.8K\"]\n");
    bench.file("pattern/a.8K", CLEAN);
    bench.file("twice/acrc.toml", "[project]\nfiles = [\"a.8K\", \"./a.8K\"]\n");
    bench.file("twice/a.8K", CLEAN);
    bench.file("toml/acrc.toml/a.8K", CLEAN);
    for (path, expected) in [
        ("nothing.8K", "does not exist"),
        ("empty", "holds no program"),
        ("image.8K", "can't be read as a program"),
        ("bad", "acrc.toml"),
        ("model", "ACR9000"),
        ("listed", "gone.8K"),
        ("bare", "`bare/acrc.toml` has no program beside it or in src/"),
        ("folder", "lists `src`, which is a folder"),
        ("pattern", "lists `*.8K`, which does not exist: patterns are not read"),
        ("twice", "lists `./a.8K` twice"),
        ("toml", "`toml/acrc.toml` is a folder"),
    ] {
        for command in ["lint", "sim"] {
            let run = bench.acrc([command, path]).expect(2);
            assert!(run.stderr.starts_with("error: ") && run.stderr.contains(expected), "{path}: {}", run.stderr);
            assert!(run.stdout.is_empty(), "{path}: {}", run.stdout);
        }
    }
}

#[test]
fn wrong_arguments_end_with_status_two() {
    let bench = Bench::new();
    bench.file("clean.8K", CLEAN);
    for arguments in [
        &["lint", "--nonsense"][..],
        &["lint", "clean.8K", "--format", "xml"],
        &["sim", "clean.8K", "--run", "PROG16"],
        &["sim", "clean.8K", "--run", "PLC0"],
        &["sim", "clean.8K", "--run", "PROG0", "--until", "soon"],
        &["sim", "clean.8K", "--run", "PROG0", "--read", "X5"],
        &["sim", "clean.8K", "--run", "PROG0", "--read", "BIT999999"],
        &["sim", "clean.8K", "--run", "PROG0", "--rate", "0s"],
        &["sim", "clean.8K", "--run", "PROG0", "--world", "gone.toml"],
        &["sim", "clean.8K", "--run", "PROG0", "--trace", "no/such/folder/t.csv"],
        &["build", "clean.8K"],
        &["list", "clean.8K"],
        &["explain"],
        &[],
    ] {
        let run = bench.acrc(arguments.iter().copied());
        assert_eq!(run.status, Some(2), "{arguments:?}\n{}\n{}", run.stdout, run.stderr);
        assert!(!run.stderr.is_empty(), "{arguments:?}");
    }
    let run = bench.acrc(["lint", "--fix", "--diff"]).expect(2);
    assert!(
        run.stderr.contains("'--fix' cannot be used with '--diff'") && !run.stderr.contains("Usage"),
        "{}",
        run.stderr
    );
}

#[test]
fn a_file_that_is_far_too_large_is_refused_unread() {
    let bench = Bench::new();
    let file = std::fs::File::create(bench.path("huge.8K")).expect("writable");
    file.set_len((64 << 20) + 1).expect("a file with a hole");
    let run = bench.acrc(["lint", "huge.8K"]).expect(2);
    let expected = "error: `huge.8K` has 67108865 bytes: a program text of more than 64 MiB is not read\n";
    assert_eq!(run.stderr, expected);
}

#[test]
fn build_and_list_give_the_program_back() {
    let bench = Bench::new();
    bench.file("clean.8K", CLEAN);
    let built = bench.acrc(["build", "clean.8K", "-o", "clean.acrx"]).expect(0);
    // An axis move is a command, an axis reference and a constant.
    assert!(built.stdout.contains("12 bytes"), "{}", built.stdout);
    let listed = bench.acrc(["list", "clean.acrx"]).expect(0);
    assert!(listed.stdout.contains("\nX5\n"), "{}", listed.stdout);
    bench.acrc(["list", "clean.acrx", "--program", "PROG3"]).expect(2);
    bench.acrc(["build", "clean.8K", "-o", "stripped.acrx", "--strip"]).expect(0);
    assert_eq!(bench.acrc(["list", "stripped.acrx"]).expect(0).stdout, listed.stdout);
}

#[test]
fn a_project_with_errors_is_not_built() {
    let bench = Bench::new();
    bench.file("bad.8K", BROKEN);
    bench.file("bad.acrx", "an older image");
    let run = bench.acrc(["build", "bad.8K", "-o", "bad.acrx"]).expect(1);
    assert!(run.stderr.contains("PRNT"), "{}", run.stderr);
    assert_eq!(std::fs::read_to_string(bench.path("bad.acrx")).expect("still there"), "an older image");
    bench.acrc(["sim", "bad.8K", "--run", "PROG0"]).expect(2);
}

#[test]
fn a_damaged_image_is_refused_with_the_reason() {
    let bench = Bench::new();
    bench.file("clean.8K", CLEAN);
    bench.acrc(["build", "clean.8K", "-o", "clean.acrx"]).expect(0);
    let whole = std::fs::read(bench.path("clean.acrx")).expect("built");
    bench.file("short.acrx", &whole[..whole.len() - 3]);
    let mut altered = whole.clone();
    altered[whole.len() / 2] ^= 0x40;
    bench.file("altered.acrx", &altered);
    for name in ["short.acrx", "altered.acrx"] {
        let run = bench.acrc(["list", name]).expect(2);
        assert!(run.stderr.contains("is no image that can be listed"), "{}", run.stderr);
    }
}

#[cfg(unix)]
#[test]
fn output_that_cannot_be_written_leaves_no_half_file() {
    let bench = Bench::new();
    bench.file("clean.8K", CLEAN);
    let full = std::path::Path::new("/dev/full");
    if full.exists() {
        let run = std::process::Command::new(env!("CARGO_BIN_EXE_acrc"))
            .args(["sim", "clean.8K", "--run", "PROG0", "--format", "json"])
            .current_dir(bench.folder.path())
            .stdout(std::fs::OpenOptions::new().write(true).open(full).expect("a device"))
            .output()
            .expect("acrc starts");
        assert_eq!(run.status.code(), Some(2));
        assert!(String::from_utf8_lossy(&run.stderr).contains("cannot write to standard output"));
    }
    bench.file("empty.8K", "");
    for command in [&["sim", "empty.8K"][..], &["build", "empty.8K", "-o", "empty.acrx"]] {
        let run = bench.acrc(command.iter().copied()).expect(2);
        assert!(run.stderr.contains("empty.8K holds no statement"), "{}", run.stderr);
    }
    let run = bench.acrc(["build", "clean.8K", "-o", "no/such/folder.acrx"]).expect(2);
    assert!(run.stderr.contains("its folder does not exist"), "{}", run.stderr);
    std::fs::create_dir(bench.path("taken.acrx")).expect("writable");
    let run = bench.acrc(["build", "clean.8K", "-o", "taken.acrx"]).expect(2);
    assert!(run.stderr.contains("taken.acrx"), "{}", run.stderr);
    let names = std::fs::read_dir(bench.folder.path()).expect("readable");
    let left: Vec<_> = names.filter_map(|entry| entry.ok()?.file_name().into_string().ok()).collect();
    assert!(left.iter().all(|name| !name.starts_with(".acrc-")), "{left:?}");
}

#[test]
fn outputs_never_replace_what_is_read() {
    let bench = Bench::new();
    bench.file("clean.8K", CLEAN);
    bench.acrc(["build", "clean.8K", "-o", "clean.8K"]).expect(2);
    bench.acrc(["sim", "clean.8K", "--run", "PROG0", "--trace", "./clean.8K"]).expect(2);
    assert_eq!(std::fs::read_to_string(bench.path("clean.8K")).expect("still there"), CLEAN);
    let twice = bench.acrc(["sim", "clean.8K", "--run", "PROG0", "--trace", "a", "--plot", "a"]).expect(2);
    assert!(twice.stderr.contains("two outputs"), "{}", twice.stderr);
}

#[cfg(unix)]
#[test]
fn a_link_keeps_pointing_where_it_points() {
    let bench = Bench::new();
    bench.file("clean.8K", CLEAN);
    bench.file("real.csv", "old");
    std::os::unix::fs::symlink(bench.path("real.csv"), bench.path("link.csv")).expect("links are possible");
    bench.acrc(["sim", "clean.8K", "--run", "PROG0", "--trace", "link.csv"]).expect(0);
    assert!(bench.path("link.csv").is_symlink());
    let written = std::fs::read_to_string(bench.path("real.csv")).expect("readable");
    assert!(written.starts_with("time_s,"), "{written}");
}

#[test]
fn a_project_that_the_linter_refuses_is_not_built() {
    let bench = Bench::new();
    bench.file("open.8K", "PROG0\nPROGRAM\nWHILE (BIT 10)\nENDP\n");
    let run = bench.acrc(["build", "open.8K", "-o", "open.acrx"]).expect(1);
    assert!(run.stderr.contains("ACR110"), "{}", run.stderr);
    assert!(!bench.path("open.acrx").exists());
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_leaves_nothing_behind() {
    let bench = Bench::new();
    bench.file("poll.8K", "PROG0\nPROGRAM\n_on\nGOTO on\nENDP\n");
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_acrc"))
        .args(["sim", "poll.8K", "--run", "PROG0", "--until", "1h", "--trace", "t.csv"])
        .current_dir(bench.folder.path())
        .stdout(std::process::Stdio::null())
        .spawn()
        .expect("acrc starts");
    // The trace is begun once its temporary file is there; the run watches for signals by then. Left alone, it would end after an hour of
    // virtual time.
    let begun = || {
        let names = std::fs::read_dir(bench.folder.path()).expect("readable");
        names.filter_map(|entry| entry.ok()?.metadata().ok()).any(|found| found.len() > 1 << 16)
    };
    while !begun() {
        assert!(child.try_wait().expect("a child").is_none(), "the run goes on until it is interrupted");
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    let killed = std::process::Command::new("kill").args(["-TERM", &child.id().to_string()]).status();
    assert!(killed.expect("kill is part of every Unix").success());
    assert_eq!(child.wait().expect("a child").code(), Some(130));
    let left = std::fs::read_dir(bench.folder.path()).expect("readable").count();
    assert_eq!(left, 1, "only the program is there");
}

#[test]
fn explain_knows_commands_numbers_models_and_codes() {
    let bench = Bench::new();
    for (topic, expected) in [
        (&["JOG"][..], "JOG"),
        (&["jog", "home"], "JOG HOME"),
        (&["P12290"], "Actual"),
        (&["BIT8467"], "Kill All Motion"),
        (&["KAMR"], "8467"),
        (&["ACR9000"], "ACR9000"),
        (&["ACR101"], "undefined-label"),
        (&["undefined-label"], "ACR101"),
    ] {
        let run = bench.acrc(["explain"].iter().chain(topic)).expect(0);
        assert!(run.stdout.contains(expected), "{topic:?}: {}", run.stdout);
    }
    let near = bench.acrc(["explain", "JGO"]).expect(2);
    assert!(near.stderr.contains("did you mean `JOG`"), "{}", near.stderr);
}

#[test]
fn help_and_version_succeed() {
    let bench = Bench::new();
    assert!(bench.acrc(["--version"]).expect(0).stdout.starts_with("acrc 0."));
    for command in ["lint", "build", "list", "sim", "explain"] {
        assert!(bench.acrc([command, "--help"]).expect(0).stdout.contains("Usage: acrc"));
    }
}

#[test]
fn a_misspelt_rule_is_guessed() {
    let bench = Bench::new();
    let run = bench.acrc(["explain", "undefined-lable"]).expect(2);
    assert!(run.stderr.contains("did you mean the rule `undefined-label`?"), "{}", run.stderr);
    let run = bench.acrc(["explain", "JGO"]).expect(2);
    assert!(run.stderr.contains("JOG"), "{}", run.stderr);
}

#[test]
fn a_reader_that_goes_away_does_not_change_the_status() {
    let bench = Bench::new();
    bench.file("bad/Prog0.8K", "PROGRAM\nGOTO Nowhere\nset 32\nENDP\n");
    bench.file("clean.8K", CLEAN);
    let nobody = || {
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        writer
    };
    let formats = ["text", "concise", "json", "jsonl", "sarif", "github", "gitlab", "junit", "checkstyle"];
    let lint = formats.map(|format| (vec!["lint", "bad", "--format", format], 1));
    let others = [
        (vec!["lint", "clean.8K"], 0),
        (vec!["lint", "bad", "--fail-on", "never"], 0),
        (vec!["lint", "bad", "gone"], 2),
        (vec!["lint", "bad", "--output-file", "/dev/stdout"], 1),
        (vec!["lint", "bad", "--statistics"], 1),
        (vec!["lint", "bad", "--watch"], 1),
        (vec!["fmt", "bad", "--check"], 1),
        (vec!["fmt", "bad", "--diff"], 1),
        (vec!["mem", "bad"], 1),
        (vec!["mem", "clean.8K"], 0),
        (vec!["build", "bad", "-o", "x.acrx"], 1),
        (vec!["sim", "bad"], 2),
        (vec!["sim", "clean.8K", "--run", "PROG0", "--trace", "/dev/stdout"], 0),
        (vec!["explain", "ACR101"], 0),
    ];
    for (arguments, status) in
        lint.into_iter().chain(others).filter(|(arguments, _)| cfg!(unix) || !arguments.contains(&"/dev/stdout"))
    {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_acrc"));
        command.args(&arguments).current_dir(bench.folder.path()).stdout(nobody());
        let output = command.output().expect("acrc starts");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(status), "{arguments:?}: {said}");
        assert!(!said.contains("pipe") && !said.contains("panicked"), "{arguments:?}: {said}");
        let silent = command.stdout(nobody()).stderr(nobody()).status().expect("acrc starts");
        assert_eq!(silent.code(), Some(status), "{arguments:?} without standard error");
    }
}
