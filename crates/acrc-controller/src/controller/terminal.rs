//! The slices of communication: what was typed at the channels is read and executed.
//!
//! A channel executes a few statements in a slice, as programs do, with the variables of the program at its level. A statement that has to wait
//! (`DWL`, `INH`, a full move queue) holds its channel only.

use std::collections::VecDeque;

use acrc_catalog::{command, law, message};
use acrc_syntax::ast::{Statement, StatementKind};
use acrc_syntax::units::Level;
use acrc_vm::{FaultKind, Locals, Stop};

use super::setup::Immediate;
use super::{Controller, Observer};
use crate::machine::Machine;
use crate::orders::Order;
use crate::program::State;
use crate::streams::Port;
use crate::terminal::{
    Channel, ChannelId, Demand, Entry, Key, Piece, PromptState, Reader, StreamError, StreamName, Traffic, Typed,
    known_words,
};

/// Statements that a channel executes in one slice.
const STATEMENTS_PER_SLICE: u32 = 4;

impl Controller {
    /// Opens a channel, at the system level and with echo, as after power-up. It sends nothing before something is typed.
    ///
    /// # Errors
    /// When the model has no such stream, or another channel uses it.
    pub fn open_channel(&mut self, stream: StreamName) -> Result<ChannelId, StreamError> {
        stream.check(self.machine.model)?;
        let channel = self.machine.terminal.open(stream)?;
        self.machine.flag_echo(channel);
        Ok(channel)
    }

    /// Closes a channel. What it was executing is given up, programs go on.
    pub fn close_channel(&mut self, channel: ChannelId) {
        self.machine.terminal.close(channel);
    }

    /// Bytes have been typed. Ctrl-X, Ctrl-Y and Ctrl-Z act at once, in the middle of a line too; the rest is read in the next slice of
    /// communication, or by programs while they have the stream open, or while the channel listens to a program.
    pub fn receive(&mut self, channel: ChannelId, bytes: &[u8]) {
        for byte in bytes {
            if let Some(key) = Key::of(*byte) {
                self.press(key);
            } else {
                self.take_in(channel, *byte);
            }
        }
    }

    /// What a channel has sent since this was asked last. Text is Latin-1.
    pub fn take_output(&mut self, channel: ChannelId) -> Vec<u8> {
        self.machine.terminal.get_mut(channel).map(Channel::take_output).unwrap_or_default()
    }

    /// What a channel is doing; one that is closed is ready and has no prompt.
    pub fn prompt_state(&self, channel: ChannelId) -> PromptState {
        self.machine.terminal.get(channel).map_or_else(|| PromptState::Ready(String::new()), Channel::state)
    }

    /// What passes through a channel, for a driver that has to hold back whoever types there or what is sent. All zero for one that is
    /// closed.
    pub fn traffic(&self, channel: ChannelId) -> Traffic {
        let Some(channel) = self.machine.terminal.get(channel) else { return Traffic::default() };
        let for_programs = self.machine.streams.unread(Port::Stream(channel.stream));
        Traffic { unread: channel.unread() + for_programs, unsent: channel.unsent(), answering: channel.is_answering() }
    }

    /// The level of a channel; the system level for one that is closed.
    pub fn level(&self, channel: ChannelId) -> Level {
        self.machine.terminal.get(channel).map_or(Level::System, |channel| channel.level)
    }

    /// Names that can be typed at a level beside the words of the language: aliases, and the axes of the program.
    pub fn names_at(&self, level: Level) -> Vec<String> {
        let mut names: Vec<String> = self.aliases.known().map(|alias| alias.name.clone()).collect();
        if let Level::Program(number) = level
            && let Some(attachment) = self.machine.attachments.get(usize::from(number))
        {
            names.extend(attachment.names.iter().flatten().map(ToString::to_string));
        }
        names
    }

    /// When the channels need their next slice.
    pub(super) fn channel_demand(&self) -> Demand {
        let mut next = None;
        for channel in self.machine.terminal.channels() {
            match self.demand_of(channel) {
                Demand::Now => return Demand::Now,
                Demand::At(tick) => next = Some(next.map_or(tick, |next: u64| next.min(tick))),
                Demand::Nothing => {}
            }
        }
        next.map_or(Demand::Nothing, Demand::At)
    }

    fn demand_of(&self, channel: &Channel) -> Demand {
        match (&channel.typed, channel.listening) {
            (Some(_), _) | (None, Some(_)) if channel.escape_waits() => Demand::Now,
            (Some(typed), _) if typed.waiting => {
                let changed = self.changes.any_since(typed.waits_for, typed.waited_at);
                match typed.release.into_iter().chain(typed.alarm.ticks()).min() {
                    Some(tick) if typed.release.is_some() || !changed => Demand::At(tick),
                    None if !changed => Demand::Nothing,
                    _ => Demand::Now,
                }
            }
            (None, Some(task)) if self.program(task).is_going() => Demand::Nothing,
            (None, None) if !channel.has_input() => Demand::Nothing,
            _ => Demand::Now,
        }
    }

