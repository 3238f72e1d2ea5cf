//! `acrc get`, `set`, `move`, `watch`, `term` and `reset-kamr` against `acrc serve`, and against what is no controller.

mod common;

use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::{Shutdown, TcpListener};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use common::{Bench, Run};

const MACHINE: &str = "SYS\nDIM P(10)\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"\n\
                       AXIS0 PPU 1000 : AXIS1 PPU 1000\nACC 100 DEC 100 STP 100 VEL 10\n#DEFINE Lamp BIT33\n\
                       PROG1\nPROGRAM\n10 PRINT \"on\"\n20 DWL 0.05\n30 GOTO 10\nENDP\n";

/// A virtual controller on the network.
struct Serve {
    child: Child,
    text: u16,
    mixed: u16,
}

impl Serve {
    fn start(bench: &Bench) -> Self {
        bench.file("machine.8K", MACHINE);
        let mut command = Command::new(env!("CARGO_BIN_EXE_acrc"));
        command.args(["serve", "machine.8K", "--ports", "0,0,0,0"]).current_dir(bench.folder.path());
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().expect("acrc starts");
        let output = BufReader::new(child.stdout.take().expect("a pipe"));
        let line = output.lines().map_while(Result::ok).find(|line| line.contains("5002=")).expect("it listens");
        let port = |name: &str| {
            let rest = line.split_once(name).expect("the port is named").1;
            rest.split_whitespace().next().and_then(|digits| digits.parse().ok()).expect("a port")
        };
        Self { child, text: port("5002="), mixed: port("5006=") }
    }

    fn to(&self) -> String {
        format!("127.0.0.1:{}", self.text)
    }
}

