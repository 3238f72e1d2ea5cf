//! Whole programs as a machine builder writes them, in `tests/programs` beside the crates: a folder each, with the program, what happens around it,
//! and what it must send, worked out by hand from the rules of the language.
//!
//! `expected/PROG0.txt` is what program 0 prints, `expected/COM1.txt` what is sent to a stream. `expected/faults.txt` names the programs that stop at
//! a run-time error, one a line; without it there is none.

mod common;

use std::path::{Path, PathBuf};

use common::Bench;
use serde_json::Value;

/// The folders of the programs, in order.
fn folders() -> Vec<PathBuf> {
    let all = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/programs");
    let entries = std::fs::read_dir(all).expect("the folder of the programs");
    let mut folders: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    folders.sort();
    folders
}

/// The names of the expected files of a folder, without their extension.
fn expected(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder.join("expected")).expect("what is expected");
    let names = entries.map(|entry| entry.expect("an entry").path().file_stem().expect("a name").to_os_string());
    let mut names: Vec<String> = names.map(|name| name.into_string().expect("a plain name")).collect();
    names.sort();
    names
}

fn text(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn every_program_sends_what_it_must() {
    for folder in folders() {
        let bench = Bench::new();
        let inside = |name: &str| folder.join(name).display().to_string();
        let mut arguments = ["sim", "--format", "json", "--until", "1h"].map(str::to_owned).to_vec();
        arguments.push(inside("program.8K"));
        if folder.join("world.toml").is_file() {
            arguments.extend(["--world".to_owned(), inside("world.toml")]);
        }
        let names = expected(&folder);
        let (faults, outputs): (Vec<&str>, Vec<&str>) =
            names.iter().map(String::as_str).partition(|name| *name == "faults");
        for name in &outputs {
            arguments.extend(["--output".to_owned(), format!("{name}={name}.txt")]);
        }
        let run = bench.acrc(&arguments);
        let report: Value = serde_json::from_str(&run.stdout).unwrap_or_else(|error| panic!("{error}\n{}", run.stderr));
        let stopped = report["stopped"].as_str().unwrap_or_default();
        assert!(["ended", "fault"].contains(&stopped), "{}: {stopped}", folder.display());
        for name in &outputs {
            let sent = String::from_utf8(bench.read(&format!("{name}.txt"))).expect("plain text").replace("\r\n", "\n");
            assert_eq!(sent, text(&folder.join("expected").join(format!("{name}.txt"))), "{}", folder.display());
        }
        let stopped = report["faults"].as_array().expect("a list").iter().map(|fault| fault["program"].as_str());
        let stopped: Vec<&str> = stopped.map(|program| program.unwrap_or("setup")).collect();
        let known = if faults.is_empty() { String::new() } else { text(&folder.join("expected/faults.txt")) };
        assert_eq!(stopped, known.lines().collect::<Vec<_>>(), "{}: {}", folder.display(), report["faults"]);
    }
}

#[test]
fn no_program_has_an_error_for_the_linter() {
    for folder in folders() {
        let program = folder.join("program.8K");
        let run = Bench::new().acrc(["lint", "--fail-on", "error", &program.display().to_string()]);
        assert_eq!(run.status, Some(0), "{}\n{}", run.stdout, run.stderr);
    }
}
