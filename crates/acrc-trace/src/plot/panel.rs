//! Which signals are drawn together.

use super::canvas::text_width;
use super::lanes::LANE_HEIGHT;
use super::lines::{self, Lines};
use super::palette::Palette;
use crate::{Kind, Signal, Trace};

/// One panel: the signals of one group and kind.
pub(super) struct Panel<'t> {
    pub(super) group: &'t str,
    /// The signals with their indices in the trace.
    pub(super) signals: Vec<(usize, &'t Signal)>,
    pub(super) content: Content,
    /// Height of the drawing area, in pixels.
    pub(super) height: f64,
}

/// What a panel shows.
pub(super) enum Content {
    Lines(Lines),
    Lanes,
}

/// The signals of a panel, before it is known how they are drawn.
struct Part<'t> {
    group: &'t str,
    kind: Kind,
    signals: Vec<(usize, &'t Signal)>,
}

impl<'t> Part<'t> {
    fn into_panel(self, trace: &Trace, height: f64, palette: &mut Palette<'t>) -> Panel<'t> {
        let Self { group, kind, signals } = self;
        match kind {
            Kind::Continuous => {
                let height = height.max(lines::legend_height(signals.len()));
                let lines = Lines::new(trace, group, &signals, height, palette);
                Panel { group, signals, content: Content::Lines(lines), height }
            }
            Kind::Bit => {
                let height = LANE_HEIGHT * signals.len() as f64;
                Panel { group, signals, content: Content::Lanes, height }
            }
        }
    }
}

impl<'t> Panel<'t> {
    /// The panels of a trace, in the order in which their first signals are recorded. Panels of lines are `height`
    /// pixels high, and higher if their legend needs it.
    pub(super) fn of(trace: &'t Trace, height: f64) -> Vec<Self> {
        let mut parts: Vec<Part<'_>> = Vec::new();
        for (index, signal) in trace.signals().iter().enumerate() {
            let belongs = |part: &&mut Part<'_>| part.group == signal.group && part.kind == signal.kind;
            match parts.iter_mut().find(belongs) {
                Some(part) => part.signals.push((index, signal)),
                None => parts.push(Part { group: &signal.group, kind: signal.kind, signals: vec![(index, signal)] }),
            }
        }
        let mut palette = Palette::default();
        parts.into_iter().map(|part| part.into_panel(trace, height, &mut palette)).collect()
    }

    /// Width of the longest name, in pixels.
    pub(super) fn name_width(&self) -> f64 {
        widest(self.signals.iter().map(|(_, signal)| signal.name.as_str()))
    }
}

/// Width of the widest of some texts, in pixels.
pub(super) fn widest<'a>(texts: impl Iterator<Item = &'a str>) -> f64 {
    texts.map(text_width).fold(0.0, f64::max)
}
