//! One channel: its level, its input line, what it has to send.
//!
//! What comes back for what is typed follows the habits of working client programs: the line is echoed as it is read, a carriage return as CR LF;
//! then come the lines of the answer; then the prompt, with nothing behind it.

use std::collections::VecDeque;

use acrc_catalog::message;
use acrc_syntax::units::Level;

use super::{Entry, PromptState, StreamName, Typed};
use crate::task::Task;

/// Characters of a line, at most (`docs/fidelity.md`, terminal).
const LONGEST_LINE: usize = 1024;

/// Bits of the value of `ECHO`.
const ECHO_CHARACTERS: u8 = 1;
const ECHO_NO_PROMPT: u8 = 4;

const BACKSPACE: u8 = 0x08;
const DELETE: u8 = 0x7f;
const ESCAPE: u8 = 0x1b;

/// Characters that act as soon as they arrive (guide, "To Stop All Motion Immediately").
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Key {
    /// Ctrl-X: end all programs, kill all motion.
    Kill,
    /// Ctrl-Y: clear the kill flags.
    ClearKill,
    /// Ctrl-Z: Ctrl-X, and all drives off.
    KillAndDisable,
}

impl Key {
    /// The key of a character.
    pub(crate) fn of(byte: u8) -> Option<Self> {
        match byte {
            0x18 => Some(Self::Kill),
            0x19 => Some(Self::ClearKill),
            0x1a => Some(Self::KillAndDisable),
            _ => None,
        }
    }
}

/// Who types at a channel and takes what it sends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Typist {
    /// Whoever opened the channel.
    Driver,
    /// The world: whoever watches the run sees what is sent.
    World,
}

/// A channel.
#[derive(Debug)]
pub(crate) struct Channel {
    pub(crate) stream: StreamName,
    /// Where its statements are executed.
    pub(crate) level: Level,
    /// Value of `ECHO`.
    pub(crate) echo: u8,
    /// Value of `MODE`.
    pub(crate) mode: u8,
    /// Lines that are entered into a program (`PROGRAM`).
    pub(crate) entry: Option<Entry>,
    /// What it shows the output of.
    pub(crate) listening: Option<Task>,
    /// The stream that it is connected to (`TALK TO`).
    pub(crate) talking: Option<StreamName>,
    pub(crate) typist: Typist,
    /// The line that is being executed.
    pub(crate) typed: Option<Typed>,
    /// What has arrived and is not read yet.
    input: VecDeque<u8>,
    /// The line as far as it was read.
    line: Vec<u8>,
    /// The line has more characters than are kept.
    too_long: bool,
    /// The byte before was a carriage return, so a line feed belongs to it.
    returned: bool,
    output: Vec<u8>,
    /// The last byte sent ended a line or the prompt.
    line_open: bool,
}

impl Channel {
    /// As after power-up: at the system level, with echo and prompt.
    pub(super) fn new(stream: StreamName) -> Self {
        Self {
            stream,
            level: Level::System,
            echo: ECHO_CHARACTERS,
            mode: u8::from(matches!(stream, StreamName::Com(_))),
            entry: None,
            listening: None,
            talking: None,
            typist: Typist::Driver,
            typed: None,
            input: VecDeque::new(),
            line: Vec::new(),
            too_long: false,
            returned: false,
            output: Vec::new(),
            line_open: false,
        }
    }

    /// A byte has arrived.
    pub(crate) fn push(&mut self, byte: u8) {
        self.input.push_back(byte);
    }

    /// Whether something has arrived that is not read yet.
    pub(crate) fn has_input(&self) -> bool {
        !self.input.is_empty()
    }

    /// How many bytes have arrived that are not read yet.
    pub(crate) fn unread(&self) -> usize {
        self.input.len()
    }

    /// How many bytes it has to send.
    pub(crate) fn unsent(&self) -> usize {
        self.output.len()
    }

    /// Whether a line is being answered, or is to be read.
    pub(crate) fn is_answering(&self) -> bool {
        self.typed.is_some() || self.escape_waits() || self.listening.is_none() && self.has_input()
    }

