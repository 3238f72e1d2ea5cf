//! The move that runs: its profile, how far it is, and replanning it from where it is.

use super::Phase;
use super::moves::{MoveSettings, Override};
use super::path::{Path, Place};
use super::queue::Queued;
use crate::profile::{Moving, Profile, ProfileRequest, State};
use crate::timer::Timer;

/// A move under way.
#[derive(Clone, Copy, Debug)]
pub(super) struct Running {
    path: Path,
    settings: MoveSettings,
    override_by: Override,
    interrupt: Option<u32>,
    /// Whether it is to end on the way.
    cut: bool,
    /// How fast it may end, u/s, if not as its settings say.
    exit: Option<f64>,
    profile: Profile,
    /// Position along the path at which the profile begins, u.
    origin: f64,
    timer: Timer,
    /// Time of the profile at which it was entered, s.
    entered: f64,
    /// State along the whole path at the last tick.
    state: State,
    /// Where that is.
    place: Place,
}

/// A velocity counts as no higher when it differs by less than this part.
const ROUNDING: f64 = 1e-9;

impl Running {
    /// Begins a move that takes over the velocity and the acceleration of `state`, or begins from rest.
    ///
    /// `factor` scales the target velocity: the override, or zero to come to rest.
    pub(super) fn begin(queued: &Queued, state: State, factor: f64, timer: Timer) -> Self {
        let mut settings = queued.settings;
        let ceiling = (settings.velocity * factor).min(queued.path.ceiling());
        let start = if state.velocity > 0.0 { state.velocity } else { settings.initial_velocity.min(ceiling) };
        if settings.time > 0.0 {
            settings = timed(&settings, queued.path.length(), start);
        }
        let mut running = Self {
            path: queued.path,
            settings,
            override_by: queued.override_by,
            interrupt: queued.interrupt,
            cut: false,
            exit: queued.exit,
            profile: Profile::at_rest(),
            origin: 0.0,
            timer,
            entered: 0.0,
            state: State { position: 0.0, velocity: start, ..state },
            place: Place::default(),
        };
        let planned = running.planned(factor);
        running.follow(&planned, timer);
        running
    }

    /// Follows a profile that is planned from the present state, of which the time of the timer has passed since.
    fn follow(&mut self, planned: &Moving, timer: Timer) {
        self.profile = planned.profile;
        self.origin = self.state.position - planned.covered;
        self.entered = planned.elapsed;
        self.timer = if planned.elapsed == 0.0 { timer } else { Timer::carrying(planned.elapsed + timer.elapsed()) };
        self.refresh();
    }

    /// Plans the rest of the path anew from the present state.
    ///
    /// The last ramp down of an S-curve is left alone: it ends where and when it was going to. So is an S-curve that
    /// would otherwise end faster than it was going to and faster than it may.
    pub(super) fn replan(&mut self, factor: f64) {
        if self.is_curved() && !self.profile.stands() && self.timer.elapsed() >= self.profile.end_ramp_start() {
            return;
        }
        self.change(factor);
    }

    /// Whether it is in the midst of an S-curve.
    fn is_curved(&self) -> bool {
        self.settings.jerk > 0.0 && self.state.acceleration != 0.0
    }

    fn change(&mut self, factor: f64) {
        let planned = self.planned(factor);
        let (stop, final_velocity) = self.end();
        let fastest = self.profile.end_velocity().max(final_velocity);
        if self.is_curved() && stop > 0.0 && planned.profile.end_velocity() > fastest * (1.0 + ROUNDING) {
            return;
        }
        self.follow(&planned, Timer::default());
    }

    /// Changes how fast it may end, and plans the rest anew if that is something else.
    pub(super) fn set_exit(&mut self, exit: Option<f64>, factor: f64) {
        let before = core::mem::replace(&mut self.exit, exit);
        if before != exit {
            self.change(factor);
        }
    }

    /// The ramp at the end and the velocity it leads to.
    fn end(&self) -> (f64, f64) {
        let &MoveSettings { stop, final_velocity, deceleration, .. } = &self.settings;
        let ramp = if stop > 0.0 { stop } else { deceleration };
        self.exit.map_or((stop, final_velocity), |exit| (ramp, exit))
    }

    fn planned(&self, factor: f64) -> Moving {
        let factor = if self.cut { 0.0 } else { factor };
        let rest = self.path.length() - self.state.position;
        let mut request = request(&self.settings, rest, self.state.velocity);
        request.velocity = (request.velocity * factor).min(self.path.ceiling()).min(f64::MAX);
        (request.stop, request.final_velocity) = self.end();
        // The values were checked when the move was queued. A velocity too small to ever end the path is rest.
        Moving::plan(&request, self.state.acceleration).unwrap_or(Moving::from(Profile::at_rest()))
    }

    /// Lets time pass.
    pub(super) fn advance(&mut self, ticks: u64, step: f64) {
        self.timer.advance(ticks, step);
    }

    /// Takes the state from the profile at the present time.
    pub(super) fn refresh(&mut self) {
        let state = self.profile.sample(self.timer.elapsed());
        let position = (self.origin + state.position).min(self.path.length());
        self.state = State { position, ..state };
        self.place = self.path.place(position);
    }

