//! What lies between the loop and the machine: the converter of the output and the counter of the encoder.

use crate::value::{InvalidValue, Quantity, finite, not_negative};

/// Counts per volt of the converter itself: 16 bits over 20 V.
const COUNTS_PER_VOLT: f64 = 3276.8;

/// An analog output (DAC GAIN, DAC OFFSET).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dac {
    /// Counts per volt; a negative one turns the output round.
    pub gain: f64,
    /// Added to the output, V.
    pub offset: f64,
}

impl Default for Dac {
    fn default() -> Self {
        Self { gain: COUNTS_PER_VOLT, offset: 0.0 }
    }
}

impl Dac {
    /// The counts that the converter is given for an output in volts, within its 16 bits.
    pub fn counts(&self, volts: f64) -> i16 {
        let counts = (volts + self.offset) * self.gain;
        // The conversion cuts the fraction off and keeps within the type; a half rounds away from zero.
        (counts + if counts < 0.0 { -0.5 } else { 0.5 }) as i16
    }

    /// The voltage at the terminal for an output of the loop in volts.
    pub fn terminal(&self, volts: f64) -> f64 {
        f64::from(self.counts(volts)) / COUNTS_PER_VOLT
    }
}

/// An incremental encoder and its multiplier (MULT).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Encoder {
    pulses_per_turn: f64,
}

impl Encoder {
    /// An encoder of a number of lines and a multiplier of -4, -2, -1, 0, 1, 2 or 4.
    pub fn new(lines: f64, multiplier: i8) -> Result<Self, InvalidValue> {
        not_negative(Quantity::EncoderLines, lines)?;
        if !matches!(multiplier, -4 | -2 | -1 | 0 | 1 | 2 | 4) {
            return Err(InvalidValue { quantity: Quantity::Multiplier, value: multiplier.into() });
        }
        Ok(Self { pulses_per_turn: finite(Quantity::EncoderLines, lines * f64::from(multiplier))? })
    }

    /// Pulses in a turn; negative when it counts backwards.
    pub fn pulses_per_turn(&self) -> f64 {
        self.pulses_per_turn
    }

    /// Whole pulses counted at an angle in turns.
    pub fn count(&self, turns: f64) -> f64 {
        let pulses = turns * self.pulses_per_turn;
        let whole = (pulses as i64) as f64;
        if pulses < whole { whole - 1.0 } else { whole }
    }
}
