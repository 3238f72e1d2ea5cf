//! `ACR611`: operators whose rank is not documented, side by side without parentheses.

use acrc_catalog::{Operator, UnaryOperator};
use acrc_diagnostics::{Code, Diagnostic, Edit, Fix, Severity, Span};
use acrc_syntax::ast::{Expr, ExprKind};

use crate::Context;
use crate::rule::{Check, Group, On, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR611", name: "mixed-and-or" },
        group: Group::Style,
        severity: Severity::Advice,
        enabled: true,
        mark: None,
        what: "AND stands beside OR, or NOT before a comparison, without parentheses.",
        why: "The guide does not say which of AND and OR binds tighter, nor whether NOT takes the comparison or only its \
              first operand. acrc reads AND before OR, and NOT before comparisons; a controller that does not takes the \
              other branch.",
        bad: "PROG0\nPROGRAM\nIF (BIT 24 OR BIT 25 AND BIT 26) THEN SET 32\nENDP",
        good: "PROG0\nPROGRAM\nIF (BIT 24 OR (BIT 25 AND BIT 26)) THEN SET 32\nENDP",
        guide: "Programming Basics / Parametric Evaluation",
    },
    checks: &[Check::Expression(On::Compound, check)],
};

fn check(context: &mut Context<'_>, expr: &Expr) {
    let ExprKind::Binary(operator, place, sides) = &expr.kind else { return };
    if is_logic(*operator) {
        for side in sides.iter() {
            if let ExprKind::Binary(inner, inner_place, _) = &side.kind
                && is_logic(*inner)
                && inner != operator
            {
                let names = (inner.name(), operator.name());
                context.report(mixed(side.span, *inner_place, *place, names));
            }
        }
    } else if is_relation(*operator)
        && let Some(left) = sides.first()
        && matches!(left.kind, ExprKind::Unary(UnaryOperator::Not, _))
    {
        let word = Span::new(left.span.start, left.span.start + 3);
        let message =
            format!("NOT before {} without parentheses: is the comparison or its operand meant?", operator.name());
        let diagnostic = RULE.at(word, message).with_related(*place, "the comparison");
        context.report(diagnostic.with_help("acrc takes it for the operand; write what is meant with parentheses"));
    }
}

fn mixed(inner: Span, at: Span, beside: Span, (first, second): (&str, &str)) -> Diagnostic {
    let edits = vec![Edit::insert(inner.start, "("), Edit::insert(inner.end, ")")];
    RULE.at(at, format!("{first} beside {second} without parentheses"))
        .with_related(beside, format!("the {second}"))
        .with_help(format!("acrc computes the {first} first; write what is meant with parentheses"))
        .with_fix(Fix::unsafe_(format!("put the {first} in parentheses"), edits))
}

/// The operators that join bit by bit.
fn is_logic(operator: Operator) -> bool {
    use Operator::{And, Nand, Nor, Or, Xnor, Xor};
    matches!(operator, And | Nand | Or | Nor | Xor | Xnor)
}

fn is_relation(operator: Operator) -> bool {
    use Operator::{Eq, Ge, Gt, Le, Lt, Ne};
    matches!(operator, Eq | Ne | Lt | Gt | Le | Ge)
}

#[cfg(test)]
mod tests {
    use crate::testing::{fixed, spans_of};

    fn found(condition: &str) -> Vec<String> {
        let text = format!("IF ({condition}) THEN SET 32\n");
        spans_of("ACR611", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn the_operator_that_is_computed_first_is_marked() {
        assert_eq!(found("BIT 1 OR BIT 2 AND BIT 3"), ["AND"]);
        assert_eq!(found("BIT 1 AND BIT 2 OR BIT 3 AND BIT 4"), ["AND", "AND"]);
        assert_eq!(found("NOT P0 = 1"), ["NOT"]);
    }

    #[test]
    fn parentheses_and_equal_operators_say_what_is_meant() {
        assert_eq!(found("BIT 1 OR (BIT 2 AND BIT 3)"), [""; 0]);
        assert_eq!(found("BIT 1 AND BIT 2 AND P0 = 3"), [""; 0]);
        assert_eq!(found("NOT BIT 1 OR NOT BIT 2"), [""; 0]);
        assert_eq!(found("NOT (P0 = 1)"), [""; 0]);
        assert_eq!(found("(NOT P0) = 1"), [""; 0]);
    }

    #[test]
    fn the_parentheses_are_written() {
        let text = "P0 = P1 OR P2 AND P3\n";
        assert_eq!(fixed("ACR611", text), "P0 = P1 OR (P2 AND P3)\n");
    }
}
