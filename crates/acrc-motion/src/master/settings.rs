//! The settings of a master that are not captured with a move.

use super::{AXES, Flow, Master, SettingError};
use crate::value::{Quantity, finite, not_negative};

impl Master {
    /// Puts a slot at a position, u, with its target. Only while no move is running or waiting.
    pub fn set_position(&mut self, slot: usize, position: f64) -> Result<(), SettingError> {
        if self.in_motion() {
            return Err(SettingError::InMotion);
        }
        finite(Quantity::Position, position)?;
        *place(&mut self.positions, slot)? = position;
        *place(&mut self.targets, slot)? = position;
        Ok(())
    }

    /// Sets the weight of a slot in the length of paths laid from now on; one by default. A slot of weight zero moves
    /// along but does not count.
    pub fn set_weight(&mut self, slot: usize, weight: f64) -> Result<(), SettingError> {
        not_negative(Quantity::Weight, weight)?;
        *place(&mut self.weights, slot)? = weight;
        Ok(())
    }

    /// The weight of a slot; one for a slot that does not exist.
    pub fn weight(&self, slot: usize) -> f64 {
        self.weights.get(slot).copied().unwrap_or(1.0)
    }

    /// Sets the length, u, of a path none of whose moving axes has weight; zero, the default, allows no such move.
    pub fn set_vector(&mut self, length: f64) -> Result<(), SettingError> {
        self.vector = not_negative(Quantity::Vector, length)?;
        Ok(())
    }

    /// Sets the factor on the target velocity of every move, the running one too, which changes to its new velocity
    /// with its acceleration or deceleration ramp. At zero it comes to rest until the factor rises again.
    ///
    /// A jerk-limited move keeps its S-curves if it is not accelerating at that moment. Otherwise the rest of it goes
    /// on with straight ramps from the velocity it has; only its last ramp down, once begun, is left as it was.
    pub fn set_feedrate_override(&mut self, factor: f64) -> Result<(), SettingError> {
        not_negative(Quantity::FeedrateOverride, factor)?;
        if factor != self.feedrate_override {
            self.feedrate_override = factor;
            // A held move stays on its way to rest; it meets the new factor at cycle start.
            if self.flow == Flow::Run {
                self.replan();
            }
        }
        Ok(())
    }

    /// The factor on the target velocity.
    pub fn feedrate_override(&self) -> f64 {
        self.feedrate_override
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

fn place(values: &mut [f64; AXES], slot: usize) -> Result<&mut f64, SettingError> {
    values.get_mut(slot).ok_or(SettingError::NoSuchSlot(slot))
}
