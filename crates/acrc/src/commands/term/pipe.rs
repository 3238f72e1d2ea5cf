//! A session from a pipe or a file: bytes in, bytes out.

use std::io::{self, ErrorKind, Write as _};
use std::sync::mpsc::RecvTimeoutError;
use std::time::Duration;

use acrc_link::{Connection, LinkError, Tcp};
use anyhow::Context as _;

use super::tail::Tail;
use crate::commands::link::interrupted;
use crate::commands::stdin::read_ahead;

/// A line that brings no prompt (`LRUN`) is followed by the next when nothing came for so long.
const QUIET: Duration = Duration::from_millis(200);
/// The longest that a line is waited for while it shows something all the time.
const PATIENCE: u32 = 10;
/// Wall time between two looks at the input.
const BEAT: Duration = Duration::from_millis(20);

/// Sends what comes from standard input, line by line, and shows what comes back, until the input is over and nothing came
/// for a time.
pub(super) fn run(connection: &mut Connection<Tcp>, linger: Duration) -> anyhow::Result<()> {
    let chunks = read_ahead(1);
    let mut line = Vec::new();
    loop {
        match chunks.recv_timeout(BEAT) {
            Ok(chunk) => {
                for byte in chunk.context("standard input cannot be read")? {
                    line.push(byte);
                    let is_end = matches!(byte, b'\r' | b'\n');
                    if is_end || matches!(byte, 0x18..=0x1b) {
                        connection.type_bytes(&line)?;
                        line.clear();
                        if is_end && !answer(connection)? {
                            return Ok(());
                        }
                    }
                }
            }
            Err(RecvTimeoutError::Timeout) if interrupted() => return Err(LinkError::Interrupted.into()),
            Err(RecvTimeoutError::Timeout) => {
                if !show(&connection.listen(Duration::ZERO)?)? {
                    return Ok(());
                }
            }
            Err(RecvTimeoutError::Disconnected) => break,
        }
    }
    if !line.is_empty() {
        connection.type_bytes(&line)?;
    }
    loop {
        let text = connection.listen(linger)?;
        if text.is_empty() || !show(&text)? {
            return Ok(());
        }
    }
}

/// Shows what a line brings, up to the prompt. False when nobody reads it.
fn answer(connection: &mut Connection<Tcp>) -> anyhow::Result<bool> {
    let mut tail = Tail::new("", false);
    for _ in 0..PATIENCE {
        let text = connection.listen(QUIET)?;
        if text.is_empty() {
            break;
        }
        if !show(&text)? {
            return Ok(false);
        }
        tail.take(&text);
        if tail.prompt().is_some() {
            break;
        }
    }
    Ok(true)
}

/// Writes text as the bytes that came. False when nobody reads it.
fn show(text: &str) -> anyhow::Result<bool> {
    if text.is_empty() {
        return Ok(true);
    }
    let bytes: Vec<u8> = text.chars().map(|character| u8::try_from(character).unwrap_or(b'?')).collect();
    let mut out = io::stdout().lock();
    match out.write_all(&bytes).and_then(|()| out.flush()) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(false),
        result => result.map(|()| true).context("cannot write"),
    }
}
