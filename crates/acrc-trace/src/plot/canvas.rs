//! SVG text: elements, escaped text and fixed-point coordinates.

use std::fmt::{self, Write as _};

/// Colour of text.
const INK: &str = "#333";
/// Size of all text but the title, in pixels.
pub(super) const FONT_SIZE: f64 = 11.0;
/// From the baseline of a text to the middle of its capitals, in pixels.
pub(super) const HALF_CAPITAL: f64 = 0.35 * FONT_SIZE;
/// Average width of a Latin letter of the sans-serif fonts in use, as a part of the font size; a little more than
/// average, because a label that is too short for its place is better than one that runs over it.
const LETTER_WIDTH: f64 = 0.58;

/// A length in hundredths of a pixel: coordinates are rounded once, and written without a float in between.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Px(i64);

impl Px {
    pub(super) fn new(pixels: f64) -> Self {
        Self((pixels * 100.0).round() as i64)
    }
}

impl fmt::Display for Px {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.0 < 0 { "-" } else { "" };
        let (whole, part) = (self.0.unsigned_abs() / 100, self.0.unsigned_abs() % 100);
        match (part / 10, part % 10) {
            (0, 0) => write!(f, "{sign}{whole}"),
            (tenths, 0) => write!(f, "{sign}{whole}.{tenths}"),
            _ => write!(f, "{sign}{whole}.{part:02}"),
        }
    }
}

/// Which point of a text its position names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

impl Anchor {
    const fn attribute(self) -> &'static str {
        match self {
            Self::Start => "",
            Self::Middle => r#" text-anchor="middle""#,
            Self::End => r#" text-anchor="end""#,
        }
    }
}

/// A rectangle, in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rect {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) width: f64,
    pub(super) height: f64,
}

impl Rect {
    pub(super) fn right(self) -> f64 {
        self.left + self.width
    }

    pub(super) fn bottom(self) -> f64 {
        self.top + self.height
    }

    /// Half way down.
    pub(super) fn middle(self) -> f64 {
        self.top + self.height / 2.0
    }
}

/// A picture being written, element by element.
pub(super) struct Canvas {
    out: String,
}

impl Canvas {
    pub(super) fn new(width: f64, height: f64, title: &str) -> Self {
        let (width, height) = (Px::new(width), Px::new(height));
        let mut canvas = Self { out: String::new() };
        canvas.line(format_args!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" font-family="Helvetica, Arial, sans-serif" font-size="{FONT_SIZE}" fill="{INK}">"#
        ));
        if !title.is_empty() {
            canvas.line(format_args!("<title>{}</title>", Escaped(title)));
        }
        canvas.line(format_args!(r##"<rect width="100%" height="100%" fill="#fff"/>"##));
        canvas
    }

    /// Writes markup as it is, on a line of its own.
    pub(super) fn line(&mut self, markup: fmt::Arguments<'_>) {
        self.out.write_fmt(markup).expect("a string takes any text");
        self.out.push('\n');
    }

    /// Writes a group with these attributes around what `content` writes.
    pub(super) fn group(&mut self, attributes: &str, content: impl FnOnce(&mut Self)) {
        self.line(format_args!("<g {attributes}>"));
        content(self);
        self.line(format_args!("</g>"));
    }

    /// Writes `text` with its baseline at `y`.
    pub(super) fn text(&mut self, x: f64, y: f64, anchor: Anchor, text: &str) {
        let (x, y, anchor) = (Px::new(x), Px::new(y), anchor.attribute());
        self.line(format_args!(r#"<text x="{x}" y="{y}"{anchor}>{}</text>"#, Escaped(text)));
    }

    /// Writes `text` shortened to `width` pixels, the whole of it in a tool tip when it is.
    pub(super) fn label(&mut self, x: f64, y: f64, anchor: Anchor, text: &str, width: f64) {
        let shown = shortened(text, width);
        if shown == text {
            return self.text(x, y, anchor, text);
        }
        let (x, y, anchor) = (Px::new(x), Px::new(y), anchor.attribute());
        self.line(format_args!(
            r#"<text x="{x}" y="{y}"{anchor}><title>{}</title>{}</text>"#,
            Escaped(text),
            Escaped(&shown)
        ));
    }

    /// Writes `text` running upwards, with its middle at a point.
    pub(super) fn upward_text(&mut self, x: f64, y: f64, text: &str) {
        let (x, y) = (Px::new(x), Px::new(y));
        self.line(format_args!(
            r#"<text transform="translate({x} {y}) rotate(-90)" text-anchor="middle">{}</text>"#,
            Escaped(text)
        ));
    }

    pub(super) fn rect(&mut self, rect: Rect, attributes: &str) {
        let [left, top, width, height] = [rect.left, rect.top, rect.width, rect.height].map(Px::new);
        self.line(format_args!(r#"<rect x="{left}" y="{top}" width="{width}" height="{height}"{attributes}/>"#));
    }

    pub(super) fn horizontal(&mut self, x: f64, y: f64, width: f64) {
        let [x, y, width] = [x, y, width].map(Px::new);
        self.line(format_args!(r#"<path d="M{x} {y}h{width}"/>"#));
    }

    pub(super) fn vertical(&mut self, x: f64, y: f64, height: f64) {
        let [x, y, height] = [x, y, height].map(Px::new);
        self.line(format_args!(r#"<path d="M{x} {y}v{height}"/>"#));
    }

    pub(super) fn finish(mut self) -> String {
        self.out.push_str("</svg>\n");
        self.out
    }
}

/// About how wide a text is, in pixels.
pub(super) fn text_width(text: &str) -> f64 {
    text.chars().map(char_width).sum()
}

fn char_width(c: char) -> f64 {
    // From the first of the East Asian scripts on, letters are as wide as they are high.
    let is_wide = c >= '\u{1100}' && c != '…';
    FONT_SIZE * if is_wide { 1.0 } else { LETTER_WIDTH }
}

fn shortened(text: &str, width: f64) -> String {
    if text_width(text) <= width {
        return text.to_owned();
    }
    let mut left = width - char_width('…');
    let fits = |c: &char| {
        left -= char_width(*c);
        left >= 0.0
    };
    text.chars().take_while(fits).chain(['…']).collect()
}

/// Text that is safe in XML content and attributes.
pub(super) struct Escaped<'a>(pub(super) &'a str);

impl fmt::Display for Escaped<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for c in self.0.chars() {
            match c {
                '&' => f.write_str("&amp;")?,
                '<' => f.write_str("&lt;")?,
                '>' => f.write_str("&gt;")?,
                '"' => f.write_str("&quot;")?,
                '\'' => f.write_str("&#39;")?,
                '\t' | '\n' | '\r' => f.write_str(" ")?,
                // XML has no way to write these.
                '\0'..='\x1F' | '\u{FFFE}' | '\u{FFFF}' => f.write_char(char::REPLACEMENT_CHARACTER)?,
                other => f.write_char(other)?,
            }
        }
        Ok(())
    }
}
