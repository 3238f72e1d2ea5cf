//! Pairs of limits: one for each side of zero.

use super::Side;
use crate::value::{InvalidValue, Quantity, finite};

/// A stretch between a negative and a positive limit: of positions, errors or outputs, as the command says that sets it
/// (ALM, BLM, EXC, IPB, ITB, JLM, SLM, TLM).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Window {
    /// Upper end.
    pub positive: f64,
    /// Lower end.
    pub negative: f64,
}

impl Window {
    /// From `-value` to `value`, as a single value of these commands means.
    pub fn symmetric(value: f64) -> Self {
        Self { positive: value, negative: -value }
    }

    /// Whether a value lies inside; the ends belong to it.
    pub fn contains(&self, value: f64) -> bool {
        value >= self.negative && value <= self.positive
    }

    /// The value moved inside. (A window whose ends are the wrong way round yields its upper end.)
    pub fn clamp(&self, value: f64) -> f64 {
        value.max(self.negative).min(self.positive)
    }

    /// The side on which a value has reached or passed an end.
    pub fn reached(&self, value: f64) -> Option<Side> {
        if value >= self.positive {
            Some(Side::Positive)
        } else if value <= self.negative {
            Some(Side::Negative)
        } else {
            None
        }
    }

    /// Whether both ends are zero, which switches most of the limits off.
    pub fn is_zero(&self) -> bool {
        self.positive == 0.0 && self.negative == 0.0
    }

    /// Refuses ends that are no numbers.
    pub(crate) fn validate(&self) -> Result<(), InvalidValue> {
        finite(Quantity::Limit, self.positive)?;
        finite(Quantity::Limit, self.negative)?;
        Ok(())
    }
}
