//! The arrays that cam tables and limit switches read while they work. They belong to programs, which may change them at any time.

use acrc_catalog::OperandClass;
use acrc_motion::axis::CamPoints;
use acrc_vm::Value;

use super::cam::Segment;
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
    /// An element. `None` outside.
    fn read(&self, place: ArrayPlace, index: usize) -> Option<f64>;
    /// Changes an element. False when it does not exist or cannot hold the value.
    fn store(&mut self, place: ArrayPlace, index: usize, value: &Value) -> bool;
}

/// No arrays, where no table is read.
pub(crate) struct NoArrays;

impl Arrays for NoArrays {
    fn size(&self, _: ArrayPlace) -> usize {
        0
    }

    fn read(&self, _: ArrayPlace, _: usize) -> Option<f64> {
        None
    }

    fn store(&mut self, _: ArrayPlace, _: usize, _: &Value) -> bool {
        false
    }
}

/// The points of a cam table.
pub(super) struct Points<'a> {
    pub(super) arrays: &'a dyn Arrays,
    pub(super) segments: &'a [Option<Segment>],
}

impl CamPoints for Points<'_> {
    fn point(&self, segment: usize, index: usize) -> f64 {
        let segment = self.segments.get(segment).copied().flatten();
        segment.and_then(|segment| self.arrays.read(segment.place, index)).unwrap_or(0.0)
    }
}
