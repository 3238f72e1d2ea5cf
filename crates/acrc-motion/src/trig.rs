//! Sines and cosines with the same bits on every machine.
//!
//! They come from the crate `libm`, without its feature `arch`: portable code of additions and multiplications in a
//! fixed order, in place of the platform's mathematics library, whose last bits differ from one system to the next.

/// Radians in a degree.
pub(crate) const DEGREE: f64 = core::f64::consts::PI / 180.0;

/// Sine and cosine of an angle in radians.
pub(crate) fn sin_cos(radians: f64) -> (f64, f64) {
    libm::sincos(radians)
}

/// Sine and cosine of an angle in degrees; exact at the quarters of a turn.
pub(crate) fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    let quarters = libm::rint(degrees / 90.0);
    let (sin, cos) = sin_cos((degrees - quarters * 90.0) * DEGREE);
    // The remainder is -3 to 3, without a fraction.
    match (libm::fmod(quarters, 4.0) as i8).rem_euclid(4) {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// The angle of the direction `(x, y)`, in radians, -π to π.
pub(crate) fn angle(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

#[cfg(test)]
mod tests {
    use super::sin_cos_degrees;

    #[test]
    fn quarters_of_a_turn_are_exact() {
        for turns in [-2.0, 0.0, 1.0, 1000.0] {
            let at = |degrees: f64| sin_cos_degrees(turns * 360.0 + degrees);
            assert_eq!([at(0.0), at(90.0), at(180.0), at(270.0)], [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)]);
        }
    }

    #[test]
    fn other_angles_agree_with_the_standard_library() {
        for tenths in -7200..7200 {
            let degrees = f64::from(tenths) / 10.0;
            let (sin, cos) = sin_cos_degrees(degrees);
            let (expected_sin, expected_cos) = degrees.to_radians().sin_cos();
            assert!((sin - expected_sin).abs() < 1e-14 && (cos - expected_cos).abs() < 1e-14, "{degrees}");
        }
    }
}
