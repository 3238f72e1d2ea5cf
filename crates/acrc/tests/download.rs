//! `acrc download`, `upload` and `diff` against `acrc serve`, and downloads whose process is killed.

mod common;
#[path = "common/server.rs"]
mod server;

use std::io::{BufRead as _, BufReader};
use std::process::{Command, Stdio};

use common::{Bench, Run};
use serde_json::Value;
use server::Server;

const MACHINE: &str = "\
' A slide that goes to and fro
SYS
CLEAR
DIM PROG0(900)
DIM PROG1(600)
DIM P(4) : DIM DEF(3)
#DEFINE Lamp BIT32
#DEFINE Count P0
AXIS0 PPU 1000
PROG0
ATTACH MASTER0
ATTACH SLAVE0 AXIS0 \"X\"
ACC 100 DEC 100 STP 100 VEL 5
PROGRAM
' the lamp shows that it moves
SET Lamp
X1 : X0    ' to and fro
Count = Count + 1
CLR Lamp
ENDP
PROG1
PROGRAM
PBOOT
DWL 1
ENDP
";

impl Bench {
    fn link(&self, server: &Server, arguments: &str) -> Run {
        self.acrc(arguments.split_whitespace().chain([format!("--to={}", server.address()).as_str(), "--text"]))
    }
}

#[test]
fn a_project_goes_there_and_back() {
    let (bench, server) = (Bench::new(), Server::start());
    bench.file("machine.8K", MACHINE);
    let run = bench.link(&server, "download machine.8K --plan").expect(0);
    assert!(run.stdout.contains("machine.8K:16  SET Lamp"), "{}", run.stdout);
    let run = bench.link(&server, "download machine.8K").expect(2);
    assert!(run.stderr.contains("add --yes"), "{}", run.stderr);
    let run = bench.link(&server, "download machine.8K --yes --save flash,eeprom --run").expect(0);
    assert!(run.stdout.contains("2 programs verified"), "{}", run.stdout);
    assert!(run.stderr.starts_with("PROG1 "), "{}", run.stderr);
    bench.link(&server, "diff machine.8K").expect(0);
    let run = bench.link(&server, "upload --out back --project machine.8K").expect(0);
    assert!(run.stdout.contains("4 lines, 4 as in the project"), "{}", run.stdout);
    let text = String::from_utf8(bench.read("back/Prog0.8K")).expect("text");
    assert_eq!(
        text,
        "PROGRAM\n' the lamp shows that it moves\nSET Lamp\nX1 : X0    ' to and fro\nCount = Count + 1\nCLR Lamp\nENDP\n"
    );
    bench.link(&server, "upload --out back").expect(2);
    bench.file("machine.8K", MACHINE.replace("X1 : X0", "X2 : X0"));
    let run = bench.link(&server, "diff machine.8K").expect(1);
    assert!(run.stdout.contains("-X2 : X0\n+X1 : X0\n"), "{}", run.stdout);
    let run = bench.link(&server, "diff machine.8K --json").expect(1);
    let json: Value = serde_json::from_str(&run.stdout).expect("JSON");
    assert_eq!(json["programs"][0]["standing"], "different");
}

#[test]
fn settings_alone_are_sent_with_a_warning() {
    let (bench, server) = (Bench::new(), Server::start());
    bench.file("machine.8K", "SYS\nDIM P(9)\nP1=3\n");
    let warning = "nothing is stored: no PROGRAM ... ENDP is in the project";
    let run = bench.link(&server, "download machine.8K --plan").expect(0);
    assert!(run.stdout.contains(warning), "{}", run.stdout);
    let run = bench.link(&server, "download machine.8K --yes").expect(0);
    assert!(run.stdout.contains("0 programs verified"), "{}", run.stdout);
    assert_eq!(run.stderr, format!("warning: {warning}\n"));
}

