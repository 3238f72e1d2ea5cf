//! A connection to a controller: text, and packets beside it.

use std::time::{Duration, Instant};

use acrc_wire::binary::Replies;
use acrc_wire::ethernet::COMMAND_STREAMS;
use acrc_wire::{Channel, Decoder, Item, Reply};

use crate::question::check;
use crate::reply::{Progress, is_at_prompt, progress};
use crate::transport::{BEAT, Tcp, Transport};
use crate::{Answer, Console, Endpoint, LinkError, Protocol, Settings};
use acrc_syntax::units::Level;

/// ESC: leaves what a channel shows or waits for.
pub const ESCAPE: u8 = 0x1b;
/// What a conversation begins with: ESC ends what the channel shows, an empty line brings the prompt. So many bytes reach also
/// a port that takes text by four bytes, where the next line then shows what it is.
const WAKE: [u8; GROUP] = [ESCAPE, ESCAPE, ESCAPE, b'\r'];
/// Bytes of a packet of text, where text comes in packets.
const GROUP: usize = 4;

/// Nothing more comes for so long behind what looks like a prompt: it is one.
const QUIET: Duration = Duration::from_millis(100);
/// Nothing more comes for so long behind what another port than the expected one answers: it is that one.
pub(crate) const CERTAIN: Duration = Duration::from_millis(500);
/// Bytes that an answer has at most: much more than the listing of the largest program.
const LONGEST_ANSWER: usize = 4 << 20;
/// What is printed to see where the answers begin.
const MARK: &str = "acrc-1";
/// Gives a prompt to a channel that shows none.
const ECHO: &str = "ECHO 1";

/// A connection to a controller.
#[expect(clippy::struct_excessive_bools, reason = "each is a state that changes by itself")]
pub struct Connection<T> {
    pub(crate) transport: T,
    pub(crate) settings: Settings,
    /// What the controller is called in errors.
    pub(crate) name: String,
    /// Packets are possible.
    pub(crate) channel: Option<(Channel, Decoder<Replies>)>,
    /// Text that has come and belongs to no answer yet.
    pub(crate) text: String,
    /// The controller echoes what is typed.
    echo: bool,
    /// Answers can be told apart; not before the first prompt, nor after an answer that did not come.
    in_step: bool,
    /// The level of the last prompt.
    prompt: Level,
    /// A packet has come.
    pub(crate) packets_came: bool,
    /// The controller has ended it, or it broke.
    ended: bool,
}

impl Connection<Tcp> {
    /// Connects over TCP and waits for the prompt.
    ///
    /// # Errors
    /// When there is no connection, or nothing answers as a controller does.
    pub fn open(endpoint: &Endpoint, protocol: (u16, Protocol), settings: Settings) -> Result<Self, LinkError> {
        let (port, protocol) = protocol;
        let tcp = Tcp::connect(endpoint, port, settings.connect, settings.retries, settings.interrupted)?;
        Self::over(tcp, endpoint.at(port).to_string(), protocol, settings)
    }
}

impl<T: Transport> Connection<T> {
    /// Speaks to a controller over what carries the bytes already, and waits for the prompt.
    ///
    /// # Errors
    /// When nothing answers as a controller does.
    pub fn over(transport: T, name: String, protocol: Protocol, settings: Settings) -> Result<Self, LinkError> {
        let channel = Channel::ethernet();
        let channel = (protocol == Protocol::Mixed).then(|| (channel, channel.replies()));
        let mut connection = Self {
            transport,
            settings,
            name,
            channel,
            text: String::new(),
            echo: false,
            in_step: false,
            prompt: Level::System,
            packets_came: false,
            ended: false,
        };
        match connection.synchronize() {
            Ok(()) => Ok(connection),
            // Behind a prompt it is an answer that does not come.
            Err(LinkError::Closed { .. } | LinkError::Broken { .. } | LinkError::Endless { .. })
                if !connection.in_step && !is_at_prompt(&connection.text) =>
            {
                Err(connection.no_prompt())
            }
            Err(error) => Err(error),
        }
    }

    /// What has come instead of a prompt.
    fn no_prompt(&self) -> LinkError {
        let what = match self.text.trim() {
            "" if self.ended => format!(
                "it ended the connection at once, as a controller does whose {} streams are all in use",
                COMMAND_STREAMS.count()
            ),
            "" => "nothing comes".to_owned(),
            text if self.takes_groups(text) => "it takes text by four bytes only, as a port for packets does (5006): \
                                                --packets speaks to it"
                .to_owned(),
            text => format!("{:?}", text.chars().take(60).collect::<String>()),
        };
        LinkError::NoPrompt { endpoint: self.name.clone(), what }
    }

