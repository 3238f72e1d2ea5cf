//! A session at a terminal: lines are edited here, and the controller gets them when they are complete.

use std::io::{self, Write as _};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use acrc_link::{Connection, LinkError, Tcp};
use acrc_syntax::units::Level;
use anyhow::Context as _;
use crossterm::event::{Event, poll, read};
use reedline::Signal;

use super::tail::Tail;
use crate::commands::repl::{ControllerPrompt, Pressed, RawMode, Vocabulary, editor, is_shown, pressed};
use crate::output::Terminal;

/// Nothing more comes for so long behind a prompt: it is the end of the answer.
const QUIET: Duration = Duration::from_millis(30);
/// A line that is not answered within this time gets the keys of the terminal while it runs.
const PROMPTLY: Duration = Duration::from_millis(60);

/// What keys do that act on the whole machine, whatever is being typed.
const NOTES: [(u8, &str); 3] = [
    (0x18, "Ctrl-X: all programs are ended, and all motion is killed; Ctrl-Y allows motion again"),
    (0x19, "Ctrl-Y: the kill flags are cleared, motion is allowed again"),
    (0x1a, "Ctrl-Z: as Ctrl-X, and all drives are disabled; Ctrl-Y allows motion again, DRIVE ON enables a drive"),
];

/// Runs the session until the user leaves it.
pub(super) fn run(connection: &mut Connection<Tcp>, name: &str, terminal: Terminal) -> anyhow::Result<()> {
    greet(name, terminal).context("cannot write to the terminal")?;
    let vocabulary = Arc::new(Mutex::new(Vocabulary::default()));
    let mut editor = editor(Arc::clone(&vocabulary), terminal);
    let mut level = connection.prompt();
    loop {
        *vocabulary.lock().unwrap_or_else(PoisonError::into_inner) = Vocabulary::at(level, Vec::new());
        let signal = editor.read_line(&ControllerPrompt(prompt(level))).context("the terminal cannot be read")?;
        match signal {
            Signal::Success(text) => {
                for line in text.lines().chain(text.is_empty().then_some("")) {
                    let bytes: Vec<u8> =
                        line.chars().map(|character| u8::try_from(character).unwrap_or(b'?')).collect();
                    connection.type_bytes(&[&bytes, b"\r".as_slice()].concat())?;
                    match follow(connection, Tail::new(line, connection.echoes()), terminal)? {
                        Some(new) => level = new,
                        None => return Ok(()),
                    }
                }
            }
            Signal::HostCommand(key) => {
                connection.type_bytes(key.as_bytes())?;
                // At a prompt a key brings nothing, or the prompt once more.
                let mut tail = Tail::new("", false);
                let shown = tail.take(&connection.listen(PROMPTLY)?);
                show(shown.trim_start())?;
                tell_of(&key.into_bytes(), terminal)?;
                level = tail.prompt().unwrap_or(level);
            }
            Signal::CtrlC | Signal::CtrlD => return Ok(()),
            _ => {}
        }
    }
}

fn greet(name: &str, terminal: Terminal) -> io::Result<()> {
    let mut out = io::stdout().lock();
    writeln!(out, "{}", terminal.heading(&format!("connected to {name}")))?;
    let help = "HELP lists the commands of the prompt. Tab completes, Up finds earlier lines, Ctrl-C quits.\n\
                ESC leaves LRUN. Ctrl-X kills all motion, Ctrl-Y clears that, Ctrl-Z also disables the drives.";
    writeln!(out, "{}", terminal.faint(help))
}

/// Says what a key has made the controller do, since a controller says nothing of it.
fn tell_of(key: &[u8], terminal: Terminal) -> anyhow::Result<()> {
    let Some(note) = note_of(key) else { return Ok(()) };
    let mut out = io::stdout().lock();
    let written = write!(out, "{}\r\n", terminal.faint(note)).and_then(|()| out.flush());
    written.context("cannot write to the terminal")
}

fn note_of(key: &[u8]) -> Option<&'static str> {
    NOTES.iter().find(|(byte, _)| key == [*byte]).map(|(_, note)| *note)
}

/// The prompt as the controller writes it.
fn prompt(level: Level) -> String {
    match level {
        Level::System => "SYS>".to_owned(),
        Level::Program(number) => format!("P{number:02}>"),
        Level::Plc(number) => format!("PLC{number}>"),
    }
}

/// Shows what comes until the prompt is back, and passes keys on meanwhile. `None` when the user quits.
fn follow(connection: &mut Connection<Tcp>, mut tail: Tail, terminal: Terminal) -> anyhow::Result<Option<Level>> {
    let mut raw: Option<RawMode> = None;
    loop {
        let wait = match (&raw, tail.prompt()) {
            (_, Some(_)) | (Some(_), None) => QUIET,
            (None, None) => PROMPTLY,
        };
        let text = match connection.listen(wait) {
            Err(LinkError::Interrupted) => return Ok(None),
            text => text?,
        };
        if !text.is_empty() {
            show(&tail.take(&text))?;
            continue;
        }
        if let Some((open, level)) = tail.take_prompt() {
            show(&open)?;
            if tail.is_open() {
                show("\r\n")?;
            }
            return Ok(Some(level));
        }
        show(&tail.take_open())?;
        if raw.is_none() {
            raw = Some(RawMode::enter().context("the terminal cannot be watched")?);
        }
        while poll(Duration::ZERO).context("the keyboard cannot be read")? {
            let Event::Key(key) = read().context("the keyboard cannot be read")? else { continue };
            match pressed(key) {
                Pressed::Quit => return Ok(None),
                Pressed::Character(byte) => {
                    connection.type_bytes(&[byte])?;
                    tell_of(&[byte], terminal)?;
                }
                Pressed::Nothing => {}
            }
        }
    }
}

/// Shows text of the controller, which may hold anything; the terminal shall not act on it.
fn show(text: &str) -> anyhow::Result<()> {
    let text: String = text.chars().filter(|character| is_shown(*character)).collect();
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).context("cannot write to the terminal")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_that_act_on_the_machine_are_told() {
        for (key, begin) in [(b"\x18", "Ctrl-X: "), (b"\x19", "Ctrl-Y: "), (b"\x1a", "Ctrl-Z: ")] {
            assert!(note_of(key).is_some_and(|note| note.starts_with(begin)), "{begin}");
        }
        assert_eq!((note_of(b"\x1b"), note_of(b"x"), note_of(b"")), (None, None, None));
    }
}
