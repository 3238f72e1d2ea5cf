//! The hand wheel of one axis (HDW SRC, VEL, ACC, DEC, JRK, ON, OFF).
//!
//! A hand wheel is a gear whose output keeps limits: it goes where the counts of the wheel say, no faster than HDW VEL and
//! with the ramps of HDW ACC, DEC and JRK, so it may still be on its way when the wheel stands.
//!
//! What the guide leaves open, and how it is read here, stands in `docs/fidelity.md`, "Gear, cam and sources".

use super::{AxisState, Jog, JogError, JogSettings};
use crate::value::{InvalidValue, Quantity, finite};

/// A hand wheel.
#[derive(Clone, Debug, Default)]
pub struct HandWheel {
    profiler: Jog,
    units_per_count: f64,
    target: f64,
    on: bool,
}

impl HandWheel {
    /// Sets velocity and ramps; only these are used of the settings of a jog.
    pub fn set_settings(&mut self, settings: JogSettings, units_per_count: f64) -> Result<(), InvalidValue> {
        finite(Quantity::GearRatio, units_per_count)?;
        self.profiler.set_settings(JogSettings { limits: super::Window::default(), ..settings })?;
        self.units_per_count = units_per_count;
        Ok(())
    }

    /// Lets the axis follow the wheel (HDW ON).
    pub fn on(&mut self) {
        self.target = self.profiler.offset();
        self.on = true;
    }

    /// Ramps down (HDW OFF).
    pub fn off(&mut self) {
        self.on = false;
        self.profiler.off();
    }

    /// Stops at once, for an axis that is killed.
    pub fn halt(&mut self) {
        self.on = false;
        self.profiler.halt();
    }

    /// Gives the output a value, u. Only at rest.
    pub fn preload(&mut self, offset: f64) -> Result<(), JogError> {
        self.profiler.preload(offset)?;
        self.target = offset;
        Ok(())
    }

    /// Lets a tick of `dt` seconds pass in which the wheel was turned by `counts`.
    pub fn advance(&mut self, counts: f64, dt: f64) {
        let turned = self.target + counts * self.units_per_count;
        if self.on && counts != 0.0 && turned.is_finite() {
            self.target = turned;
            if self.profiler.settings().velocity > 0.0 {
                // A finite target is never refused.
                let _ = self.profiler.to_offset(turned);
            } else {
                self.profiler.rest_at(turned);
            }
        }
        self.profiler.advance(dt);
    }

    /// Whether the axis follows the wheel, or still ramps down from it.
    pub fn works(&self) -> bool {
        self.on || self.profiler.active()
    }

    /// Output with its velocity and acceleration. Without a limit of velocity it follows the counts, and has none.
    pub fn state(&self) -> AxisState {
        self.profiler.state()
    }
}
