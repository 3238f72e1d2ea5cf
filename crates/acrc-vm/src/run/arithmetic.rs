//! Arithmetic of the loop: what has a rule of its own or can go wrong.

use crate::fault::FaultKind;
use crate::locals::round_to_single;
use crate::op::{LongOperator, ValueOperator};
use crate::value::{Value, double_to_long};

#[inline]
pub(super) fn finite(value: f64, operation: &'static str) -> Result<f64, FaultKind> {
    if value.is_finite() { Ok(value) } else { Err(FaultKind::NotFinite { operation }) }
}

#[inline]
pub(super) fn quotient(left: f64, right: f64) -> Result<f64, FaultKind> {
    if right == 0.0 { Err(FaultKind::DivisionByZero) } else { finite(left / right, "/") }
}

/// `MOD`, with the sign of the dividend.
#[inline]
pub(super) fn remainder(left: i32, right: i32) -> Result<i32, FaultKind> {
    if right == 0 { Err(FaultKind::DivisionByZero) } else { Ok(left.wrapping_rem(right)) }
}

#[inline]
pub(super) fn long_operate(operator: LongOperator, left: i32, right: i32) -> Result<i32, FaultKind> {
    Ok(match operator {
        LongOperator::Rem => return remainder(left, right),
        LongOperator::And => left & right,
        LongOperator::Nand => !(left & right),
        LongOperator::Or => left | right,
        LongOperator::Nor => !(left | right),
        LongOperator::Xor => left ^ right,
        LongOperator::Xnor => !(left ^ right),
        // A count outside of 0 to 31 moves every bit out.
        LongOperator::ShiftLeft => left.checked_shl(right as u32).unwrap_or(0),
        LongOperator::ShiftRight => left.checked_shr(right as u32).unwrap_or(left >> 31),
    })
}

/// Arithmetic on numbers whose types are known only now; the rules are those of the loader.
pub(super) fn value_operate(operator: ValueOperator, left: &Value, right: &Value) -> Result<Value, FaultKind> {
    if let (Value::Long(left), Value::Long(right)) = (left, right) {
        match operator {
            ValueOperator::Add => return Ok(Value::Long(left.wrapping_add(*right))),
            ValueOperator::Sub => return Ok(Value::Long(left.wrapping_sub(*right))),
            ValueOperator::Mul => return Ok(Value::Long(left.wrapping_mul(*right))),
            ValueOperator::Div => {}
        }
    }
    let (a, b) = (left.to_f64()?, right.to_f64()?);
    let result = match operator {
        ValueOperator::Add => finite(a + b, "+"),
        ValueOperator::Sub => finite(a - b, "-"),
        ValueOperator::Mul => finite(a * b, "*"),
        ValueOperator::Div => quotient(a, b),
    }?;
    match (left, right) {
        (Value::Single(_), Value::Single(_)) => round_to_single(result).map(Value::Single),
        _ => Ok(Value::Double(result)),
    }
}

pub(super) fn negate(value: &Value) -> Result<Value, FaultKind> {
    match value {
        Value::Long(value) => Ok(Value::Long(value.wrapping_neg())),
        Value::Single(value) => Ok(Value::Single(-value)),
        Value::Double(value) => Ok(Value::Double(-value)),
        Value::Text(_) => Err(FaultKind::NumberExpected),
    }
}

pub(super) fn absolute(value: &Value) -> Result<Value, FaultKind> {
    match value {
        Value::Long(value) => Ok(Value::Long(value.wrapping_abs())),
        Value::Single(value) => Ok(Value::Single(value.abs())),
        Value::Double(value) => Ok(Value::Double(value.abs())),
        Value::Text(_) => Err(FaultKind::NumberExpected),
    }
}

/// The argument of `RND`. The guide passes 4294967295; a negative long counts as the unsigned number of the same bits.
pub(super) fn random_bound(below: f64) -> Result<u32, FaultKind> {
    match double_to_long(below) as u32 {
        0 => Err(FaultKind::Domain { function: "RND", argument: below }),
        below => Ok(below),
    }
}
