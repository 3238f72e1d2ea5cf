//! Numbers as text.

use crate::value::Value;

/// Whole numbers below this print all their digits; it is the largest power of ten below which a 64-bit number has 15
/// digits.
const WHOLE_LIMIT: f64 = 1e15;

/// Significant digits of a 32-bit floating point number.
const SINGLE_DIGITS: usize = 7;

/// Significant digits of a 64-bit floating point number.
const DOUBLE_DIGITS: usize = 15;

/// Exponents of ten below this are written in the exponent form.
const SMALLEST_FIXED_EXPONENT: i32 = -4;

/// A value as `PRINT` and `STR$` write it. A string is written as it is.
pub fn number(value: &Value) -> String {
    match value {
        Value::Long(value) => value.to_string(),
        Value::Single(value) => single(*value),
        Value::Double(value) => double(*value),
        Value::Text(text) => text.to_string(),
    }
}

/// A 32-bit floating point number: at most seven significant digits.
pub fn single(value: f32) -> String {
    let shortest = format!("{value:e}");
    render(f64::from(value), &shortest, SINGLE_DIGITS)
}

/// A 64-bit floating point number: at most fifteen significant digits.
pub fn double(value: f64) -> String {
    let shortest = format!("{value:e}");
    render(value, &shortest, DOUBLE_DIGITS)
}

/// `shortest` is the value in Rust's exponent form, with the fewest digits that read back.
fn render(value: f64, shortest: &str, digits: usize) -> String {
    if !value.is_finite() {
        return shortest.to_owned();
    }
    if value.trunc() == value && value.abs() < WHOLE_LIMIT {
        return format!("{}", value as i64);
    }
    let rounded = format!("{value:.*e}", digits - 1);
    let scientific = if significant(shortest) > digits { &rounded } else { shortest };
    let Some((mantissa, exponent)) = scientific.split_once('e') else { return scientific.to_owned() };
    let Ok(exponent) = exponent.parse::<i32>() else { return scientific.to_owned() };
    let (sign, mantissa) = mantissa.strip_prefix('-').map_or(("", mantissa), |rest| ("-", rest));
    let mut figures: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    figures.truncate(figures.trim_end_matches('0').len().max(1));
    let body = if (SMALLEST_FIXED_EXPONENT..digits as i32).contains(&exponent) {
        fixed(&figures, exponent)
    } else {
        exponential(&figures, exponent)
    };
    format!("{sign}{body}")
}

/// Number of digits in front of the exponent.
fn significant(scientific: &str) -> usize {
    scientific.bytes().take_while(|byte| *byte != b'e').filter(u8::is_ascii_digit).count()
}

/// `figures` with the point behind the first one, moved by `exponent`.
fn fixed(figures: &str, exponent: i32) -> String {
    let Ok(behind_first) = usize::try_from(exponent) else {
        let zeros = "0".repeat(exponent.unsigned_abs() as usize - 1);
        return format!("0.{zeros}{figures}");
    };
    let whole = behind_first + 1;
    match figures.split_at_checked(whole) {
        Some((before, behind)) if !behind.is_empty() => format!("{before}.{behind}"),
        _ => format!("{figures:0<whole$}"),
    }
}

/// `1.5e-07`
fn exponential(figures: &str, exponent: i32) -> String {
    let sign = if exponent < 0 { '-' } else { '+' };
    let (first, rest) = figures.split_at(1);
    let point = if rest.is_empty() { "" } else { "." };
    format!("{first}{point}{rest}e{sign}{:02}", exponent.unsigned_abs())
}
