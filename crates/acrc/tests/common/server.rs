//! `acrc serve` as a process.

use std::io::{BufRead as _, BufReader};
use std::process::{Child, Command, Stdio};

use serde_json::Value;

/// `acrc serve` with factory settings.
pub(crate) struct Server {
    pub(crate) process: Child,
    port: u64,
}

impl Server {
    pub(crate) fn start() -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_acrc"));
        command
            .args(["serve", "--ports", "0,0,0,0", "--speed", "max", "--json"])
            .stdout(Stdio::piped())
            .stderr(Stdio::null());
        let mut process = command.spawn().expect("acrc starts");
        let mut first = String::new();
        BufReader::new(process.stdout.take().expect("a pipe")).read_line(&mut first).expect("it says where it is");
        let event: Value = serde_json::from_str(&first).unwrap_or_else(|error| panic!("{error}: {first}"));
        let port = event["ports"]["5002"].as_u64().expect("a port");
        Self { process, port }
    }

    /// The address of its text port.
    pub(crate) fn address(&self) -> String {
        format!("127.0.0.1:{}", self.port)
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
