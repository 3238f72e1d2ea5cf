//! The gear profiler of one axis (the guide's "Gear Profiler"; GEAR SRC, PPU, RATIO, ACC, DEC, MAX, MIN, ON, OFF, RES).
//!
//! Its output is the gear offset. While the gear is on, the offset follows the change of a source: source counts, over
//! GEAR PPU, times GEAR RATIO, are programming units of the axis. What the source did while the gear was off is not made
//! up for. While the gear is engaged the offset is computed from the counts since then, so nothing drifts.
//!
//! What the guide leaves open, and how it is read here, stands in `docs/fidelity.md`, "Gear, cam and sources".

use super::Window;
use crate::value::{InvalidValue, Quantity, finite, not_negative};

/// The settings of a gear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GearSettings {
    /// Source counts per unit of the source (GEAR PPU); not zero.
    pub pulses_per_unit: f64,
    /// Units of the axis per unit of the source (GEAR RATIO); negative turns the direction.
    pub ratio: f64,
    /// Ramp to a higher speed while engaging, u/s² (GEAR ACC); zero engages at once.
    pub acceleration: f64,
    /// Ramp to a lower speed, u/s² (GEAR DEC); zero is at once.
    pub deceleration: f64,
    /// Ends of the offset, u (GEAR MAX, GEAR MIN). Both zero: none.
    pub limits: Window,
}

impl Default for GearSettings {
    /// One count of the source is one unit of the axis; no ramps, no limits.
    fn default() -> Self {
        Self { pulses_per_unit: 1.0, ratio: 1.0, acceleration: 0.0, deceleration: 0.0, limits: Window::default() }
    }
}

impl GearSettings {
    /// Units of the axis per count of the source.
    fn units_per_count(&self) -> f64 {
        self.ratio / self.pulses_per_unit
    }

    fn validate(&self) -> Result<(), InvalidValue> {
        finite(Quantity::GearRatio, self.ratio)?;
        finite(Quantity::GearRatio, self.units_per_count())?;
        not_negative(Quantity::Acceleration, self.acceleration)?;
        not_negative(Quantity::Deceleration, self.deceleration)?;
        self.limits.validate()
    }
}

/// How the axis is connected to its source.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum GearState {
    /// Not at all.
    #[default]
    Off,
    /// It changes to the speed of the source.
    Engaging,
    /// It follows the source count by count.
    Engaged,
    /// It changes to rest.
    Disengaging,
}

/// The gear profiler of one axis.
#[derive(Clone, Copy, Debug, Default)]
pub struct Gear {
    settings: GearSettings,
    state: GearState,
    offset: f64,
    velocity: f64,
    /// The offset at which the counting began.
    base: f64,
    /// Counts since then.
    counts: f64,
}

impl Gear {
    /// The settings in force.
    pub fn settings(&self) -> &GearSettings {
        &self.settings
    }

    /// Changes the settings; they act at once.
    pub fn set_settings(&mut self, settings: GearSettings) -> Result<(), InvalidValue> {
        settings.validate()?;
        let turned = settings.units_per_count() != self.settings.units_per_count();
        self.settings = settings;
        if turned && self.state == GearState::Engaged {
            self.state = GearState::Engaging;
        }
        Ok(())
    }

    /// Connects the axis to its source (GEAR ON).
    pub fn on(&mut self) {
        if matches!(self.state, GearState::Off | GearState::Disengaging) {
            self.state = GearState::Engaging;
        }
    }

    /// Disconnects it (GEAR OFF): it ramps down to rest.
    pub fn off(&mut self) {
        if self.state != GearState::Off {
            self.state = GearState::Disengaging;
        }
    }

    /// Disconnects it at once, for an axis that is killed.
    pub fn halt(&mut self) {
        self.state = GearState::Off;
        self.velocity = 0.0;
    }

    /// Gives the offset a value, u (GEAR RES). The gear stays on or off.
    pub fn preload(&mut self, offset: f64) -> Result<(), InvalidValue> {
        self.rebase(finite(Quantity::Position, offset)?);
        Ok(())
    }

    fn rebase(&mut self, offset: f64) {
        self.offset = offset;
        self.base = offset;
        self.counts = 0.0;
    }

    /// Lets a tick of `dt` seconds pass in which the source changed by `counts`.
    pub fn advance(&mut self, counts: f64, dt: f64) {
        let demand = counts * self.settings.units_per_count();
        if self.state == GearState::Off || !(dt > 0.0 && demand.is_finite()) {
            return;
        }
        match self.state {
            GearState::Off => {}
            GearState::Engaged => self.follow(counts, demand / dt),
            GearState::Engaging if self.rate_for(demand / dt) == 0.0 => {
                self.rebase(self.offset);
                self.state = GearState::Engaged;
                self.follow(counts, demand / dt);
            }
            GearState::Engaging => {
                if self.ramp(demand / dt, dt) {
                    self.state = GearState::Engaged;
                }
            }
            GearState::Disengaging => {
                if self.ramp(0.0, dt) {
                    self.state = GearState::Off;
                }
            }
        }
        let limits = self.settings.limits;
        if !limits.is_zero() && !limits.contains(self.offset) {
            self.rebase(limits.clamp(self.offset));
        }
    }

    fn follow(&mut self, counts: f64, velocity: f64) {
        self.counts += counts;
        self.offset = self.base + self.counts * self.settings.units_per_count();
        self.velocity = velocity;
    }

    /// The ramp for a change to `target`, u/s²; zero is a step.
    fn rate_for(&self, target: f64) -> f64 {
        if target.abs() > self.velocity.abs() { self.settings.acceleration } else { self.settings.deceleration }
    }

    /// A tick of ramp towards `target`. True when it is reached.
    fn ramp(&mut self, target: f64, dt: f64) -> bool {
        let rate = self.rate_for(target);
        let (from, to) = if rate == 0.0 {
            (target, target)
        } else {
            (self.velocity, target.clamp(self.velocity - rate * dt, self.velocity + rate * dt))
        };
        self.rebase(self.offset + (from + (to - from) / 2.0) * dt);
        self.velocity = to;
        to == target
    }

    /// How the axis is connected.
    pub fn state(&self) -> GearState {
        self.state
    }

    /// The gear offset, u.
    pub fn offset(&self) -> f64 {
        self.offset
    }

    /// Velocity of the offset, u/s.
    pub fn velocity(&self) -> f64 {
        self.velocity
    }
}
