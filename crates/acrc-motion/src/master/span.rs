//! One piece of a curve, between two knots, as the path of a move (the guide's SPLINE and NURB).
//!
//! The curve is a polynomial, or a quotient of polynomials, in a parameter that does not run evenly with the length.
//! A table made when the path is laid, and two steps of Newton's from there, turn the length into the parameter, so that
//! the velocity along the path is what the profile says. The axes are on the curve itself at any time.

use super::AXES;
use super::lay::length;

/// Coefficients of a polynomial: up to the fourth power.
pub(super) const TERMS: usize = 5;

/// Pieces of equal parameter in the table.
const PIECES: usize = 8;

/// Nodes and shares of a quadrature that is exact for polynomials of the ninth degree, from 0 to 1 (Gauss).
const QUADRATURE: [(f64, f64); 5] = [
    (0.046_910_077_030_668_01, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_44, 0.239_314_335_249_683_23),
    (0.5, 0.284_444_444_444_444_45),
    (0.769_234_655_052_841_5, 0.239_314_335_249_683_23),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

/// Steps of Newton's method from the table.
const STEPS: u32 = 2;

/// Part of its mean below which the speed is that of a cusp: there the table says how the parameter runs.
const CUSP: f64 = 1e-6;

/// A piece of a curve between two knots. Made by [`CurveBuilder`](super::CurveBuilder).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Coefficients of each power, of each axis.
    pub(super) numerators: [[f64; AXES]; TERMS],
    pub(super) denominator: [f64; TERMS],
    /// Which axes it moves.
    pub(super) moves: [bool; AXES],
    /// Whether another piece of the same curve follows.
    pub(super) joined: bool,
}

impl Span {
    /// Value, first and second derivative of an axis, by the parameter. `divisor` is what the denominator is there.
    fn derivatives(&self, slot: usize, u: f64, divisor: [f64; 3]) -> [f64; 3] {
        let [n, dn, ddn] = powers(core::array::from_fn(|power| self.numerators[power][slot]), u);
        let [d, dd, ddd] = divisor;
        let value = n / d;
        let first = (dn - value * dd) / d;
        [value, first, (ddn - 2.0 * first * dd - value * ddd) / d]
    }

    /// Where an axis is at the end.
    pub(super) fn end(&self, slot: usize) -> f64 {
        self.derivatives(slot, 1.0, powers(self.denominator, 1.0))[0]
    }

    /// Length covered for a unit of the parameter, each axis with its weight, and what that changes by.
    fn speed(&self, u: f64, weights: &[f64; AXES]) -> (f64, f64) {
        let mut rates = [0.0; AXES];
        let mut product = 0.0;
        let divisor = powers(self.denominator, u);
        for (slot, rate) in rates.iter_mut().enumerate().filter(|(slot, _)| self.moves[*slot]) {
            let [_, first, second] = self.derivatives(slot, u, divisor);
            *rate = first * weights[slot];
            product += *rate * second * weights[slot];
        }
        let speed = length(&rates);
        (speed, if speed > 0.0 { product / speed } else { 0.0 })
    }

    /// Length between two values of the parameter.
    fn covered(&self, from: f64, to: f64, weights: &[f64; AXES]) -> f64 {
        let width = to - from;
        width * QUADRATURE.iter().map(|(at, share)| share * self.speed(from + at * width, weights).0).sum::<f64>()
    }
}

/// Value, first and second derivative of a polynomial.
fn powers([c0, c1, c2, c3, c4]: [f64; TERMS], u: f64) -> [f64; 3] {
    [
        c0 + u * (c1 + u * (c2 + u * (c3 + u * c4))),
        c1 + u * (2.0 * c2 + u * (3.0 * c3 + u * 4.0 * c4)),
        2.0 * c2 + u * (6.0 * c3 + u * 12.0 * c4),
    ]
}

/// A place of the table.
#[derive(Clone, Copy, Debug, Default)]
struct Node {
    /// Part of the length that is covered.
    s: f64,
    /// Change of the parameter with that part.
    slope: f64,
}

/// A piece of a curve in the coordinates of the axes, measured.
#[derive(Clone, Copy, Debug)]
pub(super) struct Measured {
    span: Span,
    weights: [f64; AXES],
    length: f64,
    nodes: [Node; PIECES + 1],
}

