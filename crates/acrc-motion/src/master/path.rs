//! The path of a move through the space of its axes, and its length (the guide's VECDEF and VECTOR).

use super::AXES;
use super::lay::length;
use super::moves::PushError;
use super::span::{Measured, Parameter};
use super::tangent::Turning;
use super::winding::Winding;
use crate::profile::State;
use crate::root::sqrt;
use crate::value::{Quantity, finite};

/// How the axes get from the start to the end.
#[derive(Clone, Copy, Debug)]
pub(super) enum Shape {
    /// All evenly.
    Straight,
    /// Some turn.
    Winding(Winding),
    /// Along a piece of a curve.
    Span(Measured),
}

/// A place on a path.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Place {
    /// Length covered, u.
    along: f64,
    /// That as a part of the whole.
    s: f64,
    /// The parameter of a piece of a curve.
    parameter: Parameter,
}

impl Place {
    /// Length covered as a part of the whole.
    pub(super) fn part(&self) -> f64 {
        self.s
    }
}

/// A path from where the move before ends to the targets.
#[derive(Clone, Copy, Debug)]
pub(super) struct Path {
    start: [f64; AXES],
    end: [f64; AXES],
    length: f64,
    shape: Shape,
    turning: Option<Turning>,
    /// How fast it may be followed, u/s.
    ceiling: f64,
}

impl Path {
    /// Measures a path. Its length is the root of the mean square of its speed over its parameter, each axis with its
    /// weight, or `vector` where that is zero although an axis moves.
    ///
    /// For a straight line that is the root of the sum of `(weight · displacement)²`, for an arc or a helix of equal
    /// weights its length.
    pub(super) fn new(
        start: &[f64; AXES],
        end: &[f64; AXES],
        shape: &Shape,
        weights: &[f64; AXES],
        vector: f64,
    ) -> Result<Self, PushError> {
        let mut weighted = [0.0; AXES];
        let mut moves = false;
        for slot in 0..AXES {
            let displacement = finite(Quantity::Target, end[slot] - start[slot])?;
            moves |= displacement != 0.0;
            let covered = match shape {
                Shape::Straight | Shape::Span(_) => displacement,
                Shape::Winding(winding) => sqrt(winding.terms[slot].mean_square().max(0.0)),
            };
            weighted[slot] = covered * weights[slot];
        }
        moves |= matches!(shape, Shape::Winding(winding) if winding.winds());
        let weighted = if let Shape::Span(span) = shape { span.length() } else { length(&weighted) };
        let length = if weighted == 0.0 && moves { vector } else { weighted };
        if moves && length == 0.0 {
            return Err(PushError::NoVectorLength);
        }
        finite(Quantity::Length, length)?;
        Ok(Self { start: *start, end: *end, length, shape: *shape, turning: None, ceiling: f64::INFINITY })
    }

    /// Length along the path, u. Zero only if no axis moves.
    pub(super) fn length(&self) -> f64 {
        self.length
    }

    /// Where each axis is when the move is done, u: the targets, to the bit.
    pub(super) fn end(&self) -> &[f64; AXES] {
        &self.end
    }

    /// How fast it may be followed, u/s.
    pub(super) fn ceiling(&self) -> f64 {
        self.ceiling
    }

    /// Keeps every axis below its ceiling; zero is none.
    pub(super) fn limit(&mut self, ceilings: &[f64; AXES], weights: &[f64; AXES]) {
        for (slot, ceiling) in ceilings.iter().enumerate().filter(|(_, ceiling)| **ceiling > 0.0) {
            let fastest = self.part(self.fastest(slot, weights[slot]));
            if fastest > 0.0 {
                self.ceiling = self.ceiling.min(ceiling / fastest);
            }
        }
    }

    /// A bound of how far an axis goes for each part of the length.
    fn fastest(&self, slot: usize, weight: f64) -> f64 {
        match &self.shape {
            Shape::Winding(winding) => winding.fastest(slot),
            Shape::Span(span) if !span.moves(slot) => 0.0,
            // Somewhere it may lead along the axis alone. One without weight adds nothing to the length.
            Shape::Span(_) if weight > 0.0 => self.length / weight,
            Shape::Straight | Shape::Span(_) => self.displacement(slot).abs(),
        }
    }

    /// Whether all axes move evenly.
    pub(super) fn is_straight(&self) -> bool {
        matches!(self.shape, Shape::Straight)
    }

