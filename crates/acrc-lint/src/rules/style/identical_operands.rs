//! `ACR614`: the same operand on both sides of an operator.

use acrc_analysis::walk;
use acrc_catalog::Operator;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{Expr, ExprKind};

use crate::Context;
use crate::operands::{bare, is_repeatable, same_text};
use crate::rule::{Check, Group, On, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR614", name: "identical-operands" },
        group: Group::Style,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "Both sides of a division, a subtraction, a MOD, a comparison, an AND or an OR are the same. Functions that \
               give another value each time (RND, GETCH, INKEY$, KBHIT, DATE$, TIME$) are not the same as themselves.",
        why: "The result does not depend on the operand, or is the operand itself. Another one was meant on one side: a \
              position divided by itself is 1, and not a position in units.",
        bad: "PROG0\nPROGRAM\nP0 = P12290 / P12290\nENDP",
        good: "PROG0\nPROGRAM\nP0 = P12290 / P12375\nENDP",
        guide: "Programming Basics / Parametric Evaluation",
    },
    checks: &[Check::Expression(On::Compound, check)],
};

fn check(context: &mut Context<'_>, expr: &Expr) {
    let ExprKind::Binary(operator, _, sides) = &expr.kind else { return };
    let Some(result) = result(*operator) else { return };
    let [left, right] = &**sides;
    let (left, right) = (bare(left), bare(right));
    if walk::literal(left).is_some() || !same_text(context, left.span, right.span) || !is_repeatable(left) {
        return;
    }
    let message = format!("`{}` on both sides of `{operator}`: the result is {result}", context.slice(left.span));
    context.report(RULE.at(expr.span, message).with_help("replace one of them by the operand that was meant"));
}

/// What an operator gives for two equal sides; `None` where that is a value like others, as a square or a double is.
fn result(operator: Operator) -> Option<&'static str> {
    use Operator::{And, Div, Eq, Ge, Gt, Le, Lt, Mod, Ne, Or, Sub};
    match operator {
        Div => Some("always 1"),
        Sub | Mod => Some("always 0"),
        Eq | Le | Ge => Some("always true"),
        Ne | Lt | Gt => Some("always false"),
        And | Or => Some("the operand itself"),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{found_by, lint, spans_of};

    fn found(expression: &str) -> Vec<String> {
        let text = format!("P0 = {expression}\n");
        spans_of("ACR614", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn the_whole_operation_is_marked() {
        assert_eq!(found("2 * (P12290/P12290)"), ["P12290/P12290"]);
        assert_eq!(found("LV0 - LV0"), ["LV0 - LV0"]);
        assert_eq!(found("(LV0 + 1) MOD (lv0+1)"), ["(LV0 + 1) MOD (lv0+1)"]);
        assert_eq!(found("BIT 5 AND BIT5"), ["BIT 5 AND BIT5"]);
        assert_eq!(found("LA0(LV0) = LA0(LV0)"), ["LA0(LV0) = LA0(LV0)"]);
    }

    #[test]
    fn conditions_and_their_parts() {
        assert_eq!(spans_of("ACR614", "IF (P0 = P0) THEN SET 32\n"), ["P0 = P0"]);
        assert_eq!(spans_of("ACR614", "WHILE (BIT 1 AND LV0+1 <> (lv0 + 1))\nDWL 1\nWEND\n"), ["LV0+1 <> (lv0 + 1)"]);
    }

    #[test]
    fn one_mistake_is_one_finding() {
        let found = lint(&[("test.8K", "PROG0\nPROGRAM\nIF (P0 = P0) THEN SET 32\nENDP\n")]).concat();
        let codes: Vec<_> = found.iter().map(|found| found.code.id).collect();
        assert_eq!(codes, ["ACR614"]);
    }

    #[test]
    fn the_message_names_the_operand_and_the_result() {
        let messages: Vec<_> =
            found_by("ACR614", "P0 = P12290/P12290\n").into_iter().map(|found| found.message).collect();
        assert_eq!(messages, ["`P12290` on both sides of `/`: the result is always 1"]);
    }

    #[test]
    fn squares_numbers_and_what_changes_by_itself_are_left_alone() {
        for expression in
            ["P1 * P1", "P1 + P1", "5 - 5", "RND(3) - RND(3)", "KBHIT(1) OR KBHIT(1)", "P1 - P2", "P1 - P1 * 2"]
        {
            assert_eq!(found(expression), [""; 0], "{expression}");
        }
    }
}
