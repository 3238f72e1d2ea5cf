//! Characters that were typed at a port and that no program has read yet.

use std::collections::VecDeque;

const BACKSPACE: u8 = 0x08;
const LINE_FEED: u8 = b'\n';
const RETURN: u8 = b'\r';
const DELETE: u8 = 0x7f;

/// What a port has for the programs.
#[derive(Debug, Default)]
pub(super) struct Input {
    /// What has arrived.
    arrived: VecDeque<u8>,
    /// How much of it an `INPUT` has echoed.
    echoed: usize,
    /// A carriage return has ended the line before: a line feed may belong to it.
    returned: bool,
    /// Lines that somebody will type as soon as those before are read.
    offered: VecDeque<u8>,
}

/// How far an `INPUT` has come.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Reading {
    /// What it has to echo.
    pub(crate) echo: Vec<u8>,
    /// The line, without its end, once it is complete.
    pub(crate) line: Option<Vec<u8>>,
}

impl Input {
    /// Characters arrive. Gives how many wait now.
    pub(super) fn arrive(&mut self, bytes: &[u8]) -> usize {
        self.arrived.extend(bytes);
        self.arrived.len()
    }

    /// How many characters have arrived and wait.
    pub(super) fn unread(&self) -> usize {
        self.arrived.len()
    }

    /// Lines to be typed when the programs are ready for them.
    pub(super) fn offer(&mut self, bytes: &[u8]) {
        self.offered.extend(bytes);
    }

    /// The line feed behind a carriage return that has ended a line belongs to that line.
    fn drop_line_feed(&mut self) {
        if self.returned && self.arrived.front() == Some(&LINE_FEED) {
            self.arrived.pop_front();
        }
        self.returned &= self.arrived.is_empty();
    }

    /// The next line is typed when nothing waits.
    fn refill(&mut self) {
        self.drop_line_feed();
        if self.arrived.is_empty() {
            let end = self.offered.iter().position(|byte| is_end(*byte)).map_or(self.offered.len(), |end| end + 1);
            self.arrived.extend(self.offered.drain(..end));
        }
    }

    /// Whether no whole line has arrived.
    pub(super) fn lacks_line(&mut self) -> bool {
        self.drop_line_feed();
        !self.arrived.iter().any(|byte| is_end(*byte))
    }

    /// Whether a character waits.
    pub(super) fn waits(&mut self) -> bool {
        self.refill();
        !self.arrived.is_empty()
    }

    /// The next character.
    pub(super) fn take(&mut self) -> Option<u8> {
        self.refill();
        self.echoed = self.echoed.saturating_sub(1);
        self.arrived.pop_front()
    }

    /// Forgets what has arrived.
    pub(super) fn clear(&mut self) -> usize {
        self.echoed = 0;
        std::mem::take(&mut self.arrived).len()
    }

    /// Reads on towards the end of a line. Backspace and DEL erase a character; other control characters do not belong to a line.
    pub(super) fn read(&mut self) -> Reading {
        self.refill();
        let mut echo = Vec::new();
        let mut line = Vec::new();
        for (place, byte) in self.arrived.iter().enumerate() {
            let shown = match *byte {
                byte if is_end(byte) => {
                    self.arrived.drain(..=place);
                    self.echoed = 0;
                    self.returned = byte == RETURN;
                    return Reading { echo, line: Some(line) };
                }
                BACKSPACE | DELETE => line.pop().map_or(&b""[..], |_| b"\x08 \x08"),
                b'\t' | 0x20..=0x7e | 0xa0..=0xff => {
                    line.push(*byte);
                    std::slice::from_ref(byte)
                }
                _ => b"",
            };
            if place >= self.echoed {
                echo.extend_from_slice(shown);
            }
        }
        self.echoed = self.arrived.len();
        Reading { echo, line: None }
    }
}

fn is_end(byte: u8) -> bool {
    matches!(byte, RETURN | LINE_FEED)
}

/// Text of a file as somebody types it: the Enter key ends a line.
pub(crate) fn as_typed(text: &[u8]) -> Vec<u8> {
    let mut typed = Vec::with_capacity(text.len());
    for byte in text {
        match (byte, typed.last()) {
            (b'\n', Some(&RETURN)) => {}
            (b'\n', _) => typed.push(RETURN),
            (byte, _) => typed.push(*byte),
        }
    }
    typed
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_echoed_once_and_taken_when_it_ends() {
        let mut input = Input::default();
        input.arrive(b"1x\x08");
        assert_eq!(input.read(), Reading { echo: b"1x\x08 \x08".to_vec(), line: None });
        assert_eq!(input.read(), Reading { echo: vec![], line: None });
        input.arrive(b"2\r\n3\nrest");
        assert_eq!(input.read(), Reading { echo: b"2".to_vec(), line: Some(b"12".to_vec()) });
        assert_eq!(input.read(), Reading { echo: b"3".to_vec(), line: Some(b"3".to_vec()) });
        assert_eq!((input.take(), input.clear()), (Some(b'r'), 3));
    }

    #[test]
    fn an_offered_line_comes_when_the_one_before_is_read() {
        let mut input = Input::default();
        input.offer(b"ab\rcd");
        assert!(input.waits());
        assert_eq!((input.take(), input.clear()), (Some(b'a'), 2));
        assert_eq!(input.read(), Reading { echo: b"cd".to_vec(), line: None });
    }
}
