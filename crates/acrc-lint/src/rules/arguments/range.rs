//! The ranges of the catalogue that are exact enough to check a number against.

use std::fmt;
use std::sync::LazyLock;

use acrc_catalog::{Command as Row, Confidence};

/// Values that an argument may have.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Range {
    /// `0..15`
    Between(f64, f64),
    /// `>=0`, `0..`
    AtLeast(f64),
    /// `>0`
    Above(f64),
    /// `1|-1`, `0 none|1 positive|2 negative|3 both`, with the words that explain them.
    OneOf(Vec<(f64, &'static str)>),
}

impl Range {
    /// Reads the range column. `None` for everything that is not exact: words, doubts, exceptions.
    pub(super) fn parse(text: &'static str) -> Option<Self> {
        if let Some(limit) = text.strip_prefix(">=") {
            return limit.trim().parse().ok().map(Self::AtLeast);
        }
        if let Some(limit) = text.strip_prefix('>') {
            return limit.trim().parse().ok().map(Self::Above);
        }
        if let Some((low, high)) = text.split_once("..") {
            let low = low.parse().ok()?;
            return if high.is_empty() {
                Some(Self::AtLeast(low))
            } else {
                Some(Self::Between(low, high.parse().ok()?))
            };
        }
        let choices: Vec<_> = text.split('|').map(choice).collect::<Option<_>>()?;
        (choices.len() > 1).then_some(Self::OneOf(choices))
    }

    /// Whether `value` is in it.
    pub(super) fn holds(&self, value: f64) -> bool {
        match self {
            Self::Between(low, high) => (*low..=*high).contains(&value),
            Self::AtLeast(low) => value >= *low,
            Self::Above(low) => value > *low,
            Self::OneOf(choices) => choices.iter().any(|(choice, _)| *choice == value),
        }
    }

    /// Open ranges say what makes sense, closed ones what there is.
    pub(super) fn is_closed(&self) -> bool {
        matches!(self, Self::Between(..) | Self::OneOf(_))
    }
}

/// A choice with the words that explain it: `1 positive`, `0 = 12 bit`.
fn choice(text: &'static str) -> Option<(f64, &'static str)> {
    let text = text.trim();
    let (number, words) = text.split_once(' ').unwrap_or((text, ""));
    Some((number.parse().ok()?, words.trim_start_matches("= ")))
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Between(low, high) => write!(f, "{low} to {high}"),
            Self::AtLeast(low) => write!(f, "{low} and more"),
            Self::Above(low) => write!(f, "more than {low}"),
            Self::OneOf(choices) => {
                for (at, (number, words)) in choices.iter().enumerate() {
                    let comma = if at > 0 { ", " } else { "" };
                    write!(f, "{comma}{number}")?;
                    if !words.is_empty() {
                        write!(f, " ({words})")?;
                    }
                }
                Ok(())
            }
        }
    }
}

/// The exact ranges by operation code, then by argument. Rows of less than high confidence have none.
static RANGES: LazyLock<Vec<Vec<Option<Range>>>> = LazyLock::new(|| {
    let mut ranges = Vec::new();
    for row in acrc_catalog::all_commands().filter(|row| row.confidence == Confidence::High) {
        let of_row: Vec<_> = row.arguments.iter().map(|argument| Range::parse(argument.range)).collect();
        if of_row.iter().any(Option::is_some) {
            let at = usize::from(row.id.0);
            if ranges.len() <= at {
                ranges.resize(at + 1, Vec::new());
            }
            if let Some(place) = ranges.get_mut(at) {
                *place = of_row;
            }
        }
    }
    ranges
});

/// The exact ranges of a command's arguments; empty when none is exact.
pub(super) fn ranges(row: &Row) -> &'static [Option<Range>] {
    RANGES.get(usize::from(row.id.0)).map_or(&[], Vec::as_slice)
}

#[cfg(test)]
mod tests {
    use super::Range;

    #[test]
    fn exact_ranges_are_read() {
        assert_eq!(Range::parse("0..15"), Some(Range::Between(0.0, 15.0)));
        assert_eq!(Range::parse("0.."), Some(Range::AtLeast(0.0)));
        assert_eq!(Range::parse(">=0"), Some(Range::AtLeast(0.0)));
        assert_eq!(Range::parse(">0"), Some(Range::Above(0.0)));
        assert_eq!(Range::parse("1|-1"), Some(Range::OneOf(vec![(1.0, ""), (-1.0, "")])));
        let read = Range::parse("0 none|1 = positive");
        assert_eq!(read, Some(Range::OneOf(vec![(0.0, "none"), (1.0, "positive")])));
        assert_eq!(read.map(|range| range.to_string()), Some("0 (none), 1 (positive)".to_owned()));
    }

    #[test]
    fn doubtful_ranges_are_not() {
        for text in [
            "",
            "-",
            "0..7 or 0..15 by model",
            "1..?",
            ">=0, 0 = no ramp",
            "flag number",
            "0 = blend",
            "0..8?",
            "0..3 (shared)",
        ] {
            assert_eq!(Range::parse(text), None, "{text}");
        }
    }
}