impl Drop for Serve {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn acrc(bench: &Bench, to: &str, arguments: &str) -> Run {
    let mut words = arguments.split_whitespace();
    let command = words.next().expect("a command");
    let output = bench.feed(&[&[command, "--to", to], &*words.collect::<Vec<_>>()].concat(), b"");
    output.into()
}

#[test]
fn values_are_read_over_both_ports() {
    let bench = Bench::new();
    let serve = Serve::start(&bench);
    for (port, how) in [(serve.text, "--text"), (serve.mixed, "--packets")] {
        let run =
            acrc(&bench, &format!("127.0.0.1:{port}"), &format!("get {how} --bare P12375 BIT516 P1 BIT8467")).expect(0);
        assert_eq!(run.stdout, "1000\n0\n0\n0\n");
    }
    let run = acrc(&bench, &serve.to(), "get --axis 1 KAMR --json").expect(0);
    assert_eq!(
        run.stdout.trim_end(),
        r#"[{"name":"AXIS1.kill_all_motion_request","register":"BIT8499","value":false,"title":"Kill All Motion Request (KAMR), axis 1"}]"#
    );
    let run = acrc(&bench, &serve.to(), "get --project machine.8K --bare Lamp Y.kamr").expect(0);
    assert_eq!(run.stdout, "0\n0\n");
    let run = acrc(&bench, &serve.to(), "get P500").expect(1);
    assert_eq!(run.stderr, "error: the controller refused `?P500`: P500 is outside DIM P(10)\n");
}

#[test]
fn the_wrong_port_is_named() {
    let bench = Bench::new();
    let serve = Serve::start(&bench);
    let run = acrc(&bench, &format!("127.0.0.1:{}", serve.mixed), "get --text P1").expect(2);
    assert!(run.stderr.contains("as a port for packets does (5006): --packets speaks to it"), "{}", run.stderr);
    let run = acrc(&bench, &serve.to(), "get --packets P12288").expect(2);
    assert!(run.stderr.contains("as a port for text does (5002): --text speaks text to it"), "{}", run.stderr);
}

#[test]
fn what_is_written_is_read_back() {
    let bench = Bench::new();
    let serve = Serve::start(&bench);
    let run = acrc(&bench, &serve.to(), "set P1=2.5 P2=-1e-3").expect(0);
    assert_eq!(run.stdout, "P1 = 2.5 (was 0)\nP2 = -0.001 (was 0)\n");
    let run = acrc(&bench, &serve.to(), "set Lamp=on --project machine.8K").expect(2);
    assert_eq!(
        run.stderr,
        "error: Lamp=-1 (BIT33, Onboard output, output, number 1) can act on the machine: add --yes\n"
    );
    let run = acrc(&bench, &serve.to(), "set Lamp=on --project machine.8K --yes").expect(0);
    assert_eq!(run.stdout, "Lamp = -1 (was 0)\n");
    let run = acrc(&bench, &serve.to(), "set BIT516=1 --yes").expect(2);
    assert_eq!(run.stderr, "error: BIT516 (In Motion, master 0) is read-only\n");
    let run = acrc(&bench, &serve.to(), "set P1=7 P500=1 P2=7 --yes").expect(1);
    assert_eq!(run.stdout, "P1 = 7 (was 2.5)\n");
    assert!(run.stderr.starts_with("note: not written: P2\nerror: the controller refused `?P500`"), "{}", run.stderr);
}

#[test]
fn axes_move_and_a_move_can_be_stopped() {
    let bench = Bench::new();
    let serve = Serve::start(&bench);
    let run = acrc(&bench, &serve.to(), "move --prog 0 X1 Y/-0.5 --velocity 20 --yes").expect(0);
    assert_eq!(run.stdout, "arrived at X 1  Y -0.5\n");
    assert_eq!(
        acrc(&bench, &serve.to(), "move --prog 0 X2").expect(2).stderr,
        "error: a move has to be confirmed: add --yes\n"
    );
    let run = acrc(&bench, &serve.to(), "move --prog 0 Z2 --yes").expect(2);
    assert_eq!(run.stderr, "error: program 0 has no axis named Z; it has X, Y\n");

    let mut command = Command::new(env!("CARGO_BIN_EXE_acrc"));
    command.args(["move", "--to", &serve.to(), "--prog", "0", "X1000", "--yes"]).stdout(Stdio::piped());
    let child = command.stderr(Stdio::piped()).spawn().expect("acrc starts");
    let deadline = Instant::now() + Duration::from_secs(20);
    while acrc(&bench, &serve.to(), "get --bare BIT516").stdout != "-1\n" {
        assert!(Instant::now() < deadline, "it does not move");
    }
    interrupt(&child);
    let run = Run::from(child.wait_with_output().expect("it ends")).expect(130);
    assert!(run.stdout.starts_with("stopped at X "), "{}", run.stdout);
    assert_eq!(run.stderr, "note: Kill All Moves of MASTER0 is set: acrc reset-kamr clears it\n");
    assert_eq!(acrc(&bench, &serve.to(), "get --bare BIT516").stdout, "0\n");

    let run = acrc(&bench, &serve.to(), "move --prog 0 X1 --yes").expect(1);
    assert!(run.stderr.contains("BIT522 (Kill All Moves Request, master 0) is set"), "{}", run.stderr);
    let run = acrc(&bench, &serve.to(), "reset-kamr --show").expect(1);
    assert_eq!(run.stdout, "set:\n  MASTER0.kill_all_moves (BIT522)\n");
    let run = acrc(&bench, &serve.to(), "reset-kamr --yes").expect(0);
    assert_eq!(run.stdout, "cleared:\n  MASTER0.kill_all_moves (BIT522)\n");
    let run = acrc(&bench, &serve.to(), "reset-kamr").expect(0);
    assert_eq!(run.stdout, "no axis has a kill request, and no master\n");
}

#[test]
fn watching_gives_a_line_for_each_sample() {
    let bench = Bench::new();
    let serve = Serve::start(&bench);
    let mixed = format!("127.0.0.1:{}", serve.mixed);
    let run = acrc(&bench, &mixed, "watch --packets P12375 BIT516 --every 5ms --for 50ms").expect(0);
    let lines: Vec<&str> = run.stdout.lines().collect();
    assert_eq!(lines[0], "seconds,P12375,BIT516");
    assert!(lines.len() >= 2 && lines.iter().skip(1).all(|line| line.ends_with(",1000,0")), "{}", run.stdout);
    assert!(run.stderr.starts_with("note: ") && run.stderr.contains(" missed, the longest wait "), "{}", run.stderr);
    let run = acrc(&bench, &serve.to(), "watch --json BIT516 --for 1ms").expect(0);
    assert!(run.stdout.contains(r#""values":{"BIT516":false}"#), "{}", run.stdout);
}

#[test]
fn a_terminal_through_a_pipe_gets_the_bytes_of_the_controller() {
    let bench = Bench::new();
    let serve = Serve::start(&bench);
    let talk = |input: &[u8]| {
        let output = bench.feed(&["term", "--to", &serve.to(), "--linger", "300ms"], input);
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).expect("ASCII in these tests")
    };
    assert_eq!(talk(b"PROG0\rACC\r"), "PROG0\r\nP00>ACC\r\n100\r\nP00>");
    let heard = talk(b"PROG1\rLRUN\r\x1bHALT\r");
    assert!(heard.starts_with("PROG1\r\nP01>LRUN\r\non\r\n") && heard.ends_with("P01>HALT\r\nP01>"), "{heard}");
}

#[test]
fn what_is_no_controller_is_told() {
    let bench = Bench::new();
    let run = bench.acrc(["get", "P1"]).expect(2);
    assert!(run.stderr.contains("--to <HOST[:PORT]>"), "{}", run.stderr);

    let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
    let to = listener.local_addr().expect("it is bound").to_string();
    let run = acrc(&bench, &to, "get --timeout 300ms P1").expect(2);
    assert_eq!(run.stderr, format!("error: {to} accepted the connection but shows no prompt: nothing comes\n"));

    let closing = std::thread::spawn(move || {
        // The connection that was given up before is still in the queue.
        for _ in 0..2 {
            let (mut socket, _) = listener.accept().expect("a client");
            let _ = socket.write_all(b"\r\nSYS>").and_then(|()| socket.shutdown(Shutdown::Write));
            let _ = socket.read_to_end(&mut Vec::new());
        }
    });
    let run = acrc(&bench, &to, "get P1").expect(2);
    assert!(run.stderr.starts_with("error: the controller closed the connection"), "{}", run.stderr);
    closing.join().expect("it has served both");

    let run = acrc(&bench, &to, "get --retry 1 P1").expect(2);
    assert!(run.stderr.starts_with(&format!("error: could not connect to {to}: ")), "{}", run.stderr);
}

/// Presses Ctrl-C.
fn interrupt(child: &Child) {
    let kill = ["/bin/kill", "/usr/bin/kill"].into_iter().find(|path| Path::new(path).exists()).expect("a Unix system");
    let status = Command::new(kill).args(["-INT", &child.id().to_string()]).status().expect("it runs");
    assert!(status.success());
}