    /// A slice of communication.
    pub(super) fn communicate(&mut self, observer: &mut dyn Observer) {
        for id in self.machine.terminal.ids() {
            self.serve_channel(id, observer);
        }
        self.show_scripted(observer);
    }

    fn serve_channel(&mut self, id: ChannelId, observer: &mut dyn Observer) {
        self.with_channel(id, |channel| {
            // Nobody could end a wait for what never comes, or a loop, in another way.
            if channel.typed.is_some() && channel.skip_to_escape() {
                channel.typed = Some(Typed::default());
            }
        });
        for _ in 0..STATEMENTS_PER_SLICE {
            if !self.serve(id, observer) {
                break;
            }
        }
    }

    /// Does the next thing that a channel has to do. False when there is nothing more for now.
    fn serve(&mut self, id: ChannelId, observer: &mut dyn Observer) -> bool {
        let Some(channel) = self.machine.terminal.get_mut(id) else { return false };
        if let Some(typed) = channel.typed.take() {
            return self.execute_typed(id, typed, observer);
        }
        if let Some(task) = channel.listening {
            let left = channel.skip_to_escape();
            if !left && self.program(task).is_going() {
                return false;
            }
            self.with_channel(id, Channel::stop_listening);
            return true;
        }
        if let Some(stream) = channel.talking {
            return self.relay(id, stream, observer);
        }
        let Some(line) = channel.next_line() else { return false };
        let typed = match line {
            Ok(line) => self.read_line(id, &line),
            Err(refusal) => self.refused_line(id, refusal),
        };
        self.execute_typed(id, typed, observer)
    }

    fn with_channel(&mut self, id: ChannelId, change: impl FnOnce(&mut Channel)) {
        if let Some(channel) = self.machine.terminal.get_mut(id) {
            change(channel);
        }
    }

    /// A line that was not taken. A text that is entered would lack it, so it is not stored either.
    fn refused_line(&mut self, id: ChannelId, refusal: &str) -> Typed {
        self.with_channel(id, |channel| {
            if let Some(entry) = &mut channel.entry {
                entry.discarded = true;
            }
        });
        Typed { pieces: [Piece::Refuse(refusal.to_owned())].into(), ..Typed::default() }
    }

    /// What is to be done for a line: it goes into the text that is entered, or it is executed.
    fn read_line(&mut self, id: ChannelId, line: &str) -> Typed {
        let entry = self.machine.terminal.get_mut(id).and_then(|channel| channel.entry.take());
        let pieces = match entry {
            Some(entry) => self.enter_line(id, entry, line),
            None => self.pieces(id, line),
        };
        Typed { pieces, ..Typed::default() }
    }

    fn pieces(&mut self, id: ChannelId, line: &str) -> VecDeque<Piece> {
        let level = self.level(id);
        let Machine { model, memory, .. } = &self.machine;
        Reader { aliases: &mut self.aliases, model, level, memory, load: self.load }.read(line)
    }

    /// Adds a line to the text that is entered. Gives what is to be done behind its `ENDP`.
    fn enter_line(&mut self, id: ChannelId, mut entry: Entry, line: &str) -> VecDeque<Piece> {
        let tree = acrc_syntax::parse(line);
        let end = tree.statements().iter().find(|statement| is_end(statement)).map(|statement| statement.span);
        let number = tree.lines().first().and_then(|line| line.number);
        let start = number.map_or(0, |number| number.span.end as usize);
        let text = line.get(start..end.map_or(line.len(), |end| end.start as usize)).unwrap_or_default();
        let text = text.trim_end_matches([' ', '\t', ':']).trim_start();
        if !text.is_empty() && !text.starts_with('\'') && !entry.discarded {
            entry.text.enter(number.map(|number| number.value), text, self.space_at(entry.level));
        }
        let Some(end) = end else {
            self.with_channel(id, |channel| channel.entry = Some(entry));
            return VecDeque::new();
        };
        let refusal = self.finish_entry(entry).err().map(|error| Piece::Refuse(error.to_string()));
        let behind = self.pieces(id, line.get(end.end as usize..).unwrap_or_default());
        refusal.into_iter().chain(behind).collect()
    }

