//! A coordinated-move profiler (the guide's "Coordinated Moves Profiler" and the commands of its groups Interpolation,
//! Velocity Profile and Transformation).
//!
//! A [`Master`] runs one move at a time and holds those that wait. A move begins with the velocity its predecessor
//! hands over if it was waiting when that ended, and from rest otherwise. Time passes in ticks; a move that ends inside
//! a tick gives the rest of the tick to its successor, so blending does not depend on the tick.
//!
//! All axes of a move share one parameter, the part of its path that is covered, whatever each of them does: they start
//! and end in the same tick. Velocities and ramps are along the path.
//!
//! Blending keeps the velocity along the path. Where two moves meet at an angle, the velocities of their axes jump.

mod curve;
mod flow;
mod frame;
mod interrupt;
mod lay;
mod look;
mod moves;
mod path;
mod queue;
mod running;
mod settings;
mod span;
mod spline;
mod tangent;
mod transformation;
mod winding;

pub use curve::{Arc, Sine, SpaceArc, Turn};
pub use flow::Advanced;
pub use interrupt::start_together;
pub use look::Lookahead;
pub use moves::{Move, MoveSettings, Override, PushError, SettingError, Target};
pub use span::Span;
pub use spline::{ControlPoint, CurveBuilder, CurveError};
pub use tangent::Tangent;

use interrupt::Detour;
use lay::Ground;
use look::NO_HEADING;
use path::Path;
use queue::{Queue, Queued};
use running::Running;

use crate::profile::{Profile, State};
use crate::timer::Timer;

/// Number of axis slots of a master.
pub const AXES: usize = 16;

/// What the moves are to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Flow {
    Run,
    Hold,
    Stop,
}

/// Whether a master follows its moves or is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HoldState {
    /// Not held.
    Released,
    /// Slowing down to rest.
    Feedholding,
    /// At rest until cycle start.
    InFeedhold,
}

/// What the velocity along the path is doing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// It rises.
    Accelerating,
    /// It falls, but not toward the end of the move.
    Decelerating,
    /// It falls toward the end of the move.
    Stopping,
    /// It stays, at zero if nothing moves. So it does for a moment where an S-curve bends without a straight part.
    Steady,
}

/// The velocity a move ended with when no other was waiting. One queued in the same tick still takes it over.
#[derive(Clone, Copy, Debug)]
struct Handover {
    velocity: f64,
    /// Time since the end, s.
    since: f64,
}

/// A coordinated-move profiler for up to [`AXES`] axes.
#[derive(Clone, Debug)]
pub struct Master {
    /// Where the axes are while no move runs, u.
    positions: [f64; AXES],
    /// Where the last queued move ends, u.
    targets: [f64; AXES],
    ground: Ground,
    feedrate_override: f64,
    rapid_override: f64,
    queue: Queue,
    running: Option<Running>,
    flow: Flow,
    handover: Option<Handover>,
    /// Where the axes go on to when the running move has been cut short.
    detour: Option<Detour>,
    /// Whether moves begin only together with those of other masters.
    synchronised: bool,
    lookahead: Option<Lookahead>,
    /// The direction in which the last queued move ends.
    heading: [f64; AXES],
    /// Moves begun since the last tick.
    started: u32,
}

impl Master {
    /// A master at rest at zero, with room for `queue_capacity` waiting moves besides the running one.
    pub fn new(queue_capacity: usize) -> Self {
        Self {
            positions: [0.0; AXES],
            targets: [0.0; AXES],
            ground: Ground::DEFAULT,
            feedrate_override: 1.0,
            rapid_override: 1.0,
            queue: Queue::new(queue_capacity),
            running: None,
            flow: Flow::Run,
            handover: None,
            detour: None,
            synchronised: false,
            lookahead: None,
            heading: NO_HEADING,
            started: 0,
        }
    }

    /// Whether [`Master::push`] has room for a move, and knows where it begins: not behind a move that may yet be cut
    /// short.
    pub fn can_accept(&self) -> bool {
        self.flow != Flow::Stop && !self.end_is_open() && (self.is_idle() || self.queue.len() < self.queue.capacity())
    }

    /// Whether a move that is queued now is the next to begin.
    fn is_idle(&self) -> bool {
        self.flow == Flow::Run && self.running.is_none() && self.queue.len() == 0
    }

    /// Whether the last move may be cut short.
    fn end_is_open(&self) -> bool {
        match self.queue.last() {
            Some(last) => last.interrupt.is_some(),
            None => self.running.as_ref().is_some_and(|running| running.interrupt().is_some()),
        }
    }

