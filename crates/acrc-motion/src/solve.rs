//! A bracketed root finder with a fixed bound on its work.
//!
//! Chandrupatla's method: inverse quadratic interpolation where three points allow it, bisection where they do not.
//! It needs no derivative, never leaves the bracket, and takes the same steps on every machine.

/// A point of the function whose root is wanted.
#[derive(Clone, Copy)]
pub(crate) struct Point {
    pub(crate) x: f64,
    pub(crate) y: f64,
}

/// More than bisection alone needs from the greatest number down to the smallest. About ten steps are usual.
const MAX_STEPS: u32 = 2200;

/// Finds where `f` crosses from `below` (not above zero) to `above` (above zero).
///
/// The answer lies on the side of `below`: `f` is not above zero there, and within `slack` of zero unless the function
/// jumps or the numbers are too coarse for that.
pub(crate) fn crossing(below: Point, above: Point, slack: f64, f: impl Fn(f64) -> f64) -> f64 {
    if below.y >= -slack {
        return below.x;
    }
    let (mut newest, mut other) = (above, below);
    let mut fraction = 0.5;
    for _ in 0..MAX_STEPS {
        let x = newest.x + fraction * (other.x - newest.x);
        let point = Point { x, y: f(x) };
        if point.y <= 0.0 && point.y >= -slack {
            return x;
        }
        let same_side = (point.y > 0.0) == (newest.y > 0.0);
        let previous = if same_side { newest } else { core::mem::replace(&mut other, newest) };
        newest = point;
        let width = (other.x - newest.x).abs();
        let finest = f64::EPSILON * newest.x.abs().max(other.x.abs());
        if width <= finest {
            break;
        }
        fraction = interpolated(newest, other, previous).unwrap_or(0.5);
        let margin = finest / width;
        fraction = if margin < 0.5 { fraction.clamp(margin, 1.0 - margin) } else { 0.5 };
    }
    if newest.y > 0.0 { other.x } else { newest.x }
}

/// The part of the way from `a` to `b` at which the inverse parabola through the points is zero, where it is trusted.
fn interpolated(a: Point, b: Point, c: Point) -> Option<f64> {
    let xi = (a.x - b.x) / (c.x - b.x);
    let phi = (a.y - b.y) / (c.y - b.y);
    if phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi {
        let first = a.y / (b.y - a.y) * (c.y / (b.y - c.y));
        let second = (c.x - a.x) / (b.x - a.x) * (a.y / (c.y - a.y)) * (b.y / (c.y - b.y));
        Some(first + second)
    } else {
        None
    }
}
