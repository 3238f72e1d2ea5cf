//! What can stand between a source and the profiler that follows it: software ratchets and frequency limiters (RATCH,
//! LIMIT), and the programmable limit switch, which follows a source with outputs (PLS).
//!
//! What the guide leaves open, and how it is read here, stands in `docs/fidelity.md`, "Gear, cam and sources".

use crate::wrap::wrap;

/// What a ratchet does with counts of one direction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RatchetRule {
    /// They pass.
    #[default]
    Pass,
    /// They are lost.
    Block,
    /// They are kept, and as many counts of the other direction are used up by them.
    Buffer,
}

/// A software ratchet (RATCH).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ratchet {
    /// What is done with positive counts.
    pub positive: RatchetRule,
    /// What is done with negative counts.
    pub negative: RatchetRule,
    buffered: f64,
}

impl Ratchet {
    /// A ratchet with a rule for each direction.
    pub fn new(positive: RatchetRule, negative: RatchetRule) -> Self {
        Self { positive, negative, buffered: 0.0 }
    }

    /// The ratchet of a RATCH MODE; `None` for a mode whose meaning is not known.
    pub fn from_mode(mode: u8) -> Option<Self> {
        let negative = match mode {
            0 => RatchetRule::Pass,
            3 => RatchetRule::Buffer,
            _ => return None,
        };
        Some(Self::new(RatchetRule::Pass, negative))
    }

    /// Forgets what is buffered (RATCH RES).
    pub fn reset(&mut self) {
        self.buffered = 0.0;
    }

    /// What passes of the counts of a tick.
    pub fn pass(&mut self, counts: f64) -> f64 {
        let made_up = if counts * self.buffered < 0.0 { counts.abs().min(self.buffered.abs()) } else { 0.0 };
        let sign = if counts < 0.0 { -1.0 } else { 1.0 };
        self.buffered += sign * made_up;
        let rest = counts - sign * made_up;
        match if rest < 0.0 { self.negative } else { self.positive } {
            RatchetRule::Pass => rest,
            RatchetRule::Block => 0.0,
            RatchetRule::Buffer => {
                self.buffered += rest;
                0.0
            }
        }
    }
}

/// A frequency limiter (LIMIT).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RateLimiter {
    /// Highest rate that passes, counts/s (LIMIT FREQ); zero does not limit.
    pub rate: f64,
    /// Factor on what comes in (LIMIT MULT).
    pub multiplier: f64,
    waiting: f64,
}

impl Default for RateLimiter {
    fn default() -> Self {
        Self::new(0.0, 1.0)
    }
}

impl RateLimiter {
    /// A limiter of a rate in counts/s and a multiplier.
    pub fn new(rate: f64, multiplier: f64) -> Self {
        Self { rate, multiplier, waiting: 0.0 }
    }

    /// Forgets what still waits (LIMIT RES).
    pub fn reset(&mut self) {
        self.waiting = 0.0;
    }

    /// What passes in a tick of `dt` seconds in which the source changed by `counts`.
    pub fn pass(&mut self, counts: f64, dt: f64) -> f64 {
        self.waiting += counts * self.multiplier;
        let most = if self.rate > 0.0 { self.rate * dt } else { f64::INFINITY };
        let passed = self.waiting.min(most).max(-most);
        self.waiting -= passed;
        passed
    }
}

/// A programmable limit switch (PLS): outputs by the value of a source.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LimitSwitch {
    /// Taken off the source (PLS FLZ).
    pub source_offset: f64,
    /// Places of the table per unit of the source (PLS RATIO).
    pub ratio: f64,
    /// Places after which the table begins anew; zero: never (PLS ROTARY).
    pub rotary: f64,
    /// The bits of the destination that it may change (PLS MASK).
    pub mask: u32,
}

impl Default for LimitSwitch {
    fn default() -> Self {
        Self { source_offset: 0.0, ratio: 1.0, rotary: 0.0, mask: u32::MAX }
    }
}

impl LimitSwitch {
    /// The place in the table for a value of the source; `None` before its beginning.
    pub fn place(&self, source: f64) -> Option<usize> {
        let place = wrap((source - self.source_offset) * self.ratio, self.rotary);
        (place >= 0.0).then_some(place as usize)
    }

    /// What the destination becomes for a value of the source, from the table of outputs (PLS BASE).
    pub fn outputs(&self, source: f64, table: &[u32], destination: u32) -> u32 {
        let value = self.place(source).and_then(|place| table.get(place));
        value.map_or(destination, |value| (destination & !self.mask) | (value & self.mask))
    }
}
