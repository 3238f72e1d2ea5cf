//! Runs the built `acrc` on small projects.

#![allow(dead_code, reason = "each test file uses its part")]

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use serde_json::Value;
use tempfile::TempDir;

/// A folder of its own for one test.
pub(crate) struct Bench {
    pub(crate) folder: TempDir,
}

/// What a run of `acrc` gave.
pub(crate) struct Run {
    pub(crate) status: Option<i32>,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Bench {
    pub(crate) fn new() -> Self {
        Self { folder: TempDir::new().expect("a temporary folder") }
    }

    /// Writes a file and gives its path.
    pub(crate) fn file(&self, name: &str, text: impl AsRef<[u8]>) -> PathBuf {
        let path = self.folder.path().join(name);
        std::fs::create_dir_all(path.parent().expect("a file lies in a folder")).expect("the folder is writable");
        std::fs::write(&path, text).expect("the folder is writable");
        path
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Runs `acrc` in the folder.
    pub(crate) fn acrc<S: AsRef<std::ffi::OsStr>>(&self, arguments: impl IntoIterator<Item = S>) -> Run {
        let mut command = Command::new(env!("CARGO_BIN_EXE_acrc"));
        command.args(arguments).current_dir(self.folder.path()).env_remove("NO_COLOR");
        command.output().expect("acrc starts").into()
    }

    /// Runs `acrc` in the folder with something on standard input. What comes back may be no UTF-8.
    pub(crate) fn feed(&self, arguments: &[&str], input: &[u8]) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_acrc"));
        command.args(arguments).current_dir(self.folder.path()).env_remove("NO_COLOR");
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().expect("acrc starts");
        let mut stdin = child.stdin.take().expect("a pipe");
        stdin.write_all(input).expect("acrc reads all of it");
        drop(stdin);
        child.wait_with_output().expect("acrc ends")
    }

    /// The bytes of a file.
    pub(crate) fn read(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).expect("the file is there")
    }

    /// Runs `acrc sim --format json` and reads the report; the run must not have failed to begin.
    pub(crate) fn sim(&self, arguments: &str) -> Value {
        let run = self.acrc(["sim", "--format", "json"].into_iter().chain(arguments.split_whitespace()));
        serde_json::from_str(&run.stdout).unwrap_or_else(|error| panic!("{error}\n{}\n{}", run.stdout, run.stderr))
    }
}

impl From<Output> for Run {
    fn from(output: Output) -> Self {
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("acrc prints UTF-8");
        Self { status: output.status.code(), stdout: text(output.stdout), stderr: text(output.stderr) }
    }
}

impl Run {
    /// The run ended with this status.
    #[track_caller]
    pub(crate) fn expect(self, status: i32) -> Self {
        assert_eq!(self.status, Some(status), "stdout:\n{}\nstderr:\n{}", self.stdout, self.stderr);
        self
    }
}

/// The example machine.
pub(crate) fn gantry() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/gantry")
}

/// A trace read back: names of the columns and rows of numbers.
pub(crate) struct Csv {
    pub(crate) names: Vec<String>,
    pub(crate) rows: Vec<Vec<f64>>,
}

impl Csv {
    pub(crate) fn read(path: &Path) -> Self {
        let text = std::fs::read_to_string(path).expect("the trace was written");
        let mut lines = text.lines();
        let names = lines.next().expect("a header").split(',').map(str::to_owned).collect();
        let rows = lines.map(|line| line.split(',').map(|cell| cell.parse().expect("a number")).collect());
        Self { names, rows: rows.collect() }
    }

    /// The values of a column.
    pub(crate) fn column(&self, name: &str) -> Vec<f64> {
        let index = self.names.iter().position(|column| column == name);
        let index = index.unwrap_or_else(|| panic!("no column {name} in {:?}", self.names));
        self.rows.iter().map(|row| row[index]).collect()
    }
}
