//! Backlash compensation (the guide's "Setpoint Compensation"; BKL).
//!
//! The guide says that the value is added while the primary setpoint is positive. Play in a gearbox depends on the
//! direction of travel instead, so both are offered; see [`BacklashRule`].

use super::Side;

/// When the backlash value is added to the setpoint.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BacklashRule {
    /// While the primary setpoint is positive, as the guide words it.
    #[default]
    PositiveSetpoint,
    /// From a move of the primary setpoint in the positive direction until one in the negative direction.
    PositiveTravel,
}

/// The backlash generator of an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Backlash {
    /// The value that is added, u.
    pub value: f64,
    /// When it is added.
    pub rule: BacklashRule,
    last: Option<f64>,
    travel: Option<Side>,
}

impl Backlash {
    /// A generator of `value`, u; zero switches it off.
    pub fn new(value: f64, rule: BacklashRule) -> Self {
        Self { value, rule, ..Self::default() }
    }

    /// What is added to a primary setpoint, u. Called once a tick.
    pub fn update(&mut self, primary_setpoint: f64) -> f64 {
        let last = self.last.replace(primary_setpoint).unwrap_or(primary_setpoint);
        self.travel = Side::of(primary_setpoint - last).or(self.travel);
        let adds = match self.rule {
            BacklashRule::PositiveSetpoint => primary_setpoint > 0.0,
            BacklashRule::PositiveTravel => self.travel == Some(Side::Positive),
        };
        if adds { self.value } else { 0.0 }
    }
}
