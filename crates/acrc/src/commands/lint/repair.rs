//! Applies fixes to a project and writes or shows what changed: `--fix`, `--diff`.

use acrc_diagnostics::Applicability;
use acrc_lint::fix::{self, Trouble, TroubleKind};
use acrc_syntax::SourceText;
use anyhow::anyhow;

use super::checked::Checked;
use crate::commands::source_file;

/// A file with another text than on disk.
pub(super) struct Change {
    /// Its place in the project.
    pub(super) place: usize,
    pub(super) before: SourceText,
    pub(super) after: SourceText,
    /// How many fixes that are.
    pub(super) fixes: usize,
}

/// Repairs the files that are shown. The project holds the repaired texts and what is found in them afterwards.
pub(super) fn repair(checked: &mut Checked, boldest: Applicability) -> (Vec<Change>, Vec<anyhow::Error>) {
    let mut sources: Vec<SourceText> = checked.project.files.iter().map(|file| file.source.clone()).collect();
    let is_shown = |place| checked.shown.get(place) == Some(&true);
    let outcome = fix::fix(&mut checked.db, checked.input, &mut sources, boldest, is_shown);
    let mut changes = Vec::new();
    for (place, (loaded, after)) in checked.project.files.iter_mut().zip(sources).enumerate() {
        if loaded.source != after {
            let before = std::mem::replace(&mut loaded.source, after.clone());
            let fixes = outcome.applied.get(place).copied().unwrap_or(0);
            changes.push(Change { place, before, after, fixes });
        }
    }
    checked.take(outcome.findings);
    (changes, outcome.troubles.iter().map(trouble).collect())
}

/// A mistake in fixes, told so that it can be reported.
fn trouble(Trouble { file, kind, codes }: &Trouble) -> anyhow::Error {
    let what = match kind {
        TroubleKind::Harmful => "made a text that can't be read",
        TroubleKind::Endless => "never came to an end",
    };
    let codes: Vec<&str> = codes.iter().map(|code| code.id).collect();
    anyhow!(
        "{file} was left as it is: fixes of {} {what}. This is a mistake in acrc; please report it",
        codes.join(", ")
    )
}

/// Writes the changed files. Gives the number of fixes in those that were written, and why others were not.
pub(super) fn write(checked: &Checked, changes: &[Change]) -> (usize, Vec<anyhow::Error>) {
    let mut fixed = 0;
    let mut errors = Vec::new();
    for Change { place, before, after, fixes } in changes {
        let Some(file) = checked.project.files.get(*place) else { continue };
        match source_file::replace(file.path.as_std_path(), &before.encode(), &after.encode()) {
            Ok(()) => fixed += fixes,
            Err(error) => errors.push(error),
        }
    }
    (fixed, errors)
}
