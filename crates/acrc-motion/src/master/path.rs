//! The straight line of a move through the space of its axes (the guide's VECDEF and VECTOR).

use super::AXES;
use super::moves::{PushError, Target};
use crate::root::sqrt;
use crate::value::{Quantity, finite};

/// A straight path from where the move before ends to the targets.
#[derive(Clone, Copy, Debug)]
pub(super) struct Path {
    start: [f64; AXES],
    displacement: [f64; AXES],
    end: [f64; AXES],
    length: f64,
}

impl Path {
    /// Lays the path from `start`. Its length is the root of the sum of `(weight · displacement)²`, or `vector` where
    /// that is zero although an axis moves.
    pub(super) fn new(
        start: &[f64; AXES],
        targets: &[Option<Target>; AXES],
        weights: &[f64; AXES],
        vector: f64,
    ) -> Result<Self, PushError> {
        let mut end = *start;
        for (end, target) in end.iter_mut().zip(targets) {
            if let Some(target) = target {
                *end = target.position_after(*end)?;
            }
        }
        let mut displacement = end;
        for (displacement, start) in displacement.iter_mut().zip(start) {
            *displacement = finite(Quantity::Target, *displacement - start)?;
        }
        let moves = displacement.iter().any(|d| *d != 0.0);
        let weighted = weighted_length(&displacement, weights);
        let length = if weighted == 0.0 && moves { vector } else { weighted };
        if moves && length == 0.0 {
            return Err(PushError::NoVectorLength);
        }
        finite(Quantity::Length, length)?;
        Ok(Self { start: *start, displacement, end, length })
    }

    /// Length along the path, u. Zero only if no axis moves.
    pub(super) fn length(&self) -> f64 {
        self.length
    }

    /// Where each axis is when the move is done, u: the targets, to the bit.
    pub(super) fn end(&self) -> &[f64; AXES] {
        &self.end
    }

    /// Position of an axis, u, when the path is covered up to `along`.
    pub(super) fn position(&self, slot: usize, along: f64) -> f64 {
        self.start.get(slot).map_or(0.0, |start| start + self.scaled(slot, along))
    }

    /// The part of a quantity along the path that falls to an axis: its velocity of the vector velocity, for one.
    pub(super) fn scaled(&self, slot: usize, along: f64) -> f64 {
        match self.displacement.get(slot) {
            Some(displacement) if *displacement != 0.0 => displacement * (along / self.length),
            _ => 0.0,
        }
    }
}

/// The root of the sum of squares, taken relative to the greatest term: squares of small or great lengths would not fit.
fn weighted_length(displacement: &[f64; AXES], weights: &[f64; AXES]) -> f64 {
    let terms = || displacement.iter().zip(weights).map(|(d, w)| (d * w).abs());
    let greatest = terms().fold(0.0, f64::max);
    if greatest == 0.0 || !greatest.is_finite() {
        return greatest;
    }
    let sum: f64 = terms().map(|term| (term / greatest) * (term / greatest)).sum();
    greatest * sqrt(sum)
}
