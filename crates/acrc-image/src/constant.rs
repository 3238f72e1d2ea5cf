//! Numbers: from the text of a literal to a constant, and back.
//!
//! The two directions belong together: a number that is listed and read again must be the same constant, in kind and in value, because kind
//! decides what the program costs (guide, "How Much Memory?": 4 bytes for a long or single constant, 8 for a double).

use acrc_catalog::UnaryOperator;

use crate::node::Node;

/// A number written with more significant digits is a double.
pub const SINGLE_DIGITS: usize = 7;

/// Whole numbers up to here are exact in a double.
const EXACT: u64 = 1 << 53;

/// The constant of a whole number without a sign: a long, or a double beyond 32 bits. `None` when no double holds it exactly.
pub fn integer(value: u64) -> Option<Node> {
    match i32::try_from(value) {
        Ok(long) => Some(Node::Long(long)),
        Err(_) => (value <= EXACT).then_some(Node::Double(value as f64)),
    }
}

/// The constant of a number with a point or an exponent, without a sign. `None` when it is not a number or too large for a double.
pub fn real(text: &str) -> Option<Node> {
    let double: f64 = text.parse().ok().filter(|value: &f64| value.is_finite())?;
    // What is too small for a double is zero, however it is written.
    let single = if double == 0.0 { Some(0.0) } else { as_single(text) };
    Some(single.map_or(Node::Double(double), Node::Single))
}

/// A minus sign in front of `node`. The sign of a number is part of the number; a long has no negative zero, which keeps its sign as an
/// operator because `INH -0` waits for flag 0 to clear.
pub fn negate(node: Node) -> Node {
    match node {
        Node::Double(value) if value == -f64::from(i32::MIN) => Node::Long(i32::MIN),
        // Longs wrap, here as at run time.
        Node::Long(value) if value != 0 => Node::Long(value.wrapping_neg()),
        Node::Single(value) => Node::Single(-value),
        Node::Double(value) => Node::Double(-value),
        other => Node::Unary { op: UnaryOperator::Minus, operand: Box::new(other), parens: 0 },
    }
}

/// The text of a single constant.
pub fn format_single(value: f32) -> String {
    let plain = format!("{value:?}");
    // The zero that Rust adds behind a point counts as a digit when it is read.
    let shorter = plain.strip_suffix('0').filter(|shorter| shorter.ends_with('.')).unwrap_or(&plain);
    if significant_digits(&plain) <= SINGLE_DIGITS {
        plain
    } else if significant_digits(shorter) <= SINGLE_DIGITS {
        shorter.to_owned()
    } else {
        format!("{value:e}")
    }
}

/// The text of a double constant: a whole number beyond 32 bits without a point, anything else with so many digits that it is read as a
/// double again.
pub fn format_double(value: f64) -> String {
    let whole = value.trunc() == value && value.abs() <= EXACT as f64;
    if whole && !(f64::from(i32::MIN)..=f64::from(i32::MAX)).contains(&value) {
        return format!("{value:.0}");
    }
    let plain = format!("{value:?}");
    if value == 0.0 || as_single(plain.trim_start_matches('-')).is_none() {
        return plain;
    }
    let (mantissa, exponent) = plain.find('e').map_or((plain.as_str(), ""), |at| plain.split_at(at));
    let point = if mantissa.contains('.') { "" } else { "." };
    let zeros = "0".repeat(SINGLE_DIGITS + 1 - significant_digits(mantissa));
    format!("{mantissa}{point}{zeros}{exponent}")
}

/// The single constant that `text` (no sign) stands for, when it has few enough digits and a single holds it with full precision.
fn as_single(text: &str) -> Option<f32> {
    let value: f32 = text.parse().ok()?;
    (significant_digits(text) <= SINGLE_DIGITS && value.is_normal()).then_some(value)
}

/// Digits from the first that is not zero to the last one written, before the exponent.
fn significant_digits(text: &str) -> usize {
    let mantissa = text.bytes().take_while(|byte| !byte.eq_ignore_ascii_case(&b'e'));
    mantissa.filter(u8::is_ascii_digit).skip_while(|&digit| digit == b'0').count()
}
