//! Samples in memory, one column a signal.

use thiserror::Error;

use crate::Signal;

/// Why a row of samples was refused; the trace is left as it was.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum TraceError {
    /// The row does not have one value a signal.
    #[error("a row has {found} values, but {expected} signals are recorded")]
    WrongLength {
        /// Number of signals.
        expected: usize,
        /// Number of values in the row.
        found: usize,
    },
    /// The time is not a finite number.
    #[error("the time of a row is {time}, which is not a point in time")]
    NotATime {
        /// The time given, in seconds.
        time: f64,
    },
    /// The row lies before the one recorded last.
    #[error("a row at {time} s follows one at {previous} s")]
    TimeGoesBack {
        /// Time of the last row, in seconds.
        previous: f64,
        /// The time given, in seconds.
        time: f64,
    },
}

/// The recorded signals of a run. Times never go back; several rows may share one time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trace {
    signals: Vec<Signal>,
    times: Vec<f64>,
    columns: Vec<Vec<f64>>,
}

impl Trace {
    /// A trace of these signals, without samples.
    #[must_use]
    pub fn new(signals: Vec<Signal>) -> Self {
        let columns = signals.iter().map(|_| Vec::new()).collect();
        Self { signals, times: Vec::new(), columns }
    }

    /// Adds the samples of one point in time: `time` in seconds, `values` in the order of [`Self::signals`]. Values may
    /// be NaN or infinite: plots leave them out.
    pub fn push(&mut self, time: f64, values: &[f64]) -> Result<(), TraceError> {
        check_row(self.signals.len(), self.times.last().copied(), time, values)?;
        self.times.push(time);
        for (column, value) in self.columns.iter_mut().zip(values) {
            column.push(*value);
        }
        Ok(())
    }

    /// The same without some signals, given by their indices.
    #[must_use]
    pub fn without(mut self, is_left_out: impl Fn(usize) -> bool) -> Self {
        let mut index = 0..;
        self.signals.retain(|_| index.next().is_some_and(|index| !is_left_out(index)));
        let mut index = 0..;
        self.columns.retain(|_| index.next().is_some_and(|index| !is_left_out(index)));
        self
    }

    /// The signals, in the order of the values of a row.
    pub fn signals(&self) -> &[Signal] {
        &self.signals
    }

    /// Index of the first signal with this name.
    pub fn signal_index(&self, name: &str) -> Option<usize> {
        self.signals.iter().position(|signal| signal.name == name)
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.times.len()
    }

    /// Time of a row in seconds; `None` beyond the last one.
    pub fn time(&self, row: usize) -> Option<f64> {
        self.times.get(row).copied()
    }

    /// The value of a signal, given by its index, in a row; `None` beyond the last signal or row.
    pub fn value(&self, row: usize, signal: usize) -> Option<f64> {
        self.columns.get(signal)?.get(row).copied()
    }

    /// The times of all rows, in seconds.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// All values of a signal, given by its index, one a row; empty beyond the last signal.
    pub fn column(&self, signal: usize) -> &[f64] {
        self.columns.get(signal).map_or(&[], Vec::as_slice)
    }
}

/// Whether a row fits `signals` signals and may follow one at `previous` seconds.
pub(crate) fn check_row(signals: usize, previous: Option<f64>, time: f64, values: &[f64]) -> Result<(), TraceError> {
    if values.len() != signals {
        return Err(TraceError::WrongLength { expected: signals, found: values.len() });
    }
    if !time.is_finite() {
        return Err(TraceError::NotATime { time });
    }
    match previous {
        Some(previous) if time < previous => Err(TraceError::TimeGoesBack { previous, time }),
        _ => Ok(()),
    }
}
