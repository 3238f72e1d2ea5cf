//! Where something is in a file: a half-open range of bytes.

use std::ops::Range;

/// A half-open range of byte offsets in the decoded text of one file.
///
/// Offsets are 32 bits wide: a program text larger than 4 GiB is not a thing a controller can hold. The renderers and
/// [`apply`](crate::apply) accept any span, also one that lies outside the text or splits a character; nothing panics.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Span {
    /// Offset of the first byte.
    pub start: u32,
    /// Offset one past the last byte; never below `start` in a span made by [`Span::new`].
    pub end: u32,
}

impl Span {
    /// The span from `start` up to, not including, `end`. An `end` below `start` gives the empty span at `start`.
    #[must_use]
    pub const fn new(start: u32, end: u32) -> Self {
        Self { start, end: if end < start { start } else { end } }
    }

    /// The empty span at `offset`, a place between two characters.
    #[must_use]
    pub const fn empty(offset: u32) -> Self {
        Self { start: offset, end: offset }
    }

    /// Length in bytes.
    #[must_use]
    pub const fn len(self) -> u32 {
        self.end.saturating_sub(self.start)
    }

    /// Whether the span covers no byte.
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.end <= self.start
    }

    /// Whether the byte at `offset` lies in the span. An empty span contains nothing.
    #[must_use]
    pub const fn contains(self, offset: u32) -> bool {
        self.start <= offset && offset < self.end
    }

    /// The smallest span that covers both `a` and `b` and whatever lies between them.
    #[must_use]
    pub fn cover(a: Self, b: Self) -> Self {
        Self { start: a.start.min(b.start), end: a.end.max(b.end) }
    }

    /// The span as an index range for `str::get`.
    #[must_use]
    pub const fn range(self) -> Range<usize> {
        self.start as usize..self.end as usize
    }
}

impl From<Span> for Range<usize> {
    fn from(span: Span) -> Self {
        span.range()
    }
}

/// Offsets beyond `u32::MAX` become `u32::MAX`.
impl From<Range<usize>> for Span {
    fn from(range: Range<usize>) -> Self {
        let narrow = |offset| u32::try_from(offset).unwrap_or(u32::MAX);
        Self::new(narrow(range.start), narrow(range.end))
    }
}
