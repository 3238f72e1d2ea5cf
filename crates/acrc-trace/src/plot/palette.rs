//! Colours that people with colour-blindness can tell apart, and dashes for when they run out.

/// The palette of Okabe and Ito without its yellow, which is too light for a line on white; the darkest first.
const COLORS: [&str; 7] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#444444"];
/// Dashes of the first, second, ... line of one colour in a panel.
const DASHES: [&str; 4] = ["", "6 3", "2 2.5", "8 3 2 3"];

/// The colour of a bit that is on.
pub(super) const LANE_COLOR: &str = "#0072b2";

/// The look of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Style {
    color: &'static str,
    dash: &'static str,
}

impl Style {
    /// Attributes for a `<path>`.
    pub(super) fn attributes(self) -> String {
        let Self { color, dash } = self;
        if dash.is_empty() {
            format!(r#"stroke="{color}""#)
        } else {
            format!(r#"stroke="{color}" stroke-dasharray="{dash}""#)
        }
    }
}

/// Gives the colours of a picture to the names in it, so that the lines of one thing have one colour in all panels.
#[derive(Default)]
pub(super) struct Palette<'t> {
    owners: Vec<&'t str>,
}

impl<'t> Palette<'t> {
    /// The looks of the lines of one panel, which belong to these owners: lines of one colour differ in their dashes.
    pub(super) fn styles(&mut self, owners: impl Iterator<Item = &'t str>) -> Vec<Style> {
        let mut styles: Vec<Style> = Vec::new();
        for owner in owners {
            let color = COLORS[self.index_of(owner) % COLORS.len()];
            let repeat = styles.iter().filter(|style| style.color == color).count();
            styles.push(Style { color, dash: DASHES[repeat % DASHES.len()] });
        }
        styles
    }

    fn index_of(&mut self, owner: &'t str) -> usize {
        self.owners.iter().position(|other| *other == owner).unwrap_or_else(|| {
            self.owners.push(owner);
            self.owners.len() - 1
        })
    }
}
