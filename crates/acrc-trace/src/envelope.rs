//! The least and the greatest value of every signal over time, in bounded memory.
//!
//! A short run is kept sample by sample. When a run is longer than there is room for, two neighbouring points become one that holds the least and the
//! greatest of both, and from then on a point stands for twice as many samples. No peak is ever lost, only the moment at which it was.

use crate::trace::check_row;
use crate::{Signal, TraceError};

/// What a run recorded, as points of one or more samples each.
#[derive(Clone, Debug)]
pub struct Envelope {
    signals: Vec<Signal>,
    /// Points at most.
    limit: usize,
    /// Samples of a point.
    per_point: u64,
    /// Samples of the last point so far.
    pending: u64,
    last_time: Option<f64>,
    times: Vec<f64>,
    bands: Vec<Band>,
}

/// The values of one signal, one a point. Points without a number are NaN.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Band {
    /// The least value of each point.
    pub low: Vec<f64>,
    /// The greatest value of each point.
    pub high: Vec<f64>,
}

impl Band {
    fn push(&mut self, value: f64) {
        self.low.push(value);
        self.high.push(value);
    }

    fn widen(&mut self, value: f64) {
        if let (Some(low), Some(high)) = (self.low.last_mut(), self.high.last_mut()) {
            // These take the other one where one is no number.
            *low = low.min(value);
            *high = high.max(value);
        }
    }

    fn merge_pairs(&mut self) {
        merge(&mut self.low, f64::min);
        merge(&mut self.high, f64::max);
    }

    /// Whether the signal was 0 all the time.
    pub fn is_zero(&self) -> bool {
        self.low.iter().chain(&self.high).all(|value| *value == 0.0)
    }
}

impl Envelope {
    /// Takes these signals, and keeps at most so many `values` of all of them together: a least and a greatest one each count.
    #[must_use]
    pub fn new(signals: Vec<Signal>, values: usize) -> Self {
        let limit = (values / (2 * signals.len().max(1))).max(2);
        let bands = signals.iter().map(|_| Band::default()).collect();
        Self { signals, limit, per_point: 1, pending: 0, last_time: None, times: Vec::new(), bands }
    }

    /// Adds the samples of one point in time: `time` in seconds, `values` in the order of the signals.
    pub fn push(&mut self, time: f64, values: &[f64]) -> Result<(), TraceError> {
        check_row(self.signals.len(), self.last_time, time, values)?;
        self.last_time = Some(time);
        let begins = self.times.is_empty() || self.pending == self.per_point;
        if begins && self.times.len() >= self.limit {
            self.thin_out();
            return self.push(time, values);
        }
        if begins {
            self.times.push(time);
            self.pending = 0;
        }
        self.pending += 1;
        for (band, value) in self.bands.iter_mut().zip(values) {
            if begins { band.push(*value) } else { band.widen(*value) }
        }
        Ok(())
    }

    fn thin_out(&mut self) {
        let is_odd = self.times.len() % 2 == 1;
        merge(&mut self.times, |first, _| first);
        self.bands.iter_mut().for_each(Band::merge_pairs);
        self.pending = if is_odd { self.per_point } else { 2 * self.per_point };
        self.per_point *= 2;
    }

    /// The same without some signals, given by their indices.
    #[must_use]
    pub fn without(mut self, is_left_out: impl Fn(usize) -> bool) -> Self {
        let mut index = 0..;
        self.signals.retain(|_| index.next().is_some_and(|index| !is_left_out(index)));
        let mut index = 0..;
        self.bands.retain(|_| index.next().is_some_and(|index| !is_left_out(index)));
        self
    }

    /// The signals.
    pub fn signals(&self) -> &[Signal] {
        &self.signals
    }

    /// How many samples a point stands for: 1 as long as nothing had to be left out.
    pub fn per_point(&self) -> u64 {
        self.per_point
    }

    /// When each point begins, in seconds.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// When the last sample was taken, in seconds; `None` without one.
    pub fn end(&self) -> Option<f64> {
        self.last_time
    }

    /// The values, in the order of the signals.
    pub fn bands(&self) -> &[Band] {
        &self.bands
    }
}

/// Makes one of two neighbours; the last one stays alone where there is no other.
fn merge(values: &mut Vec<f64>, join: impl Fn(f64, f64) -> f64) {
    let merged = values.chunks(2).map(|pair| match pair {
        [first, second] => join(*first, *second),
        [alone] => *alone,
        _ => f64::NAN,
    });
    *values = merged.collect();
}
