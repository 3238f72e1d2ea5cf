//! A panel of real numbers: lines, grid, value axis, legend.

use std::fmt::Write as _;

use super::canvas::{Anchor, Canvas, HALF_CAPITAL, Px, Rect};
use super::decimate::{self, Point};
use super::layout::{AXIS_TITLE_WIDTH, Frame, GRID, LABEL_GAP, LEGEND_SAMPLE, LONGEST_NAME, draw_border};
use super::palette::{Palette, Style};
use super::panel::{Panel, widest};
use super::scale::{Domain, Scale, is_drawable};
use super::ticks::{Tick, ticks};
use crate::{Signal, Trace};

/// Room above the highest and below the lowest value, as a part of their range.
const PADDING: f64 = 0.06;
/// Pixels a tick on the value axis, at the least.
const TICK_SPACING: f64 = 28.0;
/// Height of a line of the legend, in pixels.
const LEGEND_ROW: f64 = 16.0;
/// Zero stands out among the grid lines.
const ZERO_LINE: &str = r##"stroke="#999""##;
pub(super) const CURVES: &str = r#"fill="none" stroke-width="1.5" stroke-linejoin="round" stroke-linecap="round""#;

/// What the lines of a panel need besides their samples.
pub(super) struct Lines {
    axis_title: String,
    domain: Domain,
    ticks: Vec<Tick>,
    styles: Vec<Style>,
}

impl Lines {
    pub(super) fn new<'t>(
        trace: &Trace,
        group: &str,
        signals: &[(usize, &'t Signal)],
        height: f64,
        palette: &mut Palette<'t>,
    ) -> Self {
        let values = signals.iter().flat_map(|(index, _)| trace.column(*index)).copied();
        let domain = Domain::of(values).unwrap_or(Domain { min: 0.0, max: 0.0 });
        // Constant values get a tenth of their size, so that the axis is labelled in digits that mean something.
        let domain = domain.widened(PADDING, if domain.max == 0.0 { 1.0 } else { domain.max.abs() / 10.0 });
        Self {
            axis_title: axis_title(group, signals),
            domain,
            ticks: ticks(domain, height / TICK_SPACING),
            styles: palette.styles(signals.iter().map(|(_, signal)| signal.owner())),
        }
    }

    /// Width of the value axis with its title, in pixels.
    pub(super) fn axis_width(&self) -> f64 {
        widest(self.ticks.iter().map(|tick| tick.label.as_str())) + LABEL_GAP + AXIS_TITLE_WIDTH
    }

    pub(super) fn draw(&self, canvas: &mut Canvas, trace: &Trace, panel: &Panel<'_>, frame: Frame, time: &Scale) {
        let area = frame.area;
        let values = Scale::new(self.domain, area.bottom(), area.top);
        self.draw_axis(canvas, area, &values);
        canvas.upward_text(frame.title_left, area.middle(), &self.axis_title);
        canvas.group(CURVES, |canvas| {
            for ((signal, _), style) in panel.signals.iter().zip(&self.styles) {
                let path = path(trace.times(), trace.column(*signal), time, &values);
                if !path.is_empty() {
                    canvas.line(format_args!(r#"<path {} d="{path}"/>"#, style.attributes()));
                }
            }
        });
        draw_border(canvas, area);
        self.draw_legend(canvas, panel, area);
    }

    fn draw_axis(&self, canvas: &mut Canvas, area: Rect, values: &Scale) {
        canvas.group(GRID, |canvas| {
            for tick in self.ticks.iter().filter(|tick| tick.value != 0.0) {
                canvas.horizontal(area.left, values.at(tick.value), area.width);
            }
        });
        if values.contains(0.0) {
            canvas.group(ZERO_LINE, |canvas| {
                canvas.horizontal(area.left, values.at(0.0), area.width);
            });
        }
        for tick in &self.ticks {
            let baseline = values.at(tick.value) + HALF_CAPITAL;
            canvas.text(area.left - LABEL_GAP, baseline, Anchor::End, &tick.label);
        }
    }

    /// The names, beside the panel.
    fn draw_legend(&self, canvas: &mut Canvas, panel: &Panel<'_>, area: Rect) {
        let left = area.right() + LABEL_GAP;
        let row = |index: usize| area.top + LEGEND_ROW * (index as f64 + 0.5);
        canvas.group(r#"fill="none" stroke-width="2""#, |canvas| {
            for (index, style) in self.styles.iter().enumerate() {
                let [x, y, width] = [left, row(index), LEGEND_SAMPLE].map(Px::new);
                canvas.line(format_args!(r#"<path {} d="M{x} {y}h{width}"/>"#, style.attributes()));
            }
        });
        let text_left = left + LEGEND_SAMPLE + LABEL_GAP;
        for (index, (_, signal)) in panel.signals.iter().enumerate() {
            canvas.label(text_left, row(index) + HALF_CAPITAL, Anchor::Start, &signal.name, LONGEST_NAME);
        }
    }
}

/// The group with the units of its signals: `velocity [mm/s]`.
pub(super) fn axis_title(group: &str, signals: &[(usize, &Signal)]) -> String {
    let mut units: Vec<&str> = Vec::new();
    for (_, signal) in signals {
        if !signal.unit.is_empty() && !units.contains(&signal.unit.as_str()) {
            units.push(&signal.unit);
        }
    }
    let units = units.join(", ");
    match (group, units.as_str()) {
        (group, "") => group.to_owned(),
        ("", units) => format!("[{units}]"),
        (group, units) => format!("{group} [{units}]"),
    }
}

/// The path data of one signal; empty if nothing of it can be drawn.
fn path(times: &[f64], column: &[f64], time: &Scale, values: &Scale) -> String {
    let samples = times.iter().zip(column).map(|(at, value)| {
        let drawable = is_drawable(*at) && is_drawable(*value);
        drawable.then(|| Point::new(time.at(*at), values.at(*value)))
    });
    let mut data = String::new();
    for stretch in decimate::stretches(samples) {
        let mut command = 'M';
        for point in &stretch {
            write!(data, "{command}{point}").expect("a string takes any text");
            command = 'L';
        }
        if stretch.len() == 1 {
            // A line without length, which its round ends make a dot.
            data.push_str("h0");
        }
    }
    data
}

/// Width of a legend whose names are at most `names` pixels wide.
pub(super) const fn legend_width(names: f64) -> f64 {
    LABEL_GAP + LEGEND_SAMPLE + LABEL_GAP + names
}

/// Height of a legend, in pixels.
pub(super) fn legend_height(names: usize) -> f64 {
    LEGEND_ROW * names as f64
}
