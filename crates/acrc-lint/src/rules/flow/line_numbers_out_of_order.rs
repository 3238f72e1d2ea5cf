//! `ACR132`: line numbers that do not rise.

use acrc_analysis::SectionIndex;
use acrc_analysis::index::LineSite;
use acrc_diagnostics::{Code, Severity};

use super::duplicate_line_number::number_span;
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR132", name: "line-numbers-out-of-order" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A line has a lower number than the line before it.",
        why: "Lines are stored, and run, in the order of their numbers: the program does another thing than its text says.",
        bad: "PROG0\n10 SET 32\n30 CLR 32\n20 DWL 1",
        good: "PROG0\n10 SET 32\n20 DWL 1\n30 CLR 32",
        guide: "Programming Basics / Programs and Commands",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    // The index has them by number.
    if section.lines.is_sorted_by_key(|line| line.statement) {
        return;
    }
    let mut lines: Vec<LineSite> = section.lines.clone();
    lines.sort_unstable_by_key(|line| line.statement);
    for pair in lines.windows(2) {
        let [before, line] = pair else { continue };
        if line.number < before.number
            && let Some(span) = number_span(context, line.statement)
            && let Some(other) = number_span(context, before.statement)
        {
            let message = format!("line {} runs before line {}, which stands above it", line.number, before.number);
            let diagnostic = RULE.at(span, message).with_related(other, "the number before it");
            context.report(diagnostic.with_help("write the lines in the order in which they run"));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    #[test]
    fn each_step_back_is_marked() {
        assert_eq!(spans_of("ACR132", "PROG0\n10 SET 32\n30 SET 33\n20 SET 34\n40 SET 35\n5 SET 36\n"), ["20", "5"]);
        assert_eq!(spans_of("ACR132", "PROG0\n10 SET 32\n10 SET 33\n20 SET 34\n"), [""; 0]);
    }

    #[test]
    fn a_line_that_is_put_in_later_is_meant() {
        assert_eq!(spans_of("ACR132", "PROG0\n10 SET 32\n20 SET 33\nLIST\n15 SET 34\n"), [""; 0]);
    }
}