    /// Whether a straight path leads the same way as another.
    pub(super) fn goes_with(&self, other: &Self) -> bool {
        (0..AXES).map(|slot| self.displacement(slot) * other.displacement(slot)).sum::<f64>() > 0.0
    }

    /// The place on the path up to which `along` is covered.
    pub(super) fn place(&self, along: f64) -> Place {
        let s = self.part(along);
        let parameter = if let Shape::Span(span) = &self.shape { span.parameter(s) } else { [s, 1.0, 0.0] };
        Place { along, s, parameter }
    }

    /// Position of an axis, u.
    pub(super) fn position(&self, slot: usize, place: &Place) -> f64 {
        if let Some(turning) = self.turning_of(slot) {
            return turning.position(self, place);
        }
        match (&self.shape, self.start.get(slot)) {
            (_, None) => 0.0,
            (Shape::Straight, Some(start)) => start + self.displacement(slot) * self.part(place.along),
            (_, Some(_)) => self.bent(slot, 0, place),
        }
    }

    /// Velocity of an axis, u/s, in a state along the path.
    pub(super) fn velocity(&self, slot: usize, place: &Place, state: &State) -> f64 {
        if let Some(turning) = self.turning_of(slot) {
            return turning.velocity(self, place, state);
        }
        match &self.shape {
            Shape::Straight => self.displacement(slot) * self.part(state.velocity),
            _ => self.bent(slot, 1, place) * self.part(state.velocity),
        }
    }

    /// Acceleration of an axis, u/s², in a state along the path: that of the vector velocity, and that of the bend.
    pub(super) fn acceleration(&self, slot: usize, place: &Place, state: &State) -> f64 {
        if let Some(turning) = self.turning_of(slot) {
            return turning.acceleration(self, place, state);
        }
        let rate = self.part(state.velocity);
        match &self.shape {
            Shape::Straight => self.displacement(slot) * self.part(state.acceleration),
            _ => self.bent(slot, 1, place) * self.part(state.acceleration) + self.bent(slot, 2, place) * (rate * rate),
        }
    }

    /// Derivative of the given order, by the part of the length, of where an axis is on a path that is not straight.
    fn bent(&self, slot: usize, order: u8, place: &Place) -> f64 {
        match &self.shape {
            Shape::Straight => 0.0,
            Shape::Winding(winding) => winding.at(slot, order, place.s),
            Shape::Span(span) => span.at(slot, order, place.parameter),
        }
    }

    /// First or second derivative, by the part of the length, of where an axis is that does not point along the path.
    pub(super) fn rate(&self, slot: usize, order: u8, place: &Place) -> f64 {
        match &self.shape {
            Shape::Straight if order == 1 => self.displacement(slot),
            _ => self.bent(slot, order, place),
        }
    }

    pub(super) fn shape(&self) -> &Shape {
        &self.shape
    }

    /// Lets an axis point along the path.
    pub(super) fn turn(&mut self, turning: &Turning) {
        let end = turning.position(self, &self.place(self.length));
        if let Some(place) = self.end.get_mut(turning.axis) {
            *place = end;
        }
        self.turning = Some(*turning);
    }

    fn turning_of(&self, slot: usize) -> Option<&Turning> {
        self.turning.as_ref().filter(|turning| turning.axis == slot)
    }

    /// The direction at the start or the end, of length one, each axis with its weight; zero if there is none.
    pub(super) fn heading(&self, at_end: bool, weights: &[f64; AXES]) -> [f64; AXES] {
        let place = self.place(if at_end { self.length } else { 0.0 });
        let mut heading: [f64; AXES] = core::array::from_fn(|slot| self.rate(slot, 1, &place) * weights[slot]);
        let size = length(&heading);
        for part in &mut heading {
            *part = if size > 0.0 { *part / size } else { 0.0 };
        }
        heading
    }

    /// Whether the next move continues the same curve.
    pub(super) fn is_joined(&self) -> bool {
        matches!(&self.shape, Shape::Span(span) if span.joined())
    }

    fn displacement(&self, slot: usize) -> f64 {
        if self.turning_of(slot).is_some() {
            return 0.0;
        }
        match (self.end.get(slot), self.start.get(slot)) {
            (Some(end), Some(start)) => end - start,
            _ => 0.0,
        }
    }

    /// A quantity along the path as a part of its length.
    pub(super) fn part(&self, along: f64) -> f64 {
        if self.length == 0.0 { 0.0 } else { along / self.length }
    }
}
