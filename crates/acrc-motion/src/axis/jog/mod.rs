//! The jog profiler of one axis (the guide's "Jog Profiler": JOG ABS, INC, FWD, REV, OFF, VEL, ACC, DEC, JRK, SRC; JLM).
//!
//! Its output is the jog offset, which adds to the other profilers' positions. A jog is planned from the state the axis
//! is in, in closed form, and planned again whenever a command or a setting changes it: position and velocity never
//! jump (unless a ramp is switched off), and with a jerk neither does the acceleration.
//!
//! # Flags
//!
//! [`Jog::flags`] gives the jog flags of the axis' primary flags: bits 792 to 797 of axis 0, in the order of
//! [`JogFlags`].
//!
//! What the guide leaves open, and how it is read here, stands in `docs/fidelity.md`, "Jog, homing, limits and kills".

pub(super) mod ramp;
mod settings;
mod track;

pub use ramp::AxisState;
pub use settings::{JogError, JogSettings};

use ramp::Limits;
use track::Track;

use super::Side;
use crate::timer::Timer;
use crate::value::{InvalidValue, Quantity, finite, not_negative};

/// Which of the settings a continuous jog goes at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Pace {
    /// JOG VEL.
    Jog,
    /// JOG HOMVF.
    HomeFinal,
}

/// What the profiler is doing.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Goal {
    Rest,
    Position(f64),
    Run {
        side: Side,
        pace: Pace,
    },
    /// A stop with JOG DEC and JOG JRK, or with this ramp instead.
    Stop {
        ramp: Option<f64>,
    },
}

/// The jog flags, in the order of their bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "each is a flag of the controller")]
pub struct JogFlags {
    /// A jog is under way, its last ramp included (bit 792).
    pub active: bool,
    /// It goes in the negative direction (bit 793).
    pub negative: bool,
    /// It has reached its velocity (bit 794).
    pub at_speed: bool,
    /// It ramps down to rest (bit 795).
    pub stopping: bool,
    /// JOG FWD is in force (bit 796).
    pub forward: bool,
    /// JOG REV is in force (bit 797).
    pub reverse: bool,
}

/// What happened in a tick of a jog.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct JogReport {
    /// The jog came to its end.
    pub finished: bool,
    /// The jog limit on this side ended it: it now ramps down.
    pub limit: Option<Side>,
}

/// The jog profiler of one axis.
#[derive(Clone, Debug)]
pub struct Jog {
    settings: JogSettings,
    goal: Goal,
    track: Track,
    timer: Timer,
    state: AxisState,
}

impl Default for Jog {
    fn default() -> Self {
        Self::new()
    }
}

impl Jog {
    /// A profiler at rest with an offset of zero.
    pub fn new() -> Self {
        Self {
            settings: JogSettings::default(),
            goal: Goal::Rest,
            track: Track::resting(0.0),
            timer: Timer::default(),
            state: AxisState::default(),
        }
    }

    /// The settings in force.
    pub fn settings(&self) -> &JogSettings {
        &self.settings
    }

    /// Changes the settings. A jog under way follows them from now on.
    pub fn set_settings(&mut self, settings: JogSettings) -> Result<(), InvalidValue> {
        settings.validate()?;
        if settings != self.settings {
            self.settings = settings;
            if self.goal != Goal::Rest {
                self.plan();
            }
        }
        Ok(())
    }

    /// Goes to an offset, u (JOG ABS).
    pub fn to_offset(&mut self, target: f64) -> Result<(), InvalidValue> {
        finite(Quantity::Target, target)?;
        self.begin(Goal::Position(target));
        Ok(())
    }

    /// Goes a distance, u, from where the offset is now (JOG INC).
    pub fn by_distance(&mut self, distance: f64) -> Result<(), InvalidValue> {
        self.to_offset(self.state.position + distance)
    }

    /// Runs until told otherwise (JOG FWD, JOG REV).
    pub fn run(&mut self, side: Side) {
        self.begin(Goal::Run { side, pace: Pace::Jog });
    }

    pub(super) fn run_at(&mut self, side: Side, pace: Pace) {
        self.begin(Goal::Run { side, pace });
    }

    /// Ramps down to rest with JOG DEC (JOG OFF), unless it ramps down already.
    pub fn off(&mut self) {
        if !matches!(self.goal, Goal::Rest | Goal::Stop { .. }) {
            self.begin(Goal::Stop { ramp: None });
        }
    }

    /// Comes to rest from `velocity`, u/s, with a straight ramp of `deceleration`, u/s²; zero stops at once.
    ///
    /// This is how a killed axis stops (HLDEC) and one that meets a software limit (SLDEC): the velocity is that of the
    /// whole axis, all of which the jog profiler takes over.
    pub fn stop_from(&mut self, velocity: f64, deceleration: f64) -> Result<(), InvalidValue> {
        finite(Quantity::StartVelocity, velocity)?;
        not_negative(Quantity::Deceleration, deceleration)?;
        self.state = AxisState { velocity, acceleration: 0.0, ..self.state };
        self.begin(Goal::Stop { ramp: Some(deceleration) });
        Ok(())
    }

    /// Stops where it is, without a ramp.
    pub fn halt(&mut self) {
        self.rest_at(self.state.position);
    }

