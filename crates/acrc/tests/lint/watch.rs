//! `--watch`: what is seen again, and the end.

#![cfg(unix)]

use std::io::{BufRead as _, BufReader};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc;
use std::time::Duration;

use super::Bench;

/// Ends a run that never says what it should.
struct Guard(Child);

impl Drop for Guard {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

#[test]
fn a_change_is_seen_and_ctrl_c_ends_it() {
    let bench = Bench::new();
    bench.file("p/acrc.toml", "");
    bench.file("p/Prog0.8K", "PROGRAM\nGOTO Nowhere\nENDP\n");
    let mut child = Command::new(env!("CARGO_BIN_EXE_acrc"))
        .args(["lint", "p", "--watch"])
        .current_dir(bench.folder.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("acrc starts");
    let output = BufReader::new(child.stdout.take().expect("a pipe"));
    let mut child = Guard(child);
    let (sender, lines) = mpsc::channel();
    std::thread::spawn(move || output.lines().map_while(Result::ok).try_for_each(|line| sender.send(line)));
    // The time only keeps a run that went wrong from waiting for ever.
    let wait_for = |expected: &str| {
        while let Ok(line) = lines.recv_timeout(Duration::from_mins(1)) {
            if line == expected {
                return;
            }
        }
        panic!("`{expected}` is not said");
    };
    wait_for("1 error in 1 file");
    bench.file("p/Prog0.8K", "PROGRAM\nSET 32\nENDP\n");
    wait_for("no problems in 1 file");
    bench.file("p/Prog1.8K", "PROGRAM\nGOTO A\nGOTO B\nENDP\n");
    wait_for("2 errors in 2 files");
    bench.file("p/acrc.toml", "[lint]\nignore = [\"ACR101\"]\n");
    wait_for("no problems in 2 files");
    std::fs::remove_file(bench.path("p/Prog1.8K")).expect("a file of ours");
    wait_for("no problems in 1 file");
    std::fs::create_dir(bench.path("new")).expect("a folder of ours");
    bench.file("new/Prog2.8K", "PROGRAM\nGOTO Nowhere\nENDP\n");
    bench.file("p/acrc.toml", "");
    wait_for("no problems in 1 file");
    std::fs::rename(bench.path("new"), bench.path("p/src")).expect("a folder of ours");
    wait_for("1 error in 2 files");
    std::fs::remove_dir_all(bench.path("p")).expect("a folder of ours");
    bench.file("p/Prog0.8K", "PROGRAM\nGOTO A\nGOTO B\nGOTO C\nENDP\n");
    wait_for("3 errors in 1 file");
    bench.file("p/Prog0.8K", "PROGRAM\nGOTO A\nENDP\n");
    wait_for("1 error in 1 file");
    let killed = Command::new("kill").args(["-INT", &child.0.id().to_string()]).status();
    assert!(killed.expect("kill is part of every Unix").success());
    assert_eq!(child.0.wait().expect("a child").code(), Some(130));
}