    /// Position of an axis, u.
    pub(super) fn position(&self, slot: usize) -> f64 {
        self.path.position(slot, &self.place)
    }

    /// Velocity of an axis, u/s.
    pub(super) fn velocity(&self, slot: usize) -> f64 {
        self.path.velocity(slot, &self.place, &self.state)
    }

    /// Acceleration of an axis, u/s².
    pub(super) fn acceleration(&self, slot: usize) -> f64 {
        self.path.acceleration(slot, &self.place, &self.state)
    }

    /// Goes back in time, at most to where the profile was entered.
    pub(super) fn retreat(&mut self, ticks: u64, step: f64) {
        self.timer.retreat(ticks, step, self.entered);
        self.refresh();
    }

    /// Time since the end of the move, if it has ended: at the end of the path, or at rest where it was cut short.
    pub(super) fn over(&self) -> Option<Timer> {
        if self.profile.stands() && !self.cut { None } else { self.timer.past(self.profile.duration()) }
    }

    /// Where an axis is when the profile is over, u.
    pub(super) fn end_position(&self, slot: usize) -> f64 {
        if self.profile.stands() {
            let along = (self.origin + self.profile.length()).min(self.path.length());
            self.path.position(slot, &self.path.place(along))
        } else {
            self.path.end().get(slot).copied().unwrap_or(0.0)
        }
    }

    /// Brings it to rest on the way and ends it there, if that is before the end of the path.
    pub(super) fn cut_short(&mut self) {
        self.cut = true;
        self.replan(0.0);
    }

    /// Nothing can cut it short any more.
    pub(super) fn close_end(&mut self) {
        self.interrupt = None;
    }

    /// Goes on along another path that begins here. False, and no change, if that leads back or is too short.
    pub(super) fn redirect(&mut self, path: &Path, factor: f64) -> bool {
        let mut redirected = *self;
        redirected.path = *path;
        redirected.state.position = 0.0;
        let planned = redirected.planned(factor);
        let (stop, final_velocity) = self.end();
        let fastest = final_velocity * (1.0 + ROUNDING);
        let too_short = stop > 0.0 && planned.profile.end_velocity() > fastest;
        if self.state.velocity > 0.0 && (too_short || !path.goes_with(&self.path)) {
            return false;
        }
        redirected.follow(&planned, Timer::default());
        redirected.close_end();
        *self = redirected;
        true
    }

    /// Whether it has come to rest on the way.
    pub(super) fn stands(&self) -> bool {
        self.profile.stands() && self.timer.past(self.profile.duration()).is_some()
    }

    /// Time until the profile ends or comes to rest, s.
    pub(super) fn remaining(&self) -> Option<f64> {
        let remaining = self.profile.duration() - self.timer.elapsed();
        (!self.stands()).then_some(remaining.max(0.0))
    }

    /// What the profile is doing.
    pub(super) fn phase(&self) -> Phase {
        let ending = !self.profile.stands() && self.timer.elapsed() >= self.profile.end_ramp_start();
        if self.state.acceleration > 0.0 {
            Phase::Accelerating
        } else if self.state.acceleration < 0.0 {
            if ending { Phase::Stopping } else { Phase::Decelerating }
        } else {
            Phase::Steady
        }
    }

    /// What may cut it short or has done so: whether its end is open.
    pub(super) fn interrupt(&self) -> Option<u32> {
        self.interrupt
    }

    /// What may cut it short.
    pub(super) fn interruptible(&self) -> Option<u32> {
        self.interrupt.filter(|_| !self.cut)
    }

    /// Whether it was cut short.
    pub(super) fn is_cut(&self) -> bool {
        self.cut
    }

    pub(super) fn settings(&self) -> &MoveSettings {
        &self.settings
    }

    /// Which override acts on it.
    pub(super) fn override_by(&self) -> Override {
        self.override_by
    }

    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    pub(super) fn profile(&self) -> &Profile {
        &self.profile
    }

    pub(super) fn state(&self) -> &State {
        &self.state
    }
}

fn request(settings: &MoveSettings, length: f64, start_velocity: f64) -> ProfileRequest {
    ProfileRequest {
        length: length.max(0.0),
        start_velocity,
        velocity: settings.velocity,
        acceleration: settings.acceleration,
        deceleration: settings.deceleration,
        stop: settings.stop,
        final_velocity: settings.final_velocity,
        jerk: settings.jerk,
    }
}

/// The settings lowered so that the move takes its time at a feedrate override of one.
fn timed(settings: &MoveSettings, length: f64, start_velocity: f64) -> MoveSettings {
    let Ok(lowered) = request(settings, length, start_velocity).lowered_to(settings.time) else {
        return *settings;
    };
    MoveSettings {
        velocity: lowered.velocity,
        acceleration: lowered.acceleration,
        deceleration: lowered.deceleration,
        stop: lowered.stop,
        final_velocity: lowered.final_velocity,
        jerk: lowered.jerk,
        ..*settings
    }
}
