//! The output filters of the servo loop: NOTCH and LOPASS.

use core::f64::consts::{PI, SQRT_2};

/// A digital filter of second order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Biquad {
    feed: [f64; 3],
    back: [f64; 2],
    memory: [f64; 2],
}

impl Biquad {
    /// A notch of a width between its half-power points, both in Hz, at a sampling period in s.
    ///
    /// `None`, which is no filter, if a value is not above zero or the frequency cannot be sampled.
    pub(super) fn notch(frequency: f64, width: f64, period: f64) -> Option<Self> {
        let warped = warped(frequency, period).filter(|_| width > 0.0)?;
        let damping = warped * width / frequency;
        let square = warped * warped;
        let scale = 1.0 / (1.0 + damping + square);
        let (ends, middle) = ((1.0 + square) * scale, 2.0 * (square - 1.0) * scale);
        Some(Self::new([ends, middle, ends], [middle, (1.0 - damping + square) * scale]))
    }

    /// A low pass of second order without overshoot in its frequency response (Butterworth), 3 dB down at a frequency in
    /// Hz. `None` as for a notch.
    pub(super) fn low_pass(frequency: f64, period: f64) -> Option<Self> {
        let warped = warped(frequency, period)?;
        let damping = SQRT_2 * warped;
        let square = warped * warped;
        let scale = 1.0 / (1.0 + damping + square);
        let gain = square * scale;
        Some(Self::new([gain, 2.0 * gain, gain], [2.0 * (square - 1.0) * scale, (1.0 - damping + square) * scale]))
    }

    fn new(feed: [f64; 3], back: [f64; 2]) -> Self {
        Self { feed, back, memory: [0.0; 2] }
    }

    /// Forgets what went through it.
    pub(super) fn reset(&mut self) {
        self.memory = [0.0; 2];
    }

    /// The next sample.
    pub(super) fn apply(&mut self, x: f64) -> f64 {
        let [b0, b1, b2] = self.feed;
        let [a1, a2] = self.back;
        let y = b0 * x + self.memory[0];
        self.memory = [b1 * x - a1 * y + self.memory[1], b2 * x - a2 * y];
        y
    }
}

/// The frequency at which a filter sampled at a period has the response that an analog one has at `frequency`.
fn warped(frequency: f64, period: f64) -> Option<f64> {
    let cycles = frequency * period;
    (cycles > 0.0 && cycles < 0.5).then(|| libm::tan(PI * cycles))
}
