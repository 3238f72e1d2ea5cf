//! A coordinated-move profiler (the guide's "Coordinated Moves Profiler", FOV, VECDEF, VECTOR, feedhold and cycle start,
//! Kill All Moves, Stop All Moves).
//!
//! A [`Master`] runs one move at a time and holds those that wait. A move begins with the velocity its predecessor
//! hands over if it was waiting when that ended, and from rest otherwise. Time passes in ticks; a move that ends inside
//! a tick gives the rest of the tick to its successor, so blending does not depend on the tick.
//!
//! Blending keeps the velocity along the path. Where two moves meet at an angle, the velocities of their axes jump.

mod moves;
mod path;
mod queue;
mod running;
mod settings;
mod timer;

pub use moves::{Move, MoveSettings, PushError, SettingError, Target};

use path::Path;
use queue::{Queue, Queued};
use running::Running;
use timer::Timer;

use crate::profile::{Profile, State};

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

/// What happened in a tick.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Advanced {
    /// Moves that began, including those that began when they were queued since the tick before.
    pub started: u32,
    /// Moves that ended.
    pub completed: u32,
    /// A stop has come to its end and every move was dropped.
    pub stopped: bool,
    /// Velocity along the path, u/s, with which a move ended while none was waiting: it dropped to zero at once. Zero if
    /// none did. Known one tick late, since a successor may still be queued in the same tick.
    pub dropped_velocity: f64,
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
    weights: [f64; AXES],
    vector: f64,
    feedrate_override: f64,
    queue: Queue,
    running: Option<Running>,
    flow: Flow,
    handover: Option<Handover>,
    /// Moves begun since the last tick.
    started: u32,
}

impl Master {
    /// A master at rest at zero, with room for `queue_capacity` waiting moves besides the running one.
    pub fn new(queue_capacity: usize) -> Self {
        Self {
            positions: [0.0; AXES],
            targets: [0.0; AXES],
            weights: [1.0; AXES],
            vector: 0.0,
            feedrate_override: 1.0,
            queue: Queue::new(queue_capacity),
            running: None,
            flow: Flow::Run,
            handover: None,
            started: 0,
        }
    }

    /// Whether [`Master::push`] has room for a move.
    pub fn can_accept(&self) -> bool {
        self.flow != Flow::Stop && (self.starts_at_once() || self.queue.len() < self.queue.capacity())
    }

    fn starts_at_once(&self) -> bool {
        self.flow == Flow::Run && self.running.is_none() && self.queue.len() == 0
    }

    /// Queues a move; if nothing is running or waiting, it begins now.
    ///
    /// Its path is laid from the end of the move queued before it, with the weights of now. A move without
    /// displacement takes no time and ends in the next tick.
    pub fn push(&mut self, command: &Move) -> Result<(), PushError> {
        if self.flow == Flow::Stop {
            return Err(PushError::Stopping);
        }
        if !self.can_accept() {
            return Err(PushError::Full);
        }
        command.settings.validate()?;
        let path = Path::new(&self.targets, &command.targets, &self.weights, self.vector)?;
        self.targets = *path.end();
        let queued = Queued { path, settings: command.settings };
        if self.starts_at_once() {
            let (velocity, since) = self.handover.take().map_or((0.0, 0.0), |h| (h.velocity, h.since));
            self.begin(&queued, velocity, Timer::carrying(since));
        } else {
            self.queue.push(&queued);
        }
        Ok(())
    }

    fn begin(&mut self, queued: &Queued, velocity: f64, timer: Timer) {
        self.running = Some(Running::begin(queued, velocity, self.factor(), timer));
        self.started += 1;
    }

    /// What the target velocity is multiplied by: zero brings the move to rest.
    fn factor(&self) -> f64 {
        match self.flow {
            Flow::Run => self.feedrate_override,
            Flow::Hold | Flow::Stop => 0.0,
        }
    }

    /// Lets one tick of `dt` seconds pass. Nothing passes if `dt` is not a positive finite number.
    pub fn advance(&mut self, dt: f64) -> Advanced {
        self.advance_ticks(1, dt)
    }

