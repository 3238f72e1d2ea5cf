//! Samples of a run in bounded memory, whatever its length.

use acrc_trace::{Signal, Trace, TraceError};

/// A trace of at most so many rows: when it is full, every second row is dropped, and from then on half as many are taken.
#[derive(Debug)]
pub(super) struct Thinned {
    trace: Trace,
    most: usize,
    /// Every how manieth sample is kept.
    keep: u64,
    samples: u64,
}

impl Thinned {
    pub(super) fn new(signals: Vec<Signal>, most: usize) -> Self {
        Self { trace: Trace::new(signals), most, keep: 1, samples: 0 }
    }

    pub(super) fn sample(&mut self, seconds: f64, row: &[f64]) -> Result<(), TraceError> {
        self.samples += 1;
        if !(self.samples - 1).is_multiple_of(self.keep) {
            return Ok(());
        }
        if self.trace.rows() >= self.most {
            self.thin_out()?;
        }
        self.trace.push(seconds, row)
    }

    fn thin_out(&mut self) -> Result<(), TraceError> {
        let full = std::mem::replace(&mut self.trace, Trace::new(Vec::new()));
        let mut thinner = Trace::new(full.signals().to_vec());
        let mut values = Vec::with_capacity(full.signals().len());
        for (index, time) in full.times().iter().enumerate().step_by(2) {
            values.clear();
            values.extend((0..full.signals().len()).filter_map(|signal| full.value(index, signal)));
            thinner.push(*time, &values)?;
        }
        self.trace = thinner;
        self.keep *= 2;
        Ok(())
    }

    /// What is there.
    pub(super) fn into_trace(self) -> Trace {
        self.trace
    }
}
