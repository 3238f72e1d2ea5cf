//! The table of a cam: segments of equally spaced points over the way of the source.

use alloc::vec::Vec;
use core::fmt;

use crate::value::{InvalidValue, Quantity, finite};

/// A stretch of a table (CAM SEG).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CamSegment {
    /// Source counts it covers; above zero.
    pub length: f64,
    /// Points in its array, at least one. The first lies at its start and the last at its end.
    pub points: usize,
}

/// Where the points of a table come from: the value of a point by segment and place in that segment's array.
///
/// The arrays belong to a program and can change at any time, so the table does not copy them. A closure will do.
pub trait CamPoints {
    /// The value of point `index` of `segment`.
    fn point(&self, segment: usize, index: usize) -> f64;
}

impl<F: Fn(usize, usize) -> f64> CamPoints for F {
    fn point(&self, segment: usize, index: usize) -> f64 {
        self(segment, index)
    }
}

/// Why a table cannot be used as told. Nothing has changed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CamError {
    /// The table has no segment of this number.
    NoSuchSegment(usize),
    /// The array of a segment has no points.
    NoPoints,
    /// A length that is not above zero.
    Length(f64),
    /// A value is not a number or infinite.
    Invalid(InvalidValue),
}

impl From<InvalidValue> for CamError {
    fn from(error: InvalidValue) -> Self {
        Self::Invalid(error)
    }
}

impl fmt::Display for CamError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchSegment(segment) => write!(f, "the table has no segment {segment}"),
            Self::NoPoints => f.write_str("the array of the segment has no points"),
            Self::Length(length) => write!(f, "the length of a segment is {length}, but has to be above zero"),
            Self::Invalid(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for CamError {}

/// The segments of a cam, one after the other. Its place is taken when it is dimensioned.
#[derive(Clone, Debug, Default)]
pub(super) struct Table {
    segments: Vec<Option<CamSegment>>,
    length: f64,
}

impl Table {
    pub(super) fn with_segments(count: usize) -> Self {
        let mut segments = Vec::new();
        segments.resize(count, None);
        Self { segments, length: 0.0 }
    }

    pub(super) fn set(&mut self, index: usize, segment: CamSegment) -> Result<(), CamError> {
        finite(Quantity::Length, segment.length)?;
        if segment.length <= 0.0 {
            return Err(CamError::Length(segment.length));
        }
        if segment.points == 0 {
            return Err(CamError::NoPoints);
        }
        *self.segments.get_mut(index).ok_or(CamError::NoSuchSegment(index))? = Some(segment);
        self.length = self.defined().map(|(_, segment)| segment.length).sum();
        Ok(())
    }

    fn defined(&self) -> impl DoubleEndedIterator<Item = (usize, &CamSegment)> {
        self.segments.iter().enumerate().filter_map(|(index, segment)| Some((index, segment.as_ref()?)))
    }

    /// Source counts from its beginning to its end; zero while no segment is defined.
    pub(super) fn length(&self) -> f64 {
        self.length
    }

    /// What one pass through the table adds: its last point over its first.
    pub(super) fn rise(&self, points: &impl CamPoints) -> f64 {
        let (first, last) = (self.defined().next(), self.defined().next_back());
        match (first, last) {
            (Some((first, _)), Some((last, segment))) => {
                points.point(last, segment.points - 1) - points.point(first, 0)
            }
            _ => 0.0,
        }
    }

    /// The value at a place between zero and the length, interpolated between points.
    pub(super) fn value(&self, place: f64, points: &impl CamPoints) -> f64 {
        let mut rest = place;
        let mut found = None;
        for (index, segment) in self.defined() {
            found = Some((index, segment, rest));
            if rest < segment.length {
                break;
            }
            rest -= segment.length;
        }
        let Some((index, segment, rest)) = found else { return 0.0 };
        let intervals = segment.points - 1;
        let steps = (rest / segment.length).clamp(0.0, 1.0) * intervals as f64;
        let before = (steps as usize).min(intervals.saturating_sub(1));
        let from = points.point(index, before);
        if intervals == 0 { from } else { from + (points.point(index, before + 1) - from) * (steps - before as f64) }
    }
}
