//! A server in a process of its own, and times.

use std::fs;
use std::io::BufReader;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use super::generate::{MARK, Project};
use crate::client::Client;

/// Durations of the same thing.
#[derive(Default)]
pub(crate) struct Times(Vec<Duration>);

impl Times {
    pub(crate) fn add<T>(&mut self, work: impl FnOnce() -> T) {
        let start = Instant::now();
        let result = work();
        self.0.push(start.elapsed());
        drop(result);
    }

    pub(crate) fn print(mut self, name: &str) {
        self.0.sort_unstable();
        let at = |part: f64| {
            let place = ((self.0.len() - 1) as f64 * part).round() as usize;
            self.0[place].as_secs_f64() * 1000.0
        };
        println!("{name}: p50 {:.2} ms, p99 {:.2} ms, most {:.2} ms", at(0.5), at(0.99), at(1.0));
    }
}

/// A session, and the document in which somebody types.
pub(crate) struct Server {
    process: Child,
    client: Client<BufReader<ChildStdout>, ChildStdin>,
    uri: String,
    version: i32,
    /// Line and column of the first keystroke.
    cursor: (u32, u32),
    /// What is typed, and then removed, again and again.
    typed: &'static str,
}

impl Server {
    pub(crate) fn begin(mut command: Command, project: &Project) -> Self {
        let mut process = command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("the server can be started");
        let input = BufReader::new(process.stdout.take().expect("it has an output"));
        let mut client = Client::new(input, process.stdin.take().expect("it has an input"));
        client.initialize(json!({}), Some(&project.uri("")));
        Self { process, client, uri: String::new(), version: 0, cursor: (0, 0), typed: "" }
    }

    /// Opens a file, and puts the cursor where the project wants it.
    pub(crate) fn open(&mut self, project: &Project, file: usize, typed: &'static str) {
        let (name, text) = &project.files[file];
        self.uri = project.uri(name);
        self.version = 1;
        self.typed = typed;
        let line = text.lines().position(|line| line.contains(MARK)).map_or(0, |mark| mark + 1);
        let column = text.lines().nth(line).map_or(0, str::len);
        self.cursor = (line as u32, column as u32);
        self.client.open(&self.uri, text);
    }

    pub(crate) fn first_diagnostics(&mut self) {
        self.diagnostics();
    }

    /// Waits for what is found in the present version.
    pub(crate) fn diagnostics(&mut self) {
        self.client.diagnostics(&self.uri, self.version);
    }

    /// One more character, or when all are typed, all of them removed.
    pub(crate) fn type_one(&mut self, step: usize) {
        let (line, column) = self.cursor;
        let typed = step % (self.typed.len() + 1);
        let position = |character: usize| json!({ "line": line, "character": column as usize + character });
        let (end, text) = match self.typed.get(typed..=typed) {
            Some(text) => (typed, text),
            None => (typed, ""),
        };
        let start = if text.is_empty() { 0 } else { end };
        self.version += 1;
        let range = json!({ "start": position(start), "end": position(end) });
        self.client.change(&self.uri, self.version, json!([{ "range": range, "text": text }]));
    }

    pub(crate) fn complete(&mut self) {
        let (line, column) = self.cursor;
        let at = json!({ "textDocument": { "uri": self.uri }, "position": { "line": line, "character": column } });
        let answer: Value = self.client.request("textDocument/completion", at);
        assert!(answer.is_object() || answer.is_array(), "{answer}");
    }

    /// A line of `/proc/PID/status`, in megabytes; 0 where there is none.
    pub(crate) fn memory(&self, name: &str) -> f64 {
        let status = fs::read_to_string(format!("/proc/{}/status", self.process.id())).unwrap_or_default();
        let line = status.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(':'));
        let number = line.and_then(|line| line.split_whitespace().next()).and_then(|number| number.parse::<f64>().ok());
        number.unwrap_or(0.0) / 1024.0
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // It would end by itself when its input is closed; this does not wait for it.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
