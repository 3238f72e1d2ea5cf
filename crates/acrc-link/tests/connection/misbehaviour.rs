//! Lines that are cut, silent, or speak something else.

use std::cell::Cell;
use std::collections::VecDeque;
use std::io;
use std::rc::Rc;
use std::time::Duration;

use acrc_link::{Connection, Console as _, LinkError, Protocol, Settings, Transport};
use acrc_wire::Request;
use proptest::collection::vec;
use proptest::prelude::*;

use crate::support::Machine;

/// Sends what it was told to, whatever it is asked.
#[derive(Clone, Debug)]
struct Script {
    /// Pieces: what is sent after each line that comes, `None` for an end.
    answers: VecDeque<Option<Vec<u8>>>,
    pending: VecDeque<u8>,
    closed: bool,
}

impl Script {
    fn new<'a>(answers: impl IntoIterator<Item = &'a str>) -> Self {
        let answers = answers.into_iter().map(|text| Some(text.as_bytes().to_vec())).collect();
        Self { answers, pending: VecDeque::new(), closed: false }
    }

    fn then_closed(mut self) -> Self {
        self.answers.push_back(None);
        self
    }

    /// Answers the lines that a connection begins with.
    fn greeting<'a>(answers: impl IntoIterator<Item = &'a str>) -> Self {
        let begin = ["\r\nSYS>", "? \"acrc-1\"\r\nacrc-1\r\nSYS>"];
        Self::new(begin.into_iter().chain(answers))
    }

    fn connect(self) -> Result<Connection<Self>, LinkError> {
        Connection::over(self, "script:5002".to_owned(), Protocol::Text, Settings::default())
    }
}

impl Transport for Script {
    fn read_within(&mut self, buffer: &mut [u8], _: Duration) -> io::Result<Option<usize>> {
        let count = buffer.len().min(self.pending.len()).min(3);
        for (place, byte) in buffer.iter_mut().zip(self.pending.drain(..count)) {
            *place = byte;
        }
        match (count, self.closed) {
            (0, false) => Ok(None),
            (count, _) => Ok(Some(count)),
        }
    }

    fn write_within(&mut self, bytes: &[u8], _: Duration) -> io::Result<()> {
        if bytes.contains(&b'\r') {
            match self.answers.pop_front() {
                Some(Some(text)) => self.pending.extend(text),
                Some(None) => self.closed = true,
                None => {}
            }
        }
        Ok(())
    }
}

#[test]
fn nothing_answers() {
    let error = Script::new([]).connect().err().expect("nothing comes");
    assert_eq!(error.to_string(), "script:5002 accepted the connection but shows no prompt: nothing comes");
}

#[test]
fn a_controller_without_a_free_stream_ends_the_connection() {
    let error = Script::new([]).then_closed().connect().err().expect("it is closed");
    assert_eq!(
        error.to_string(),
        "script:5002 accepted the connection but shows no prompt: it ended the connection at once, as a controller \
         does whose 4 streams are all in use"
    );
}

#[test]
fn a_web_server_is_quoted() {
    let error = Script::new(["HTTP/1.1 400 Bad Request\r\n"]).then_closed().connect().err().expect("that is no prompt");
    assert!(error.to_string().ends_with("shows no prompt: \"HTTP/1.1 400 Bad Request\""), "{error}");
}

