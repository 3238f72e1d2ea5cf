//! `acrc sim --state` and `acrc state`: what a controller keeps from one run to the next.

mod common;

use std::process::{Command, Stdio};
use std::time::Duration;

use common::Bench;
use serde_json::json;

/// Counts its starts in P0 and says what X was scaled to.
const COUNTER: &str = "SYS\nHALT ALL\nNEW ALL\nDETACH ALL\nCLEAR\nDIM PROG0(4096)\nDIM P(4)\nPROG0\nATTACH MASTER0\n\
                       ATTACH SLAVE0 AXIS0 \"X\"\nPPU X4000\nSYS\nESAVE\nPROG0\nPROGRAM\nPBOOT\nP0 = P0 + 1\n\
                       PRINT P0, P12375\nENDP\n";

fn lines(report: &serde_json::Value) -> Vec<&str> {
    let output = report["output"].as_array().expect("a list");
    output.iter().map(|line| line["text"].as_str().expect("a text")).collect()
}

fn show(bench: &Bench) -> String {
    bench.acrc(["state", "show", "kept"]).expect(0).stdout
}

#[test]
fn a_controller_goes_on_where_it_was_switched_off() {
    let bench = Bench::new();
    bench.file("count.8K", COUNTER);
    assert_eq!(lines(&bench.sim("count.8K --state kept")), ["1\t4000"]);
    assert_eq!(lines(&bench.sim("--state kept --stored")), ["2\t4000"]);
    let report = bench.sim("--state kept --stored --read P0,P12375");
    assert_eq!((lines(&report), &report["values"]), (vec!["3\t4000"], &json!({ "P0": 3, "P12375": 4000 })));
    insta::assert_snapshot!(show(&bench), @r"
    model                  ACR9000
    battery-backed memory  PROG0; 4 user parameters, 0 aliases; 4128 bytes given out
    retained parameters    0
    system parameters      saved; 1 master and 1 axis attached, 0 settings
    image in flash memory  none
    ");
    assert_eq!(lines(&bench.sim("count.8K --state kept")), ["1\t4000"], "the download clears the memory");
}

#[test]
fn a_project_is_sent_to_what_the_controller_has_kept() {
    let bench = Bench::new();
    bench.file("count.8K", COUNTER);
    bench.file("more.8K", "SYS\nDIM P(4)\nDIM PROG1(4096)\nPROG1\nPROGRAM\nPBOOT\nPRINT \"one\"\nENDP\n");
    bench.sim("count.8K --state kept");
    let report = bench.sim("more.8K --state kept");
    assert_eq!(lines(&report), ["2\t4000", "one"]);
    let faults = report["faults"].to_string();
    assert!(faults.contains("Re-dimensioned block: P has 32 bytes already"), "{faults}");
}

#[test]
fn without_a_battery_the_image_in_flash_is_what_is_left() {
    let bench = Bench::new();
    bench.file("count.8K", COUNTER);
    bench.file("flash.8K", format!("{COUNTER}SYS\nP0 = 10\nFLASH IMAGE\n"));
    bench.sim("count.8K --state kept --no-battery");
    assert!(lines(&bench.sim("--state kept --stored --no-battery")).is_empty());
    bench.sim("flash.8K --state kept --no-battery");
    for _ in 0..2 {
        assert_eq!(lines(&bench.sim("--state kept --stored --no-battery")), ["11\t4000"]);
    }
    assert!(show(&bench).contains("lost: factory settings"));
}

#[test]
fn the_way_back_to_the_factory() {
    let bench = Bench::new();
    bench.file("count.8K", format!("{COUNTER}SYS\nFLASH IMAGE\n"));
    bench.file(
        "factory.8K",
        "HALT ALL\nNEW ALL\nDETACH ALL\nCLEAR\nERASE\nFLASH ERASE\nCONFIG CLEAR\nCLEAR COM1\nCLEAR COM2\nBRESET\nREBOOT\n",
    );
    bench.sim("count.8K --state kept");
    bench.acrc(["sim", "factory.8K", "--state", "kept"]).expect(0);
    insta::assert_snapshot!(show(&bench), @r"
    model                  ACR9000
    battery-backed memory  lost: factory settings
    retained parameters    0
    system parameters      not saved
    image in flash memory  none
    ");
    assert!(lines(&bench.sim("--state kept --stored")).is_empty());
}

#[test]
fn what_is_stored_is_looked_at_before_it_runs() {
    let bench = Bench::new();
    bench.file("two.8K", "PROG0\nPROGRAM\nPRINT \"zero\"\nENDP\nPROG1\nPROGRAM\nPRINT \"never\"\nPM ON AXIS0\nENDP\n");
    bench.sim("two.8K --run PROG0 --state kept");
    let run = |programs: &str| bench.acrc(["sim", "--state", "kept", "--stored", "--run", programs]);
    assert!(run("PROG0").expect(0).stdout.contains("zero"));
    assert!(run("PROG4").expect(2).stderr.contains("PROG4 has no text in the controller"));
    let refused = run("PROG1").expect(2);
    assert!(refused.stderr.contains("PROG1: PM ON") && refused.stdout.is_empty(), "{}", refused.stderr);
}

#[test]
fn reset_forgets_everything() {
    let bench = Bench::new();
    bench.file("count.8K", COUNTER);
    bench.sim("count.8K --state kept");
    bench.acrc(["state", "reset", "kept"]).expect(0);
    assert_eq!(show(&bench), "nothing was saved yet\n");
    let refused = bench.acrc(["sim", "--state", "kept", "--stored"]).expect(2);
    assert!(refused.stderr.contains("nothing was saved yet: run a project with --state first"), "{}", refused.stderr);
    let refused = bench.acrc(["state", "show", "nowhere"]).expect(2);
    assert!(refused.stderr.contains("nowhere is no folder"), "{}", refused.stderr);
}

#[test]
fn what_cannot_be_used_is_refused_before_the_run() {
    let bench = Bench::new();
    bench.file("count.8K", COUNTER);
    bench.file("other/notes.txt", "1");
    let refused = |folder: &str| bench.acrc(["sim", "count.8K", "--state", folder]).expect(2);
    let run = refused("other");
    assert!(run.stderr.contains("holds notes.txt, so it is no folder of a controller's state"), "{}", run.stderr);
    assert!(run.stdout.is_empty());

    bench.sim("count.8K --state kept");
    let path = bench.path("kept/state-00000002.acrs");
    let text = std::fs::read_to_string(&path).expect("two states were saved");
    std::fs::write(&path, text.replacen("4000.0", "8000.0", 1)).expect("room");
    let run = refused("kept");
    assert!(run.stderr.contains("state-00000002.acrs cannot be used: it was altered"), "{}", run.stderr);
    assert!(run.stderr.contains("without it, the state before it is used"), "{}", run.stderr);

    std::fs::remove_file(&path).expect("there");
    let held = acrc_store::Store::open(&bench.path("kept")).expect("free");
    assert!(refused("kept").stderr.contains("in use by another process"));
    drop(held);
    bench.file("model/acrc.toml", "[project]\nmodel = \"ACR1505\"\nfiles = [\"a.8K\"]\n");
    bench.file("model/a.8K", COUNTER);
    let run = bench.acrc(["sim", "model", "--state", "kept"]).expect(2);
    assert!(run.stderr.contains("it was saved by ACR9000, and this controller is ACR1505"), "{}", run.stderr);
}

#[test]
fn a_run_that_is_killed_leaves_a_state() {
    let bench = Bench::new();
    let text = COUNTER.replace("PRINT P0, P12375", "_AGAIN\nP0 = P0 + 1\nESAVE\nFLASH IMAGE\nGOTO AGAIN");
    bench.file("count.8K", text);
    let newest = || {
        let names = std::fs::read_dir(bench.path("kept")).into_iter().flatten().flatten().map(|entry| entry.path());
        names.filter(|path| path.extension().is_some_and(|end| end == "acrs")).max()
    };
    for round in 0..4 {
        let before = newest();
        let mut command = Command::new(env!("CARGO_BIN_EXE_acrc"));
        command.args(["sim", "count.8K", "--state", "kept", "--until", "10h"]).current_dir(bench.folder.path());
        let mut child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("acrc starts");
        while newest() <= before {
            assert_eq!(child.try_wait().expect("a child"), None, "it saves until it is killed");
            std::thread::sleep(Duration::from_millis(1));
        }
        std::thread::sleep(Duration::from_millis(7 * round));
        child.kill().expect("it runs for hours");
        child.wait().expect("it was killed");
        assert!(show(&bench).contains("system parameters      saved"));
    }
}
