//! Positions on a closed way.

/// Where `x` lies on a way of `length` that closes on itself: at or above zero and below `length`.
///
/// A length that is not positive, or a position that is not finite, is given back as it is.
pub(crate) fn wrap(x: f64, length: f64) -> f64 {
    if !(length > 0.0 && x.is_finite()) || (x >= 0.0 && x < length) {
        return x;
    }
    // The remainder is exact; it has the sign of `x`.
    let rest = x % length;
    let folded = if rest < 0.0 { rest + length } else { rest };
    // A tiny negative remainder rounds up to the whole length.
    if folded >= length { 0.0 } else { folded }
}
