//! A panel of bits: one lane each, filled while on.

use super::canvas::{Anchor, Canvas, HALF_CAPITAL, Rect};
use super::layout::{AXIS_TITLE_WIDTH, Frame, LABEL_GAP, LONGEST_NAME, draw_border};
use super::palette::LANE_COLOR;
use super::panel::Panel;
use super::scale::{Scale, is_drawable};
use crate::Trace;
use crate::signal::is_on;

/// Height of a lane in pixels.
pub(super) const LANE_HEIGHT: f64 = 18.0;
/// What is left free above and below the bar in it.
const BAR_MARGIN: f64 = 3.5;
/// A pulse is drawn at least this wide, so that it is seen however short it is.
const NARROWEST: f64 = 1.0;
/// A pause shorter than this, in pixels, is not drawn.
const SHORTEST_PAUSE: f64 = 0.5;
const GROUND_LINE: &str = r##"stroke="#bbb""##;
/// Every other lane; it lets the grid through.
const SHADE: &str = r#" fill-opacity="0.04""#;

/// Width of the names and the title, in pixels.
pub(super) fn axis_width(panel: &Panel<'_>) -> f64 {
    panel.name_width().min(LONGEST_NAME) + LABEL_GAP + AXIS_TITLE_WIDTH
}

pub(super) fn draw(canvas: &mut Canvas, trace: &Trace, panel: &Panel<'_>, frame: Frame, time: &Scale) {
    let area = frame.area;
    draw_lanes(canvas, panel, area);
    canvas.group(&format!(r#"fill="{LANE_COLOR}""#), |canvas| {
        for (index, (signal, _)) in panel.signals.iter().enumerate() {
            let top = lane(area, index).top + BAR_MARGIN;
            for (left, right) in bars(trace.times(), trace.column(*signal), time) {
                let bar = Rect { left, top, width: right - left, height: LANE_HEIGHT - 2.0 * BAR_MARGIN };
                canvas.rect(bar, "");
            }
        }
    });
    draw_border(canvas, area);
    for (index, (_, signal)) in panel.signals.iter().enumerate() {
        let baseline = lane(area, index).middle() + HALF_CAPITAL;
        canvas.label(area.left - LABEL_GAP, baseline, Anchor::End, &signal.name, LONGEST_NAME);
    }
    canvas.upward_text(frame.title_left, area.middle(), panel.group);
}

/// The ground that the bars stand on.
fn draw_lanes(canvas: &mut Canvas, panel: &Panel<'_>, area: Rect) {
    for index in (0..panel.signals.len()).step_by(2) {
        canvas.rect(lane(area, index), SHADE);
    }
    canvas.group(GROUND_LINE, |canvas| {
        for index in 0..panel.signals.len() {
            canvas.horizontal(area.left, lane(area, index).bottom() - BAR_MARGIN, area.width);
        }
    });
}

/// The lane of the bit with this index.
fn lane(area: Rect, index: usize) -> Rect {
    Rect { top: area.top + LANE_HEIGHT * index as f64, height: LANE_HEIGHT, ..area }
}

/// Where the bit is on, from pixel to pixel.
fn bars(times: &[f64], column: &[f64], time: &Scale) -> Vec<(f64, f64)> {
    let mut bars: Vec<(f64, f64)> = Vec::new();
    let mut on_since = None;
    let samples = times.iter().zip(column).filter(|(at, _)| is_drawable(**at));
    for (at, value) in samples {
        match (on_since, is_on(*value)) {
            (None, true) => on_since = Some(time.at(*at)),
            (Some(since), false) => {
                push_bar(&mut bars, time, since, time.at(*at));
                on_since = None;
            }
            _ => {}
        }
    }
    if let Some(since) = on_since {
        let last = times.iter().rfind(|at| is_drawable(**at)).map_or(since, |at| time.at(*at));
        push_bar(&mut bars, time, since, last);
    }
    bars
}

fn push_bar(bars: &mut Vec<(f64, f64)>, time: &Scale, from: f64, to: f64) {
    let from = from.min(time.end() - NARROWEST);
    let to = to.max(from + NARROWEST);
    match bars.last_mut() {
        Some((_, last)) if from - *last < SHORTEST_PAUSE => *last = to,
        _ => bars.push((from, to)),
    }
}
