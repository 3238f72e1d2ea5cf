//! Paths of axes that turn: arcs, helices, sinusoids, in one form.
//!
//! Along any of them an axis is at `base + slope·s + cos·cos(sweep·s) + sin·sin(sweep·s)`, where `s` runs from zero to
//! one, the same for all axes. An arc has one sweep for its axes, a straight axis none.

use super::AXES;
use super::frame::Rotation;
use crate::root::sqrt;
use crate::trig::sin_cos;

/// The law of one axis, in the coordinates of the program, scaled.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Term {
    pub(super) base: f64,
    pub(super) slope: f64,
    pub(super) cos: f64,
    pub(super) sin: f64,
    /// Radians.
    pub(super) sweep: f64,
}

impl Term {
    /// An axis that moves evenly.
    pub(super) fn straight(from: f64, to: f64) -> Self {
        Self { base: from, slope: to - from, ..Self::default() }
    }

    /// Whether the axis turns.
    fn winds(&self) -> bool {
        self.sweep != 0.0 && (self.cos != 0.0 || self.sin != 0.0)
    }

    /// Derivative of the given order at `s`.
    fn at(&self, order: u8, s: f64) -> f64 {
        let straight = match order {
            0 => self.base + self.slope * s,
            1 => self.slope,
            _ => 0.0,
        };
        if self.cos == 0.0 && self.sin == 0.0 {
            return straight;
        }
        let (sin, cos) = sin_cos(self.sweep * s);
        straight
            + match order {
                0 => self.cos * cos + self.sin * sin,
                1 => self.sweep * (self.sin * cos - self.cos * sin),
                _ => -(self.sweep * self.sweep) * (self.cos * cos + self.sin * sin),
            }
    }

    /// The highest speed that it may have anywhere.
    fn fastest(&self) -> f64 {
        self.slope.abs() + self.sweep.abs() * sqrt(self.cos * self.cos + self.sin * self.sin)
    }

    /// The mean of the square of the first derivative from 0 to 1.
    pub(super) fn mean_square(&self) -> f64 {
        let Self { slope, cos: a, sin: b, sweep, .. } = *self;
        if !self.winds() {
            return slope * slope;
        }
        let (sin, cos) = sin_cos(sweep);
        // Means of sin·cos, and of the difference of sin² and cos² from one half.
        let mixed = sin * sin / (2.0 * sweep);
        let uneven = sin * cos / (2.0 * sweep);
        let wound = a * a * (0.5 - uneven) + b * b * (0.5 + uneven) - 2.0 * a * b * mixed;
        slope * slope + 2.0 * slope * (a * (cos - 1.0) + b * sin) + sweep * sweep * wound
    }
}

/// The laws of all axes of one move.
#[derive(Clone, Copy, Debug)]
pub(super) struct Winding {
    pub(super) terms: [Term; AXES],
    pub(super) rotation: Option<Rotation>,
    /// What is added behind the rotation, u.
    pub(super) shift: [f64; AXES],
}

impl Winding {
    /// Derivative of the given order, by `s`, of where an axis is.
    pub(super) fn at(&self, slot: usize, order: u8, s: f64) -> f64 {
        let Some(term) = self.terms.get(slot) else { return 0.0 };
        let shift = if order == 0 { self.shift[slot] } else { 0.0 };
        let Some(rotation) = self.rotation.as_ref().filter(|rotation| rotation.partner(slot).is_some()) else {
            return term.at(order, s) + shift;
        };
        let [first, second] = rotation.slots;
        let [x, y] = if order == 0 { rotation.center } else { [0.0; 2] };
        let [dx, dy] = rotation.turned([self.terms[first].at(order, s) - x, self.terms[second].at(order, s) - y]);
        shift + if slot == first { x + dx } else { y + dy }
    }

    /// A bound of the first derivative, by `s`, of where an axis is.
    pub(super) fn fastest(&self, slot: usize) -> f64 {
        let Some(term) = self.terms.get(slot) else { return 0.0 };
        let Some(rotation) = self.rotation.as_ref().filter(|rotation| rotation.partner(slot).is_some()) else {
            return term.fastest();
        };
        let [first, second] = rotation.slots.map(|slot| &self.terms[slot]);
        let [x, y] =
            if slot == rotation.slots[0] { [rotation.cos, -rotation.sin] } else { [rotation.sin, rotation.cos] };
        if first.winds() && second.winds() && first.sweep != second.sweep {
            return x.abs() * first.fastest() + y.abs() * second.fastest();
        }
        let sweep = if first.winds() { first.sweep } else { second.sweep };
        let mixed = |of: fn(&Term) -> f64| x * of(first) + y * of(second);
        Term { base: 0.0, slope: mixed(|t| t.slope), cos: mixed(|t| t.cos), sin: mixed(|t| t.sin), sweep }.fastest()
    }

    /// How far the direction in the plane of two axes turns along an arc, radians; zero on other paths.
    pub(super) fn turning(&self, plane: [usize; 2]) -> f64 {
        let [x, y] = plane.map(|slot| &self.terms[slot]);
        let area = x.cos * y.sin - x.sin * y.cos;
        if x.sweep != y.sweep || area == 0.0 {
            0.0
        } else if area > 0.0 {
            x.sweep
        } else {
            -x.sweep
        }
    }

    /// Whether any axis turns.
    pub(super) fn winds(&self) -> bool {
        self.terms.iter().any(Term::winds)
    }
}