#[test]
fn mistakes_stop_it_before_a_connection_is_made() {
    let bench = Bench::new();
    bench.file("machine.8K", MACHINE.replace("SET Lamp", "SET Lampp"));
    // Nobody listens at this port, and nobody asks.
    let run = bench.acrc(["download", "machine.8K", "--to", "127.0.0.1:9", "--yes"]).expect(1);
    assert!(run.stderr.contains("is not sent"), "{}", run.stderr);
    bench.file("machine.8K", MACHINE.replace("AXIS0 PPU 1000", "LRUN PROG1"));
    let run = bench.acrc(["download", "machine.8K", "--to", "127.0.0.1:9", "--yes"]).expect(1);
    assert!(run.stderr.contains("ACR040"), "{}", run.stderr);
    bench.acrc(["explain", "ACR041"]).expect(0);
}

#[test]
fn a_program_is_told_that_nothing_could_be_sent() {
    let bench = Bench::new();
    bench.file("machine.8K", MACHINE);
    // Whoever asks is turned away, as by a controller whose streams are all in use.
    let listener = std::net::TcpListener::bind("127.0.0.1:0").expect("a port");
    let to = listener.local_addr().expect("an address").to_string();
    std::thread::spawn(move || listener.incoming().for_each(drop));
    let run = bench.acrc(["download", "machine.8K", "--to", &to, "--yes", "--json"]).expect(2);
    let last: Value = serde_json::from_str(run.stdout.lines().last().expect("a line")).expect("JSON");
    assert_eq!(last["event"], "refused");
    let text = last["objections"][0]["text"].as_str().expect("a text");
    assert!(text.contains("shows no prompt"), "{text}");
    let run = bench.acrc(["download", "machine.8K", "--to", &to, "--yes", "--run=PROGX"]).expect(2);
    assert!(run.stderr.starts_with("error: --run=PROGX: "), "{}", run.stderr);
}

#[test]
fn a_refused_line_is_shown_in_the_source() {
    let (bench, server) = (Bench::new(), Server::start());
    bench.file("machine.8K", MACHINE);
    bench.link(&server, "download machine.8K --yes").expect(0);
    let other = "PROG1\nATTACH MASTER0\nACC 1 DEC 1 STP 1 VEL 1\nPROGRAM\nPRINT \"other\"\nENDP\n";
    bench.file("other.8K", other);
    let run = bench.link(&server, "download other.8K --yes").expect(1);
    let stderr = run.stderr;
    assert!(stderr.contains("ACR041") && stderr.contains("2 │ ATTACH MASTER0"), "{stderr}");
    assert!(stderr.contains("PROG0: old, as before the download\nPROG1: erased"), "{stderr}");
}

/// Kills the download when it says that it sends the line with this number. False when it was over before.
fn kill_at(bench: &Bench, server: &Server, line: u64) -> bool {
    let mut command = Command::new(env!("CARGO_BIN_EXE_acrc"));
    command
        .args(["download", "machine.8K", "--yes", "--json", "--text", "--to", &server.address()])
        .current_dir(bench.folder.path());
    let mut process = command.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().expect("acrc starts");
    let mut killed = false;
    for event in BufReader::new(process.stdout.take().expect("a pipe")).lines() {
        let event: Value = serde_json::from_str(&event.expect("text")).expect("JSON");
        if event["event"] == "send" && event["number"] == line {
            process.kill().expect("it lives");
            killed = true;
            break;
        }
    }
    process.wait().expect("it ends");
    killed
}

#[test]
fn a_process_that_is_killed_anywhere_is_run_again() {
    let (bench, server) = (Bench::new(), Server::start());
    bench.file("machine.8K", MACHINE);
    for line in (1..).step_by(3) {
        // Another version first, so that everything has to be replaced.
        bench.file("before.8K", MACHINE.replace("DWL 1", "DWL 2").replace("BIT32", "BIT33").replace("X1 : X0", "X3"));
        bench.link(&server, "download before.8K --yes").expect(0);
        if !kill_at(&bench, &server, line) {
            assert!(line > 20, "there were {line} lines only");
            break;
        }
        let run = bench.link(&server, "download machine.8K --yes").expect(0);
        assert!(run.stdout.contains("2 programs verified"), "killed at line {line}: {}", run.stdout);
    }
}
