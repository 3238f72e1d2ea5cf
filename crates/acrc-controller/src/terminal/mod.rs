//! The terminal: what a person or a client program types at a communication channel, and what comes back (guide, "Communication Levels",
//! "Immediate Mode Commands", "Listening to a Program").
//!
//! This module holds the channels with their input lines and prompts and reads what is typed. `crate::controller` executes it in the slices of
//! communication: typed statements run as those of programs do, through [`crate::command::Context`].

mod channel;
mod entry;
mod line;
mod stored;
mod stream;
mod words;

use std::collections::BTreeMap;

use crate::task::Task;

pub(crate) use channel::{Channel, Key, Typist};
pub(crate) use entry::Entry;
pub(crate) use line::{Piece, Reader, Typed, complaint};
pub(crate) use stored::StoredText;
pub use stream::{StreamError, StreamName};
pub(crate) use words::known_words;

/// A channel that is open.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ChannelId(u32);

/// What a channel is doing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PromptState {
    /// It takes lines; this is its prompt, `P00>`.
    Ready(String),
    /// It executes a line, or has not read yet what was typed.
    Busy,
    /// It shows the output of a program (`LRUN`, `LISTEN`) or what comes in at a stream (`TALK TO`) until ESC.
    Listening,
}

/// What passes through a channel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Traffic {
    /// Bytes that have arrived and that neither the terminal nor a program has read.
    pub unread: usize,
    /// Bytes that wait to be taken.
    pub unsent: usize,
    /// A line is being answered: more is to come.
    pub answering: bool,
}

/// When a channel needs its next slice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Demand {
    /// There is something to do.
    Now,
    /// At this tick.
    At(u64),
    /// When something has happened, or somebody types.
    Nothing,
}

/// The channels of a controller.
#[derive(Debug, Default)]
pub(crate) struct Terminal {
    channels: BTreeMap<ChannelId, Channel>,
    opened: u32,
}

impl Terminal {
    /// Opens a channel on a stream that nobody else uses.
    pub(crate) fn open(&mut self, stream: StreamName) -> Result<ChannelId, StreamError> {
        if self.channels.values().any(|channel| channel.stream == stream) {
            return Err(StreamError::InUse(stream));
        }
        let id = ChannelId(self.opened);
        self.opened += 1;
        self.channels.insert(id, Channel::new(stream));
        Ok(id)
    }

    /// Closes a channel; what it was executing is given up.
    pub(crate) fn close(&mut self, id: ChannelId) {
        self.channels.remove(&id);
    }

    /// A channel; `None` once it is closed.
    pub(crate) fn get(&self, id: ChannelId) -> Option<&Channel> {
        self.channels.get(&id)
    }

    /// A channel to change.
    pub(crate) fn get_mut(&mut self, id: ChannelId) -> Option<&mut Channel> {
        self.channels.get_mut(&id)
    }

    /// The channels that are open, oldest first.
    pub(crate) fn ids(&self) -> Vec<ChannelId> {
        self.channels.keys().copied().collect()
    }

    /// The controller restarts: every channel is at the system level, nobody listens or enters a program, and what waited is given up.
    pub(crate) fn restart(&mut self) {
        for channel in self.channels.values_mut() {
            channel.level = acrc_syntax::units::Level::System;
            channel.entry = None;
            // The line that restarts the controller is in execution, so it is not among those that wait.
            let waited = channel.typed.take().is_some();
            if waited || channel.is_away() {
                channel.stop_listening();
            }
        }
    }

    /// Whether a stream echoes and leaves its prompts out, if it is open.
    pub(crate) fn set_echo(&mut self, stream: StreamName, echo: bool, no_prompt: bool) {
        if let Some(channel) = self.channels.values_mut().find(|channel| channel.stream == stream) {
            channel.set_echo(echo, no_prompt);
        }
    }

    /// All channels.
    pub(crate) fn channels(&self) -> impl Iterator<Item = &Channel> {
        self.channels.values()
    }

    /// Sends bytes to whoever typed a statement.
    pub(crate) fn send(&mut self, id: ChannelId, bytes: &[u8]) {
        if let Some(channel) = self.channels.get_mut(&id) {
            channel.send(bytes);
        }
    }

    /// Sends bytes to whoever has a stream, besides whoever watches the run.
    pub(crate) fn send_to(&mut self, stream: StreamName, bytes: &[u8]) {
        if let Some(channel) =
            self.channels.values_mut().find(|channel| channel.stream == stream && channel.typist == Typist::Driver)
        {
            channel.send(bytes);
        }
    }

    /// The channel that is connected to a stream.
    pub(crate) fn talker(&mut self, stream: StreamName) -> Option<&mut Channel> {
        self.channels.values_mut().find(|channel| channel.talking == Some(stream))
    }

    /// Takes what the terminals have sent at which the world types.
    pub(crate) fn take_scripted(&mut self) -> Vec<(StreamName, Vec<u8>)> {
        let scripted = self.channels.values_mut().filter(|channel| channel.typist == Typist::World);
        scripted.map(|channel| (channel.stream, channel.take_output())).filter(|(_, sent)| !sent.is_empty()).collect()
    }

    /// The channel of a stream.
    pub(crate) fn find(&self, stream: StreamName) -> Option<ChannelId> {
        self.channels.iter().find(|(_, channel)| channel.stream == stream).map(|(id, _)| *id)
    }

    /// What those who listen to a program have typed, up to the end of a line.
    pub(crate) fn take_typed(&mut self, program: u8) -> Vec<u8> {
        let listeners = self.channels.values_mut().filter(|channel| channel.listening == Some(Task::Program(program)));
        listeners.flat_map(Channel::take_typed).collect()
    }

    /// Sends bytes to those who listen to a program or PLC program, besides whoever watches the run.
    pub(crate) fn tell_listeners(&mut self, task: Task, bytes: &[u8]) {
        for channel in self
            .channels
            .values_mut()
            .filter(|channel| channel.listening == Some(task) && channel.typist == Typist::Driver)
        {
            channel.send(bytes);
        }
    }
}