    /// Reads up to the end of a line and gives the line: `Err` with the controller's text for one that is too long.
    pub(crate) fn next_line(&mut self) -> Option<Result<String, &'static str>> {
        while let Some(byte) = self.input.pop_front() {
            let after_return = std::mem::replace(&mut self.returned, byte == b'\r');
            match byte {
                b'\n' if after_return => {}
                b'\r' | b'\n' => return Some(self.end_line()),
                BACKSPACE | DELETE => self.rub_out(),
                b'\t' | 0x20..=0x7e | 0xa0..=0xff => self.take_character(byte),
                // Nothing else belongs to a line: NUL pads packets, ESC is harmless at a prompt.
                _ => {}
            }
        }
        None
    }

    fn end_line(&mut self) -> Result<String, &'static str> {
        self.echo_bytes(b"\r\n");
        self.line_open = false;
        let line = std::mem::take(&mut self.line);
        if std::mem::take(&mut self.too_long) {
            return Err(message::LINE_TOO_LONG.text());
        }
        Ok(line.into_iter().map(char::from).collect())
    }

    fn rub_out(&mut self) {
        if self.line.pop().is_some() {
            self.echo_bytes(b"\x08 \x08");
        }
    }

    fn take_character(&mut self, byte: u8) {
        self.echo_bytes(&[byte]);
        if self.line.len() < LONGEST_LINE {
            self.line.push(byte);
        } else {
            self.too_long = true;
        }
    }

    /// Whether it echoes what is typed.
    pub(crate) fn echoes(&self) -> bool {
        self.echo & ECHO_CHARACTERS != 0
    }

    /// Whether it leaves the prompt out.
    pub(crate) fn hides_prompt(&self) -> bool {
        self.echo & ECHO_NO_PROMPT != 0
    }

    /// Echoes or not, and leaves the prompt out or not.
    pub(super) fn set_echo(&mut self, echo: bool, no_prompt: bool) {
        let rest = self.echo & !(ECHO_CHARACTERS | ECHO_NO_PROMPT);
        self.echo = rest | if echo { ECHO_CHARACTERS } else { 0 } | if no_prompt { ECHO_NO_PROMPT } else { 0 };
    }

    fn echo_bytes(&mut self, bytes: &[u8]) {
        if self.echoes() {
            self.send(bytes);
        }
    }

    /// Whether an ESC waits to be read.
    pub(crate) fn escape_waits(&self) -> bool {
        self.input.contains(&ESCAPE)
    }

    /// Drops what was typed up to an ESC. False, and nothing is dropped, when there is none.
    pub(crate) fn skip_to_escape(&mut self) -> bool {
        let place = self.input.iter().position(|byte| *byte == ESCAPE);
        if let Some(place) = place {
            self.input.drain(..=place);
        }
        place.is_some()
    }

    /// Gives up what was typed up to the end of a line, or up to an ESC.
    pub(crate) fn take_typed(&mut self) -> Vec<u8> {
        let escape = self.input.iter().position(|byte| *byte == ESCAPE).unwrap_or(self.input.len());
        let end = self.input.iter().position(|byte| matches!(byte, b'\r' | b'\n')).map_or(escape, |end| end + 1);
        self.input.drain(..end.min(escape)).collect()
    }

    /// Sends bytes.
    pub(crate) fn send(&mut self, bytes: &[u8]) {
        if let Some(last) = bytes.last() {
            self.output.extend_from_slice(bytes);
            self.line_open = *last != b'\n';
        }
    }

    /// Sends a line of text, in Latin-1.
    pub(crate) fn send_line(&mut self, text: &str) {
        let bytes: Vec<u8> = text.chars().map(|character| u8::try_from(character).unwrap_or(b'?')).collect();
        self.send(&bytes);
        self.send(b"\r\n");
    }

    /// Sends the prompt.
    pub(crate) fn send_prompt(&mut self) {
        if !self.hides_prompt() {
            let prompt = self.prompt();
            self.output.extend_from_slice(prompt.as_bytes());
        }
        self.line_open = false;
    }

    /// Leaves `LRUN`, `LISTEN` or `TALK TO`: the prompt comes back on a line of its own.
    pub(crate) fn stop_listening(&mut self) {
        self.listening = None;
        self.talking = None;
        if self.line_open {
            self.send(b"\r\n");
        }
        self.send_prompt();
    }

    /// Whether it shows something else until ESC, and has no prompt.
    pub(crate) fn is_away(&self) -> bool {
        self.listening.is_some() || self.talking.is_some()
    }

    /// The prompt of its level.
    pub(crate) fn prompt(&self) -> String {
        match self.level {
            Level::System => "SYS>".to_owned(),
            Level::Program(number) => format!("P{number:02}>"),
            Level::Plc(number) => format!("PLC{number}>"),
        }
    }

    /// What it has to send.
    pub(crate) fn take_output(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.output)
    }

    /// What it is doing, as its driver sees it.
    pub(crate) fn state(&self) -> PromptState {
        if self.is_answering() {
            PromptState::Busy
        } else if self.is_away() {
            PromptState::Listening
        } else {
            PromptState::Ready(self.prompt())
        }
    }
}
