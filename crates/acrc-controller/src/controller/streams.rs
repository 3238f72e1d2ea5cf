//! Characters that arrive from outside: typed at the channels, by the world, or offered for the programs to read.

use std::ops::Range;

use acrc_image::UnitName;

use super::{Controller, Observer, Sent};
use crate::streams::{Port, as_typed};
use crate::terminal::{ChannelId, StreamName, Typist};

impl Controller {
    /// Gives the programs text to read at a port: each line of it is typed when a program asks for input there and has read the lines before. The
    /// end of a line is the Enter key. A stream is read while a program has it open.
    pub fn offer(&mut self, port: Port, text: &[u8]) {
        self.machine.streams.offer(port, &as_typed(text));
        self.changes.everywhere();
    }

    /// A byte that was typed at a channel goes to the programs that have its stream open, to the channel that talks to it, or to the terminal. A
    /// program to which the terminal listens takes it from there when it asks for input.
    pub(super) fn take_in(&mut self, id: ChannelId, byte: u8) {
        let Some(stream) = self.machine.terminal.get(id).map(|channel| channel.stream) else { return };
        if self.pass_on(stream, &[byte]) {
            return;
        }
        let Some(channel) = self.machine.terminal.get_mut(id) else { return };
        channel.push(byte);
        if channel.listening.is_some() {
            self.changes.everywhere();
        }
    }

    /// Gives bytes that come in at a stream to the programs or to the channel that talks to it. False when it has neither.
    fn pass_on(&mut self, stream: StreamName, bytes: &[u8]) -> bool {
        if self.machine.streams.takes(Port::Stream(stream)) {
            self.arrive(Port::Stream(stream), bytes);
            return true;
        }
        let Some(talker) = self.machine.terminal.talker(stream) else { return false };
        talker.send(bytes);
        true
    }

    /// Sends what was typed at a channel out at the stream that it talks to. False when there is nothing more for now.
    pub(super) fn relay(&mut self, id: ChannelId, stream: StreamName, observer: &mut dyn Observer) -> bool {
        let Some(channel) = self.machine.terminal.get_mut(id) else { return false };
        let typed = channel.take_typed();
        if typed.is_empty() {
            let left = channel.skip_to_escape();
            if left {
                channel.stop_listening();
            }
            return left;
        }
        self.machine.terminal.send_to(stream, &typed);
        self.show(stream, &typed, observer);
        true
    }

    /// Types what events of the world say: at the programs, or at the terminal of the stream.
    pub(super) fn type_events(&mut self, events: Range<usize>) {
        for event in events {
            let typed = self.machine.world().events().get(event).and_then(|event| event.typed.clone());
            let Some(typed) = typed else { continue };
            match typed.port {
                Port::Stream(stream) if self.pass_on(stream, &typed.text) => {}
                Port::Stream(stream) => {
                    if let Some(channel) = self.scripted_channel(stream) {
                        self.receive(channel, &typed.text);
                    }
                }
                port @ Port::Listener(_) => self.arrive(port, &typed.text),
            }
        }
    }

    /// The channel of a stream, opened when there is none.
    fn scripted_channel(&mut self, stream: StreamName) -> Option<ChannelId> {
        if let Some(channel) = self.machine.terminal.find(stream) {
            return Some(channel);
        }
        let id = self.open_channel(stream).ok()?;
        self.machine.terminal.get_mut(id)?.typist = Typist::World;
        Some(id)
    }

    /// Shows what the terminals at which the world types have answered.
    pub(super) fn show_scripted(&mut self, observer: &mut dyn Observer) {
        for (stream, sent) in self.machine.terminal.take_scripted() {
            self.show(stream, &sent, observer);
        }
    }

    /// Tells of what a terminal sends out at a stream.
    fn show(&self, stream: StreamName, sent: &[u8], observer: &mut dyn Observer) {
        let text: String = sent.iter().copied().map(char::from).collect();
        let seconds = self.machine.clock.seconds();
        observer.output(&Sent { seconds, unit: UnitName::Boot, device: 0, stream: Some(stream), text: &text });
    }

    /// Characters arrive for the programs. A sender is held back while the buffer is full, so nothing is lost.
    fn arrive(&mut self, port: Port, bytes: &[u8]) {
        self.changes.everywhere();
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
