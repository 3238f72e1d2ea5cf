//! The move that runs: its profile, how far it is, and replanning it from where it is.

use super::moves::MoveSettings;
use super::path::Path;
use super::queue::Queued;
use super::timer::Timer;
use crate::profile::{Profile, ProfileRequest, State};

/// A move under way.
#[derive(Clone, Copy, Debug)]
pub(super) struct Running {
    path: Path,
    settings: MoveSettings,
    profile: Profile,
    /// Position along the path at which the profile begins, u.
    origin: f64,
    timer: Timer,
    /// State along the whole path at the last tick.
    state: State,
    /// Whether the profile covers the rest of the path; otherwise it comes to rest on the way.
    reaches_end: bool,
}

impl Running {
    /// Begins a move that takes over `velocity` (zero: it begins from rest).
    ///
    /// `factor` scales the target velocity: the feedrate override, or zero to come to rest.
    pub(super) fn begin(queued: &Queued, velocity: f64, factor: f64, timer: Timer) -> Self {
        let mut settings = queued.settings;
        let ceiling = settings.velocity * factor;
        let start = if velocity > 0.0 { velocity } else { settings.initial_velocity.min(ceiling) };
        if settings.time > 0.0 {
            settings = timed(&settings, queued.path.length(), start);
        }
        let mut running = Self {
            path: queued.path,
            settings,
            profile: Profile::at_rest(),
            origin: 0.0,
            timer,
            state: State { velocity: start, ..State::default() },
            reaches_end: false,
        };
        running.plan(factor, settings.jerk);
        running.refresh();
        running
    }

    /// Plans the rest of the path anew from the present state.
    ///
    /// While an S-curve is accelerating the new ramps are straight ones, from the present velocity. The last ramp down
    /// of an S-curve is left alone: it ends where and when it was going to.
    pub(super) fn replan(&mut self, factor: f64) {
        let curved = self.settings.jerk > 0.0 && self.state.acceleration != 0.0;
        if curved && self.reaches_end && self.timer.elapsed() >= self.profile.end_ramp_start() {
            return;
        }
        self.origin = self.state.position;
        self.timer = Timer::default();
        self.plan(factor, if curved { 0.0 } else { self.settings.jerk });
        self.refresh();
    }

    fn plan(&mut self, factor: f64, jerk: f64) {
        let rest = self.path.length() - self.origin;
        let mut request = request(&self.settings, rest, self.state.velocity);
        request.velocity = (request.velocity * factor).min(f64::MAX);
        request.jerk = jerk;
        let planned = if request.velocity == 0.0 { Profile::plan_hold(&request) } else { Profile::plan(&request) };
        // The values were checked when the move was queued. A velocity too small to ever end the path is rest.
        self.profile = planned.unwrap_or_else(|_| Profile::at_rest());
        self.reaches_end = self.profile.length() == request.length;
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
    }

    /// Time since the end of the path, if it is reached.
    pub(super) fn past_end(&self) -> Option<Timer> {
        if self.reaches_end { self.timer.past(self.profile.duration()) } else { None }
    }

    /// Whether it has come to rest on the way.
    pub(super) fn stands(&self) -> bool {
        !self.reaches_end && self.timer.past(self.profile.duration()).is_some()
    }

    /// Time until the profile ends or comes to rest, s.
    pub(super) fn remaining(&self) -> Option<f64> {
        let remaining = self.profile.duration() - self.timer.elapsed();
        (!self.stands()).then_some(remaining.max(0.0))
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
