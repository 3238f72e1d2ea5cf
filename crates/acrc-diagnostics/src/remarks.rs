//! What is said of a finding besides its message.

use crate::plain::plain_line;
use crate::{Applicability, Diagnostic};

/// What is said of every finding that is marked unconfirmed.
const UNCONFIRMED: &str = "rests on behaviour that the controller's documents leave open";

/// The remarks on a finding, each with its heading. A help that a fix repeats is left out.
pub(crate) fn remarks(diagnostic: &Diagnostic) -> Vec<(&'static str, &str)> {
    let is_fix = |text: &str| diagnostic.fixes.iter().any(|fix| fix.title == text);
    let help = diagnostic.help.as_deref().filter(|help| !is_fix(help));
    let fixes = diagnostic.fixes.iter().map(|fix| {
        let heading = match fix.applicability {
            Applicability::Safe => "fix",
            Applicability::Unsafe => "unsafe fix",
            Applicability::DisplayOnly => "suggestion",
        };
        (heading, fix.title.as_str())
    });
    let unconfirmed = diagnostic.unconfirmed.then_some(("unconfirmed", UNCONFIRMED));
    let mut remarks = Vec::new();
    remarks.extend(help.map(|help| ("help", help)));
    remarks.extend(fixes);
    remarks.extend(diagnostic.note.as_deref().map(|note| ("note", note)));
    remarks.extend(unconfirmed);
    remarks
}

/// The message and the remarks, each on a line of its own: for forms that have one text a finding.
pub(crate) fn message_with_remarks(diagnostic: &Diagnostic) -> String {
    let mut text = plain_line(&diagnostic.message).into_owned();
    for (heading, remark) in remarks(diagnostic) {
        text.push('\n');
        text.push_str(heading);
        text.push_str(": ");
        text.push_str(&plain_line(remark));
    }
    text
}