    /// Whether a line was taken only as far as it fills whole groups of bytes: the end of it, which brings the answer, is missing.
    fn takes_groups(&self, text: &str) -> bool {
        let mark = mark_line();
        let whole = |line: &str| line.get(..line.len() / GROUP * GROUP).is_some_and(|begin| text.ends_with(begin));
        // Where nothing came at first, all that was sent before counts as well.
        self.channel.is_none() && (whole(&mark) || text.ends_with(ECHO))
    }

    /// Whether packets are possible.
    pub const fn has_packets(&self) -> bool {
        self.channel.is_some()
    }

    /// Whether the controller echoes what is typed.
    pub const fn echoes(&self) -> bool {
        self.echo
    }

    /// The level of the prompt that was seen last.
    pub const fn prompt(&self) -> Level {
        self.prompt
    }

    /// Types bytes, as at a terminal. What comes back is for [`Connection::listen`]; a command that follows brings the
    /// channel to a prompt first.
    ///
    /// # Errors
    /// When they cannot be sent.
    pub fn type_bytes(&mut self, bytes: &[u8]) -> Result<(), LinkError> {
        self.in_step = false;
        self.write(bytes, "")
    }

    /// The text that comes next, in Latin-1, for at most so long; empty when none comes.
    ///
    /// # Errors
    /// When the connection ends.
    pub fn listen(&mut self, longest: Duration) -> Result<String, LinkError> {
        if self.text.is_empty() {
            self.more(longest, "")?;
        }
        Ok(std::mem::take(&mut self.text))
    }

    /// How it was made.
    pub const fn settings(&self) -> &Settings {
        &self.settings
    }

    /// From now on nothing is given up when the user wants to: what is left to do is to leave things in order.
    pub fn finish_undisturbed(&mut self) {
        self.settings.interrupted = || false;
    }

    /// Ends the connection as the Ethernet specification asks for.
    pub fn close(mut self) {
        self.transport.close();
    }

    /// Brings the channel to a prompt, and finds out whether it echoes.
    ///
    /// A channel without a prompt is given one.
    fn synchronize(&mut self) -> Result<(), LinkError> {
        self.in_step = false;
        self.echo = false;
        self.text.clear();
        self.write(&WAKE, "")?;
        if !self.settle()? {
            self.write_line(ECHO)?;
            if !self.settle()? {
                return Err(self.no_prompt());
            }
        }
        self.in_step = true;
        let line = mark_line();
        self.text.clear();
        self.write_line(&line)?;
        loop {
            // What the empty line left may still come before it.
            let before = self.text.rfind(&line).and_then(|place| self.text.get(..place));
            let echo = before.is_some_and(|before| before.is_empty() || before.ends_with(['\n', '\r', '>']));
            let printed = self.text.lines().any(|line| line.trim() == MARK);
            match progress(&self.text, &line, echo) {
                Progress::Whole(_, level) if echo || printed => {
                    (self.echo, self.prompt) = (echo, level);
                    self.text.clear();
                    return Ok(());
                }
                _ => {}
            }
            let suspicious = self.takes_groups(&self.text);
            let longest = if suspicious { CERTAIN.min(self.settings.answer) } else { self.settings.answer };
            if !self.more(longest, &line)? {
                self.in_step = false;
                let timeout = LinkError::Timeout { line, after: self.settings.answer };
                return Err(if suspicious { self.no_prompt() } else { timeout });
            }
        }
    }

    /// Reads until a prompt is followed by silence, or the time of two answers is over without any. False when none comes.
    fn settle(&mut self) -> Result<bool, LinkError> {
        let begun = Instant::now();
        loop {
            let at_prompt = is_at_prompt(&self.text);
            let longest = match at_prompt {
                true => QUIET,
                false if self.takes_groups(&self.text) => CERTAIN.min(self.settings.answer),
                false => self.settings.answer,
            };
            if !self.more(longest, "")? || begun.elapsed() > self.settings.answer * 2 {
                return Ok(at_prompt);
            }
        }
    }

    fn exchange(&mut self, line: &str, patience: Duration) -> Result<Answer, LinkError> {
        check(line)?;
        if !self.in_step {
            self.synchronize()?;
        }
        self.drop_leftovers(line)?;
        self.write_line(line)?;
        self.in_step = false;
        loop {
            let (lines, prompt) = match progress(&self.text, line, self.echo) {
                Progress::Whole(lines, prompt) => (lines, prompt),
                Progress::MaybeWhole(lines, prompt) => {
                    if self.more(QUIET, line)? {
                        continue;
                    }
                    (lines, prompt)
                }
                Progress::Partial => {
                    if self.more(patience, line)? {
                        continue;
                    }
                    return Err(LinkError::Timeout { line: line.to_owned(), after: patience });
                }
            };
            (self.in_step, self.prompt) = (true, prompt);
            self.text.clear();
            return Ok(Answer { command: line.to_owned(), lines, prompt });
        }
    }

