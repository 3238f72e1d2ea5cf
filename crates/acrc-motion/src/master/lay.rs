//! From what a move asks for to its path: targets, the short way round, arcs and sinusoids in the frame of the program.

use super::AXES;
use super::curve::{Arc, Curve, Sine, SpaceArc, Turn};
use super::frame::Frame;
use super::moves::{Move, PushError, Target};
use super::path::{Path, Shape};
use super::span::{Measured, Span};
use super::tangent::Tangent;
use super::winding::{Term, Winding};
use crate::root::sqrt;
use crate::trig::{DEGREE, angle, sin_cos_degrees};
use crate::value::{InvalidValue, Quantity, finite};

const FULL_TURN: f64 = 2.0 * core::f64::consts::PI;

/// What a path is laid with.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ground {
    /// Share of each axis in the length (VECDEF).
    pub(super) weights: [f64; AXES],
    /// Length where only axes without a share move (VECTOR), u.
    pub(super) vector: f64,
    /// Length of a turn of each rotary axis (ROTARY), u; zero is a linear axis.
    pub(super) rotary: [f64; AXES],
    /// How fast each axis may be (MAXVEL), u/s; zero is no limit.
    pub(super) ceilings: [f64; AXES],
    pub(super) frame: Frame,
    pub(super) tangent: Option<Tangent>,
}

impl Ground {
    pub(super) const DEFAULT: Self = Self {
        weights: [1.0; AXES],
        vector: 0.0,
        rotary: [0.0; AXES],
        ceilings: [0.0; AXES],
        frame: Frame::NONE,
        tangent: None,
    };

    /// Lays the path of a move that begins at `start`.
    pub(super) fn lay(&self, start: &[f64; AXES], command: &Move) -> Result<Path, PushError> {
        let mut draft = Draft::new(self.frame.program_at(start));
        for (slot, target) in command.targets.iter().enumerate() {
            if let Some(target) = target {
                draft.axis(slot, *target)?;
            }
        }
        if command.crowded {
            // More curves than there are axes for.
            return Err(PushError::SlotTwice(command.curves[0].map_or(0, |curve| curve.slots()[0])));
        }
        for curve in command.curves.iter().flatten() {
            draft.curve(curve)?;
        }
        let end = self.end(start, command, &draft)?;
        let shape = if draft.winds() { Shape::Winding(self.wind(&draft, start)) } else { Shape::Straight };
        let mut path = self.path(start, &end, &shape)?;
        if let Some(tangent) = self.tangent.as_ref().filter(|tangent| !draft.taken[tangent.axis]) {
            tangent.apply(&mut path, start);
        }
        Ok(path)
    }

    /// A straight path between two places of the axes.
    pub(super) fn straight(&self, start: &[f64; AXES], end: &[f64; AXES]) -> Result<Path, PushError> {
        self.path(start, end, &Shape::Straight)
    }

    fn path(&self, start: &[f64; AXES], end: &[f64; AXES], shape: &Shape) -> Result<Path, PushError> {
        let mut path = Path::new(start, end, shape, &self.weights, self.vector)?;
        path.limit(&self.ceilings, &self.weights);
        Ok(path)
    }

    /// Lays a piece of a curve, for axes that are at `start`.
    pub(super) fn lay_span(&self, start: &[f64; AXES], span: &Span) -> Result<Path, PushError> {
        let program = self.frame.program_at(start);
        let zero = self.frame.axes_at(&[0.0; AXES]);
        let mut image = *span;
        let mut end = *start;
        for (power, numerators) in image.numerators.iter_mut().enumerate() {
            let denominator = span.denominator[power];
            for slot in (0..AXES).filter(|slot| !span.moves[*slot]) {
                numerators[slot] = program[slot] * denominator;
            }
            // A shift moves the curve, which is the quotient.
            let turned = self.frame.axes_at(numerators);
            *numerators = core::array::from_fn(|slot| (turned[slot] - zero[slot]) + zero[slot] * denominator);
        }
        for (slot, end) in end.iter_mut().enumerate() {
            let partner = self.frame.rotation.as_ref().and_then(|rotation| rotation.partner(slot));
            image.moves[slot] |= partner.is_some_and(|partner| span.moves[partner]);
            if image.moves[slot] {
                *end = finite(Quantity::Target, image.end(slot))?;
            }
        }
        let measured = Measured::new(&image, &self.weights);
        let mut path = self.path(start, &end, &Shape::Span(measured))?;
        if let Some(tangent) = self.tangent.as_ref().filter(|tangent| !span.moves[tangent.axis]) {
            tangent.apply(&mut path, start);
        }
        Ok(path)
    }