/// The parameter at a part of the length, with its first and second derivative by that part.
pub(super) type Parameter = [f64; 3];

/// Width of a piece of the table.
const WIDTH: f64 = 1.0 / PIECES as f64;

impl Measured {
    pub(super) fn new(span: &Span, weights: &[f64; AXES]) -> Self {
        let mut nodes = [Node::default(); PIECES + 1];
        let mut covered = 0.0;
        for piece in 0..PIECES {
            covered += span.covered(piece as f64 * WIDTH, (piece + 1) as f64 * WIDTH, weights);
            nodes[piece + 1].s = covered;
        }
        let mut measured = Self { span: *span, weights: *weights, length: covered, nodes };
        measured.grade();
        measured
    }

    /// Finds the slopes of the table.
    fn grade(&mut self) {
        if !self.is_measured() {
            for (index, node) in self.nodes.iter_mut().enumerate() {
                *node = Node { s: index as f64 * WIDTH, slope: 1.0 };
            }
            return;
        }
        for node in &mut self.nodes {
            node.s /= self.length;
        }
        for index in 0..=PIECES {
            let (speed, _) = self.span.speed(index as f64 * WIDTH, &self.weights);
            // Up to three times the mean slope on both sides the table only rises (Fritsch and Carlson).
            let mean = |low: usize| WIDTH / (self.nodes[low + 1].s - self.nodes[low].s);
            let before = if index > 0 { mean(index - 1) } else { f64::INFINITY };
            let behind = if index < PIECES { mean(index) } else { f64::INFINITY };
            self.nodes[index].slope = (self.length / speed).min(3.0 * before).min(3.0 * behind);
        }
    }

    /// Whether it has a length of its own.
    fn is_measured(&self) -> bool {
        self.length > 0.0 && self.length.is_finite()
    }

    pub(super) fn length(&self) -> f64 {
        self.length
    }

    pub(super) fn moves(&self, slot: usize) -> bool {
        self.span.moves.get(slot).is_some_and(|moves| *moves)
    }

    pub(super) fn joined(&self) -> bool {
        self.span.joined
    }

    /// The parameter at a part of the length.
    pub(super) fn parameter(&self, s: f64) -> Parameter {
        let low = self.nodes[..PIECES].iter().rposition(|node| node.s <= s).unwrap_or(0);
        let guess = self.guess(low, s);
        if !self.is_measured() {
            return guess;
        }
        let from = low as f64 * WIDTH;
        let aim = (s - self.nodes[low].s) * self.length;
        let mut u = guess[0];
        for _ in 0..STEPS {
            let (speed, _) = self.span.speed(u, &self.weights);
            if speed > CUSP * self.length {
                u = (u - (self.span.covered(from, u, &self.weights) - aim) / speed).clamp(from, from + WIDTH);
            }
        }
        let (speed, change) = self.span.speed(u, &self.weights);
        if speed <= CUSP * self.length {
            return [u, guess[1], guess[2]];
        }
        let rate = self.length / speed;
        [u, rate, -change / speed * (rate * rate)]
    }

    /// What the table alone says: a cubic between two nodes, with the slopes of both at its ends.
    fn guess(&self, low: usize, s: f64) -> Parameter {
        let (from, to) = (self.nodes[low], self.nodes[low + 1]);
        let width = to.s - from.s;
        if width <= 0.0 {
            return [low as f64 * WIDTH, 0.0, 0.0];
        }
        let x = (s - from.s) / width;
        let (start, end) = (from.slope * width, to.slope * width);
        let (square, cube) = (3.0 * WIDTH - 2.0 * start - end, start + end - 2.0 * WIDTH);
        [
            low as f64 * WIDTH + x * (start + x * (square + x * cube)),
            (start + x * (2.0 * square + x * 3.0 * cube)) / width,
            (2.0 * square + x * 6.0 * cube) / (width * width),
        ]
    }

    /// Derivative of the given order, by the part of the length, of where an axis is.
    pub(super) fn at(&self, slot: usize, order: u8, [u, rate, bend]: Parameter) -> f64 {
        if slot >= AXES {
            return 0.0;
        }
        let [value, first, second] = self.span.derivatives(slot, u, powers(self.span.denominator, u));
        match order {
            0 => value,
            1 => first * rate,
            _ => second * (rate * rate) + first * bend,
        }
    }
}
