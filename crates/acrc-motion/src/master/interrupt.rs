//! Moves that wait for something, and moves that something ends or redirects: TRG, SYNC, INT, HSINT, TRJ.
//!
//! The master knows no inputs. A move carries a number of the caller's, most simply that of the flag it depends on; the
//! caller asks for the number that matters now, looks at the flag, and says when it has happened.

use super::look::NO_HEADING;
use super::moves::{Move, MoveSettings, Override, PushError};
use super::queue::Queued;
use super::{AXES, Flow, Master};
use crate::profile::State;
use crate::timer::Timer;
use crate::value::{Quantity, finite};

/// Where a move goes on to when it has come to rest.
#[derive(Clone, Copy, Debug)]
pub(super) struct Detour {
    end: [f64; AXES],
    settings: MoveSettings,
    override_by: Override,
}

impl Master {
    /// Whether a move with this gate begins as soon as it is the next.
    pub(super) fn begins_by_itself(&self, gate: Option<u32>) -> bool {
        gate.is_none() && !self.synchronised
    }

    pub(super) fn next_begins_by_itself(&self) -> bool {
        self.queue.first().is_none_or(|next| self.begins_by_itself(next.gate))
    }

    /// The gate that the next move waits at now (TRG): nothing runs, nothing is held.
    pub fn gate(&self) -> Option<u32> {
        if self.running.is_some() || self.flow != Flow::Run { None } else { self.queue.first()?.gate }
    }

    /// Lets the move at the gate begin. If the one before it ended in the tick just past, it takes over its velocity.
    pub fn open_gate(&mut self) {
        if self.gate().is_none() {
            return;
        }
        self.queue.open_first();
        self.look_ahead(true);
        if !self.synchronised {
            self.begin_next();
        }
    }

    /// Makes every move wait for [`start_together`] (SYNC).
    pub fn set_synchronised(&mut self, synchronised: bool) {
        self.synchronised = synchronised;
        self.look_ahead(true);
        if self.is_ready() && !synchronised {
            self.begin_next();
        }
    }

    /// Whether moves wait for those of other masters.
    pub fn is_synchronised(&self) -> bool {
        self.synchronised
    }

    /// Whether the next move waits for nothing but its start.
    pub fn is_ready(&self) -> bool {
        self.running.is_none() && self.flow == Flow::Run && self.queue.first().is_some_and(|next| next.gate.is_none())
    }

    fn begin_next(&mut self) {
        if let Some(next) = self.queue.pop() {
            self.begin_with_handover(&next);
        }
    }

    /// What may cut the running move short (INT, HSINT), while it still may.
    pub fn interruptible(&self) -> Option<u32> {
        self.running.as_ref()?.interruptible()
    }

    /// Cuts an interruptible move short: it comes to rest with its deceleration ramp, and that is its end. If its way is
    /// too short for that, it ends as it would have.
    pub fn interrupt(&mut self) {
        if let Some(running) = &mut self.running
            && running.interruptible().is_some()
        {
            running.cut_short();
        }
    }

    /// Gives an axis of the running move another end, u (HSINT). The other axes keep theirs. False, and no change, if
    /// the move is not interruptible or not straight.
    ///
    /// The move goes on with the velocity it has. Where the new end is behind, or too near to come to rest, it comes to
    /// rest with its deceleration ramp and returns. Nothing can interrupt the move any more.
    pub fn redirect(&mut self, slot: usize, position: f64) -> Result<bool, PushError> {
        finite(Quantity::Target, position)?;
        let start: [f64; AXES] = core::array::from_fn(|slot| self.position(slot));
        let Some(mut running) = self.running.filter(|r| r.interruptible().is_some() && r.path().is_straight()) else {
            return Ok(false);
        };
        let mut end = *running.path().end();
        *end.get_mut(slot).ok_or(PushError::NoSuchSlot(slot))? = position;
        let path = self.ground.straight(&start, &end)?;
        let factor = self.factor(running.override_by());
        if !running.redirect(&path, factor) {
            running.cut_short();
            running.close_end();
            self.detour = Some(Detour { end, settings: *running.settings(), override_by: running.override_by() });
        }
        self.running = Some(running);
        self.targets = end;
        self.heading = path.heading(true, &self.ground.weights);
        self.look_ahead(false);
        Ok(true)
    }

    /// A move that was cut short has ended: goes on to where it was redirected.
    pub(super) fn end_cut(&mut self, timer: Timer) {
        let detour = self.detour.take().filter(|_| self.flow != Flow::Stop);
        let path = detour.and_then(|detour| Some((detour, self.ground.straight(&self.positions, &detour.end).ok()?)));
        let Some((Detour { settings, override_by, .. }, path)) = path else {
            self.targets = self.positions;
            self.heading = NO_HEADING;
            return;
        };
        let command = Move { override_by, ..Move::new(settings) };
        self.begin(&Queued::new(&path, &command), State::default(), timer);
    }

    /// Drops the running move and those that wait, and begins another from where the axes are, with the velocity along
    /// the path that they have (TRJ). Its gate is not looked at.
    pub fn replace(&mut self, command: &Move) -> Result<(), PushError> {
        if self.flow == Flow::Stop {
            return Err(PushError::Stopping);
        }
        let start = core::array::from_fn(|slot| self.position(slot));
        command.settings.validate()?;
        let queued = Queued::new(&self.ground.lay(&start, command)?, command);
        let state = self.path_state();
        let flow = self.flow;
        self.kill();
        self.flow = flow;
        self.targets = *queued.path.end();
        self.heading = queued.path.heading(true, &self.ground.weights);
        self.begin(&queued, state, Timer::default());
        self.look_ahead(false);
        Ok(())
    }
}

/// Begins the next moves of synchronised masters in the same tick, if every one of them has one that waits for nothing
/// else. Masters that are not synchronised are left alone.
pub fn start_together(masters: &mut [&mut Master]) -> bool {
    let mut group = masters.iter().filter(|master| master.synchronised).peekable();
    if group.peek().is_none() || !group.all(|master| master.is_ready()) {
        return false;
    }
    for master in masters.iter_mut().filter(|master| master.synchronised) {
        master.begin_next();
    }
    true
}
