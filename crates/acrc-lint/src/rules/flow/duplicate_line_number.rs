//! `ACR131`: a line number that is given twice.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Severity, Span};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR131", name: "duplicate-line-number" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "Two lines of a program have the same number.",
        why: "A line takes the place of the stored one with its number: the first of the two is gone.",
        bad: "PROG0\n10 SET 32\n20 DWL 1\n20 CLR 32",
        good: "PROG0\n10 SET 32\n20 DWL 1\n30 CLR 32",
        guide: "Programming Basics / Programs and Commands",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    for pair in section.lines.windows(2) {
        let [first, second] = pair else { continue };
        if first.number == second.number
            && let Some(span) = number_span(context, second.statement)
            && let Some(earlier) = number_span(context, first.statement)
        {
            let diagnostic = RULE.at(span, format!("line {} replaces the one of the same number", second.number));
            let diagnostic = diagnostic.with_related(earlier, "this line is lost");
            context.report(diagnostic.with_help("give one of them another number"));
        }
    }
}

/// The number of the line that begins with a statement.
pub(super) fn number_span(context: &Context<'_>, statement: u32) -> Option<Span> {
    let line = context.tree().lines().get(context.tree().line_of(statement) as usize)?;
    line.number.map(|number| number.span)
}

#[cfg(test)]
mod tests {
    use crate::testing::{lines_of, spans_of};

    #[test]
    fn the_later_line_is_marked() {
        assert_eq!(spans_of("ACR131", "PROG0\n10 SET 32\n20 SET 33\n10 SET 34\n"), ["10"]);
        assert_eq!(lines_of("ACR131", &[("a.8K", "PROG0\n10 SET 32\n10 SET 33\n10 SET 34\n")]), [[3, 4]]);
    }

    #[test]
    fn programs_have_their_own_numbers_and_a_later_change_is_meant() {
        assert_eq!(spans_of("ACR131", "PROG0\n10 SET 32\nPROG1\n10 SET 33\n"), [""; 0]);
        assert_eq!(spans_of("ACR131", "PROG0\n10 SET 32\nLIST\n10 SET 33\n"), [""; 0]);
    }
}
