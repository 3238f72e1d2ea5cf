//! `ACR606`: a condition, or a part of one, that is always the same.

use acrc_analysis::walk;
use acrc_catalog::{OperandClass, Operator, UnaryOperator, command};
use acrc_diagnostics::{Code, Diagnostic, Severity};
use acrc_syntax::ast::{Expr, ExprKind, Statement, StatementKind};

use crate::Context;
use crate::operands::{Reference, bare, condition, is_relation};
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR606", name: "constant-condition" },
        group: Group::Style,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A condition joins a comparison, or a bit, and a bare number with OR or AND. A condition of numbers only is reported as \
               advice, except that of an endless WHILE.",
        why: "`P0 = 1 OR 2` is not \"1 or 2\", and `BIT 1 OR 2` does not look at bit 2: any number but zero is true, so the \
              condition always is. What should depend \
              on it happens every time.",
        bad: "PROG0\nPROGRAM\nIF (P0 = 1 OR 2) THEN SET 32\nENDP",
        good: "PROG0\nPROGRAM\nIF (P0 = 1 OR P0 = 2) THEN SET 32\nENDP",
        guide: "Programming Basics / Parametric Evaluation",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    let Some(condition) = condition(statement) else { return };
    let is_while = matches!(&statement.kind, StatementKind::Command(head) if head.id == command::WHILE);
    let inner = bare(condition);
    match walk::literal(inner).or_else(|| compared(inner)) {
        Some(value) if is_while && value != 0.0 => {}
        Some(value) => {
            let truth = if value == 0.0 { "false" } else { "true" };
            let mut diagnostic = RULE.at(condition.span, format!("this condition is always {truth}"));
            diagnostic.severity = Severity::Advice;
            context.report(diagnostic);
        }
        None => check_parts(context, inner),
    }
}

/// What a comparison of two numbers gives: 0 where it is false.
fn compared(expr: &Expr) -> Option<f64> {
    let ExprKind::Binary(operator, _, sides) = &expr.kind else { return None };
    let [left, right] = sides.as_ref();
    let order = walk::literal(left)?.partial_cmp(&walk::literal(right)?)?;
    let holds = match operator {
        Operator::Eq => order.is_eq(),
        Operator::Ne => order.is_ne(),
        Operator::Lt => order.is_lt(),
        Operator::Le => order.is_le(),
        Operator::Gt => order.is_gt(),
        Operator::Ge => order.is_ge(),
        _ => return None,
    };
    Some(f64::from(u8::from(holds)))
}

/// Looks at a condition and the conditions that it is joined of.
fn check_parts(context: &mut Context<'_>, expr: &Expr) {
    match &bare(expr).kind {
        ExprKind::Unary(UnaryOperator::Not, inner) => check_parts(context, inner),
        ExprKind::Binary(operator, _, sides) => {
            if let Some(diagnostic) = judge(context, *operator, sides) {
                context.report(diagnostic);
            } else if matches!(operator, Operator::And | Operator::Or) {
                sides.iter().for_each(|side| check_parts(context, side));
            }
        }
        _ => {}
    }
}

fn judge(context: &Context<'_>, operator: Operator, sides: &[Expr; 2]) -> Option<Diagnostic> {
    let [left, right] = sides;
    let (number, other) = match (walk::literal(left), walk::literal(right)) {
        (None, Some(_)) => (right, left),
        (Some(_), None) => (left, right),
        _ => return None,
    };
    let other = bare(other);
    let help = match &other.kind {
        ExprKind::Binary(inner, ..) if is_relation(*inner) => "repeat the comparison: `P0 = 1 OR P0 = 2`",
        _ if is_bit(context, other) => "where a bit is meant, say so: `BIT 1 OR BIT 2`",
        _ => return None,
    };
    let is_zero = walk::literal(number) == Some(0.0);
    let outcome = match operator {
        Operator::Or if !is_zero => "this number is compared with nothing: the condition is always true",
        Operator::And if is_zero => "this number is compared with nothing: the condition is always false",
        Operator::And | Operator::Or => "this number is compared with nothing, and changes nothing",
        _ => return None,
    };
    Some(RULE.at(number.span, outcome).with_help(help))
}

/// Whether an expression is a bit or its opposite.
fn is_bit(context: &Context<'_>, expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Unary(UnaryOperator::Not, inner) => is_bit(context, bare(inner)),
        _ => Reference::of(context, expr).is_some_and(|reference| reference.class() == OperandClass::Bit),
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, spans_of};

    fn found(condition: &str) -> Vec<String> {
        let text = format!("IF ({condition}) THEN SET 32\n");
        spans_of("ACR606", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn a_bare_number_beside_a_comparison() {
        assert_eq!(found("P0 = 1 OR 2"), ["2"]);
        assert_eq!(found("(P0 > 1) AND (-1)"), ["(-1)"]);
        assert_eq!(found("BIT 1 AND (P0 = 1 OR 2)"), ["2"]);
        assert_eq!(found("NOT (P0 = 1 OR 2)"), ["2"]);
        assert_eq!(found("BIT 1 OR 2"), ["2"]);
        assert_eq!(found("NOT BIT 1 AND 2"), ["2"]);
    }

    #[test]
    fn masks_and_flags_are_joined_bit_by_bit() {
        assert_eq!(found("P4096 AND 4"), [""; 0]);
        assert_eq!(found("(P4096 AND 4) = 4"), [""; 0]);
        assert_eq!(found("P0 = 1 OR BIT 2"), [""; 0]);
        assert_eq!(found("(P0 OR 2) = 3"), [""; 0]);
    }

    #[test]
    fn numbers_only() {
        assert_eq!(found("0"), ["(0)"]);
        assert_eq!(found("1 = 2"), ["(1 = 2)"]);
        assert_eq!(spans_of("ACR606", "WHILE (1 < 2)\nDWL 1\nWEND\n"), [""; 0]);
        assert_eq!(codes("IF (0) THEN SET 32\n"), [], "advice");
        assert_eq!(spans_of("ACR606", "WHILE (1)\nDWL 1\nWEND\n"), [""; 0]);
        assert_eq!(spans_of("ACR606", "WHILE (0)\nDWL 1\nWEND\n"), ["(0)"]);
    }
}
