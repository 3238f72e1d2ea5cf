//! `acrc serve` and clients that share nothing with it: one in Python, written from the documents alone, and recorded
//! sessions. Both lie in `tests/interop` of the workspace.

mod common;

use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::{SocketAddr, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

/// After this much without an answer something is wrong.
const PATIENCE: Duration = Duration::from_secs(20);

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/interop")
}

/// A controller on ports that were free. It ends with the test.
struct Served {
    process: Child,
    ports: Vec<(u16, u16)>,
}

impl Served {
    fn start() -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_acrc"));
        command.arg("serve").arg(folder().join("machine")).args(["--ports", "0,0,0,0"]);
        let mut process = command.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().expect("acrc starts");
        let mut output = BufReader::new(process.stdout.take().expect("a pipe"));
        let mut line = String::new();
        while !line.starts_with("listening") {
            line.clear();
            assert_ne!(output.read_line(&mut line).expect("acrc prints text"), 0, "acrc ended before it listened");
        }
        let pairs = line.split_whitespace().filter_map(|word| word.split_once('='));
        let ports = pairs.filter_map(|(name, port)| Some((name.parse().ok()?, port.parse().ok()?))).collect();
        // What it prints later must not fill the pipe.
        std::thread::spawn(move || std::io::copy(&mut output, &mut std::io::sink()));
        Self { process, ports }
    }

    fn address(&self, name: u16) -> SocketAddr {
        let port = self.ports.iter().find(|(port, _)| *port == name).unwrap_or_else(|| panic!("no port {name}")).1;
        ([127, 0, 0, 1], port).into()
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

#[test]
fn a_client_written_from_the_documents() {
    let python = Command::new("python3").arg("--version").output();
    if !python.is_ok_and(|output| output.status.success()) {
        assert!(std::env::var_os("CI").is_none(), "python3 is not installed");
        println!("not run: python3 is not installed");
        return;
    }
    let served = Served::start();
    let mut command = Command::new("python3");
    command.arg("-B").arg(folder().join("test_controller.py")).arg("127.0.0.1");
    for (name, port) in &served.ports {
        command.arg(format!("{name}={port}"));
    }
    let output = command.output().expect("python3 starts");
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{text}{}", String::from_utf8_lossy(&output.stderr));
}

/// One side of a recorded session.
enum Step {
    /// The client sends.
    Sent(Vec<u8>),
    /// The controller answers with exactly this.
    Heard(Vec<u8>),
}

/// A recorded session: a port, then lines with what is sent (`>` text, `>>` bytes) and heard (`<`, `<<`).
struct Session {
    name: String,
    port: u16,
    steps: Vec<Step>,
}

impl Session {
    fn read(path: &Path) -> Self {
        let text = std::fs::read_to_string(path).expect("a text file");
        let mut session = Self { name: path.display().to_string(), port: 0, steps: Vec::new() };
        for line in text.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
            let (mark, rest) = line.split_once(' ').unwrap_or_else(|| panic!("{}: {line}", session.name));
            match mark {
                "port" => session.port = rest.parse().expect("a port"),
                ">" => session.steps.push(Step::Sent(unescape(rest))),
                "<" => session.steps.push(Step::Heard(unescape(rest))),
                ">>" => session.steps.push(Step::Sent(hex(rest))),
                "<<" => session.steps.push(Step::Heard(hex(rest))),
                _ => panic!("{}: {line}", session.name),
            }
        }
        session
    }

    /// Plays the client's side. What follows on each other without an answer between them is sent as one, then cut.
    fn play(&self, served: &Served, cut: &mut dyn FnMut(&mut TcpStream, &[u8])) {
        let mut stream = TcpStream::connect(served.address(self.port)).expect("it listens");
        stream.set_nodelay(true).expect("a TCP socket");
        stream.set_read_timeout(Some(PATIENCE)).expect("a TCP socket");
        let mut sent = Vec::new();
        for step in &self.steps {
            match step {
                Step::Sent(bytes) => sent.extend_from_slice(bytes),
                Step::Heard(expected) => {
                    cut(&mut stream, &std::mem::take(&mut sent));
                    self.expect(&mut stream, expected);
                }
            }
        }
        stream.shutdown(std::net::Shutdown::Write).expect("it is open");
        let mut rest = Vec::new();
        stream.read_to_end(&mut rest).expect("the controller closes the connection");
        assert!(rest.is_empty(), "{}: more than expected: {}", self.name, rest.escape_ascii());
    }

    fn expect(&self, stream: &mut TcpStream, expected: &[u8]) {
        let mut heard = vec![0; expected.len()];
        let mut length = 0;
        while length < heard.len() {
            match stream.read(&mut heard[length..]) {
                Ok(count @ 1..) => length += count,
                end => panic!(
                    "{}: {end:?} after {}\nexpected {}",
                    self.name,
                    heard[..length].escape_ascii(),
                    expected.escape_ascii()
                ),
            }
        }
        assert!(
            heard == expected,
            "{}:\n   heard {}\nexpected {}",
            self.name,
            heard.escape_ascii(),
            expected.escape_ascii()
        );
    }
}

/// `\r`, `\n`, `\t`, `\0`, `\\` and `\xHH`.
fn unescape(text: &str) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut rest = text;
    while let Some((plain, escape)) = rest.split_once('\\') {
        bytes.extend_from_slice(plain.as_bytes());
        let (byte, length) = match escape.as_bytes().first() {
            Some(b'r') => (b'\r', 1),
            Some(b'n') => (b'\n', 1),
            Some(b't') => (b'\t', 1),
            Some(b'0') => (0, 1),
            Some(b'\\') => (b'\\', 1),
            _ => (u8::from_str_radix(&escape[1..3], 16).expect("two digits"), 3),
        };
        bytes.push(byte);
        rest = &escape[length..];
    }
    bytes.extend_from_slice(rest.as_bytes());
    bytes
}

fn hex(text: &str) -> Vec<u8> {
    text.split_whitespace().map(|byte| u8::from_str_radix(byte, 16).expect("two digits")).collect()
}

/// Lengths of pieces, 1 to 7, in an order of its own for each seed (splitmix64).
struct Lengths(u64);

impl Lengths {
    fn next(&mut self) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        1 + (mixed >> 32) as usize % 7
    }
}

#[test]
fn recorded_sessions_however_they_are_cut() {
    let served = Served::start();
    let files = std::fs::read_dir(folder().join("sessions")).expect("the sessions");
    let mut paths: Vec<PathBuf> = files.map(|file| file.expect("a file").path()).collect();
    paths.sort();
    assert!(!paths.is_empty());
    for path in paths {
        let session = Session::read(&path);
        session.play(&served, &mut |stream, bytes| stream.write_all(bytes).expect("the controller reads"));
        for seed in 0..4 {
            let mut lengths = Lengths(seed);
            session.play(&served, &mut |stream, mut bytes| {
                while !bytes.is_empty() {
                    let (piece, rest) = bytes.split_at(lengths.next().min(bytes.len()));
                    stream.write_all(piece).expect("the controller reads");
                    bytes = rest;
                }
            });
        }
    }
}
