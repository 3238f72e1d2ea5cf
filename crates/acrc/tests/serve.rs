//! `acrc serve` as a process: what it says, how it ends, what it keeps.

#![cfg(unix)]

mod common;

use std::io::{BufReader, Read as _, Write as _};
use std::net::{TcpListener, TcpStream, UdpSocket};
use std::process::{Child, ChildStdout, Command, Stdio};
use std::time::Duration;

use common::Bench;
use serde_json::Value;

/// A server that is ended with the test.
struct Serving {
    process: Child,
    lines: BufReader<ChildStdout>,
    /// The first line.
    listening: Value,
}

impl Serving {
    fn start(bench: &Bench, arguments: &[&str]) -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_acrc"));
        command.args(["serve", "--ports", "0,0,0,0", "--json"]).args(arguments).current_dir(bench.folder.path());
        let mut process = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("acrc starts");
        let mut lines = BufReader::new(process.stdout.take().expect("a pipe"));
        let listening = next(&mut lines);
        Self { process, lines, listening }
    }

    fn address(&self, service: &str) -> (&'static str, u16) {
        let port = self.listening["ports"][service].as_u64().expect("a port");
        ("127.0.0.1", u16::try_from(port).expect("a port"))
    }

    fn ask(&self, line: &str) -> String {
        let mut client = TcpStream::connect(self.address("5002")).expect("it listens");
        client.set_read_timeout(Some(Duration::from_secs(20))).expect("a timeout");
        client.write_all(line.as_bytes()).expect("it listens");
        client.shutdown(std::net::Shutdown::Write).expect("an open connection");
        let mut answer = String::new();
        client.read_to_string(&mut answer).expect("it answers");
        answer
    }

    /// Brings more lines into the log than a pipe and the queue before it hold.
    fn flood(&self) {
        let socket = UdpSocket::bind("127.0.0.1:0").expect("a port");
        for _ in 0..80 {
            for _ in 0..100 {
                // No request for fast status.
                socket.send_to(b"?", self.address("5003")).expect("it is sent");
            }
            // By then these have been read, or some are lost.
            assert_eq!(self.ask("?1\r"), "?1\r\n1\r\nSYS>");
        }
    }

    fn signal(&self, signal: &str) {
        let pid = self.process.id().to_string();
        assert!(Command::new("kill").args([signal, &pid]).status().expect("kill starts").success());
    }

    /// Sends a signal and gives the exit status and the lines that were left.
    fn end(mut self, signal: &str) -> (Option<i32>, Vec<Value>) {
        self.signal(signal);
        let mut rest = String::new();
        self.lines.read_to_string(&mut rest).expect("it ends");
        let status = self.process.wait().expect("it ends").code();
        (status, rest.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect())
    }
}

impl Drop for Serving {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

fn next(lines: &mut impl std::io::BufRead) -> Value {
    let mut line = String::new();
    lines.read_line(&mut line).expect("a line");
    serde_json::from_str(&line).expect("JSON")
}

#[test]
fn a_project_is_served_until_it_is_interrupted() {
    let bench = Bench::new();
    bench.file("machine.8K", "DIM P(10)\nP3=5\n");
    let serving = Serving::start(&bench, &["machine.8K", "--stats"]);
    assert_eq!(serving.listening["event"], "listening");
    assert_eq!(serving.listening["model"], "ACR9000");
    assert_eq!(serving.listening["streams"][0], "STREAM2");
    assert_eq!(serving.ask("?P3\r"), "?P3\r\n5\r\nSYS>");
    let (status, rest) = serving.end("-INT");
    assert_eq!(status, Some(130));
    let events: Vec<&str> = rest.iter().filter_map(|line| line["event"].as_str()).collect();
    assert_eq!(events, ["connected", "disconnected", "statistics"]);
    assert_eq!(rest[0]["port"], 5002);
    assert_eq!(rest[1]["reason"], "closed by the client");
    assert_eq!(rest[2]["clients"], 1);
}

#[test]
fn what_the_controller_keeps_is_there_the_next_time() {
    let bench = Bench::new();
    let serving = Serving::start(&bench, &["--state", "kept"]);
    assert_eq!(serving.ask("DIM P(10)\rP4=11\r"), "DIM P(10)\r\nSYS>P4=11\r\nSYS>");
    assert_eq!(serving.end("-TERM").0, Some(130));
    let serving = Serving::start(&bench, &["--state", "kept"]);
    assert_eq!(serving.ask("?P4\r"), "?P4\r\n11\r\nSYS>");
}

#[test]
fn who_does_not_read_the_log_stops_nobody() {
    let bench = Bench::new();
    let mut serving = Serving::start(&bench, &["--state", "kept", "--stats"]);
    serving.flood();
    assert_eq!(serving.ask("DIM P(10)\rP4=12\r"), "DIM P(10)\r\nSYS>P4=12\r\nSYS>");
    serving.signal("-TERM");
    // The pipe is still there, and full.
    assert_eq!(serving.process.wait().expect("it ends").code(), Some(130));
    let serving = Serving::start(&bench, &["--state", "kept"]);
    assert_eq!(serving.ask("?P4\r"), "?P4\r\n12\r\nSYS>");
}

#[test]
fn lines_that_the_log_could_not_take_are_counted() {
    let bench = Bench::new();
    let serving = Serving::start(&bench, &[]);
    serving.flood();
    let (status, lines) = serving.end("-INT");
    assert_eq!(status, Some(130));
    let lost: u64 = lines.iter().filter(|line| line["event"] == "lost").filter_map(|line| line["lines"].as_u64()).sum();
    assert!(lost > 0, "{} lines came", lines.len());
}

#[test]
fn a_port_that_is_taken_is_one_line() {
    let bench = Bench::new();
    let taken = TcpListener::bind("127.0.0.1:0").expect("a port");
    let port = taken.local_addr().expect("an address").port();
    let run = bench.acrc(["serve", "--ports", &format!("{port},0,0,0")]).expect(2);
    let expected =
        format!("error: ASCII cannot listen at 127.0.0.1:{port}: the port is in use, perhaps by another controller\n");
    assert_eq!(run.stderr, expected);
}

#[test]
fn arguments_that_make_no_sense_are_refused() {
    let bench = Bench::new();
    for (arguments, expected) in [
        (["--ports", "1,2,3"], "write four ports from 0 to 65535"),
        (["--ports", "5002,0,5002,0"], "the three TCP ports must differ"),
        (["--wire", "crc=none"], "`crc=none` is no reading"),
        (["--model", "ACR1505"], "ACR1505 has no Ethernet: its streams are DPCB, COM1"),
        (["--speed", "0"], "write a factor from 0.001 to 1000, or max"),
    ] {
        let run = bench.acrc(["serve"].into_iter().chain(arguments)).expect(2);
        assert!(run.stderr.contains(expected), "{}", run.stderr);
    }
}
