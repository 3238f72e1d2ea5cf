//! What is known of the programs of a controller while a download goes on.

use std::collections::BTreeMap;
use std::fmt;

use acrc_image::UnitName;

/// What became of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Fate {
    /// The controller did not have it, and nothing of it was sent.
    Missing,
    /// It is as it was before, and not what the project has.
    Old,
    /// It was there already, the same as in the project.
    Kept,
    /// It was erased, and the new text is not there yet.
    Erased,
    /// A part of the new text was sent: the program must not run.
    Partial,
    /// The whole text was sent.
    Sent,
    /// It was listed and is the same as in the project.
    Verified,
}

impl fmt::Display for Fate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Missing => "not there",
            Self::Old => "old, as before the download",
            Self::Kept => "new: it was there already",
            Self::Erased => "erased",
            Self::Partial => "partial: it may be old, erased, or hold the beginning of the new text; do not run it",
            Self::Sent => "new, not verified",
            Self::Verified => "new, verified",
        })
    }
}

/// What is known of the controller.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct State {
    /// Programs of the project and of the controller.
    pub programs: BTreeMap<UnitName, Fate>,
    /// Lines that were sent and answered.
    pub done: usize,
    /// Lines that there are.
    pub lines: usize,
    /// The text of this program is being entered.
    pub open: Option<UnitName>,
    /// System memory was cleared, so what it had given out before is gone.
    pub cleared: bool,
}

impl State {
    /// Notes what became of a program.
    pub(super) fn set(&mut self, unit: UnitName, fate: Fate) {
        self.programs.insert(unit, fate);
    }

    /// The programs of a fate.
    pub fn with(&self, fate: Fate) -> impl Iterator<Item = UnitName> {
        self.programs.iter().filter(move |(_, other)| **other == fate).map(|(unit, _)| *unit)
    }
}

/// A line for each kind of programs that there is.
impl fmt::Display for State {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { done, lines, .. } = self;
        write!(f, "{done} of {lines} lines were sent and answered")?;
        for fate in [Fate::Missing, Fate::Old, Fate::Kept, Fate::Erased, Fate::Partial, Fate::Sent, Fate::Verified] {
            let units: Vec<String> = self.with(fate).map(|unit| unit.to_string()).collect();
            if !units.is_empty() {
                write!(f, "\n{}: {fate}", units.join(", "))?;
            }
        }
        Ok(())
    }
}
