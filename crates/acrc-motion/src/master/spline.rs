//! Curves from control points and knots, one piece after the other (the guide's SPLINE, NURB and K).

use core::fmt;

use super::AXES;
use super::span::{Span, TERMS};
use crate::value::{InvalidValue, Quantity, finite};

/// Points and knots that are kept: twice the highest rank.
const KEPT: usize = 2 * TERMS;

/// How points and knots make a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// Cubic pieces through the points, with the direction at each from its neighbours.
    Spline,
    /// Pieces between knots, drawn by as many control points as the rank says.
    Nurbs { rank: usize },
}

/// A point that bends a curve.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ControlPoint {
    /// Where it is, u; an axis that is not given is where it was at the point before, and at first not on the curve.
    pub position: [Option<f64>; AXES],
    /// How much it attracts a NURBS curve; other curves do not look at it.
    pub weight: Option<f64>,
}

impl ControlPoint {
    /// A point of no axis yet, with a weight of one.
    pub fn new() -> Self {
        Self::default()
    }

    /// The same point with a position on one axis. There is nothing at a slot of [`AXES`] or above.
    #[must_use]
    pub fn at(mut self, slot: usize, position: f64) -> Self {
        if let Some(place) = self.position.get_mut(slot) {
            *place = Some(position);
        }
        self
    }
}

/// Makes pieces of a curve from its control points and knots, in the order in which a program gives them.
///
/// A NURBS curve of rank `k` (degree `k - 1`) with `n` points takes `n + k` knots: the first `n` come with the points,
/// the others after them. Knots that are missing at the end count as equal to the last. A spline goes through its
/// points, the first of which is where the axes should be; its knots are the values of its parameter there.
///
/// Each piece is given out when the next is known, so that the last can be told from the others.
#[derive(Clone, Copy, Debug)]
pub struct CurveBuilder {
    kind: Kind,
    points: [[f64; AXES]; KEPT],
    weights: [f64; KEPT],
    knots: [f64; KEPT],
    point_count: usize,
    knot_count: usize,
    moves: [bool; AXES],
    held: Option<Span>,
}

/// Why a curve cannot go on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CurveError {
    /// A rank that is not 2 to 5.
    Rank(usize),
    /// A value is not a number, infinite, or a weight not above zero.
    Invalid(InvalidValue),
    /// A knot below the one before; on a spline also an equal one.
    KnotOrder {
        /// The knot before.
        before: f64,
        /// The knot.
        knot: f64,
    },
    /// A knot of a spline without a point.
    NoPoint,
    /// A point behind a knot that had none.
    PointAfterEnd,
}

impl From<InvalidValue> for CurveError {
    fn from(error: InvalidValue) -> Self {
        Self::Invalid(error)
    }
}

impl fmt::Display for CurveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rank(rank) => write!(f, "rank {rank} of a curve is not 2 to {TERMS}"),
            Self::Invalid(error) => error.fmt(f),
            Self::KnotOrder { before, knot } => write!(f, "knot {knot} does not lie above the knot before, {before}"),
            Self::NoPoint => f.write_str("the spline has no point at this knot"),
            Self::PointAfterEnd => f.write_str("the control points of the curve have already ended"),
        }
    }
}

impl core::error::Error for CurveError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Invalid(error) => Some(error),
            _ => None,
        }
    }
}

impl CurveBuilder {
    /// A cubic spline through its points.
    pub fn spline() -> Self {
        Self::new(Kind::Spline)
    }

    /// A NURBS curve of a rank from 2 to 5: its degree is one less.
    pub fn nurbs(rank: usize) -> Result<Self, CurveError> {
        if (2..=TERMS).contains(&rank) { Ok(Self::new(Kind::Nurbs { rank })) } else { Err(CurveError::Rank(rank)) }
    }

    fn new(kind: Kind) -> Self {
        Self {
            kind,
            points: [[0.0; AXES]; KEPT],
            weights: [1.0; KEPT],
            knots: [0.0; KEPT],
            point_count: 0,
            knot_count: 0,
            moves: [false; AXES],
            held: None,
        }
    }

    /// Takes the next knot with its point, if it has one, and gives out a piece if one is ready. A knot that is not given
    /// is one more than the one before.
    pub fn push(&mut self, knot: Option<f64>, point: Option<&ControlPoint>) -> Result<Option<Span>, CurveError> {
        let before = self.knot_count.checked_sub(1).map(|last| self.knot(last));
        let knot = finite(Quantity::Knot, knot.unwrap_or(before.map_or(0.0, |before| before + 1.0)))?;
        if let Some(before) = before
            && (knot < before || knot == before && self.kind == Kind::Spline)
        {
            return Err(CurveError::KnotOrder { before, knot });
        }
        match point {
            Some(point) => self.point(point)?,
            None if self.kind == Kind::Spline => return Err(CurveError::NoPoint),
            None => {}
        }
        Ok(self.next(knot))
    }

    /// Gives out what is left, piece by piece, when the curve has ended. The last piece is the end of the curve.
    pub fn finish(&mut self) -> Option<Span> {
        match self.kind {
            Kind::Spline => {
                if let Some(span) = self.spline_span(self.point_count.checked_sub(2)?)
                    && self.knot_count == self.point_count
                {
                    // Counted so that it is made once.
                    self.knot_count += 1;
                    if let Some(before) = self.held.replace(span) {
                        return Some(before);
                    }
                }
            }
            Kind::Nurbs { rank } => {
                while self.knot_count > 0 && self.knot_count < self.point_count + rank {
                    let last = self.knot(self.knot_count - 1);
                    if let Some(span) = self.next(last) {
                        return Some(span);
                    }
                }
            }
        }
        self.held.take().map(|span| Span { joined: false, ..span })
    }

