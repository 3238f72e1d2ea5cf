//! The kinds of moves besides the straight line (the guide's "Combining Types of Motion": CIRCW, CIRCCW, TARC, SINE).

/// Which way round an arc runs, seen with its first axis to the right and its second axis up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turn {
    /// From the second axis toward the first (CIRCW).
    Clockwise,
    /// From the first axis toward the second (CIRCCW).
    CounterClockwise,
}

/// An arc of two axes, by its end and its centre (CIRCW, CIRCCW, and arcs of binary moves).
///
/// Its radius is the distance from the centre to the end. Where the move before did not end on that circle, the axes
/// jump onto it, straight away from the centre. An end where the move before ended makes a full circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    /// The two slots, the primary one first.
    pub slots: [usize; 2],
    /// Where the arc ends, u.
    pub target: [f64; 2],
    /// Its centre, u.
    pub center: [f64; 2],
    /// Whether the end is relative to the target of the move before.
    pub relative_target: bool,
    /// Whether the centre is relative to the target of the move before.
    pub relative_center: bool,
    /// Which way round.
    pub turn: Turn,
}

/// An arc of three axes: from where they are, through one point, to another (TARC).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpaceArc {
    /// The three slots.
    pub slots: [usize; 3],
    /// A point on the way, u.
    pub via: [f64; 3],
    /// Where the arc ends, u.
    pub target: [f64; 3],
}

/// A sinusoidal move of one axis (SINE).
///
/// The sinusoid runs evenly from its first phase through its sweep while the straight axes of the move run from start
/// to end. An axis that is not where the sinusoid begins comes over to it evenly on the way: at its start the axis is
/// where it was, at its end it is at the target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sine {
    /// Where the axis ends, u.
    pub target: f64,
    /// Phase at the start, degrees.
    pub phase: f64,
    /// Change of phase over the move, degrees.
    pub sweep: f64,
    /// Amplitude, u.
    pub amplitude: f64,
}

/// A curve that takes more than one axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Curve {
    Arc(Arc),
    SpaceArc(SpaceArc),
}

impl Curve {
    pub(super) fn slots(&self) -> &[usize] {
        match self {
            Self::Arc(arc) => &arc.slots,
            Self::SpaceArc(arc) => &arc.slots,
        }
    }
}
