//! How late things were.

use std::time::Duration;

/// Width of a class in microseconds.
const WIDTH: u128 = 10;
/// Classes; what is later than the last one counts in it.
const CLASSES: usize = 5000;

/// Counts durations in classes of 10 us up to 50 ms.
#[derive(Clone, Debug)]
pub struct Histogram {
    classes: Vec<u64>,
    count: u64,
    longest: Duration,
}

impl Default for Histogram {
    fn default() -> Self {
        Self { classes: vec![0; CLASSES], count: 0, longest: Duration::ZERO }
    }
}

impl Histogram {
    pub(crate) fn record(&mut self, duration: Duration) {
        let class = usize::try_from(duration.as_micros() / WIDTH).unwrap_or(CLASSES).min(CLASSES - 1);
        if let Some(class) = self.classes.get_mut(class) {
            *class += 1;
        }
        self.count += 1;
        self.longest = self.longest.max(duration);
    }

    /// How many durations there were.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// The longest one.
    pub fn longest(&self) -> Duration {
        self.longest
    }

    /// What a share of them, from 0 to 1, did not exceed, to 10 us. Zero when there were none.
    pub fn quantile(&self, share: f64) -> Duration {
        let wanted = (self.count as f64 * share).ceil() as u64;
        let mut sum = 0;
        for (class, count) in (1_u32..).zip(&self.classes) {
            sum += count;
            if sum >= wanted && *count > 0 {
                return (Duration::from_micros(WIDTH as u64) * class).min(self.longest);
            }
        }
        Duration::ZERO
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_what_was_recorded() {
        let mut histogram = Histogram::default();
        assert_eq!(histogram.quantile(0.99), Duration::ZERO);
        for microseconds in 1..=1000 {
            histogram.record(Duration::from_micros(microseconds));
        }
        assert_eq!(histogram.quantile(0.5), Duration::from_micros(510));
        assert_eq!(histogram.quantile(0.99), Duration::from_millis(1));
        histogram.record(Duration::from_secs(1));
        assert_eq!(histogram.quantile(1.0), Duration::from_millis(50));
        assert_eq!(histogram.longest(), Duration::from_secs(1));
    }
}
