//! How often a run is sampled.

use acrc_controller::View;
use anyhow::bail;

/// Seconds from one sample to the next when nobody says.
const USUAL: f64 = 0.001;
/// How far a time may miss a multiple of the servo period, in periods: most decimal times have no exact binary form.
const ROUNDING: f64 = 1e-6;

/// How often a run is sampled.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rate {
    /// Seconds from one sample to the next, if somebody says.
    every: Option<f64>,
    /// The servo period of the controller with the ticks from one sample to the next; setup code may change it.
    stride: Option<(f64, u64)>,
}

impl Rate {
    pub(super) fn new(every: Option<f64>) -> anyhow::Result<Self> {
        if every.is_some_and(|every| every <= 0.0) {
            bail!("--rate: the time between two samples must be above 0");
        }
        Ok(Self { every, stride: None })
    }

    /// Whether the present tick is to be sampled.
    pub(super) fn is_due(&mut self, view: &View) -> anyhow::Result<bool> {
        let period = view.period();
        let stride = match self.stride {
            Some((known, stride)) if known == period => stride,
            _ => self.ticks(period)?,
        };
        self.stride = Some((period, stride));
        Ok(view.ticks().is_multiple_of(stride))
    }

    fn ticks(self, period: f64) -> anyhow::Result<u64> {
        let Some(every) = self.every else { return Ok(((USUAL / period).round() as u64).max(1)) };
        let exact = every / period;
        let ticks = exact.round();
        if ticks >= 1.0 && (exact - ticks).abs() <= ROUNDING * ticks.max(1.0) {
            return Ok(ticks as u64);
        }
        let (below, above) = (exact.floor() * period, exact.ceil() * period);
        let near = match exact.floor() {
            0.0 => format!("the shortest is {}", time(above)),
            _ => format!("{} and {} are", time(below), time(above)),
        };
        bail!("--rate {} is no multiple of the servo period, which is {}; {near}", time(every), time(period))
    }
}

/// A time as it is written on the command line.
fn time(seconds: f64) -> String {
    let (value, unit) = match seconds {
        _ if seconds < 0.001 => (seconds * 1e6, "us"),
        _ if seconds < 1.0 => (seconds * 1e3, "ms"),
        _ => (seconds, "s"),
    };
    // Nine digits are more than any servo period has, and hide what the binary form adds.
    let rounded = (value * 1e6).round() / 1e6;
    format!("{rounded}{unit}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ticks(every: Option<f64>, period: f64) -> Result<u64, String> {
        Rate { every, stride: None }.ticks(period).map_err(|error| error.to_string())
    }

    #[test]
    fn only_multiples_of_the_servo_period_are_rates() {
        assert_eq!(ticks(None, 0.0005), Ok(2));
        assert_eq!(ticks(None, 0.0004), Ok(3));
        assert_eq!(ticks(None, 0.002), Ok(1));
        assert_eq!(ticks(Some(0.0005), 0.0005), Ok(1));
        assert_eq!(ticks(Some(0.03), 0.0005), Ok(60));
        assert_eq!(ticks(Some(3600.0), 0.0003), Ok(12_000_000));
        for (every, period, expected) in [
            (0.0007, 0.0005, "--rate 700us is no multiple of the servo period, which is 500us; 500us and 1ms are"),
            (0.00025, 0.0005, "--rate 250us is no multiple of the servo period, which is 500us; the shortest is 500us"),
            (1.0001, 0.0004, "--rate 1.0001s is no multiple of the servo period, which is 400us; 1s and 1.0004s are"),
        ] {
            assert_eq!(ticks(Some(every), period), Err(expected.to_owned()));
        }
    }
}
