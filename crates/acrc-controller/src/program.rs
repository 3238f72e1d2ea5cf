//! One program slot: stored text, variables, place of execution.

use acrc_image::Unit;
use acrc_vm::{Code, Frame, Locals, Location};

use crate::controller::boots;
use crate::footprint::{Changes, Places};
use crate::streams::Port;
use crate::terminal::StoredText;
use crate::watch::{Circle, Watch};

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

    /// It runs, if only to wait.
    pub(crate) fn is_active(self) -> bool {
        matches!(self, Self::Running | Self::Waiting)
    }
}

/// When a command that waits for a parameter looks at it although nothing has happened (`IHPOS`).
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Alarm {
    /// Tick at which it gives up.
    pub(crate) timeout: Option<u64>,
    /// Tick at which a parameter that follows the time may have got there.
    pub(crate) look: Option<u64>,
}

impl Alarm {
    /// The ticks at which something can happen.
    pub(crate) fn ticks(&self) -> impl Iterator<Item = u64> {
        self.timeout.into_iter().chain(self.look)
    }
}

/// How a program goes on from line to line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mode {
    /// By itself (`AUT`).
    Automatic,
    /// Block mode (`BLK`): it waits for `STEP` before each line.
    Block,
    /// Block mode, and the line that `STEP` has asked for is not over.
    Step,
}

/// A tick that does not come.
pub(crate) const NEVER: u64 = u64::MAX;

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
    pub(crate) alarm: Alarm,
    /// Where it waits for characters.
    pub(crate) awaits: Option<Port>,
    /// The count of changes when the program last found that it must wait.
    pub(crate) waited_at: u64,
    /// What its waiting depends on.
    pub(crate) waits_for: Places,
    pub(crate) statements: u64,
    /// Numbers of its lines, in order.
    pub(crate) numbers: Box<[u32]>,
    /// It begins with `PBOOT`.
    pub(crate) boots: bool,
    pub(crate) mode: Mode,
    /// `TRON`: the number of each line is shown.
    pub(crate) trace: bool,
    pub(crate) watch: Watch,
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
            alarm: Alarm::default(),
            awaits: None,
            waited_at: 0,
            waits_for: Places::ALL,
            statements: 0,
            numbers: Box::default(),
            boots: false,
            mode: Mode::Automatic,
            trace: false,
            watch: Watch::default(),
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

    /// Takes a text in the place of the one before; it still has to be made ready to run.
    pub(crate) fn keep(&mut self, unit: Unit) {
        let instructions = unit.decode().unwrap_or_default();
        self.numbers = acrc_image::list::lines(&instructions).map(|line| line.number).collect();
        self.boots = boots(&unit);
        self.text_bytes = u64::from(unit.memory());
        self.edited = None;
        self.code = None;
        self.unit = Some(unit);
    }

    /// Gives its variables what its space has left beside its text.
    pub(crate) fn set_space(&mut self, bytes: u64) {
        self.locals.set_limit(bytes.saturating_sub(self.text_bytes));
    }

    /// The scheduler gives it slices.
    pub(crate) fn is_active(&self) -> bool {
        self.state.is_active() && self.mode != Mode::Block
    }

    /// The tick before which a program that waits has nothing to look at as long as nothing changes; [`NEVER`] when only that ends its waiting.
    /// `None` when it does not wait.
    pub(crate) fn waits(&self, changes: &Changes) -> Option<u64> {
        let waits = self.state == State::Waiting
            && (self.release.is_some() || !changes.any_since(self.waits_for, self.waited_at));
        waits.then(|| self.release.into_iter().chain(self.alarm.ticks()).min().unwrap_or(NEVER))
    }

    /// It goes round in a circle, and nothing has changed since that was found.
    pub(crate) fn circle(&self, changes: &Changes) -> Option<Circle> {
        self.watch
            .circle(changes)
            .filter(|_| self.state == State::Running && !self.trace && self.mode == Mode::Automatic)
    }

    /// It has executed a line, or has to wait in it. False when it does not go on at once.
    pub(crate) fn line_is_over(&mut self) -> bool {
        if self.mode == Mode::Step && self.state != State::Waiting {
            self.mode = Mode::Block;
        }
        self.state == State::Running
    }

    /// The place of its next statement.
    pub(crate) fn location(&self) -> Location {
        self.code.as_ref().map_or_else(Location::default, |code| code.location(self.frame.pc()))
    }

    /// The number of its next line.
    pub(crate) fn line_number(&self) -> u32 {
        let line = self.location().line as usize;
        line.checked_sub(1).and_then(|line| self.numbers.get(line)).copied().unwrap_or(0)
    }

    /// Starts it at its first statement.
    pub(crate) fn start(&mut self) {
        self.frame.reset();
        self.release = None;
        self.alarm = Alarm::default();
        self.state = State::Running;
        self.watch = Watch::default();
        self.mode = if self.mode == Mode::Step { Mode::Block } else { self.mode };
    }

    /// Stops it for good.
    pub(crate) fn stop(&mut self, state: State) {
        self.release = None;
        self.alarm = Alarm::default();
        self.state = state;
    }
}
