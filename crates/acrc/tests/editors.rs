//! The integrations in `editors/`, in the real editors where these are installed, with the real server.

mod common;

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use common::Bench;

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().expect("the repository")
}

/// Whether a program is on the path. Where it is not, a test has to be left out, which it says; on a CI server (`CI=true`), that is a failure.
fn has(program: &str) -> bool {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let found = std::env::split_paths(&path).any(|folder| folder.join(program).is_file());
    let on_server = std::env::var("CI").is_ok_and(|value| value == "true");
    assert!(found || !on_server, "{program} is not installed, and on a CI server its integration has to be tested");
    if !found {
        eprintln!("{program} is not installed: its integration is not tested here");
    }
    found
}

/// Lets an editor act in a folder of its own, with nothing of the person's, and gives what it prints; it must end well.
fn act<A: AsRef<OsStr>>(program: &str, arguments: impl IntoIterator<Item = A>, bench: &Bench) -> String {
    let project = bench.path("project");
    std::fs::create_dir_all(&project).expect("the folder is writable");
    let mut command = Command::new(program);
    command.args(arguments).current_dir(bench.folder.path()).stdin(Stdio::null());
    for name in ["HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME"] {
        command.env(name, bench.path(name));
    }
    command.env("ACRC", env!("CARGO_BIN_EXE_acrc")).env("PROJECT", project);
    command.env("EXAMPLES", repository().join("examples")).env("QUERIES", repository().join("editors"));
    let output = command.output().expect("the editor starts");
    let said = format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{program}: {}\n{said}", output.status);
    said
}

#[test]
fn neovim() {
    if !has("nvim") || !has("cc") {
        return;
    }
    let bench = Bench::new();
    let test = repository().join("editors/neovim/test");
    let [init, session] = ["init.lua", "session.lua"].map(|name| test.join(name).into_os_string());
    let said = act("nvim", ["--headless".into(), "-u".into(), init, "-S".into(), session], &bench);
    assert_eq!(said.matches("ok ").count(), 13, "{said}");
}

#[test]
fn vs_code() {
    let folder = repository().join("editors/vscode");
    if !has("node") || !has("npm") {
        return;
    }
    if !folder.join("node_modules").is_dir() {
        let on_server = std::env::var("CI").is_ok_and(|value| value == "true");
        assert!(!on_server, "`npm ci --prefix editors/vscode` has to run before the tests");
        eprintln!("`npm ci --prefix editors/vscode` did not run: the extension is not tested here");
        return;
    }
    let bench = Bench::new();
    let said = act("npm", ["test".into(), "--prefix".into(), folder.into_os_string()], &bench);
    assert!(said.contains("# fail 0") && said.contains("# skipped 0"), "{said}");
}

#[test]
fn emacs() {
    if !has("emacs") {
        return;
    }
    let bench = Bench::new();
    let folder = repository().join("editors/emacs");
    let test = folder.join("test/acrobasic-test.el").into_os_string();
    let load = ["-Q".into(), "--batch".into(), "-L".into(), folder.into_os_string(), "-l".into(), test];
    let said = act("emacs", load.into_iter().chain(["-f".into(), "ert-run-tests-batch-and-exit".into()]), &bench);
    assert!(said.contains(" 0 unexpected"), "{said}");
}
