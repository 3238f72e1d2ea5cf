//! From the coordinates of the program to those of the axes (the guide's SCALE, ROTATE, OFFSET and FLZ).
//!
//! A programmed point is scaled axis by axis, then rotated in the plane of two axes, then shifted. What is programmed
//! relative to the point before is relative in the coordinates of the program: it is scaled and rotated, not shifted.

use super::AXES;

/// A rotation in the plane of two axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rotation {
    pub(super) slots: [usize; 2],
    pub(super) center: [f64; 2],
    pub(super) sin: f64,
    pub(super) cos: f64,
}

impl Rotation {
    /// A direction, or a point seen from the centre, turned.
    pub(super) fn turned(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.cos * x - self.sin * y, self.sin * x + self.cos * y]
    }

    fn inverse(&self) -> Self {
        Self { sin: -self.sin, ..*self }
    }

    /// Turns a point about the centre.
    fn apply(&self, point: &mut [f64; AXES]) {
        let [first, second] = self.slots;
        let [x, y] = self.center;
        let [dx, dy] = self.turned([point[first] - x, point[second] - y]);
        point[first] = x + dx;
        point[second] = y + dy;
    }

    /// The axis that is turned together with this one.
    pub(super) fn partner(&self, slot: usize) -> Option<usize> {
        let [first, second] = self.slots;
        if slot == first {
            Some(second)
        } else if slot == second {
            Some(first)
        } else {
            None
        }
    }
}

/// The transformation of a master.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    pub(super) factors: [f64; AXES],
    /// What the factors leave in place.
    pub(super) centers: [f64; AXES],
    pub(super) rotation: Option<Rotation>,
    /// The angle of the rotation, degrees.
    pub(super) degrees: f64,
    pub(super) offsets: [f64; AXES],
    pub(super) floats: [f64; AXES],
}

impl Frame {
    /// The transformation that changes nothing.
    pub(super) const NONE: Self = Self {
        factors: [1.0; AXES],
        centers: [0.0; AXES],
        rotation: None,
        degrees: 0.0,
        offsets: [0.0; AXES],
        floats: [0.0; AXES],
    };

    /// Scales one coordinate of a point.
    pub(super) fn scaled(&self, slot: usize, value: f64) -> f64 {
        if self.factors[slot] == 1.0 {
            return value;
        }
        self.centers[slot] + self.factors[slot] * (value - self.centers[slot])
    }

    /// What an axis is shifted by, u.
    pub(super) fn shift(&self, slot: usize) -> f64 {
        self.offsets[slot] + self.floats[slot]
    }

    /// Where the axes are at a programmed point.
    pub(super) fn axes_at(&self, program: &[f64; AXES]) -> [f64; AXES] {
        let mut point = *program;
        for (slot, value) in point.iter_mut().enumerate() {
            *value = self.scaled(slot, *value);
        }
        if let Some(rotation) = &self.rotation {
            rotation.apply(&mut point);
        }
        for (slot, value) in point.iter_mut().enumerate() {
            *value += self.shift(slot);
        }
        point
    }

    /// The programmed point of where the axes are.
    pub(super) fn program_at(&self, axes: &[f64; AXES]) -> [f64; AXES] {
        let mut point = *axes;
        for (slot, value) in point.iter_mut().enumerate() {
            *value -= self.shift(slot);
        }
        if let Some(rotation) = &self.rotation {
            rotation.inverse().apply(&mut point);
        }
        for (slot, value) in point.iter_mut().enumerate() {
            if self.factors[slot] != 1.0 {
                *value = self.centers[slot] + (*value - self.centers[slot]) / self.factors[slot];
            }
        }
        point
    }
}
