//! The transformations of a master: SCALE, ROTATE, OFFSET, FLZ.
//!
//! They act on moves queued from now on; a path that is laid stays where it is.

use super::frame::Rotation;
use super::settings::place;
use super::{AXES, Master, SettingError};
use crate::trig::sin_cos_degrees;
use crate::value::{Quantity, finite};

impl Master {
    /// Scales what is programmed for a slot by `factor` about `center`, u (SCALE). A negative factor mirrors; zero is
    /// refused, since no move could be programmed from there.
    pub fn set_scale(&mut self, slot: usize, factor: f64, center: f64) -> Result<(), SettingError> {
        finite(Quantity::ScaleFactor, factor)?;
        finite(Quantity::Center, center)?;
        if factor == 0.0 {
            return Err(SettingError::ZeroScale);
        }
        *place(&mut self.ground.frame.factors, slot)? = factor;
        *place(&mut self.ground.frame.centers, slot)? = center;
        Ok(())
    }

    /// The factor on what is programmed for a slot; one for a slot that does not exist.
    pub fn scale(&self, slot: usize) -> f64 {
        self.ground.frame.factors.get(slot).copied().unwrap_or(1.0)
    }

    /// Rotates what is programmed for two slots by an angle, degrees, about a centre, u, from the first slot toward the
    /// second (ROTATE). Zero ends the rotation.
    pub fn set_rotation(&mut self, slots: [usize; 2], degrees: f64, center: [f64; 2]) -> Result<(), SettingError> {
        finite(Quantity::RotationAngle, degrees)?;
        for value in center {
            finite(Quantity::Center, value)?;
        }
        if let Some(slot) = slots.into_iter().find(|slot| *slot >= AXES) {
            return Err(SettingError::NoSuchSlot(slot));
        }
        if slots[0] == slots[1] {
            return Err(SettingError::SameSlot(slots[0]));
        }
        let (sin, cos) = sin_cos_degrees(degrees);
        self.ground.frame.degrees = degrees;
        self.ground.frame.rotation = (degrees != 0.0).then_some(Rotation { slots, center, sin, cos });
        Ok(())
    }

    /// The angle by which paths are rotated, degrees.
    pub fn rotation(&self) -> f64 {
        self.ground.frame.degrees
    }

    /// Shifts what is programmed for a slot, u (OFFSET).
    pub fn set_offset(&mut self, slot: usize, offset: f64) -> Result<(), SettingError> {
        *place(&mut self.ground.frame.offsets, slot)? = finite(Quantity::PathShift, offset)?;
        Ok(())
    }

    /// The shift of a slot by [`Master::set_offset`], u.
    pub fn offset(&self, slot: usize) -> f64 {
        self.ground.frame.offsets.get(slot).copied().unwrap_or(0.0)
    }

    /// Shifts what is programmed for a slot so that its zero lies `offset` from where the last queued move takes the
    /// slot, u (FLZ).
    pub fn float_zero(&mut self, slot: usize, offset: f64) -> Result<(), SettingError> {
        let there = *place(&mut self.targets, slot)?;
        let resting = self.ground.frame.offsets.get(slot).copied().unwrap_or(0.0);
        self.set_float(slot, there - resting + offset)
    }

    /// Sets the shift of a slot that [`Master::float_zero`] finds, u; zero, the default, takes it back.
    pub fn set_float(&mut self, slot: usize, shift: f64) -> Result<(), SettingError> {
        *place(&mut self.ground.frame.floats, slot)? = finite(Quantity::PathShift, shift)?;
        Ok(())
    }

    /// The shift of a slot by [`Master::float_zero`], u.
    pub fn float(&self, slot: usize) -> f64 {
        self.ground.frame.floats.get(slot).copied().unwrap_or(0.0)
    }

    /// Where the last queued move takes a slot in the coordinates of the program, u.
    pub fn programmed_target(&self, slot: usize) -> f64 {
        self.ground.frame.program_at(&self.targets).get(slot).copied().unwrap_or(0.0)
    }
}
