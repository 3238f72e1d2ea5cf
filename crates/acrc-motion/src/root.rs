//! The square root, with and without the standard library.
//!
//! IEEE 754 fixes every bit of a square root, so both ways below give the same number.

/// The square root of `x`, rounded to nearest.
#[cfg(feature = "std")]
pub(crate) fn sqrt(x: f64) -> f64 {
    x.sqrt()
}

/// The square root of `x`, rounded to nearest.
#[cfg(not(feature = "std"))]
pub(crate) fn sqrt(x: f64) -> f64 {
    integer::sqrt(x)
}

/// The root taken in integers, for targets without a floating-point library.
#[cfg(any(test, not(feature = "std")))]
mod integer {
    const MANTISSA_BITS: u32 = 52;
    const HIDDEN_BIT: u64 = 1 << MANTISSA_BITS;
    const EXPONENT_BIAS: i32 = 1023;

    /// The value `2^exponent` of a normal number.
    fn power_of_two(exponent: i32) -> f64 {
        f64::from_bits(u64::from((exponent + EXPONENT_BIAS).unsigned_abs()) << MANTISSA_BITS)
    }

    pub(super) fn sqrt(x: f64) -> f64 {
        if x < 0.0 {
            return f64::NAN;
        }
        if x == 0.0 || !x.is_finite() {
            return x;
        }
        let bits = x.to_bits();
        let stored = bits & (HIDDEN_BIT - 1);
        // x = mantissa * 2^exponent, the mantissa holding exactly 53 bits.
        let (mantissa, exponent) = match (bits >> MANTISSA_BITS) as i32 {
            0 => {
                let shift = stored.leading_zeros() - HIDDEN_BIT.leading_zeros();
                (stored << shift, 1 - EXPONENT_BIAS - 52 - shift as i32)
            }
            field => (stored | HIDDEN_BIT, field - EXPONENT_BIAS - 52),
        };
        // An even exponent can be halved; 54 bits of root are one more than a double holds.
        let shift = 54 + ((exponent - 54) & 1);
        let root = (u128::from(mantissa) << shift).isqrt() as u64;
        // The root of a 53-bit number never lies exactly between two doubles, so the last bit alone rounds.
        let rounded = (root + 1) >> 1;
        rounded as f64 * power_of_two((exponent - shift) / 2 + 1)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::integer;

    proptest! {
        #[test]
        fn integer_root_equals_the_processor_s(x in proptest::num::f64::ANY) {
            let (ours, exact) = (integer::sqrt(x), x.sqrt());
            prop_assert!(ours.to_bits() == exact.to_bits() || ours.is_nan() && exact.is_nan());
        }
    }

    #[test]
    fn integer_root_at_the_edges() {
        for x in [0.0, -0.0, 1.0, 2.0, 4.0, f64::MIN_POSITIVE, 5e-324, f64::MAX, f64::INFINITY] {
            assert_eq!(integer::sqrt(x).to_bits(), x.sqrt().to_bits(), "{x:e}");
        }
    }
}
