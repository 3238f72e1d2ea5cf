//! The rules of the linter.

use std::fmt::Write as _;

use acrc_lint::rules;

use super::{cell, heading};

pub(super) fn page() -> String {
    let mut page = heading("Rules", "the registry of `acrc-lint`");
    page.push_str("`acrc explain CODE` prints the page of a rule.\n\n| Code | Name | Severity | What it finds |\n|---|---|---|---|\n");
    for rule in rules() {
        let _ = writeln!(page, "| {} | {} | {} | {} |", rule.code.id, rule.code.name, rule.severity, cell(rule.what));
    }
    for rule in rules() {
        let _ = write!(page, "\n## {} {}\n\n{}\n\n{}\n\n", rule.code.id, rule.code.name, rule.what, rule.why);
        for (title, program) in [("Bad", rule.bad), ("Good", rule.good)] {
            let _ = write!(page, "{title}:\n\n```basic\n{}\n```\n\n", program.trim_end());
        }
        let _ = writeln!(page, "Guide: {}", rule.guide);
    }
    page
}
