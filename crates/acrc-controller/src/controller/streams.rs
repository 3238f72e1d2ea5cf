//! Characters that arrive from outside: typed at the channels, by the world, or offered for the programs to read.

use std::ops::Range;

use super::{Controller, Observer, Sent};
use crate::streams::{Port, as_typed};
use crate::terminal::{Channel, ChannelId, StreamName};

impl Controller {
    /// Gives the programs text to read at a port: each line of it is typed when a program asks for input there and has read the lines before. The
    /// end of a line is the Enter key. A stream is read while a program has it open.
    pub fn offer(&mut self, port: Port, text: &[u8]) {
        self.machine.streams.offer(port, &as_typed(text));
        self.changes += 1;
    }

    /// A byte that was typed at a channel goes to the programs that have its stream open, or to the terminal. A program to which the terminal
    /// listens takes it from there when it asks for input.
    pub(super) fn take_in(&mut self, id: ChannelId, byte: u8) {
        let Some(channel) = self.machine.terminal.get_mut(id) else { return };
        let stream = Port::Stream(channel.stream);
        if self.machine.streams.takes(stream) {
            self.arrive(stream, &[byte]);
            return;
        }
        channel.push(byte);
        if channel.listening.is_some() {
            self.changes += 1;
        }
    }

    /// Types what events of the world say: at the programs, or at the terminal of the stream.
    pub(super) fn type_events(&mut self, events: Range<usize>) {
        for event in events {
            let typed = self.machine.world().events().get(event).and_then(|event| event.typed.clone());
            let Some(typed) = typed else { continue };
            match typed.port {
                Port::Stream(stream) if !self.machine.streams.takes(typed.port) => {
                    if let Some(channel) = self.scripted_channel(stream) {
                        self.receive(channel, &typed.text);
                    }
                }
                port => self.arrive(port, &typed.text),
            }
        }
    }

    /// The channel of a stream, opened when there is none.
    fn scripted_channel(&mut self, stream: StreamName) -> Option<ChannelId> {
        if let Some(channel) = self.machine.terminal.find(stream) {
            return Some(channel);
        }
        let channel = self.open_channel(stream).ok()?;
        self.scripted.push(channel);
        Some(channel)
    }

    /// Shows what the terminals at which the world types have answered.
    pub(super) fn show_scripted(&mut self, observer: &mut dyn Observer) {
        for id in &self.scripted {
            let Some(channel) = self.machine.terminal.get_mut(*id) else { continue };
            let stream = channel.stream;
            let text: String = Channel::take_output(channel).into_iter().map(char::from).collect();
            if !text.is_empty() {
                let seconds = self.machine.clock.seconds();
                observer.output(&Sent { seconds, program: None, device: 0, stream: Some(stream), text: &text });
            }
        }
    }

    /// Characters arrive for the programs. A sender is held back while the buffer is full, so nothing is lost.
    fn arrive(&mut self, port: Port, bytes: &[u8]) {
        self.changes += 1;
        let waiting = self.machine.streams.arrive(port, bytes);
        if let Port::Stream(stream) = port {
            let size = self.machine.memory.stream_bytes(stream);
            if waiting > size as usize {
                self.machine.notes.insert(format!(
                    "{stream}: more characters arrived than its buffer of {size} bytes holds; the sender was held back until programs had read"
                ));
            }
        }
    }
}
