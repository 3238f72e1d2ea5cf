//! From values to pixels.

/// Numbers farther from zero than this are not drawn: differences of them need not be finite.
const LARGEST: f64 = 1e100;
/// A range narrower than this part of its values is drawn as if they were constant: its ticks could not be told apart.
const NARROWEST: f64 = 1e-9;
/// So is a range smaller than this: powers of ten beyond it are no longer exact enough to count ticks with.
const SMALLEST: f64 = 1e-100;

/// Whether a value has a place in a plot.
pub(super) fn is_drawable(value: f64) -> bool {
    value.abs() <= LARGEST
}

/// The range of values that an axis shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Domain {
    pub(super) min: f64,
    pub(super) max: f64,
}

impl Domain {
    /// From the smallest to the largest drawable value; `None` without one.
    pub(super) fn of(values: impl Iterator<Item = f64>) -> Option<Self> {
        values.filter(|value| is_drawable(*value)).fold(None, |domain: Option<Self>, value| {
            let Self { min, max } = domain.unwrap_or(Self { min: value, max: value });
            Some(Self { min: min.min(value), max: max.max(value) })
        })
    }

    /// Distance from the smallest to the largest value.
    pub(super) fn size(self) -> f64 {
        self.max - self.min
    }

    /// The same middle with another distance between smallest and largest value.
    pub(super) fn resized(self, size: f64) -> Self {
        let middle = f64::midpoint(self.min, self.max);
        Self { min: middle - size / 2.0, max: middle + size / 2.0 }
    }

    /// Makes room on both sides: `padding` as a part of the range or, where all values are the same, `constant` in
    /// their unit and at least as much as can be told apart at their size.
    pub(super) fn widened(self, padding: f64, constant: f64) -> Self {
        let Self { min, max } = self;
        let size = min.abs().max(max.abs());
        let range = max - min;
        let room = if range <= SMALLEST.max(size * NARROWEST) {
            constant.max(size * NARROWEST * 10.0).max(SMALLEST)
        } else {
            range * padding
        };
        Self { min: min - room, max: max + room }
    }
}

/// The place of values between two pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scale {
    pub(super) domain: Domain,
    from: f64,
    to: f64,
}

impl Scale {
    /// The smallest value stands at pixel `from`, the largest at pixel `to`.
    pub(super) const fn new(domain: Domain, from: f64, to: f64) -> Self {
        Self { domain, from, to }
    }

    /// The pixel of a value.
    pub(super) fn at(&self, value: f64) -> f64 {
        let part = (value - self.domain.min) / (self.domain.max - self.domain.min);
        self.from + part * (self.to - self.from)
    }

    /// Whether a value lies on the axis.
    pub(super) fn contains(&self, value: f64) -> bool {
        self.domain.min <= value && value <= self.domain.max
    }

    /// Length of the axis in pixels.
    pub(super) fn length(&self) -> f64 {
        (self.to - self.from).abs()
    }

    /// The pixel of the largest value.
    pub(super) const fn end(&self) -> f64 {
        self.to
    }
}