    /// Where the axes end.
    fn end(&self, start: &[f64; AXES], command: &Move, draft: &Draft) -> Result<[f64; AXES], InvalidValue> {
        let aimed = self.frame.axes_at(&draft.end);
        let mut end = *start;
        for slot in 0..AXES {
            let partner = self.frame.rotation.as_ref().and_then(|rotation| rotation.partner(slot));
            // An axis that nothing is said of stays, to the bit, unless it is rotated together with one that moves.
            if draft.taken[slot] || partner.is_some_and(|partner| draft.taken[partner]) {
                end[slot] = finite(Quantity::Target, aimed[slot])?;
            }
            if matches!(command.targets[slot], Some(Target::Absolute(_))) && self.rotary[slot] > 0.0 {
                end[slot] = start[slot] + short_way(end[slot] - start[slot], self.rotary[slot]);
            }
        }
        Ok(end)
    }

    /// The laws of the axes behind the frame.
    fn wind(&self, draft: &Draft, start: &[f64; AXES]) -> Winding {
        let frame = &self.frame;
        let mut winding = Winding { terms: draft.terms, rotation: frame.rotation, shift: [0.0; AXES] };
        for (slot, term) in winding.terms.iter_mut().enumerate() {
            let partner = frame.rotation.as_ref().and_then(|rotation| rotation.partner(slot));
            if !draft.taken[slot] && partner.is_none() {
                *term = Term { base: start[slot], ..Term::default() };
                continue;
            }
            let factor = frame.factors[slot];
            term.base = frame.scaled(slot, term.base);
            term.slope *= factor;
            term.cos *= factor;
            term.sin *= factor;
            winding.shift[slot] = frame.shift(slot);
        }
        winding
    }
}

/// The part of a distance that leads to the same place of a rotary axis, at most half a turn.
pub(super) fn short_way(distance: f64, turn: f64) -> f64 {
    let rest = libm::fmod(distance, turn);
    if rest > turn / 2.0 {
        rest - turn
    } else if rest < -turn / 2.0 {
        rest + turn
    } else {
        rest
    }
}

/// A move in the coordinates of the program.
struct Draft {
    start: [f64; AXES],
    end: [f64; AXES],
    terms: [Term; AXES],
    /// Which axes the move says something of.
    taken: [bool; AXES],
}

impl Draft {
    fn new(start: [f64; AXES]) -> Self {
        Self { start, end: start, terms: start.map(|at| Term::straight(at, at)), taken: [false; AXES] }
    }

    fn winds(&self) -> bool {
        self.terms.iter().any(|term| term.sweep != 0.0)
    }

    /// Takes a slot that no other part of the move has.
    fn take(&mut self, slot: usize) -> Result<(), PushError> {
        let taken = self.taken.get_mut(slot).ok_or(PushError::NoSuchSlot(slot))?;
        if core::mem::replace(taken, true) { Err(PushError::SlotTwice(slot)) } else { Ok(()) }
    }

    fn axis(&mut self, slot: usize, target: Target) -> Result<(), PushError> {
        self.take(slot)?;
        let start = self.start[slot];
        match target {
            Target::Absolute(_) | Target::Relative(_) => {
                self.end[slot] = target.position_after(start)?;
                self.terms[slot] = Term::straight(start, self.end[slot]);
            }
            Target::Sine(sine) => {
                self.end[slot] = sine.target;
                self.terms[slot] = sine_term(&sine, start)?;
            }
        }
        Ok(())
    }

    fn curve(&mut self, curve: &Curve) -> Result<(), PushError> {
        for slot in curve.slots() {
            self.take(*slot)?;
        }
        match curve {
            Curve::Arc(arc) => self.arc(arc),
            Curve::SpaceArc(arc) => self.space_arc(arc),
        }
    }

