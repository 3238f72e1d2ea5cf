//! As many points as can be seen: two a pixel column, its highest and its lowest, so that no peak is lost.

use std::fmt;

use super::canvas::Px;

/// A place in the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Point {
    x: Px,
    y: Px,
    column: i64,
}

impl Point {
    pub(super) fn new(x: f64, y: f64) -> Self {
        Self { x: Px::new(x), y: Px::new(y), column: x.floor() as i64 }
    }
}

impl fmt::Display for Point {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.x, self.y)
    }
}

/// Unbroken stretches of the samples, which come in order of time; `None` breaks a stretch.
pub(super) fn stretches(samples: impl Iterator<Item = Option<Point>>) -> Vec<Vec<Point>> {
    let mut stretches = Vec::new();
    let mut current = Stretch::default();
    for sample in samples {
        match sample {
            Some(point) => current.push(point),
            None => current.finish_into(&mut stretches),
        }
    }
    current.finish_into(&mut stretches);
    stretches
}

/// A stretch being thinned out.
#[derive(Default)]
struct Stretch {
    points: Vec<Point>,
    column: Option<Column>,
}

/// What is kept of a pixel column.
#[derive(Clone, Copy)]
struct Column {
    high: Point,
    low: Point,
    /// Which of the two extremes came first.
    high_is_first: bool,
    last: Point,
}

impl Stretch {
    fn push(&mut self, point: Point) {
        match &mut self.column {
            Some(column) if column.high.column == point.column => column.add(point),
            _ => {
                self.close_column();
                // The very first sample is kept exactly, whatever else its column holds.
                if self.points.is_empty() {
                    self.points.push(point);
                }
                self.column = Some(Column::new(point));
            }
        }
    }

    fn close_column(&mut self) {
        if let Some(column) = self.column.take() {
            for point in column.extremes() {
                self.keep(point);
            }
        }
    }

    fn finish_into(&mut self, stretches: &mut Vec<Vec<Point>>) {
        let last = self.column.map(|column| column.last);
        self.close_column();
        if let Some(last) = last {
            self.keep(last);
            stretches.push(std::mem::take(&mut self.points));
        }
    }

    /// Adds a point, and drops the one before it where that says nothing: twice the same, or inside a level stretch.
    fn keep(&mut self, point: Point) {
        if self.points.last() == Some(&point) {
            return;
        }
        if let [.., before, last] = self.points.as_slice()
            && before.y == last.y
            && last.y == point.y
        {
            self.points.pop();
        }
        self.points.push(point);
    }
}

impl Column {
    const fn new(point: Point) -> Self {
        Self { high: point, low: point, high_is_first: true, last: point }
    }

    fn add(&mut self, point: Point) {
        // Pixels count downwards.
        if point.y < self.high.y {
            self.high = point;
            self.high_is_first = false;
        } else if point.y > self.low.y {
            self.low = point;
            self.high_is_first = true;
        }
        self.last = point;
    }

    const fn extremes(self) -> [Point; 2] {
        if self.high_is_first { [self.high, self.low] } else { [self.low, self.high] }
    }
}
