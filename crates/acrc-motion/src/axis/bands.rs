//! Bands that an axis reports whether it is in: in position, excess error, torque, stroke limits (IPB, EXC, ITB, TLM, ALM,
//! BLM).

use super::Window;
use crate::value::InvalidValue;

/// The bands of an axis. All ends are zero by default.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bands {
    /// Following errors at which the axis is in position, u (IPB).
    pub in_position: Window,
    /// Following errors that are not in excess, u (EXC).
    pub excess_error: Window,
    /// Outputs inside the torque band, V (ITB).
    pub torque: Window,
    /// Stroke limit A, u (ALM).
    pub stroke_a: Window,
    /// Stroke limit B, u (BLM).
    pub stroke_b: Window,
}

/// Which bands an axis is in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "each is a flag of the controller")]
pub struct BandFlags {
    /// In position: the opposite of flag 768 of axis 0.
    pub in_position: bool,
    /// No excess error: flag 769 of axis 0.
    pub error_allowed: bool,
    /// Output inside the torque band.
    pub in_torque_band: bool,
    /// Setpoint inside stroke limit A.
    pub in_stroke_a: bool,
    /// Setpoint inside stroke limit B.
    pub in_stroke_b: bool,
}

impl Bands {
    /// Refuses ends that are no numbers.
    pub fn validate(&self) -> Result<(), InvalidValue> {
        for window in [self.in_position, self.excess_error, self.torque, self.stroke_a, self.stroke_b] {
            window.validate()?;
        }
        Ok(())
    }

    /// Which bands an axis is in with a following error (u), a servo output (V) and a primary setpoint (u).
    pub fn flags(&self, following_error: f64, output: f64, setpoint: f64) -> BandFlags {
        BandFlags {
            in_position: self.in_position.contains(following_error),
            error_allowed: self.excess_error.contains(following_error),
            in_torque_band: self.torque.contains(output),
            in_stroke_a: self.stroke_a.contains(setpoint),
            in_stroke_b: self.stroke_b.contains(setpoint),
        }
    }
}
