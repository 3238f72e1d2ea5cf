//! The path of a tool: one signal over another, both to one scale.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use super::canvas::{Anchor, Canvas, FONT_SIZE, HALF_CAPITAL, Px, Rect};
use super::decimate::Point;
use super::layout::{AXIS_TITLE_WIDTH, Frame, GRID, LABEL_GAP, draw_border};
use super::lines::{CURVES, axis_title};
use super::panel::widest;
use super::scale::{Domain, Scale, is_drawable};
use super::ticks::{Tick, ticks};
use crate::{Signal, Trace};

/// Height of the drawing area, in pixels.
pub(super) const HEIGHT: f64 = 320.0;
/// What stands below it: labels, and the title of the axis.
pub(super) const FOOTER: f64 = 36.0;
/// Room around the path, as a part of its size.
const PADDING: f64 = 0.06;
/// Pixels a tick, at the least.
const TICK_SPACING: f64 = 44.0;
/// Points closer than this, in pixels, are one; a way between two such places is drawn once, however often it is gone.
const CELL: f64 = 0.5;
const COLOR: &str = "#0072b2";

/// One panel.
pub(super) struct PathPanel<'t> {
    signals: [&'t Signal; 2],
    points: Vec<Option<(f64, f64)>>,
    across: Domain,
    up: Domain,
    ticks: [Vec<Tick>; 2],
}

impl<'t> PathPanel<'t> {
    /// The path of two signals by name in a drawing area of this width; `None` when there is nothing to draw.
    pub(super) fn new(trace: &'t Trace, names: &[String; 2], width: f64) -> Option<Self> {
        let index = |name: &String| trace.signal_index(name);
        let [x, y] = [index(&names[0])?, index(&names[1])?];
        let signals = [trace.signals().get(x)?, trace.signals().get(y)?];
        let pairs = trace.column(x).iter().zip(trace.column(y));
        let points: Vec<Option<(f64, f64)>> =
            pairs.map(|(x, y)| (is_drawable(*x) && is_drawable(*y)).then_some((*x, *y))).collect();
        let drawable = || points.iter().flatten();
        let across = Domain::of(drawable().map(|point| point.0))?;
        let up = Domain::of(drawable().map(|point| point.1))?;
        if across.size() <= 0.0 && up.size() <= 0.0 {
            return None;
        }
        let (across, up) = (across.widened(PADDING, 0.0), up.widened(PADDING, 0.0));
        // One scale for both, so that a circle is a circle.
        let scale = (across.size() / width).max(up.size() / HEIGHT);
        let (across, up) = (across.resized(scale * width), up.resized(scale * HEIGHT));
        let ticks = [ticks(across, width / (2.0 * TICK_SPACING)), ticks(up, HEIGHT / TICK_SPACING)];
        Some(Self { signals, points, across, up, ticks })
    }

    /// Width of the value axis with its title, in pixels.
    pub(super) fn axis_width(&self) -> f64 {
        widest(self.ticks[1].iter().map(|tick| tick.label.as_str())) + LABEL_GAP + AXIS_TITLE_WIDTH
    }

    pub(super) fn draw(&self, canvas: &mut Canvas, frame: Frame) {
        let area = frame.area;
        let x = Scale::new(self.across, area.left, area.right());
        let y = Scale::new(self.up, area.bottom(), area.top);
        self.draw_axes(canvas, frame, &x, &y);
        let path = self.path(&x, &y);
        canvas.group(CURVES, |canvas| {
            canvas.line(format_args!(r#"<path stroke="{COLOR}" d="{path}"/>"#));
        });
        draw_border(canvas, area);
        self.draw_ends(canvas, area, &x, &y);
    }

    fn draw_axes(&self, canvas: &mut Canvas, frame: Frame, x: &Scale, y: &Scale) {
        let area = frame.area;
        let [across, up] = &self.ticks;
        canvas.group(GRID, |canvas| {
            for tick in across {
                canvas.vertical(x.at(tick.value), area.top, area.height);
            }
            for tick in up {
                canvas.horizontal(area.left, y.at(tick.value), area.width);
            }
        });
        let baseline = area.bottom() + LABEL_GAP + FONT_SIZE * 0.8;
        for tick in across {
            canvas.text(x.at(tick.value), baseline, Anchor::Middle, &tick.label);
        }
        for tick in up {
            canvas.text(area.left - LABEL_GAP, y.at(tick.value) + HALF_CAPITAL, Anchor::End, &tick.label);
        }
        let [below, left] = self.signals.map(|signal| axis_title(&signal.name, &[(0, signal)]));
        canvas.text(area.left + area.width / 2.0, baseline + FONT_SIZE * 1.5, Anchor::Middle, &below);
        canvas.upward_text(frame.title_left, area.middle(), &left);
    }

    /// The path data. A way that was gone before is left out.
    fn path(&self, x: &Scale, y: &Scale) -> String {
        let cell = |at: (f64, f64)| ((at.0 / CELL).floor() as i64, (at.1 / CELL).floor() as i64);
        let mut data = String::new();
        let mut gone = BTreeSet::new();
        let mut last: Option<(f64, f64)> = None;
        let mut pen_is_down = false;
        for point in &self.points {
            let Some(point) = point else {
                (last, pen_is_down) = (None, false);
                continue;
            };
            let at = (x.at(point.0), y.at(point.1));
            let Some(from) = last.replace(at) else { continue };
            let (here, before) = (cell(at), cell(from));
            if here == before {
                last = Some(from);
                continue;
            }
            if !gone.insert((here.min(before), here.max(before))) {
                pen_is_down = false;
                continue;
            }
            if !pen_is_down {
                write!(data, "M{}", Point::new(from.0, from.1)).expect("a string takes any text");
            }
            write!(data, "L{}", Point::new(at.0, at.1)).expect("a string takes any text");
            pen_is_down = true;
        }
        data
    }

    /// Where the path begins and ends, and what the marks mean.
    fn draw_ends(&self, canvas: &mut Canvas, area: Rect, x: &Scale, y: &Scale) {
        let mut drawable = self.points.iter().flatten();
        let Some(first) = drawable.next() else { return };
        let last = drawable.next_back().unwrap_or(first);
        let left = area.right() + 3.0 * LABEL_GAP;
        for (row, point, what, look) in [
            (0.0, first, "start", format!(r##"fill="#fff" stroke="{COLOR}" stroke-width="1.5""##)),
            (1.0, last, "end", format!(r#"fill="{COLOR}""#)),
        ] {
            let beside = (left, area.top + 16.0 * (row + 0.5));
            // The end lies inside the ring of the start where they are one place.
            for (centre, radius) in [((x.at(point.0), y.at(point.1)), 4.5 - 2.0 * row), (beside, 4.5 - 2.0 * row)] {
                let [cx, cy, r] = [centre.0, centre.1, radius].map(Px::new);
                canvas.line(format_args!(r#"<circle cx="{cx}" cy="{cy}" r="{r}" {look}/>"#));
            }
            canvas.text(left + 2.0 * LABEL_GAP, beside.1 + HALF_CAPITAL, Anchor::Start, what);
        }
    }
}
