//! `ACR135`: a `FOR` whose numbers do not fit each other.

use acrc_analysis::walk;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{Statement, StatementKind};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR135", name: "for-never-runs" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A FOR begins beyond its end, or has a STEP that is zero or negative.",
        why: "FOR tests before the first pass and counts upwards only: beyond its end it is skipped as a whole. What a STEP \
              that is not positive does is not documented; the dry run stops the program.",
        bad: "PROG0\nPROGRAM\nFOR P0 = 10 TO 1 STEP -1\nPRINT P0\nNEXT\nENDP",
        good: "PROG0\nPROGRAM\nFOR P0 = 1 TO 10\nPRINT 11 - P0\nNEXT\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    let StatementKind::For(head) = &statement.kind else { return };
    let number = |value: f64| value.to_string();
    let step = head.step.as_ref().and_then(|step| Some((step.span, walk::literal(step)?)));
    if let Some((span, step)) = step.filter(|(_, step)| *step <= 0.0) {
        let diagnostic = RULE.at(span, format!("STEP is {}, and must be positive", number(step)));
        context.report(diagnostic.with_help("count upwards, and compute the falling value inside of the loop"));
        return;
    }
    if let (Some(start), Some(end)) = (walk::literal(&head.start), walk::literal(&head.end))
        && start > end
    {
        let message = format!("this FOR never runs: it begins at {} and ends at {}", number(start), number(end));
        let diagnostic = RULE.at(statement.span, message);
        context.report(diagnostic.with_help("a FOR counts upwards only; write the lower number first"));
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, spans_of};

    fn found(head: &str) -> Vec<String> {
        let text = format!("{head}\nSET 32\nNEXT\n");
        spans_of("ACR135", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn numbers_that_do_not_fit() {
        assert_eq!(found("FOR LV0 = 5 TO 1"), ["FOR LV0 = 5 TO 1"]);
        assert_eq!(found("FOR SV0 = -1 TO -1.5 STEP 0.5"), ["FOR SV0 = -1 TO -1.5 STEP 0.5"]);
        assert_eq!(found("FOR LV0 = 5 TO 1 STEP -1"), ["-1"]);
        assert_eq!(found("FOR LV0 = 1 TO 5 STEP 0"), ["0"]);
    }

    #[test]
    fn a_falling_loop_is_one_mistake() {
        assert_eq!(codes("FOR LV0 = 5 TO 1 STEP -1\nSET 32\nNEXT\n"), [(1, "ACR135")]);
    }

    #[test]
    fn one_pass_and_computed_numbers_may_be_right() {
        assert_eq!(found("FOR LV0 = 1 TO 1"), [""; 0]);
        assert_eq!(found("FOR LV0 = 1 TO (LV1 - 1) STEP LV2"), [""; 0]);
    }
}
