//! Numbers of the controller in the two forms of a packet: 32-bit integers and IEEE singles.
//!
//! The rules are those of `docs/fidelity.md`, "Host interface": a number becomes an integer as it does when a program stores it in
//! a long variable, and a single by rounding to the nearest, where what is beyond the largest single becomes that.

use acrc_vm::Value;

use super::HostError;

/// A number as a long integer. Text has none.
pub(super) fn long(value: &Value) -> Option<i32> {
    value.to_long().ok()
}

/// A number as a single. Text has none.
pub(super) fn single(value: &Value) -> Option<f32> {
    match value {
        Value::Long(long) => Some(*long as f32),
        Value::Single(single) => Some(*single),
        Value::Double(double) => Some(narrowed(*double)),
        Value::Text(_) => None,
    }
}

/// The four bytes that carry a number in its own form: an integer as it is, any other as a single.
pub(super) fn bits(value: &Value) -> Option<u32> {
    match value {
        Value::Long(long) => Some(long.cast_unsigned()),
        _ => single(value).map(f32::to_bits),
    }
}

/// The single next to a 64-bit number.
pub(super) fn narrowed(value: f64) -> f32 {
    (value as f32).clamp(f32::MIN, f32::MAX)
}

/// A single of a host, unless it is infinite or no number.
pub(super) fn finite(value: f32) -> Result<f32, HostError> {
    if value.is_finite() { Ok(value) } else { Err(HostError::NotFinite(value)) }
}