    /// Lets `ticks` ticks of `dt` seconds pass, with the same result, to the bit, as one after the other. The time it
    /// takes depends on the number of moves that end, not on the number of ticks.
    pub fn advance_ticks(&mut self, ticks: u64, dt: f64) -> Advanced {
        let mut report = Advanced::default();
        if ticks == 0 || !(dt > 0.0 && dt.is_finite()) {
            return report;
        }
        if let Some(handover) = self.handover.take() {
            report.dropped_velocity = handover.velocity;
        }
        if let Some(running) = &mut self.running {
            running.advance(ticks, dt);
        }
        while let Some((timer, running)) = self.running.as_ref().and_then(|r| Some((r.past_end()?, r))) {
            let velocity = running.profile().end_velocity();
            self.positions = *running.path().end();
            self.running = None;
            report.completed += 1;
            self.hand_over(velocity, timer, &mut report);
        }
        if let Some(running) = &mut self.running {
            running.refresh();
        }
        if self.flow == Flow::Stop && self.running.as_ref().is_none_or(Running::stands) {
            self.kill();
            report.stopped = true;
        }
        report.started = core::mem::take(&mut self.started);
        report
    }

    /// A move ended: begins the next one, or notes the velocity it ended with.
    fn hand_over(&mut self, velocity: f64, timer: Timer, report: &mut Advanced) {
        let goes_on = self.flow == Flow::Run || velocity > 0.0;
        if goes_on && let Some(next) = self.queue.pop() {
            self.begin(&next, velocity, timer);
        } else if velocity > 0.0 {
            match timer.within_tick() {
                Some(since) if self.flow == Flow::Run => self.handover = Some(Handover { velocity, since }),
                _ => report.dropped_velocity = velocity,
            }
        }
    }

    /// Time until the running move ends or comes to rest in a hold, s. `None` if nothing will change by itself.
    pub fn next_event(&self) -> Option<f64> {
        self.running.as_ref().and_then(Running::remaining)
    }

    /// Brings the move to rest along its path with its deceleration ramp, and keeps it there until
    /// [`Master::cycle_start`]. If its way is too short for that, it ends as it would have, and if that is not at rest
    /// the moves that wait go on slowing down. Moves queued meanwhile wait. An S-curve changes as described at
    /// [`Master::set_feedrate_override`].
    pub fn feedhold(&mut self) {
        if self.flow == Flow::Run {
            self.flow = Flow::Hold;
            self.replan();
        }
    }

    /// Goes on after a feedhold, with the acceleration ramp.
    pub fn cycle_start(&mut self) {
        if self.flow != Flow::Hold {
            return;
        }
        self.flow = Flow::Run;
        if self.running.is_some() {
            self.replan();
        } else if let Some(next) = self.queue.pop() {
            self.begin(&next, 0.0, Timer::default());
        }
    }

    /// Drops every move and releases a hold. The axes stop where they are, without a ramp.
    pub fn kill(&mut self) {
        let mut positions = self.positions;
        for (slot, position) in positions.iter_mut().enumerate() {
            *position = self.position(slot);
        }
        self.positions = positions;
        self.targets = positions;
        self.running = None;
        self.queue.clear();
        self.handover = None;
        self.flow = Flow::Run;
    }

    /// Brings the move to rest as [`Master::feedhold`] does, then drops every move. [`Advanced::stopped`] tells when.
    pub fn stop(&mut self) {
        let was = core::mem::replace(&mut self.flow, Flow::Stop);
        if was == Flow::Run {
            self.replan();
        }
    }

    fn replan(&mut self) {
        let factor = self.factor();
        if let Some(running) = &mut self.running {
            running.replan(factor);
        }
    }

    /// Whether a move is running or waiting, held or not.
    pub fn in_motion(&self) -> bool {
        self.running.is_some() || self.queue.len() > 0
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
            Some(running) => running.path().position(slot, running.state().position),
            None => self.positions.get(slot).copied().unwrap_or(0.0),
        }
    }

    /// Where the last queued move takes a slot, u.
    pub fn target(&self, slot: usize) -> f64 {
        self.targets.get(slot).copied().unwrap_or(0.0)
    }

    /// Velocity of a slot, u/s.
    pub fn velocity(&self, slot: usize) -> f64 {
        self.running.as_ref().map_or(0.0, |r| r.path().scaled(slot, r.state().velocity))
    }

    /// Acceleration of a slot, u/s².
    pub fn acceleration(&self, slot: usize) -> f64 {
        self.running.as_ref().map_or(0.0, |r| r.path().scaled(slot, r.state().acceleration))
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
