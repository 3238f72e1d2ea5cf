//! Points in time that are marked through all panels, with what happened written above them.

use super::canvas::{Anchor, Canvas, Escaped, FONT_SIZE, Px, text_width};
use super::layout::{Frame, LABEL_GAP};
use super::scale::Scale;
use crate::plot::Event;

/// Height of a row of texts, in pixels.
const ROW_HEIGHT: f64 = 14.0;
/// Rows of texts. An event without room in any of them keeps its line, with its text in a tool tip.
const MOST_ROWS: usize = 4;
/// Texts are cut to this width, in pixels.
const LONGEST_TEXT: f64 = 240.0;
const COLOR: &str = "#882255";

/// The events of a picture, in order of time, each with the place of its text.
pub(super) struct Markers<'e> {
    markers: Vec<Marker<'e>>,
    rows: usize,
}

struct Marker<'e> {
    x: f64,
    text: &'e str,
    /// Row from the top; `None` if the text is not written.
    row: Option<usize>,
    anchor: Anchor,
}

impl<'e> Markers<'e> {
    pub(super) fn new(events: &'e [Event], time: &Scale) -> Self {
        let mut events: Vec<&Event> = events.iter().filter(|event| time.contains(event.time)).collect();
        events.sort_by(|a, b| a.time.total_cmp(&b.time));
        let mut ends = [f64::NEG_INFINITY; MOST_ROWS];
        let markers: Vec<Marker<'_>> = events.into_iter().map(|event| Marker::place(event, time, &mut ends)).collect();
        let rows = markers.iter().filter_map(|marker| marker.row).max().map_or(0, |row| row + 1);
        Self { markers, rows }
    }

    /// Height of the rows of texts, in pixels.
    pub(super) fn height(&self) -> f64 {
        self.rows as f64 * ROW_HEIGHT
    }

    /// Draws the markers over the panels, and their texts above the first one.
    pub(super) fn draw(&self, canvas: &mut Canvas, frames: &[Frame]) {
        let (Some(first), Some(last)) = (frames.first(), frames.last()) else { return };
        let top = first.area.top - self.height();
        for marker in &self.markers {
            let row = marker.row.unwrap_or(self.rows) as f64;
            let from = top + row * ROW_HEIGHT;
            let [x, y, length] = [marker.x, from, last.area.bottom() - from].map(Px::new);
            canvas.line(format_args!(
                r#"<path stroke="{COLOR}" stroke-width="0.75" stroke-dasharray="3 2" d="M{x} {y}v{length}"><title>{}</title></path>"#,
                Escaped(marker.text)
            ));
        }
        // A white seam keeps a text readable where the line of another event runs through it.
        let text = format!(r##"fill="{COLOR}" stroke="#fff" stroke-width="3" paint-order="stroke""##);
        canvas.group(&text, |canvas| {
            for marker in &self.markers {
                let Some(row) = marker.row else { continue };
                let baseline = top + row as f64 * ROW_HEIGHT + FONT_SIZE * 0.8;
                let gap = if marker.anchor == Anchor::End { -LABEL_GAP } else { LABEL_GAP };
                canvas.label(marker.x + gap / 2.0, baseline, marker.anchor, marker.text, LONGEST_TEXT);
            }
        });
    }
}

impl<'e> Marker<'e> {
    /// Finds the first row with room; `ends` are where the last text of every row ends.
    fn place(event: &'e Event, time: &Scale, ends: &mut [f64]) -> Self {
        let x = time.at(event.time);
        let width = text_width(&event.text).min(LONGEST_TEXT) + LABEL_GAP;
        let fits_right = x + width <= time.end();
        let anchor = if fits_right { Anchor::Start } else { Anchor::End };
        let (from, to) = if fits_right { (x, x + width) } else { (x - width, x) };
        let row = ends.iter().position(|end| *end <= from);
        if let Some(end) = row.and_then(|row| ends.get_mut(row)) {
            *end = to;
        }
        Self { x, text: &event.text, row, anchor }
    }
}
