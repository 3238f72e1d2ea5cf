//! The settings of a master that are not captured with a move.

use super::look::NO_HEADING;
use super::{AXES, Flow, Master, Override, SettingError};
use crate::value::{Quantity, finite, not_negative};

impl Master {
    /// Puts a slot at a position, u, with its target. Only while no move is running or waiting.
    pub fn set_position(&mut self, slot: usize, position: f64) -> Result<(), SettingError> {
        if self.in_motion() {
            return Err(SettingError::InMotion);
        }
        finite(Quantity::Position, position)?;
        *place(&mut self.positions, slot)? = position;
        self.heading = NO_HEADING;
        *place(&mut self.targets, slot)? = position;
        Ok(())
    }

    /// Sets the weight of a slot in the length of paths laid from now on; one by default. A slot of weight zero moves
    /// along but does not count.
    pub fn set_weight(&mut self, slot: usize, weight: f64) -> Result<(), SettingError> {
        not_negative(Quantity::Weight, weight)?;
        *place(&mut self.ground.weights, slot)? = weight;
        Ok(())
    }

    /// The weight of a slot; one for a slot that does not exist.
    pub fn weight(&self, slot: usize) -> f64 {
        self.ground.weights.get(slot).copied().unwrap_or(1.0)
    }

    /// Sets the length, u, of a path none of whose moving axes has weight; zero, the default, allows no such move.
    pub fn set_vector(&mut self, length: f64) -> Result<(), SettingError> {
        self.ground.vector = not_negative(Quantity::Vector, length)?;
        Ok(())
    }

    /// Sets the length of a turn of a rotary axis, u (ROTARY); zero, the default, is a linear axis.
    ///
    /// An absolute target of a straight move is then taken the short way round, at most half a turn. Positions go on
    /// counting: the axis ends at the target or at whole turns from it.
    pub fn set_rotary(&mut self, slot: usize, length: f64) -> Result<(), SettingError> {
        not_negative(Quantity::RotaryLength, length)?;
        *place(&mut self.ground.rotary, slot)? = length;
        Ok(())
    }

    /// Sets how fast a slot may be in moves laid from now on, u/s (MAXVEL); zero, the default, is no limit.
    ///
    /// A move that would make the axis faster is followed more slowly, whatever the override, and so ends the move before
    /// it. An axis that turns counts with the highest speed of its circle, also where the arc does not reach it, and one on a
    /// curve as if the curve led along it. An axis that points along the path is not limited.
    pub fn set_ceiling(&mut self, slot: usize, velocity: f64) -> Result<(), SettingError> {
        not_negative(Quantity::Velocity, velocity)?;
        *place(&mut self.ground.ceilings, slot)? = velocity;
        Ok(())
    }

    /// Sets the factor on the target velocity of feeding moves (FOV), the running one too, which changes to its new
    /// velocity with its acceleration or deceleration ramp. At zero it comes to rest until the factor rises again.
    ///
    /// A jerk-limited move keeps to its jerk, also when it is accelerating at that moment. Its last ramp down, once
    /// begun, is left as it was, and so is a ramp that could not be ended in time for the end of the path.
    pub fn set_feedrate_override(&mut self, factor: f64) -> Result<(), SettingError> {
        not_negative(Quantity::FeedrateOverride, factor)?;
        let before = core::mem::replace(&mut self.feedrate_override, factor);
        self.override_changed(Override::Feedrate, before != factor);
        Ok(())
    }

    /// Sets the factor on the target velocity of rapid moves (ROV); it acts as [`Master::set_feedrate_override`] does.
    pub fn set_rapid_override(&mut self, factor: f64) -> Result<(), SettingError> {
        not_negative(Quantity::RapidOverride, factor)?;
        let before = core::mem::replace(&mut self.rapid_override, factor);
        self.override_changed(Override::Rapid, before != factor);
        Ok(())
    }

    /// A held move stays on its way to rest; it meets the new factor at cycle start.
    fn override_changed(&mut self, which: Override, changed: bool) {
        if !changed {
            return;
        }
        if self.lookahead.is_some() {
            self.look_ahead(true);
        }
        let acts = self.running.as_ref().is_some_and(|running| running.override_by() == which);
        if acts && self.flow == Flow::Run {
            self.replan();
        }
    }

    /// The factor on the target velocity of feeding moves.
    pub fn feedrate_override(&self) -> f64 {
        self.feedrate_override
    }

    /// The factor on the target velocity of rapid moves.
    pub fn rapid_override(&self) -> f64 {
        self.rapid_override
    }

    /// Changes how many moves can wait, which allocates their places anew. False, and no change, if more than that are waiting now.
    pub fn set_queue_capacity(&mut self, capacity: usize) -> bool {
        match self.queue.resized(capacity) {
            Some(queue) => {
                self.queue = queue;
                true
            }
            None => false,
        }
    }
}

pub(super) fn place(values: &mut [f64; AXES], slot: usize) -> Result<&mut f64, SettingError> {
    values.get_mut(slot).ok_or(SettingError::NoSuchSlot(slot))
}