    fn point(&mut self, point: &ControlPoint) -> Result<(), CurveError> {
        if self.point_count < self.knot_count {
            return Err(CurveError::PointAfterEnd);
        }
        let weight = point.weight.unwrap_or(1.0);
        finite(Quantity::ControlWeight, weight)?;
        if weight <= 0.0 {
            return Err(InvalidValue { quantity: Quantity::ControlWeight, value: weight }.into());
        }
        for value in point.position.iter().flatten() {
            finite(Quantity::ControlPoint, *value)?;
        }
        let previous = self.points[(self.point_count + KEPT - 1) % KEPT];
        let place = self.point_count % KEPT;
        self.points[place] = core::array::from_fn(|slot| point.position[slot].unwrap_or(previous[slot]));
        for (moves, position) in self.moves.iter_mut().zip(point.position) {
            *moves |= position.is_some();
        }
        self.weights[place] = weight;
        self.point_count += 1;
        Ok(())
    }

    fn next(&mut self, knot: f64) -> Option<Span> {
        self.knots[self.knot_count % KEPT] = knot;
        self.knot_count += 1;
        let span = match self.kind {
            Kind::Spline => self.knot_count.checked_sub(3).and_then(|first| self.spline_span(first)),
            Kind::Nurbs { rank } => self.knot_count.checked_sub(rank).and_then(|first| self.nurbs_span(first, rank)),
        };
        // Kept until the next is known.
        span.and_then(|span| self.held.replace(span))
    }

    fn knot(&self, index: usize) -> f64 {
        self.knots[index % KEPT]
    }

    /// The piece of a NURBS curve between a knot and the next, if there is any.
    fn nurbs_span(&self, first: usize, rank: usize) -> Option<Span> {
        let (from, to) = (self.knot(first), self.knot(first + 1));
        if first + 1 < rank || first >= self.point_count || from >= to {
            return None;
        }
        // De Boor's recursion, on polynomials in the part of the way from this knot to the next: row by row, which
        // share each of the control points has in the curve.
        let mut shares = [[[0.0; TERMS]; TERMS]; TERMS];
        for (index, share) in shares.iter_mut().enumerate().take(rank) {
            share[index][0] = 1.0;
        }
        for level in 1..rank {
            for index in (level..rank).rev() {
                let low = first + 1 + index - rank;
                let (start, end) = (self.knot(low), self.knot(low + rank - level));
                let (constant, linear) = ((from - start) / (end - start), (to - from) / (end - start));
                let (before, this) = (shares[index - 1], shares[index]);
                shares[index] = core::array::from_fn(|point| mixed(&before[point], &this[point], constant, linear));
            }
        }
        let mut span = self.empty_span();
        for (index, share) in shares[rank - 1].iter().enumerate().take(rank) {
            let place = (first + 1 + index - rank) % KEPT;
            let weight = self.weights[place];
            for (power, share) in share.iter().enumerate() {
                span.denominator[power] += share * weight;
                for slot in 0..AXES {
                    span.numerators[power][slot] += share * weight * self.points[place][slot];
                }
            }
        }
        Some(span)
    }

    /// The piece of a spline between a point and the next. Without neighbours a direction follows from the other end.
    fn spline_span(&self, first: usize) -> Option<Span> {
        if first + 1 >= self.point_count {
            return None;
        }
        let width = |low: usize| self.knot(low + 1) - self.knot(low);
        let mut span = self.empty_span();
        span.denominator[0] = 1.0;
        for slot in (0..AXES).filter(|slot| self.moves[*slot]) {
            let at = |index: usize| self.points[index % KEPT][slot];
            let slope = |low: usize| (at(low + 1) - at(low)) / width(low);
            // The direction of the parabola through a point and its neighbours.
            let direction = |index: usize| {
                let (before, behind) = (width(index - 1), width(index));
                (behind * slope(index - 1) + before * slope(index)) / (before + behind)
            };
            let has_before = first > 0;
            let has_behind = first + 2 < self.point_count;
            let mean = slope(first);
            let start = if has_before { Some(direction(first)) } else { None };
            let end = if has_behind { Some(direction(first + 1)) } else { None };
            let (start, end) = match (start, end) {
                (Some(start), Some(end)) => (start, end),
                (Some(start), None) => (start, 2.0 * mean - start),
                (None, Some(end)) => (2.0 * mean - end, end),
                (None, None) => (mean, mean),
            };
            let (rise, start, end) = (at(first + 1) - at(first), start * width(first), end * width(first));
            span.numerators[0][slot] = at(first);
            span.numerators[1][slot] = start;
            span.numerators[2][slot] = 3.0 * rise - 2.0 * start - end;
            span.numerators[3][slot] = start + end - 2.0 * rise;
        }
        Some(span)
    }

    fn empty_span(&self) -> Span {
        Span { numerators: [[0.0; AXES]; TERMS], denominator: [0.0; TERMS], moves: self.moves, joined: true }
    }
}

/// `(1 - a) · before + a · this`, where `a` is `constant + linear · u`.
fn mixed(before: &[f64; TERMS], this: &[f64; TERMS], constant: f64, linear: f64) -> [f64; TERMS] {
    let mut sum = [0.0; TERMS];
    for power in 0..TERMS {
        sum[power] += (1.0 - constant) * before[power] + constant * this[power];
        if power + 1 < TERMS {
            sum[power + 1] += linear * (this[power] - before[power]);
        }
    }
    sum
}
