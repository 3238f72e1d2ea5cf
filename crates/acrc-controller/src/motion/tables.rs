//! The arrays that cam tables and limit switches read while they work. They belong to programs, which may change them at any time.

use acrc_catalog::OperandClass;
use acrc_motion::axis::CamPoints;

use crate::task::Task;

/// An array of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ArrayPlace {
    pub(crate) task: Task,
    pub(crate) class: OperandClass,
    pub(crate) array: i64,
}

/// Access to the arrays of programs.
pub(crate) trait Arrays {
    /// Elements of an array; 0 when it does not exist.
    fn size(&self, place: ArrayPlace) -> usize;
    /// An element; 0 outside.
    fn element(&self, place: ArrayPlace, index: usize) -> f64;
}

/// No arrays, where no table is read.
pub(crate) struct NoArrays;

impl Arrays for NoArrays {
    fn size(&self, _: ArrayPlace) -> usize {
        0
    }

    fn element(&self, _: ArrayPlace, _: usize) -> f64 {
        0.0
    }
}

/// The points of a cam table.
pub(super) struct Points<'a> {
    pub(super) arrays: &'a dyn Arrays,
    pub(super) segments: &'a [Option<ArrayPlace>],
}

impl CamPoints for Points<'_> {
    fn point(&self, segment: usize, index: usize) -> f64 {
        let place = self.segments.get(segment).copied().flatten();
        place.map_or(0.0, |place| self.arrays.element(place, index))
    }
}
