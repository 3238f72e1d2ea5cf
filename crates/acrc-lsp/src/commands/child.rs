//! This program, run once more.

use std::io;
use std::process::Stdio;

use tokio::process::Command;

/// How a child ended.
pub(super) struct Done {
    /// Its exit status, unless a signal ended it.
    pub(super) status: Option<i32>,
    pub(super) output: String,
    pub(super) errors: String,
}

/// Runs this program with other arguments. It ends when nobody waits for it any more.
pub(super) async fn run(arguments: &[&str]) -> io::Result<Done> {
    let child = Command::new(std::env::current_exe()?)
        .args(["--color", "never"])
        .args(arguments)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .kill_on_drop(true)
        .spawn()?;
    let done = child.wait_with_output().await?;
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    Ok(Done { status: done.status.code(), output: text(&done.stdout), errors: text(&done.stderr) })
}