    /// Gives the offset a value (JOG RES and its like). Only at rest.
    pub fn preload(&mut self, offset: f64) -> Result<(), JogError> {
        if self.active() {
            return Err(JogError::InMotion);
        }
        self.rest_at(finite(Quantity::Position, offset)?);
        Ok(())
    }

    /// Stands at an offset from now on.
    pub(super) fn rest_at(&mut self, position: f64) {
        self.goal = Goal::Rest;
        self.track = Track::resting(position);
        self.timer = Timer::default();
        self.state = AxisState { position, ..AxisState::default() };
    }

    fn begin(&mut self, goal: Goal) {
        self.goal = goal;
        self.plan();
    }

    /// Plans the goal anew from the present state.
    fn plan(&mut self) {
        let settings = &self.settings;
        let mut limits =
            Limits { acceleration: settings.acceleration, deceleration: settings.deceleration, jerk: settings.jerk };
        let planned = match self.goal {
            Goal::Rest => None,
            Goal::Position(target) => Track::to_position(self.state, target, settings.velocity, &limits),
            Goal::Run { side, pace } => {
                let velocity = match pace {
                    Pace::Jog => settings.velocity,
                    Pace::HomeFinal => settings.home_velocity,
                };
                Some(Track::to_velocity(self.state, side.sign() * velocity, &limits))
            }
            Goal::Stop { ramp } => {
                if let Some(deceleration) = ramp {
                    limits = Limits { deceleration, jerk: 0.0, ..limits };
                }
                Some(Track::to_velocity(self.state, 0.0, &limits))
            }
        };
        // A target that would never be reached is waited for at rest. A jerk so small that nothing fits into numbers
        // is none.
        let stops = || Track::to_velocity(self.state, 0.0, &limits);
        let straight = || Track::to_velocity(self.state, 0.0, &Limits { jerk: 0.0, ..limits });
        self.track = planned.filter(Track::is_finite).unwrap_or_else(stops);
        if !self.track.is_finite() {
            self.track = straight();
        }
        self.timer = Timer::default();
    }

    /// Lets `dt` seconds, or units of the time base, pass. Nothing passes if that is not a finite number.
    pub fn advance(&mut self, dt: f64) -> JogReport {
        let mut report = JogReport::default();
        if self.goal == Goal::Rest || dt == 0.0 || !dt.is_finite() {
            return report;
        }
        if dt < 0.0 {
            let elapsed = (self.timer.elapsed() + dt).max(0.0);
            self.timer = Timer::carrying(elapsed);
            self.state = self.track.sample(elapsed);
            return report;
        }
        if let Some(side) = self.limit_ahead() {
            report.limit = Some(side);
            self.begin(Goal::Stop { ramp: None });
        }
        self.timer.advance(1, dt);
        let time = self.timer.elapsed();
        self.state = self.track.sample(time);
        if let Some((duration, position)) = self.end()
            && self.timer.past(duration).is_some()
        {
            self.rest_at(position);
            report.finished = true;
        }
        report
    }

    /// When, since it was planned, and where the jog ends by itself.
    fn end(&self) -> Option<(f64, f64)> {
        let ends = match self.goal {
            Goal::Position(_) => self.track.arrives(),
            Goal::Stop { .. } => true,
            Goal::Rest | Goal::Run { .. } => false,
        };
        self.track.rest().filter(|_| ends)
    }

    /// The jog limit that the offset has reached and is heading for.
    fn limit_ahead(&self) -> Option<Side> {
        let limits = self.settings.limits;
        if limits.is_zero() {
            return None;
        }
        limits.reached(self.state.position).filter(|side| self.heading() == Some(*side))
    }

    /// Where the jog is going; `None` while it ramps down for good.
    fn heading(&self) -> Option<Side> {
        match self.goal {
            Goal::Position(target) => Side::of(target - self.state.position),
            Goal::Run { side, .. } => Some(side),
            Goal::Rest | Goal::Stop { .. } => None,
        }
    }

    /// The jog offset with its velocity and acceleration.
    pub fn state(&self) -> AxisState {
        self.state
    }

    /// The jog offset, u.
    pub fn offset(&self) -> f64 {
        self.state.position
    }

    /// Whether a jog is under way.
    pub fn active(&self) -> bool {
        self.goal != Goal::Rest
    }

    /// The flags of the axis.
    pub fn flags(&self) -> JogFlags {
        let running = |side| matches!(self.goal, Goal::Run { side: running, .. } if running == side);
        let speed = self.state.velocity.abs();
        JogFlags {
            active: self.active(),
            negative: Side::of(self.state.velocity).or(self.heading()) == Some(Side::Negative),
            at_speed: speed > 0.0 && speed == self.speed() && self.state.acceleration == 0.0,
            stopping: self.active() && self.track.stopping(self.timer.elapsed()),
            forward: running(Side::Positive),
            reverse: running(Side::Negative),
        }
    }

    /// The velocity the jog is to reach, u/s.
    fn speed(&self) -> f64 {
        match self.goal {
            Goal::Run { pace: Pace::HomeFinal, .. } => self.settings.home_velocity,
            Goal::Run { .. } | Goal::Position(_) => self.settings.velocity,
            Goal::Rest | Goal::Stop { .. } => 0.0,
        }
    }

    /// Time until the jog ends, s or units of the time base; `None` if it does not end by itself.
    pub fn remaining(&self) -> Option<f64> {
        self.end().map(|(duration, _)| (duration - self.timer.elapsed()).max(0.0))
    }
}