/// Sends the same for ever, as fast as it is read.
struct Endless(&'static [u8]);

impl Transport for Endless {
    fn read_within(&mut self, buffer: &mut [u8], _: Duration) -> io::Result<Option<usize>> {
        for (place, byte) in buffer.iter_mut().zip(self.0.iter().cycle()) {
            *place = *byte;
        }
        Ok(Some(buffer.len()))
    }

    fn write_within(&mut self, _: &[u8], _: Duration) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn what_has_no_end_is_given_up() {
    for text in [&b"x"[..], b"1\r\n", b"\r\nSYS>", b"\xff\x00\r"] {
        for protocol in [Protocol::Text, Protocol::Mixed] {
            let opened = Connection::over(Endless(text), "endless:5002".to_owned(), protocol, Settings::default());
            let error = opened.err().expect("that is no controller");
            assert!(matches!(error, LinkError::NoPrompt { .. } | LinkError::Endless { .. }), "{text:?}: {error}");
        }
    }
}

#[test]
fn something_else_answers() {
    let error = Script::new(["SSH-2.0-OpenSSH_9.6\r\n"]).connect().err().expect("that is no prompt");
    assert!(error.to_string().ends_with("shows no prompt: \"SSH-2.0-OpenSSH_9.6\""), "{error}");
}

#[test]
fn the_other_side_closes() {
    let error = Script::new([]).then_closed().connect().err().expect("it is closed");
    assert!(matches!(error, LinkError::NoPrompt { .. }), "{error}");
    let mut console = Script::greeting([]).then_closed().connect().expect("a prompt");
    let error = console.command("VEL").expect_err("it is closed");
    assert_eq!(error.to_string(), "the controller closed the connection while the answer to `VEL` was waited for");
}

#[test]
fn an_answer_is_cut_in_the_middle() {
    let mut console = Script::greeting(["VEL\r\n10"]).connect().expect("a prompt");
    let error = console.command("VEL").expect_err("there is no prompt");
    assert_eq!(error.to_string(), "timed out after 5 s waiting for the answer to `VEL`");
}

#[test]
fn a_late_prompt_is_no_answer() {
    let mut console = Script::greeting(["SYS>SYS>VEL\r\n10\r\nP00>"]).connect().expect("a prompt");
    assert_eq!(console.command("VEL").and_then(|answer| answer.number()).ok(), Some(10.0));
}

#[test]
fn a_controller_without_echo() {
    let script = Script::new(["\r\nSYS>", "acrc-1\r\nSYS>", "10\r\nSYS>", "SYS>"]);
    let mut console = script.connect().expect("a prompt");
    assert_eq!(console.command("VEL").and_then(|answer| answer.number()).ok(), Some(10.0));
    assert!(console.command("VEL 5").and_then(|answer| answer.silence()).is_ok());
}

#[test]
fn a_broken_line_is_an_error() {
    let machine = Machine::new();
    for bytes in 0..60 {
        let result = machine.line().breaking_after(bytes).try_connect().and_then(|mut console| {
            console.command("? 1")?;
            console.command("PROG0")?;
            console.command("DIM LV(10)")
        });
        let sent = "\u{1b}\u{1b}\u{1b}\r? \"acrc-1\"\r? 1\rPROG0\rDIM LV(10)\r".len();
        assert_eq!(result.is_err_and(|error| error.is_broken()), bytes < sent, "{bytes}");
    }
    assert_eq!(machine.connect().command("? 1").and_then(|answer| answer.number()).ok(), Some(1.0));
}

proptest! {
    #[test]
    fn garbage_never_panics_nor_hangs(pieces in vec(vec(any::<u8>(), 0..40), 0..6)) {
        let script = Script { answers: pieces.into_iter().map(Some).collect(), ..Script::new([]) };
        let mut greeted = Script::greeting([]);
        greeted.answers.extend(script.answers.iter().cloned());
        for script in [script, greeted] {
            if let Ok(mut console) = script.connect() {
                let _ = console.command("VEL");
                let _ = console.command("ACC");
            }
        }
    }
}

/// A port that takes so many bytes at a time, and echoes what it has taken.
struct Groups {
    size: usize,
    taken: Vec<u8>,
    pending: VecDeque<u8>,
    /// How long was waited in vain.
    waited: Rc<Cell<Duration>>,
}

impl Groups {
    fn of(size: usize) -> (Self, Rc<Cell<Duration>>) {
        let waited = Rc::<Cell<Duration>>::default();
        (Self { size, taken: Vec::new(), pending: VecDeque::new(), waited: waited.clone() }, waited)
    }
}

impl Transport for Groups {
    fn read_within(&mut self, buffer: &mut [u8], longest: Duration) -> io::Result<Option<usize>> {
        let count = buffer.len().min(self.pending.len());
        for (place, byte) in buffer.iter_mut().zip(self.pending.drain(..count)) {
            *place = byte;
        }
        if count == 0 {
            self.waited.set(self.waited.get() + longest);
        }
        Ok((count > 0).then_some(count))
    }

    fn write_within(&mut self, bytes: &[u8], _: Duration) -> io::Result<()> {
        self.taken.extend(bytes);
        let whole = self.taken.len() / self.size * self.size;
        for byte in self.taken.drain(..whole) {
            match byte {
                b'\r' => self.pending.extend(b"\r\nSYS>"),
                b' '..=b'~' => self.pending.push_back(byte),
                _ => {}
            }
        }
        Ok(())
    }
}

#[test]
fn text_at_a_port_for_packets_is_told() {
    let (port, waited) = Groups::of(4);
    let opened = Connection::over(port, "the machine".to_owned(), Protocol::Text, Settings::default());
    assert_eq!(
        opened.err().expect("it is no port for text").to_string(),
        "the machine accepted the connection but shows no prompt: it takes text by four bytes only, as a port for packets \
         does (5006): --packets speaks to it"
    );
    assert!(waited.get() < Duration::from_secs(1), "{:?}", waited.get());
}

#[test]
fn packets_at_a_port_for_text_are_told() {
    let (port, waited) = Groups::of(1);
    let opened = Connection::over(port, "the machine".to_owned(), Protocol::Mixed, Settings::default());
    let mut connection = opened.expect("a prompt");
    let error = connection.ask(&[Request::GetLong { parameter: 0x3041 }], |_, _| {}).expect_err("no packet comes");
    assert_eq!(
        error.to_string(),
        "the machine answers packets with text (at `get P12353`), as a port for text does (5002): --text speaks text to it, \
         and packets go to the port that stands for 5006"
    );
    assert!(waited.get() < Duration::from_secs(1), "{:?}", waited.get());
    // One that shows nothing of it is asked for as long as ever.
    let error = connection.ask(&[Request::GetLong { parameter: 0x1000 }], |_, _| {}).expect_err("no packet comes");
    assert!(matches!(error, LinkError::Timeout { .. }), "{error}");
}