    /// Queues a move; if nothing is running or waiting, it begins now.
    ///
    /// Its path is laid from the end of the move queued before it, with the weights of now. A move without
    /// displacement takes no time and ends in the next tick.
    pub fn push(&mut self, command: &Move) -> Result<(), PushError> {
        self.room(command)?;
        let path = self.ground.lay(&self.targets, command)?;
        self.queue_along(&path, command);
        Ok(())
    }

    /// Queues a move along a piece of a curve (SPLINE, NURB). The targets of the move are not looked at.
    ///
    /// Where another piece of the curve follows, the move hands its velocity over, as without a stop ramp. A curve that
    /// does not begin where the axes are begins with a jump.
    pub fn push_span(&mut self, command: &Move, span: &Span) -> Result<(), PushError> {
        self.room(command)?;
        let path = self.ground.lay_span(&self.targets, span)?;
        self.queue_along(&path, command);
        Ok(())
    }

    /// Checks that a move can be queued, and the values of its profile.
    fn room(&self, command: &Move) -> Result<(), PushError> {
        if self.flow == Flow::Stop {
            return Err(PushError::Stopping);
        }
        if self.end_is_open() {
            return Err(PushError::OpenEnd);
        }
        let waits = !self.is_idle() || !self.begins_by_itself(command.gate);
        if waits && self.queue.len() >= self.queue.capacity() {
            return Err(PushError::Full);
        }
        Ok(command.settings.validate()?)
    }

    fn queue_along(&mut self, path: &Path, command: &Move) {
        self.targets = *path.end();
        let queued = Queued { corner: self.corner(path), ..Queued::new(path, command) };
        self.heading = path.heading(true, &self.ground.weights);
        if self.is_idle() && self.begins_by_itself(command.gate) {
            self.begin_with_handover(&queued);
        } else {
            self.queue.push(&queued);
        }
        self.look_ahead(false);
    }

    /// Begins a move with the velocity and the acceleration along the path of `state`.
    fn begin(&mut self, queued: &Queued, state: State, timer: Timer) {
        self.running = Some(Running::begin(queued, state, self.factor(queued.override_by), timer));
        self.started += 1;
    }

    /// Begins a move with the velocity of one that has ended in this tick, or from rest.
    fn begin_with_handover(&mut self, queued: &Queued) {
        let (velocity, since) = self.handover.take().map_or((0.0, 0.0), |h| (h.velocity, h.since));
        self.begin(queued, State { velocity, ..State::default() }, Timer::carrying(since));
    }

    /// Whether a move is running or waiting, held or not.
    pub fn in_motion(&self) -> bool {
        self.running.is_some() || self.queue.len() > 0
    }

    /// What the velocity along the path is doing.
    pub fn phase(&self) -> Phase {
        self.running.as_ref().map_or(Phase::Steady, Running::phase)
    }

    /// Whether the master is held.
    pub fn hold_state(&self) -> HoldState {
        match self.flow {
            Flow::Hold if self.running.as_ref().is_none_or(Running::stands) => HoldState::InFeedhold,
            Flow::Hold => HoldState::Feedholding,
            Flow::Run | Flow::Stop => HoldState::Released,
        }
    }

    /// Number of moves that wait.
    pub fn waiting(&self) -> usize {
        self.queue.len()
    }

    /// Position of a slot, u. A slot of [`AXES`] or above reads as zero, here and below.
    pub fn position(&self, slot: usize) -> f64 {
        match &self.running {
            Some(running) => running.position(slot),
            None => self.positions.get(slot).copied().unwrap_or(0.0),
        }
    }

    /// Where the last queued move takes a slot, u.
    pub fn target(&self, slot: usize) -> f64 {
        self.targets.get(slot).copied().unwrap_or(0.0)
    }

    /// Velocity of a slot, u/s.
    pub fn velocity(&self, slot: usize) -> f64 {
        self.running.as_ref().map_or(0.0, |running| running.velocity(slot))
    }

    /// Acceleration of a slot, u/s².
    pub fn acceleration(&self, slot: usize) -> f64 {
        self.running.as_ref().map_or(0.0, |running| running.acceleration(slot))
    }

    /// State along the path of the running move; all zeros without one.
    pub fn path_state(&self) -> State {
        self.running.as_ref().map_or_else(State::default, |running| *running.state())
    }

    /// Velocity along the path, u/s.
    pub fn vector_velocity(&self) -> f64 {
        self.path_state().velocity
    }

    /// Acceleration along the path, u/s²; negative while slowing down.
    pub fn vector_acceleration(&self) -> f64 {
        self.path_state().acceleration
    }

    /// The profile being followed: that of the whole move, or of its rest since the last change of feedrate or hold.
    pub fn profile(&self) -> Option<&Profile> {
        self.running.as_ref().map(Running::profile)
    }
}
