//! Signals as one self-contained SVG picture: stacked panels over a shared time axis.
//!
//! Every group of signals is a panel. Real numbers are lines; bits are lanes of a timeline, filled while on. Below the
//! time axis stand the paths of tools, to one scale in both directions. The
//! picture has its own white background, no scripts and no external fonts, and its size depends on its width in pixels, not on
//! the number of samples. What can't be drawn (NaN, infinity, numbers beyond 1e100) leaves a gap in its line.

mod canvas;
mod decimate;
mod events;
mod lanes;
mod layout;
mod lines;
mod palette;
mod panel;
mod path;
mod scale;
mod ticks;

use canvas::Canvas;
use events::Markers;
use layout::{Across, Layout};
use panel::{Content, Panel};
use path::PathPanel;
use scale::{Domain, Scale};

use crate::Trace;

/// What a plot looks like.
#[derive(Clone, Debug, PartialEq)]
pub struct PlotOptions {
    /// The heading; none if empty.
    pub title: String,
    /// Width of the picture in pixels. A picture that is too narrow for its labels becomes wider.
    pub width: u32,
    /// Height of the drawing area of a panel with lines, in pixels. One with a long legend becomes higher; a panel of
    /// bits is as high as its lanes.
    pub panel_height: u32,
    /// Points in time to mark, in any order.
    pub events: Vec<Event>,
    /// Pairs of signals by name that are drawn one over the other below the time axis, as the path of a tool. Pairs of which a signal was not
    /// recorded, or that never moved, are left out.
    pub paths: Vec<[String; 2]>,
}

impl Default for PlotOptions {
    fn default() -> Self {
        Self { title: String::new(), width: 1000, panel_height: 180, events: Vec::new(), paths: Vec::new() }
    }
}

/// Something that happened, marked by a thin line through all panels.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// When, in seconds. An event outside the recorded time is left out.
    pub time: f64,
    /// What, in a few words.
    pub text: String,
}

/// Text as it stands in markup.
pub(crate) fn escaped(text: &str) -> String {
    canvas::Escaped(text).to_string()
}

/// Draws a trace.
#[must_use]
pub fn svg(trace: &Trace, options: &PlotOptions) -> String {
    let panels = Panel::of(trace, f64::from(options.panel_height));
    let domain = Domain::of(trace.times().iter().copied());
    let Some(domain) = domain.filter(|_| !panels.is_empty()) else {
        let PlotOptions { title, width, panel_height, .. } = options;
        return layout::draw_message(*width, *panel_height, title, "nothing was recorded");
    };
    // A single point in time stands in the middle of a second.
    let domain = domain.widened(0.0, 0.5);

    let across = Across::new(&panels, options.width, 0.0);
    let paths = |across: Across| -> Vec<PathPanel<'_>> {
        options.paths.iter().filter_map(|names| PathPanel::new(trace, names, across.plot_width)).collect()
    };
    // How wide a path can be depends on the labels beside it, which depend little on how wide it is.
    let path_axis = paths(across).iter().map(PathPanel::axis_width).fold(0.0, f64::max);
    let across = Across::new(&panels, options.width, path_axis);
    let paths = paths(across);
    let time = Scale::new(domain, across.left, across.left + across.plot_width);
    let markers = Markers::new(&options.events, &time);
    let layout = Layout::new(across, &panels, &paths, !options.title.is_empty(), markers.height());

    let mut canvas = Canvas::new(layout.width, layout.height, &options.title);
    layout.draw_title(&mut canvas, &options.title);
    layout.draw_time_axis(&mut canvas, &time);
    for (panel, frame) in panels.iter().zip(&layout.frames) {
        match &panel.content {
            Content::Lines(lines) => lines.draw(&mut canvas, trace, panel, *frame, &time),
            Content::Lanes => lanes::draw(&mut canvas, trace, panel, *frame, &time),
        }
    }
    markers.draw(&mut canvas, &layout.frames);
    for (path, frame) in paths.iter().zip(&layout.paths) {
        path.draw(&mut canvas, *frame);
    }
    canvas.finish()
}