    /// Executes the next statement of a typed line; behind the last one comes the prompt. False when the line has to wait, or when there is
    /// nothing more.
    fn execute_typed(&mut self, id: ChannelId, mut typed: Typed, observer: &mut dyn Observer) -> bool {
        let Some(level) = self.machine.terminal.get(id).map(|channel| channel.level) else { return false };
        let done = match typed.pieces.front() {
            None => true,
            Some(Piece::Run(_)) => self.run_typed(id, &mut typed, observer),
            Some(Piece::Refuse(text)) => {
                self.say(id, text);
                true
            }
            Some(Piece::Store(number, line)) => {
                if let Err(error) = self.store_line(level, *number, line) {
                    self.say(id, &error.to_string());
                }
                true
            }
            Some(Piece::Read(rest)) => {
                let pieces = self.pieces(id, rest);
                typed.pieces.extend(pieces);
                true
            }
            Some(Piece::Enter(first)) => {
                let behind = self.enter(id, level, first);
                typed.pieces.extend(behind);
                true
            }
        };
        if done {
            typed.pieces.pop_front();
            typed.frame.reset();
        }
        let Some(channel) = self.machine.terminal.get_mut(id) else { return false };
        if typed.pieces.is_empty() {
            if !channel.is_away() {
                channel.send_prompt();
            }
            return true;
        }
        let waiting = typed.waiting;
        channel.typed = Some(typed);
        !waiting
    }

    /// `PROGRAM`: what is typed from now on is stored, beginning with what follows on the line. Gives what is to be done behind its `ENDP`.
    fn enter(&mut self, id: ChannelId, level: Level, first: &str) -> VecDeque<Piece> {
        let (entry, allowed) = self.begin_entry(level);
        if let Err(error) = allowed {
            self.say(id, &error.to_string());
        }
        self.enter_line(id, entry, first)
    }

    /// One statement of the first piece of a typed line. True when the piece is done.
    fn run_typed(&mut self, id: ChannelId, typed: &mut Typed, observer: &mut dyn Observer) -> bool {
        let Some(Piece::Run(code)) = typed.pieces.front() else { return true };
        let Some(channel) = self.machine.terminal.get(id) else { return true };
        self.machine.level = channel.level;
        let statement = Immediate {
            code,
            frame: &mut typed.frame,
            release: &mut typed.release,
            alarm: &mut typed.alarm,
            spare: &mut self.boot.locals,
            channel: Some(id),
        };
        let dimensions = statement.spare.dimensions().len();
        let (run, footprint) = statement.run(&mut self.machine, &mut self.programs, &mut self.plcs, observer);
        let level = self.machine.level;
        typed.waiting = run.stop == Stop::Blocked;
        if run.statements > 0 || run.stop != Stop::Blocked {
            self.changes.everywhere();
        }
        (typed.waited_at, typed.waits_for) = (self.changes.count(), footprint.reads);
        if let Stop::Fault(fault) = &run.stop {
            typed.frame.skip_statement(code);
            if belongs_elsewhere(&fault.kind, level) {
                self.say(id, message::UNKNOWN_COMMAND.text());
            } else {
                self.say(id, &fault.to_string());
            }
        } else if self.boot.locals.dimensions().len() > dimensions {
            // A block without elements needs no memory, and there is none to give at the system prompt either.
            self.boot.locals = Locals::new(0);
            self.say(id, message::UNKNOWN_COMMAND.text());
        }
        let done = run.stop == Stop::Ended;
        self.with_channel(id, |channel| channel.level = level);
        self.apply_requests(observer);
        done
    }

    /// Answers with a line of text.
    fn say(&mut self, id: ChannelId, text: &str) {
        self.with_channel(id, |channel| channel.send_line(known_words(text)));
    }

    /// A character that acts at once (guide, "To Stop All Motion Immediately").
    fn press(&mut self, key: Key) {
        self.changes.everywhere();
        for axis in 0..u32::from(self.machine.model.axes) {
            self.machine.flags.set_law(law::KILL_ALL_MOTION_REQUEST, axis, key != Key::ClearKill);
            if key == Key::KillAndDisable {
                self.machine.set_drive(axis as u8, false);
            }
        }
        if key == Key::ClearKill {
            for master in 0..u32::from(self.machine.model.masters) {
                self.machine.flags.set_law(law::KILL_ALL_MOVES, master, false);
            }
            self.machine.update_kills();
            return;
        }
        self.machine.update_kills();
        let plcs = self.plcs.iter_mut().map(|plc| &mut plc.program);
        for program in self.programs.iter_mut().chain(plcs).filter(|program| program.is_going()) {
            program.stop(State::Ended);
        }
        for master in 0..usize::from(self.machine.model.masters) {
            self.machine.order(master, Order::Kill);
        }
        self.update_program_flags();
    }
}

/// Whether a fault only shows that a statement is none of a level: there are local variables to dimension where programs are, and jumps where
/// there are lines to jump to.
fn belongs_elsewhere(fault: &FaultKind, level: Level) -> bool {
    match fault {
        FaultKind::OutOfMemory { .. } => level == Level::System,
        FaultKind::NoSuchLine { .. }
        | FaultKind::GosubTooDeep { .. }
        | FaultKind::ReturnWithoutGosub
        | FaultKind::NextWithoutFor
        | FaultKind::BreakOutsideLoop => !matches!(level, Level::Program(_)),
        _ => false,
    }
}

/// Whether a statement ends the text that is entered.
fn is_end(statement: &Statement) -> bool {
    matches!(&statement.kind, StatementKind::Command(command) if command.id == command::ENDP)
}
