//! One program slot: stored text, variables, place of execution.

use acrc_image::Unit;
use acrc_vm::{Code, Frame, Locals};

use crate::streams::Port;
use crate::terminal::StoredText;

/// Where a program is in its life.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum State {
    /// Has not been started.
    #[default]
    Idle,
    /// Runs.
    Running,
    /// Runs, and waits at its present statement (`DWL`, `INH`, a move that finds the queue full).
    Waiting,
    /// Suspended by `PAUSE`.
    Paused,
    /// Reached its end, or was halted.
    Ended,
    /// Stopped at a run-time error.
    Fault,
}

impl State {
    /// The word of the reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Idle => "idle",
            Self::Running => "running",
            Self::Waiting => "waiting",
            Self::Paused => "paused",
            Self::Ended => "ended",
            Self::Fault => "fault",
        }
    }

    /// The scheduler gives it slices.
    pub(crate) fn is_active(self) -> bool {
        matches!(self, Self::Running | Self::Waiting)
    }
}

/// When a command that waits for a parameter looks at it although nothing has happened (`IHPOS`).
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Watch {
    /// Tick at which it gives up.
    pub(crate) timeout: Option<u64>,
    /// Tick at which a parameter that follows the time may have got there.
    pub(crate) look: Option<u64>,
}

impl Watch {
    /// The ticks at which something can happen.
    pub(crate) fn ticks(&self) -> impl Iterator<Item = u64> {
        self.timeout.into_iter().chain(self.look)
    }
}

/// A program slot.
#[derive(Debug)]
pub(crate) struct Program {
    /// Bytes of its stored text.
    pub(crate) text_bytes: u64,
    /// Its stored text.
    pub(crate) unit: Option<Unit>,
    /// Its stored text, decoded; `None` when it cannot be executed.
    pub(crate) code: Option<Code>,
    /// The lines of its text after they were edited, until they are compiled; `unit` is what they were before.
    pub(crate) edited: Option<StoredText>,
    pub(crate) frame: Frame,
    pub(crate) locals: Locals,
    pub(crate) state: State,
    /// Tick at which its dwell ends.
    pub(crate) release: Option<u64>,
    pub(crate) watch: Watch,
    /// Where it waits for characters.
    pub(crate) awaits: Option<Port>,
    /// The machine's count of changes when the program last found that it must wait.
    pub(crate) waited_at: u64,
    pub(crate) statements: u64,
}

impl Program {
    /// An empty slot.
    pub(crate) fn new() -> Self {
        Self {
            text_bytes: 0,
            unit: None,
            code: None,
            edited: None,
            frame: Frame::new(),
            locals: Locals::new(0),
            state: State::Idle,
            release: None,
            watch: Watch::default(),
            awaits: None,
            waited_at: 0,
            statements: 0,
        }
    }

    /// Whether it has text.
    pub(crate) fn has_text(&self) -> bool {
        self.edited.as_ref().map_or(self.unit.is_some(), |text| !text.is_empty())
    }

    /// It has been started and has not ended, so that its text cannot be changed.
    pub(crate) fn is_going(&self) -> bool {
        self.state.is_active() || self.state == State::Paused
    }

    /// Gives its variables what its space has left beside its text.
    pub(crate) fn set_space(&mut self, bytes: u64) {
        self.locals.set_limit(bytes.saturating_sub(self.text_bytes));
    }

    /// Starts it at its first statement.
    pub(crate) fn start(&mut self) {
        self.frame.reset();
        self.release = None;
        self.watch = Watch::default();
        self.state = State::Running;
    }

    /// It waits for a time, or for something that has not happened since: `changes` counts what could.
    pub(crate) fn waits(&self, changes: u64) -> bool {
        self.state == State::Waiting && (self.release.is_some() || self.waited_at == changes)
    }

    /// Stops it for good.
    pub(crate) fn stop(&mut self, state: State) {
        self.release = None;
        self.watch = Watch::default();
        self.state = state;
    }
}
