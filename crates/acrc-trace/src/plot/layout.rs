//! Where everything stands, and what surrounds the panels: title, frames, time axis.

use std::mem::discriminant;

use super::canvas::{Anchor, Canvas, FONT_SIZE, Rect};
use super::lanes;
use super::lines::legend_width;
use super::panel::{Content, Panel};
use super::path::{self, PathPanel};
use super::scale::Scale;
use super::ticks::ticks;

/// Between a label and what it labels, in pixels.
pub(super) const LABEL_GAP: f64 = 6.0;
/// Width of the title of a value axis, which runs upwards.
pub(super) const AXIS_TITLE_WIDTH: f64 = 20.0;
/// Names are cut to this width, in pixels.
pub(super) const LONGEST_NAME: f64 = 180.0;
/// Length of the piece of line beside a name in a legend.
pub(super) const LEGEND_SAMPLE: f64 = 18.0;
/// The look of grid lines.
pub(super) const GRID: &str = r##"stroke="#e4e4e4""##;

/// Around the picture, in pixels.
const MARGIN: f64 = 10.0;
const TITLE_HEIGHT: f64 = 26.0;
const TITLE_SIZE: f64 = 15.0;
const PANEL_GAP: f64 = 14.0;
const TIME_AXIS_HEIGHT: f64 = 36.0;
/// The drawing area is at least this wide, whatever the labels need.
const NARROWEST_PLOT: f64 = 120.0;
/// What the last label of the time axis may need beyond the drawing area.
const HALF_TICK_LABEL: f64 = 20.0;
/// Pixels a tick on the time axis, at the least.
const TICK_SPACING: f64 = 80.0;

/// What stands where from left to right; it is the same for all panels.
#[derive(Clone, Copy)]
pub(super) struct Across {
    pub(super) left: f64,
    pub(super) plot_width: f64,
    width: f64,
}

impl Across {
    /// `axis` is the room that something else than the panels needs on the left.
    pub(super) fn new(panels: &[Panel<'_>], width: u32, axis: f64) -> Self {
        let legend = |panel: &Panel<'_>| match &panel.content {
            Content::Lines(_) => legend_width(panel.name_width().min(LONGEST_NAME)),
            Content::Lanes => HALF_TICK_LABEL,
        };
        let left = MARGIN + panels.iter().map(axis_width).fold(axis, f64::max);
        let right = MARGIN + panels.iter().map(legend).fold(0.0, f64::max);
        let plot_width = (f64::from(width) - left - right).max(NARROWEST_PLOT);
        Self { left, plot_width, width: left + plot_width + right }
    }
}

/// Width of the labels left of a panel and of its title, in pixels.
fn axis_width(panel: &Panel<'_>) -> f64 {
    match &panel.content {
        Content::Lines(lines) => lines.axis_width(),
        Content::Lanes => lanes::axis_width(panel),
    }
}

/// Where a panel stands.
#[derive(Clone, Copy)]
pub(super) struct Frame {
    /// The drawing area.
    pub(super) area: Rect,
    /// Where the title of its axis runs upwards.
    pub(super) title_left: f64,
}

/// The places of a picture, in pixels.
pub(super) struct Layout {
    pub(super) width: f64,
    pub(super) height: f64,
    /// The panels from top to bottom.
    pub(super) frames: Vec<Frame>,
    /// The paths below them.
    pub(super) paths: Vec<Frame>,
}

impl Layout {
    /// The panels below a title, if there is one, and the texts of the events; paths below the time axis.
    pub(super) fn new(
        across: Across,
        panels: &[Panel<'_>],
        paths: &[PathPanel<'_>],
        has_title: bool,
        events: f64,
    ) -> Self {
        let mut top = top_margin(has_title) + events;
        let mut frames = Vec::new();
        for panel in panels {
            let area = Rect { left: across.left, top, width: across.plot_width, height: panel.height };
            frames.push(Frame { area, title_left: across.left - title_distance(panel, panels) });
            top += panel.height + PANEL_GAP;
        }
        top += TIME_AXIS_HEIGHT - PANEL_GAP;
        let path_title = paths.iter().map(PathPanel::axis_width).fold(0.0, f64::max) - FONT_SIZE;
        let mut path_frames = Vec::new();
        for _ in paths {
            top += PANEL_GAP;
            let area = Rect { left: across.left, top, width: across.plot_width, height: path::HEIGHT };
            path_frames.push(Frame { area, title_left: across.left - path_title });
            top += path::HEIGHT + path::FOOTER;
        }
        Self { width: across.width, height: top + MARGIN, frames, paths: path_frames }
    }

    pub(super) fn draw_title(&self, canvas: &mut Canvas, title: &str) {
        if title.is_empty() {
            return;
        }
        let left = self.frames.first().map_or(MARGIN, |frame| frame.area.left);
        canvas.group(&format!(r#"font-size="{TITLE_SIZE}" font-weight="bold""#), |canvas| {
            let room = (self.width - left - MARGIN) * FONT_SIZE / TITLE_SIZE;
            canvas.label(left, MARGIN + TITLE_SIZE, Anchor::Start, title, room);
        });
    }

    /// Grid lines through all panels, labels below the last one.
    pub(super) fn draw_time_axis(&self, canvas: &mut Canvas, time: &Scale) {
        let ticks = ticks(time.domain, time.length() / TICK_SPACING);
        canvas.group(GRID, |canvas| {
            for Frame { area, .. } in &self.frames {
                for tick in &ticks {
                    canvas.vertical(time.at(tick.value), area.top, area.height);
                }
            }
        });
        let Some(Frame { area: last, .. }) = self.frames.last() else { return };
        let baseline = last.bottom() + LABEL_GAP + FONT_SIZE * 0.8;
        for tick in &ticks {
            canvas.text(time.at(tick.value), baseline, Anchor::Middle, &tick.label);
        }
        let middle = last.left + last.width / 2.0;
        canvas.text(middle, baseline + FONT_SIZE * 1.5, Anchor::Middle, "time [s]");
    }
}

/// How far left of its panel the title of an axis stands: as far as in the other panels of its kind.
fn title_distance(panel: &Panel<'_>, panels: &[Panel<'_>]) -> f64 {
    let alike = |other: &&Panel<'_>| discriminant(&other.content) == discriminant(&panel.content);
    panels.iter().filter(alike).map(axis_width).fold(0.0, f64::max) - FONT_SIZE
}

/// A picture of one empty panel with a message in it.
pub(super) fn draw_message(width: u32, panel_height: u32, title: &str, message: &str) -> String {
    let area = Rect {
        left: MARGIN,
        top: top_margin(!title.is_empty()),
        width: f64::from(width).max(NARROWEST_PLOT) - 2.0 * MARGIN,
        height: f64::from(panel_height),
    };
    let frames = vec![Frame { area, title_left: MARGIN }];
    let layout = Layout { width: area.right() + MARGIN, height: area.bottom() + MARGIN, frames, paths: Vec::new() };
    let mut canvas = Canvas::new(layout.width, layout.height, title);
    layout.draw_title(&mut canvas, title);
    draw_border(&mut canvas, area);
    canvas.text(area.left + area.width / 2.0, area.middle(), Anchor::Middle, message);
    canvas.finish()
}

fn top_margin(has_title: bool) -> f64 {
    MARGIN + if has_title { TITLE_HEIGHT } else { 0.0 }
}

/// The border of a panel.
pub(super) fn draw_border(canvas: &mut Canvas, area: Rect) {
    canvas.rect(area, r##" fill="none" stroke="#888""##);
}
