//! Round numbers along an axis: multiples of 1, 2 or 5 times a power of ten.
//!
//! A tick is a whole multiple of its step, and its label is written from that whole number, so that no label ever shows
//! a rounding error such as 0.30000000000000004.

use super::scale::Domain;

/// Labels are written without an exponent if they have at most this many digits before the point,
const MOST_DIGITS: i32 = 6;
/// and either at most this many behind it,
const MOST_DECIMALS: i32 = 4;
/// or at most this many zeros before the first digit that is none.
const MOST_ZEROS: i32 = 2;
/// The factors of a step, with the largest part of the next decade that each is taken for.
const FACTORS: [i64; 3] = [1, 2, 5];

/// A labelled place on an axis.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tick {
    pub(super) value: f64,
    pub(super) label: String,
}

/// The distance between ticks: `factor * 10^exponent`.
#[derive(Clone, Copy)]
struct Step {
    factor: i64,
    exponent: i32,
}

/// About `count` ticks, at most that many and one more.
pub(super) fn ticks(domain: Domain, count: f64) -> Vec<Tick> {
    let step = Step::at_least((domain.max - domain.min) / count.max(1.0));
    let first = step.multiples_in(domain.min).ceil() as i64;
    let last = step.multiples_in(domain.max).floor() as i64;
    let largest = domain.min.abs().max(domain.max.abs()).max(step.value(1));
    let style = LabelStyle::new(step, largest);
    (first..=last).map(|multiple| Tick { value: step.value(multiple), label: style.label(multiple) }).collect()
}

impl Step {
    /// The smallest step that is not below `size`.
    fn at_least(size: f64) -> Self {
        let exponent = decade(size);
        let fitting = FACTORS.into_iter().map(|factor| Self { factor, exponent }).find(|step| step.value(1) >= size);
        fitting.unwrap_or(Self { factor: 1, exponent: exponent + 1 })
    }

    fn value(self, multiple: i64) -> f64 {
        let whole = (multiple * self.factor) as f64;
        // A positive power of ten is exact for longer than a negative one.
        if self.exponent < 0 { whole / power_of_ten(-self.exponent) } else { whole * power_of_ten(self.exponent) }
    }

    /// How many steps fit into `value`.
    fn multiples_in(self, value: f64) -> f64 {
        let whole =
            if self.exponent < 0 { value * power_of_ten(-self.exponent) } else { value / power_of_ten(self.exponent) };
        whole / self.factor as f64
    }
}

/// How the labels of one axis are written: all alike.
struct LabelStyle {
    factor: i64,
    decimals: usize,
    /// Power of ten taken out of every label.
    exponent: Option<i32>,
}

impl LabelStyle {
    fn new(step: Step, largest: f64) -> Self {
        let digits = decade(largest);
        let is_short = step.exponent >= -MOST_DECIMALS || digits >= -MOST_ZEROS;
        let is_plain = digits < MOST_DIGITS && is_short;
        let (unit, exponent) = if is_plain { (0, None) } else { (digits, Some(digits)) };
        let decimals = usize::try_from(unit - step.exponent).unwrap_or(0);
        // Without an exponent, a step of hundreds is written out.
        let zeros = u32::try_from(step.exponent - unit).unwrap_or(0);
        Self { factor: step.factor * 10_i64.pow(zeros), decimals, exponent }
    }

    fn label(&self, multiple: i64) -> String {
        let number = multiple * self.factor;
        if number == 0 {
            return "0".to_owned();
        }
        // The true minus sign is as wide as a digit.
        let sign = if number < 0 { "\u{2212}" } else { "" };
        let digits = format!("{:0width$}", number.unsigned_abs(), width = self.decimals + 1);
        let (whole, part) = digits.split_at(digits.len() - self.decimals);
        let point = if part.is_empty() { "" } else { "." };
        let exponent = self.exponent.map_or_else(String::new, |exponent| format!("e{exponent}"));
        format!("{sign}{whole}{point}{part}{exponent}")
    }
}

/// The exponent of the power of ten at or below a positive number. Read off the decimal form, which is exact, because
/// the last digit of a logarithm depends on the platform.
fn decade(value: f64) -> i32 {
    let text = format!("{value:e}");
    text.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0)
}

fn power_of_ten(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(f64::INFINITY)
}
