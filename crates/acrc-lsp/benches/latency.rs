//! How long an editor waits, measured through the real protocol over standard input and output of a process of its own.
//!
//! `cargo bench -p acrc-lsp` measures this crate; with `ACRC=path/to/acrc` the program that is given to users. With
//! `RUFF=path/to/ruff` the keystrokes are typed into `ruff server` too, on Python of the same length in as many files.

#[path = "../tests/lsp/client.rs"]
mod client;
mod latency {
    pub(crate) mod generate;
    pub(crate) mod measure;
}

use std::process::{Command, ExitCode};

use latency::generate::{self, Project};
use latency::measure::{Server, Times};

#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// Says to this program that it is the server.
const SERVE: &str = "ACRC_LATENCY_SERVE";
/// Keystrokes of each kind.
const KEYSTROKES: usize = 400;
/// What is typed behind an assignment.
const CODE: &str = " + P100 * 2";
/// The same in Python.
const PYTHON: &str = " + values[1] * 2";
/// What is typed behind the number of an alias.
const ALIAS: &str = "12";
/// Sessions whose start is measured.
const STARTS: usize = 15;

fn main() -> ExitCode {
    if std::env::var_os(SERVE).is_some() {
        return ExitCode::from(u8::from(!acrc_lsp::run_stdio().expect("the session begins")));
    }
    if std::env::args().any(|argument| argument == "--test") {
        return ExitCode::SUCCESS;
    }
    let small = Project::write(&generate::small());
    let large = Project::write(&generate::programs());
    println!("project: {} lines in {} files", large.lines(), large.files.len());
    start("start to first diagnostics, small file", &small);
    start("start to first diagnostics, project", &large);
    keystrokes("acrc", acrc(), &large, CODE);
    keystrokes("acrc", acrc(), &Project::write(&generate::one_file()), CODE);
    if let Some(ruff) = std::env::var_os("RUFF") {
        for files in [generate::python(), generate::one_python_file()] {
            let mut command = Command::new(&ruff);
            command.arg("server");
            keystrokes("ruff", command, &Project::write(&files), PYTHON);
        }
    }
    ExitCode::SUCCESS
}

fn acrc() -> Command {
    if let Some(program) = std::env::var_os("ACRC") {
        let mut command = Command::new(program);
        command.arg("lsp");
        return command;
    }
    let mut command = Command::new(std::env::current_exe().expect("this program has a path"));
    command.env(SERVE, "1");
    command
}

fn start(name: &str, project: &Project) {
    let mut times = Times::default();
    for _ in 0..STARTS {
        times.add(|| {
            let mut server = Server::begin(acrc(), project);
            server.open(project, project.edited, "");
            server.first_diagnostics();
            server
        });
    }
    times.print(name);
}

/// Types into a file in the middle of the project.
fn keystrokes(name: &str, command: Command, project: &Project, typed: &'static str) {
    println!("{name}: {} lines in {} files", project.lines(), project.files.len());
    let mut server = Server::begin(command, project);
    server.open(project, project.edited, typed);
    server.first_diagnostics();
    let mut times = Times::default();
    for step in 0..KEYSTROKES {
        times.add(|| {
            server.type_one(step);
            server.diagnostics();
        });
    }
    times.print(&format!("{name}: keystroke to diagnostics"));
    if name == "acrc" {
        let mut times = Times::default();
        for step in 0..KEYSTROKES {
            times.add(|| {
                server.type_one(step);
                server.complete();
            });
            server.diagnostics();
        }
        times.print("acrc: keystroke to completion");
        if project.files.len() > 1 {
            setup_keystrokes(&mut server, project);
        }
    }
    println!("{name}: memory {:.0} MB, at most {:.0} MB", server.memory("VmRSS"), server.memory("VmHWM"));
}

/// Types into the setup, on which all programs hang.
fn setup_keystrokes(server: &mut Server, project: &Project) {
    server.open(project, 0, ALIAS);
    server.first_diagnostics();
    let mut times = Times::default();
    for step in 0..KEYSTROKES {
        times.add(|| {
            server.type_one(step);
            server.diagnostics();
        });
    }
    times.print("acrc: keystroke in an alias of the setup to diagnostics");
}