    /// Drops what came since the last answer. Without an echo it would be taken for a part of the next one.
    fn drop_leftovers(&mut self, line: &str) -> Result<(), LinkError> {
        self.text.clear();
        while !self.echo && self.more(Duration::ZERO, line)? {
            self.text.clear();
        }
        Ok(())
    }

    fn write_line(&mut self, line: &str) -> Result<(), LinkError> {
        let bytes: Vec<u8> = line.chars().filter_map(|character| u8::try_from(character).ok()).chain([b'\r']).collect();
        self.write(&bytes, line)
    }

    /// Sends text, in packets of four where that is spoken.
    fn write(&mut self, text: &[u8], line: &str) -> Result<(), LinkError> {
        match &self.channel {
            None => self.write_bytes(text, line),
            Some((channel, _)) => {
                let mut bytes = Vec::new();
                channel.text(text, &mut bytes);
                self.write_bytes(&bytes, line)
            }
        }
    }

    pub(crate) fn write_bytes(&mut self, bytes: &[u8], line: &str) -> Result<(), LinkError> {
        let sent = self.transport.write_within(bytes, self.settings.answer);
        sent.map_err(|reason| LinkError::Broken { line: line.to_owned(), reason })
    }

    /// Reads what comes next, for at most so long; packets among it are dropped. False when nothing comes.
    fn more(&mut self, longest: Duration, line: &str) -> Result<bool, LinkError> {
        self.read_on(longest, line, &mut |_| {})
    }

    /// Reads what comes next, for at most so long. False when nothing comes.
    pub(crate) fn read_on(&mut self, longest: Duration, line: &str, found: Found<'_>) -> Result<bool, LinkError> {
        // Counted by what the transport was given, so that one that keeps a time of its own decides how long that is.
        let mut left = longest;
        let mut buffer = [0; 16 * 1024];
        loop {
            if (self.settings.interrupted)() {
                return Err(LinkError::Interrupted);
            }
            let beat = left.min(BEAT);
            match self.transport.read_within(&mut buffer, beat) {
                Ok(Some(0)) => {
                    self.ended = true;
                    return Err(LinkError::Closed { line: line.to_owned() });
                }
                Ok(Some(count)) => {
                    self.take_in(buffer.get(..count).unwrap_or_default(), found);
                    if self.text.len() > LONGEST_ANSWER {
                        return Err(LinkError::Endless { line: line.to_owned(), bytes: LONGEST_ANSWER });
                    }
                    return Ok(true);
                }
                Ok(None) if left <= beat => return Ok(false),
                Ok(None) => left -= beat,
                Err(reason) => {
                    self.ended = true;
                    return Err(LinkError::Broken { line: line.to_owned(), reason });
                }
            }
        }
    }

    fn take_in(&mut self, bytes: &[u8], found: Found<'_>) {
        let Some((_, decoder)) = &mut self.channel else {
            self.text.extend(bytes.iter().copied().filter(|byte| *byte != 0).map(char::from));
            return;
        };
        let mut input = bytes;
        while let Some(item) = decoder.next_item(&mut input) {
            match item {
                Item::Text(text) => self.text.extend(text.iter().copied().map(char::from)),
                Item::Packet(reply) => found(Ok(reply)),
                Item::Unreadable(malformed) => found(Err(malformed.to_string())),
            }
        }
    }
}

/// Prints what shows where the answers begin.
fn mark_line() -> String {
    format!("? \"{MARK}\"")
}

/// Is given each packet that comes, or why it cannot be read.
pub(crate) type Found<'a> = &'a mut dyn FnMut(Result<Reply<'_>, String>);

impl<T: Transport> Console for Connection<T> {
    fn command(&mut self, line: &str) -> Result<Answer, LinkError> {
        self.exchange(line, self.settings.answer)
    }

    fn command_within(&mut self, line: &str, patience: Duration) -> Result<Answer, LinkError> {
        self.exchange(line, patience)
    }

    fn send_key(&mut self, key: u8) -> Result<(), LinkError> {
        let result = self.write(&[key], "");
        // Without an echo, what the key brings could be taken for the next answer.
        self.in_step &= self.echo;
        result
    }
}
