//! The settings of the servo loop.

use crate::axis::Window;
use crate::value::{InvalidValue, Quantity, finite, not_negative};

/// The gains, bands and filters of a servo loop. Errors are in pulses, outputs in volts. Zero switches each of them off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ServoGains {
    /// Volts per pulse of following error (PGAIN).
    pub proportional: f64,
    /// Volts per pulse and second (IGAIN).
    pub integral: f64,
    /// Greatest output of the integral, V (ILIMIT).
    pub integral_limit: f64,
    /// Time after the end of motion at which the integral begins to grow, s (IDELAY); zero lets it grow at all times.
    pub integral_delay: f64,
    /// Volts per pulse/s of change of the following error (DGAIN).
    pub derivative: f64,
    /// Time between samples of that change, s (DWIDTH); zero samples in every period.
    pub derivative_width: f64,
    /// Volts per pulse/s of setpoint velocity (FFVEL).
    pub velocity_feedforward: f64,
    /// Volts per pulse/s² of setpoint acceleration (FFACC).
    pub acceleration_feedforward: f64,
    /// Volts per pulse/s of actual velocity, taken off (FBVEL).
    pub velocity_feedback: f64,
    /// The velocity loop behind the position loop (KVP, KVI, KVF).
    pub velocity_loop: VelocityLoop,
    /// Output that is added outside a dead zone of the error (DZL, DZU, DIP, DIN).
    pub dead_zone: DeadZone,
    /// Notch filter: centre and width, Hz (NOTCH).
    pub notch: (f64, f64),
    /// Cut-off frequency of the low pass, Hz (LOPASS).
    pub low_pass: f64,
    /// Ends of the output, V (TLM).
    pub torque_limit: Window,
}

impl Default for ServoGains {
    /// The factory's: a proportional gain of 10 V in 4096 pulses, and a torque limit of 10 V.
    fn default() -> Self {
        Self {
            proportional: 0.002_441_406,
            integral: 0.0,
            integral_limit: 0.0,
            integral_delay: 0.0,
            derivative: 0.0,
            derivative_width: 0.0,
            velocity_feedforward: 0.0,
            acceleration_feedforward: 0.0,
            velocity_feedback: 0.0,
            velocity_loop: VelocityLoop::default(),
            dead_zone: DeadZone::default(),
            notch: (0.0, 0.0),
            low_pass: 0.0,
            torque_limit: Window::symmetric(10.0),
        }
    }
}

impl ServoGains {
    pub(super) fn validate(&self) -> Result<(), InvalidValue> {
        let DeadZone { inner, outer, positive, negative } = self.dead_zone;
        let VelocityLoop { proportional, integral, feedforward } = self.velocity_loop;
        let gains = [
            self.proportional,
            self.integral,
            self.derivative,
            self.velocity_feedforward,
            self.acceleration_feedforward,
            self.velocity_feedback,
            proportional,
            integral,
            feedforward,
            positive,
            negative,
        ];
        for gain in gains {
            finite(Quantity::Gain, gain)?;
        }
        for value in [self.integral_limit, inner, outer] {
            not_negative(Quantity::Limit, value)?;
        }
        for time in [self.integral_delay, self.derivative_width] {
            not_negative(Quantity::Time, time)?;
        }
        for frequency in [self.notch.0, self.notch.1, self.low_pass] {
            not_negative(Quantity::Frequency, frequency)?;
        }
        self.torque_limit.validate()
    }
}

/// A velocity loop inside the position loop.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct VelocityLoop {
    /// Volts per unit of velocity error (KVP).
    pub proportional: f64,
    /// Volts per unit of velocity error and second (KVI).
    pub integral: f64,
    /// Part of the setpoint velocity in the commanded velocity (KVF).
    pub feedforward: f64,
}

impl VelocityLoop {
    pub(super) fn is_off(&self) -> bool {
        *self == Self::default()
    }
}

/// Compensation for a drive or valve that does nothing on small outputs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DeadZone {
    /// Error up to which nothing is added, pulses (DZL).
    pub inner: f64,
    /// Error from which all of it is added, pulses (DZU); in between a part.
    pub outer: f64,
    /// Added while the error is positive, V (DIP).
    pub positive: f64,
    /// Taken off while the error is negative, V (DIN).
    pub negative: f64,
}

impl DeadZone {
    /// What is added to the output at an error in pulses, V.
    pub(super) fn added(&self, error: f64) -> f64 {
        let size = error.abs();
        let part = if size <= self.inner {
            0.0
        } else if size >= self.outer {
            1.0
        } else {
            (size - self.inner) / (self.outer - self.inner)
        };
        if error > 0.0 { part * self.positive } else { -part * self.negative }
    }
}
