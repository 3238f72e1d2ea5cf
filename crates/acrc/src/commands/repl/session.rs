//! A controller, the channel at which it is spoken to, and the pace of its time.

use std::time::{Duration, Instant};

use acrc_controller::nonvolatile::Saved;
use acrc_controller::world::WorldEvent;
use acrc_controller::{ChannelId, Controller, FaultReport, Observer, PromptState, Sent, StreamName, View};
use acrc_syntax::units::Level;

use crate::cli::Speed;
use crate::commands::nonvolatile::State;
use crate::commands::virtual_controller::unseen;
use crate::output::Terminal;

/// Wall time that is spent at once on a controller that is to run as fast as it can.
const BURST: Duration = Duration::from_millis(20);
/// Virtual milliseconds between two looks at the clock on the wall.
const STRIDE_MS: f64 = 50.0;

/// A session.
pub(super) struct Session {
    pub(super) controller: Controller,
    channel: ChannelId,
    speed: Speed,
    /// When the time of the wall and of the controller were the same.
    since: (Instant, f64),
    notes: Notes,
    terminal: Terminal,
}

impl Session {
    /// At a channel that was opened on this stream.
    pub(super) fn new(
        controller: Controller,
        (channel, stream): (ChannelId, StreamName),
        speed: Speed,
        state: Option<State>,
        terminal: Terminal,
    ) -> Self {
        let notes = Notes { stream, state, failure: None, list: Vec::new() };
        Self { controller, channel, speed, since: (Instant::now(), 0.0), notes, terminal }
    }

    /// Executes the setup code.
    pub(super) fn power_up(&mut self) {
        self.pass(0.0);
        self.since = (Instant::now(), self.controller.seconds());
    }

    /// Switches the controller off: what it keeps without power is saved.
    pub(super) fn power_off(mut self) -> anyhow::Result<()> {
        if let Some(state) = &mut self.notes.state {
            state.save(&self.controller.saved())?;
        }
        self.notes.failure.map_or(Ok(()), Err)
    }

    pub(super) fn speed(&self) -> Speed {
        self.speed
    }

    pub(super) fn state(&self) -> PromptState {
        self.controller.prompt_state(self.channel)
    }

    pub(super) fn level(&self) -> Level {
        self.controller.level(self.channel)
    }

    /// Types bytes.
    pub(super) fn send(&mut self, bytes: &[u8]) {
        self.controller.receive(self.channel, bytes);
    }

    /// What the controller has answered.
    pub(super) fn read(&mut self) -> Vec<u8> {
        self.controller.take_output(self.channel)
    }

    /// Lets the controller catch up with the time of the wall, or work for a moment.
    pub(super) fn catch_up(&mut self) {
        let begun = Instant::now();
        match self.speed {
            Speed::Factor(factor) => {
                let (since, seconds) = self.since;
                let now = seconds + since.elapsed().as_secs_f64() * factor;
                self.pass(now - self.controller.seconds());
            }
            Speed::Max => {
                while begun.elapsed() < BURST && !(self.is_ready() && self.controller.is_idle()) {
                    self.pass(STRIDE_MS / 1000.0);
                }
            }
        }
    }

    /// Lets the controller work until it has answered, for so many virtual seconds at most.
    pub(super) fn settle(&mut self, seconds: f64) {
        let end = self.controller.seconds() + seconds;
        while !self.is_ready() && self.controller.seconds() < end {
            self.step();
        }
    }

    fn is_ready(&self) -> bool {
        matches!(self.state(), PromptState::Ready(_))
    }

    /// Lets the shortest time pass.
    pub(super) fn step(&mut self) {
        self.controller.step(1, &mut self.notes);
        self.tell();
    }

    /// Lets virtual seconds pass.
    fn pass(&mut self, seconds: f64) {
        let period = self.controller.view().period();
        self.controller.step((seconds / period).max(0.0) as u64, &mut self.notes);
        self.tell();
    }

    /// Tells what no channel shows: setup code has no terminal, and a program without a listener is silent.
    fn tell(&mut self) {
        for note in std::mem::take(&mut self.notes.list) {
            // Standard error may be gone; the session goes on.
            crate::exit::note(&note, self.terminal);
        }
    }
}

/// What the run has told.
struct Notes {
    /// The stream at which the session is: it shows what is sent there.
    stream: StreamName,
    /// Where the controller's saved state goes.
    state: Option<State>,
    /// Why something could not be saved.
    failure: Option<anyhow::Error>,
    list: Vec<String>,
}

impl Observer for Notes {
    fn output(&mut self, sent: &Sent) {
        let own = self.stream;
        self.list.extend(unseen(sent, |stream| stream == own));
    }

    fn fault(&mut self, fault: &FaultReport) {
        if !fault.heard {
            self.list.push(fault.to_string());
        }
    }

    fn saved(&mut self, saved: &Saved) {
        let result = self.state.as_mut().map_or(Ok(()), |state| state.save(saved));
        if let Err(error) = result {
            self.list.push(format!("{error:#}"));
            self.failure.get_or_insert(error);
        }
    }

    fn event(&mut self, _: f64, _: &WorldEvent, _: &View) {}

    fn tick(&mut self, _: &View) {}

    fn watches_every_tick(&self) -> bool {
        false
    }
}
