//! Virtual time.
//!
//! The controller counts ticks of its servo period. Seconds are always computed from the count, never summed up, so that an hour of ticks is
//! exactly an hour.

use thiserror::Error;

/// Length of one program slice in seconds (`docs/fidelity.md`, program scheduling).
pub const SLICE_SECONDS: f64 = 0.001;

/// Counts servo periods since power-up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clock {
    /// Servo period in seconds (`PERIOD`).
    period: f64,
    /// Ticks of a second, when they are a whole number: times are exact quotients then, without the error of the period.
    ticks_per_second: Option<f64>,
    /// Ticks of a program slice.
    slice: u64,
    ticks: u64,
}

impl Clock {
    /// A clock at zero.
    pub fn new(period: f64) -> Self {
        let mut clock = Self { period, ticks_per_second: None, slice: 1, ticks: 0 };
        clock.set_period(period);
        clock
    }

    /// Servo period in seconds.
    pub fn period(self) -> f64 {
        self.period
    }

    /// Changes the servo period. Only sensible while the count is zero.
    pub(crate) fn set_period(&mut self, period: f64) {
        self.period = period;
        self.ticks_per_second = whole_rate(period);
        self.slice = self.tick_at(SLICE_SECONDS).max(1);
    }

    /// Ticks since power-up.
    pub fn ticks(self) -> u64 {
        self.ticks
    }

    /// Seconds since power-up.
    pub fn seconds(self) -> f64 {
        match self.ticks_per_second {
            Some(rate) => self.ticks as f64 / rate,
            None => self.ticks as f64 * self.period,
        }
    }

    /// The first tick that is not before `seconds`. A tick that misses it by less than a millionth of a period counts as reaching it, since
    /// most decimal times have no exact binary form.
    pub fn tick_at(self, seconds: f64) -> u64 {
        let ticks = seconds / self.period;
        let nearest = ticks.round();
        if (ticks - nearest).abs() < 1e-6 { nearest as u64 } else { ticks.ceil() as u64 }
    }

    /// Ticks of a program slice, at least one.
    pub(crate) fn slice_ticks(self) -> u64 {
        self.slice
    }

    pub(crate) fn advance(&mut self, ticks: u64) {
        self.ticks += ticks;
    }
}

fn whole_rate(period: f64) -> Option<f64> {
    let rate = (1.0 / period).round();
    ((rate * period - 1.0).abs() < 1e-12).then_some(rate)
}

/// A duration that cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("`{0}` is no duration: write a number with a unit, for example 250ms, 60s, 5min or 1h")]
pub struct DurationError(String);

/// Reads a duration such as `60s`, `250ms`, `1.5min`, `2h` or a plain number of seconds.
pub fn parse_duration(text: &str) -> Result<f64, DurationError> {
    const UNITS: [(&str, f64); 6] = [("us", 1e-6), ("ms", 1e-3), ("min", 60.0), ("s", 1.0), ("m", 60.0), ("h", 3600.0)];
    let trimmed = text.trim();
    let (number, factor) = UNITS
        .iter()
        .find_map(|(unit, factor)| trimmed.strip_suffix(unit).map(|number| (number, *factor)))
        .unwrap_or((trimmed, 1.0));
    let plain = number.trim();
    let digits = plain.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
    match plain.parse::<f64>() {
        Ok(value) if digits && value.is_finite() => Ok(value * factor),
        _ => Err(DurationError(text.to_owned())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_of_decimal_times_are_exact() {
        let clock = Clock::new(0.0005);
        assert_eq!(clock.tick_at(0.0), 0);
        assert_eq!(clock.tick_at(12.0), 24_000);
        assert_eq!(clock.tick_at(0.15), 300);
        assert_eq!(clock.tick_at(0.0007), 2);
    }

    #[test]
    fn durations_are_read_with_units() {
        assert_eq!(parse_duration("60s"), Ok(60.0));
        assert_eq!(parse_duration("250 ms"), Ok(0.25));
        assert_eq!(parse_duration("2.5"), Ok(2.5));
        assert_eq!(parse_duration("1.5min"), Ok(90.0));
        assert_eq!(parse_duration("2h"), Ok(7200.0));
        for bad in ["", "s", "-1s", "1e3s", "ten", "inf", "1.2.3s"] {
            assert!(parse_duration(bad).is_err(), "{bad}");
        }
    }
}
