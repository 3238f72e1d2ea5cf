//! Time since a profile began, counted in ticks so that it does not drift.

/// Time counted as a number of equal steps, on top of a part of a step carried in.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Timer {
    base: f64,
    step: f64,
    count: u64,
}

/// A profile counts as over when less than this part of a tick is missing: the product of count and step may round
/// to just below a duration that is a whole number of ticks.
const ROUNDING: f64 = 1e-9;

impl Timer {
    /// A timer that `seconds` have passed on already.
    pub(crate) fn carrying(seconds: f64) -> Self {
        Self { base: seconds, step: 0.0, count: 0 }
    }

    /// Lets `ticks` steps of `step` seconds pass.
    pub(crate) fn advance(&mut self, ticks: u64, step: f64) {
        if step != self.step {
            *self = Self { base: self.elapsed(), step, count: 0 };
        }
        self.count += ticks;
    }

    /// Goes back by `ticks` steps of `step` seconds, at most to `earliest`, s.
    pub(crate) fn retreat(&mut self, ticks: u64, step: f64, earliest: f64) {
        if step != self.step {
            *self = Self { base: self.elapsed(), step, count: 0 };
        }
        let beyond = ticks.saturating_sub(self.count);
        self.count = self.count.saturating_sub(ticks);
        self.base = (self.base - beyond as f64 * step).max(earliest);
    }

    /// Time passed, s.
    pub(crate) fn elapsed(&self) -> f64 {
        self.after(self.count)
    }

    /// Time passed since the end of something that took `duration`, s, and ended within one of the ticks; the whole
    /// ticks after that one are still counted as ticks. `None` while it lasts.
    pub(crate) fn past(&self, duration: f64) -> Option<Self> {
        let over = |count: u64| self.after(count) >= duration - ROUNDING * self.step;
        if !over(self.count) {
            return None;
        }
        let estimate = if self.step > 0.0 { (duration - self.base) / self.step } else { 0.0 };
        // The conversion rounds down and clamps to zero; rounding errors are made good by the two loops.
        let mut first = (estimate as u64).min(self.count);
        while !over(first) {
            first += 1;
        }
        while first > 0 && over(first - 1) {
            first -= 1;
        }
        let base = (self.after(first) - duration).max(0.0);
        Some(Self { base, step: self.step, count: self.count - first })
    }

    /// Time of the tick in which something ended, s, if that was the tick just past.
    pub(crate) fn within_tick(&self) -> Option<f64> {
        (self.count == 0).then_some(self.base)
    }

    fn after(&self, count: u64) -> f64 {
        self.base + count as f64 * self.step
    }
}
