//! A session from a pipe or a file: bytes in, bytes out.
//!
//! At full speed virtual time depends on nothing but the bytes: the same input gives the same output, byte by byte, however it arrives.

use std::io::{self, ErrorKind, Write as _};
use std::sync::mpsc::RecvTimeoutError;
use std::time::Duration;

use acrc_controller::PromptState;
use anyhow::Context as _;

use super::session::Session;
use crate::cli::Speed;
use crate::commands::stdin::read_ahead;

/// Wall time between two looks at the controller.
const BEAT: Duration = Duration::from_millis(2);
/// Chunks that wait for the controller.
const CHUNKS: usize = 16;

/// Runs the session until the input is over and everything typed is answered, for `linger` virtual seconds behind it at most.
pub(super) fn run(session: &mut Session, linger: f64) -> anyhow::Result<()> {
    match feed(session, linger) {
        // Nobody reads the answers any more.
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        result => result.context("the session was cut off"),
    }
}

fn feed(session: &mut Session, linger: f64) -> io::Result<()> {
    let chunks = read_ahead(CHUNKS);
    let mut line = Vec::new();
    loop {
        let chunk = match session.speed() {
            Speed::Max => chunks.recv().map_err(|_| RecvTimeoutError::Disconnected),
            Speed::Factor(_) => chunks.recv_timeout(BEAT),
        };
        match chunk {
            Ok(chunk) => {
                for byte in chunk? {
                    type_byte(session, &mut line, byte, linger)?;
                }
            }
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => break,
        }
        if session.speed() != Speed::Max {
            session.catch_up();
        }
        show(session)?;
    }
    session.send(&line);
    finish(session, linger)
}

/// Types a byte. Lines go to the controller as a whole, at full speed one behind the answer to the other.
fn type_byte(session: &mut Session, line: &mut Vec<u8>, byte: u8, linger: f64) -> io::Result<()> {
    line.push(byte);
    let is_end = matches!(byte, b'\r' | b'\n');
    let acts_at_once = matches!(byte, 0x18..=0x1b);
    if session.speed() != Speed::Max {
        session.send(&std::mem::take(line));
    } else if is_end || acts_at_once {
        // What acts at once must not overtake what was typed before it; ESC is there to end what goes on.
        if acts_at_once && byte != 0x1b {
            line.pop();
            session.send(&std::mem::take(line));
            if session.state() == PromptState::Busy {
                session.settle(linger);
            }
            line.push(byte);
        }
        session.send(&std::mem::take(line));
        answer(session);
    }
    show(session)
}

/// Gives the controller the time that it needs to take a line; one that waits is waited for at the end. A program that is listened to gets as
/// much, so that what is typed behind a short one is typed at the prompt.
fn answer(session: &mut Session) {
    /// Ticks in which a statement that does not wait is answered.
    const PROMPTLY: u32 = 200;
    for _ in 0..PROMPTLY {
        if matches!(session.state(), PromptState::Ready(_)) {
            break;
        }
        session.step();
    }
}

/// The input is over: what still goes on is shown until it ends.
fn finish(session: &mut Session, linger: f64) -> io::Result<()> {
    let end = session.controller.seconds() + linger;
    while !matches!(session.state(), PromptState::Ready(_)) && session.controller.seconds() < end {
        match session.speed() {
            Speed::Max => session.step(),
            Speed::Factor(_) => {
                std::thread::sleep(BEAT);
                session.catch_up();
            }
        }
        show(session)?;
    }
    show(session)
}

fn show(session: &mut Session) -> io::Result<()> {
    let bytes = session.read();
    if bytes.is_empty() {
        return Ok(());
    }
    let mut out = io::stdout().lock();
    out.write_all(&bytes)?;
    out.flush()
}