    fn arc(&mut self, arc: &Arc) -> Result<(), PushError> {
        let start = arc.slots.map(|slot| self.start[slot]);
        let [target, center] = [(arc.target, arc.relative_target), (arc.center, arc.relative_center)]
            .map(|(point, relative)| if relative { sum(start, point) } else { point });
        for (quantity, point) in [(Quantity::Target, target), (Quantity::Center, center)] {
            for value in point {
                finite(quantity, value)?;
            }
        }
        let (to_end, to_start) = (difference(target, center), difference(start, center));
        let (radius, distance) = (length(&to_end), length(&to_start));
        if radius == 0.0 || distance == 0.0 {
            return Err(PushError::NoRadius);
        }
        // The arc begins on the circle, in the direction in which the axes are.
        let from = if start == target { to_end } else { to_start.map(|v| v / distance * radius) };
        let cross = from[0] * to_end[1] - from[1] * to_end[0];
        let dot = from[0] * to_end[0] + from[1] * to_end[1];
        let mut sweep = angle(cross, dot);
        let left = arc.turn == Turn::CounterClockwise;
        if start == target {
            sweep = if left { FULL_TURN } else { -FULL_TURN };
        } else if left && sweep < 0.0 {
            sweep += FULL_TURN;
        } else if !left && sweep > 0.0 {
            sweep -= FULL_TURN;
        }
        let [x, y] = from;
        for (index, sin) in [-y, x].into_iter().enumerate() {
            let slot = arc.slots[index];
            self.end[slot] = target[index];
            self.terms[slot] = Term { base: center[index], slope: 0.0, cos: from[index], sin, sweep };
        }
        Ok(())
    }

    fn space_arc(&mut self, arc: &SpaceArc) -> Result<(), PushError> {
        for (quantity, point) in [(Quantity::Target, arc.target), (Quantity::Via, arc.via)] {
            for value in point {
                finite(quantity, value)?;
            }
        }
        let start = arc.slots.map(|slot| self.start[slot]);
        let (chord, via) = (difference(arc.target, start), difference(arc.via, start));
        // Both in terms of the greater, so that squares of squares fit.
        let size = length(&chord).max(length(&via));
        let (chord, via) = (chord.map(|v| v / size), via.map(|v| v / size));
        let normal = cross(via, chord);
        let square = dot(normal, normal);
        // Below this the centre is lost in the rounding of the points.
        if square <= 1e-24 || square.is_nan() {
            return Err(PushError::NoRadius);
        }
        let (via_square, chord_square) = (dot(via, via), dot(chord, chord));
        let lever = core::array::from_fn(|i| via_square * chord[i] - chord_square * via[i]);
        let to_center = cross(lever, normal).map(|v| v / (2.0 * square));
        let from = to_center.map(|v| -v);
        let across = cross(normal.map(|v| v / sqrt(square)), from);
        let to_end = difference(chord, to_center);
        let mut sweep = angle(dot(to_end, across), dot(to_end, from));
        if sweep <= 0.0 {
            sweep += FULL_TURN;
        }
        for (index, slot) in arc.slots.into_iter().enumerate() {
            let base = start[index] + size * to_center[index];
            self.end[slot] = arc.target[index];
            self.terms[slot] = Term { base, slope: 0.0, cos: size * from[index], sin: size * across[index], sweep };
        }
        Ok(())
    }
}

fn sine_term(sine: &Sine, start: f64) -> Result<Term, InvalidValue> {
    for (quantity, value) in [
        (Quantity::Target, sine.target),
        (Quantity::Phase, sine.phase),
        (Quantity::Sweep, sine.sweep),
        (Quantity::Amplitude, sine.amplitude),
    ] {
        finite(quantity, value)?;
    }
    let (first_sin, first_cos) = sin_cos_degrees(sine.phase);
    let (last_sin, _) = sin_cos_degrees(sine.phase + sine.sweep);
    let (cos, sin) = (sine.amplitude * first_sin, sine.amplitude * first_cos);
    let base = start - cos;
    let slope = (sine.target - start) - sine.amplitude * (last_sin - first_sin);
    Ok(Term { base, slope, cos, sin, sweep: sine.sweep * DEGREE })
}

fn sum<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    core::array::from_fn(|i| a[i] + b[i])
}

fn difference<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    core::array::from_fn(|i| a[i] - b[i])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The root of the sum of squares, taken relative to the greatest: squares of small or great lengths would not fit.
pub(super) fn length(vector: &[f64]) -> f64 {
    let greatest = vector.iter().fold(0.0, |greatest: f64, v| greatest.max(v.abs()));
    if greatest == 0.0 || !greatest.is_finite() {
        return greatest;
    }
    greatest * sqrt(vector.iter().map(|v| (v / greatest) * (v / greatest)).sum::<f64>())
}
