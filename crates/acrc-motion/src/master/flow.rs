//! Time: ticks, handing over from move to move, holding, stopping.

use super::look::NO_HEADING;
use super::moves::Override;
use super::running::Running;
use super::{AXES, Flow, Handover, Master};
use crate::profile::State;
use crate::timer::Timer;

/// What happened in a tick.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Advanced {
    /// Moves that began, including those that began when they were queued since the tick before.
    pub started: u32,
    /// Moves that ended, at their target or where they were cut short.
    pub completed: u32,
    /// A move has come to rest where it was cut short.
    pub interrupted: bool,
    /// A stop has come to its end and every move was dropped.
    pub stopped: bool,
    /// Velocity along the path, u/s, with which a move ended while none was waiting: it dropped to zero at once. Zero if
    /// none did. Known one tick late, since a successor may still be queued in the same tick.
    pub dropped_velocity: f64,
}

impl Master {
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
        while let Some((timer, running)) = self.running.as_ref().and_then(|r| Some((r.over()?, r))) {
            let velocity = running.profile().end_velocity();
            let cut = running.is_cut();
            self.positions = core::array::from_fn(|slot| running.end_position(slot));
            self.running = None;
            report.completed += 1;
            if cut {
                report.interrupted = true;
                report.dropped_velocity = report.dropped_velocity.max(velocity);
                self.end_cut(timer);
            } else {
                self.hand_over(velocity, timer, &mut report);
            }
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

    /// Lets time pass on an external time base (SRC): each count of the source is a tick of `dt` seconds for the moves.
    ///
    /// Counts back take the running move back on its path, at most to where it began or was last changed (by an
    /// override, a hold, a capture); what is counted back beyond that is lost.
    pub fn advance_counts(&mut self, counts: i64, dt: f64) -> Advanced {
        if counts >= 0 {
            return self.advance_ticks(counts.unsigned_abs(), dt);
        }
        if let Some(running) = &mut self.running
            && dt > 0.0
            && dt.is_finite()
        {
            running.retreat(counts.unsigned_abs(), dt);
        }
        Advanced { started: core::mem::take(&mut self.started), ..Advanced::default() }
    }

    /// A move ended: begins the next one, or notes the velocity it ended with.
    fn hand_over(&mut self, velocity: f64, timer: Timer, report: &mut Advanced) {
        let goes_on = self.flow == Flow::Run || velocity > 0.0;
        if goes_on
            && self.next_begins_by_itself()
            && let Some(next) = self.queue.pop()
        {
            self.begin(&next, State { velocity, ..State::default() }, timer);
        } else if velocity > 0.0 {
            match timer.within_tick() {
                Some(since) if self.flow == Flow::Run => self.handover = Some(Handover { velocity, since }),
                _ => report.dropped_velocity = velocity,
            }
        }
    }

    /// What the target velocity is multiplied by: zero brings the move to rest.
    pub(super) fn factor(&self, override_by: Override) -> f64 {
        if self.flow == Flow::Run { self.override_factor(override_by) } else { 0.0 }
    }

    /// What an override makes of the target velocity, held or not.
    pub(super) fn override_factor(&self, override_by: Override) -> f64 {
        match override_by {
            Override::Feedrate => self.feedrate_override,
            Override::Rapid => self.rapid_override,
            Override::Locked => 1.0,
        }
    }

    pub(super) fn replan(&mut self) {
        let Some(factor) = self.running.as_ref().map(|running| self.factor(running.override_by())) else { return };
        if let Some(running) = &mut self.running {
            running.replan(factor);
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
        } else if self.next_begins_by_itself()
            && let Some(next) = self.queue.pop()
        {
            self.begin(&next, State::default(), Timer::default());
        }
    }

    /// Drops every move and releases a hold. The axes stop where they are, without a ramp.
    pub fn kill(&mut self) {
        let positions: [f64; AXES] = core::array::from_fn(|slot| self.position(slot));
        self.positions = positions;
        self.targets = positions;
        self.running = None;
        self.queue.clear();
        self.heading = NO_HEADING;
        self.handover = None;
        self.detour = None;
        self.flow = Flow::Run;
    }

    /// Brings the move to rest as [`Master::feedhold`] does, then drops every move. [`Advanced::stopped`] tells when.
    pub fn stop(&mut self) {
        let was = core::mem::replace(&mut self.flow, Flow::Stop);
        if was == Flow::Run {
            self.replan();
        }
    }
}
