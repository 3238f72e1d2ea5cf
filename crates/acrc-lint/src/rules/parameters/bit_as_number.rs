//! `ACR305`: a bit that is taken for the number 1.

use acrc_analysis::walk;
use acrc_catalog::{OperandClass, Operator, UnaryOperator};
use acrc_diagnostics::{Code, Diagnostic, Edit, Fix, Severity, Span};
use acrc_syntax::ast::{Expr, ExprKind, Statement, StatementKind};

use crate::Context;
use crate::references::meaning;
use crate::rule::{Check, Group, On, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR305", name: "bit-as-number" },
        group: Group::Parameters,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A bit is compared with a number so that the result is always the same, mostly with 1. As advice: the value \
               of a bit is added to something.",
        why: "A bit that is set reads -1, not 1. `IF (BIT 5 = 1)` is never true, so that the branch behind it, perhaps \
              the one that stops the machine, is never taken. A sum of bits counts down.",
        bad: "PROG0\nPROGRAM\nIF (BIT 5 = 1) THEN SET 32\nENDP",
        good: "PROG0\nPROGRAM\nIF (BIT 5) THEN SET 32\nENDP",
        guide: "Programming Basics / Printing the Current Value",
    },
    checks: &[Check::Expression(On::Compound, compared), Check::Statement(added)],
};

/// What a bit reads when it is set and when it is clear.
const VALUES: [f64; 2] = [-1.0, 0.0];
/// What somebody expects who compares it with 1.
const EXPECTED: [f64; 2] = [1.0, 0.0];

fn compared(context: &mut Context<'_>, expr: &Expr) {
    let ExprKind::Binary(operator, _, sides) = &expr.kind else { return };
    let (flag, number, operator) = match (walk::literal(&sides[0]), walk::literal(&sides[1])) {
        (None, Some(number)) => (&sides[0], number, *operator),
        (Some(number), None) => (&sides[1], number, mirrored(*operator)),
        _ => return,
    };
    if !is_flag(context, flag) {
        return;
    }
    let results = VALUES.map(|value| relation(operator, value, number));
    let [Some(set), Some(clear)] = results else { return };
    if set != clear {
        return;
    }
    let written = context.slice(expr.span);
    let always = if set { "always true" } else { "never true" };
    let finding = RULE
        .at(expr.span, format!("`{written}` is {always}: a bit reads -1 when it is set and 0 when it is clear"))
        .with_label(format!("this is {always}"));
    context.report(repaired(
        context,
        finding,
        expr.span,
        flag,
        EXPECTED.map(|value| relation(operator, value, number)),
    ));
}

/// Adds the fix when the comparison would tell the states apart if a set bit were 1.
fn repaired(
    context: &Context<'_>,
    finding: Diagnostic,
    span: Span,
    flag: &Expr,
    meant: [Option<bool>; 2],
) -> Diagnostic {
    let written = context.slice(flag.span);
    let bare = matches!(flag.kind, ExprKind::Operand(_) | ExprKind::Alias | ExprKind::Paren(_));
    let text = match meant {
        [Some(true), Some(false)] => written.to_owned(),
        [Some(false), Some(true)] if bare => format!("NOT {written}"),
        _ => return finding.with_help("compare it with 0 or -1, or write the bit alone"),
    };
    let help = format!("write `{text}`");
    finding.with_help(&help).with_fix(Fix::unsafe_(help, vec![Edit::replace(span, text)]))
}

/// Whether an expression is a bit, or a bit behind `NOT`, which is -1 or 0 as well.
fn is_flag(context: &Context<'_>, expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Paren(inner) | ExprKind::Unary(UnaryOperator::Not, inner) => is_flag(context, inner),
        ExprKind::Operand(operand) => operand.class == OperandClass::Bit,
        _ => matches!(meaning(context, expr), Some((OperandClass::Bit, _))),
    }
}

/// The operator that says the same with the sides exchanged.
fn mirrored(operator: Operator) -> Operator {
    match operator {
        Operator::Lt => Operator::Gt,
        Operator::Gt => Operator::Lt,
        Operator::Le => Operator::Ge,
        Operator::Ge => Operator::Le,
        same => same,
    }
}

#[expect(clippy::float_cmp, reason = "whole numbers are compared as the controller does")]
fn relation(operator: Operator, left: f64, right: f64) -> Option<bool> {
    Some(match operator {
        Operator::Eq => left == right,
        Operator::Ne => left != right,
        Operator::Lt => left < right,
        Operator::Gt => left > right,
        Operator::Le => left <= right,
        Operator::Ge => left >= right,
        _ => return None,
    })
}

fn added(context: &mut Context<'_>, statement: &Statement) {
    let StatementKind::Assign(assign) = &statement.kind else { return };
    // Whatever is not zero sets a bit.
    if is_flag(context, &assign.target) {
        return;
    }
    if let Some(span) = added_bit(context, &assign.value, false) {
        let finding = RULE
            .at(span, "a bit that is set counts as -1 in this sum")
            .with_help("subtract it, or take ABS of the sum, to count up");
        context.report(Diagnostic { severity: Severity::Advice, ..finding });
    }
}

/// The first bit, alone or with a positive weight, that is added. Behind a minus sign and in a function the sign is
/// taken care of.
fn added_bit(context: &Context<'_>, expr: &Expr, in_sum: bool) -> Option<Span> {
    match &expr.kind {
        ExprKind::Paren(inner) => added_bit(context, inner, in_sum),
        ExprKind::Binary(Operator::Add, _, sides) => sides.iter().find_map(|side| added_bit(context, side, true)),
        ExprKind::Binary(Operator::Sub, _, sides) => added_bit(context, &sides[0], in_sum),
        ExprKind::Binary(Operator::Mul, _, sides) if in_sum => {
            let weighs = |expr: &Expr| walk::literal(expr).is_some_and(|weight| weight > 0.0);
            let [left, right] = &**sides;
            let bit = (weighs(right) && is_flag(context, left)) || (weighs(left) && is_flag(context, right));
            bit.then_some(expr.span)
        }
        _ if in_sum && is_flag(context, expr) => Some(expr.span),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use acrc_diagnostics::Severity;

    use crate::testing::{lint, spans_of};

    fn condition(condition: &str) -> Vec<String> {
        let text = format!("#DEFINE Ready BIT5\nWHILE ({condition})\nWEND\n");
        spans_of("ACR305", &text).into_iter().map(str::to_owned).collect()
    }

    fn fixed(condition: &str) -> Option<String> {
        let text = format!("#DEFINE Ready BIT5\nPROG0\nPROGRAM\nWHILE ({condition})\nWEND\nENDP\n");
        let found = lint(&[("test.8K", &text)]).concat();
        let edit = &found.iter().find(|found| found.code.id == "ACR305")?.fixes.first()?.edits[0];
        Some(edit.text.clone())
    }

    #[test]
    fn comparisons_that_are_always_the_same() {
        for wrong in ["BIT 5 = 1", "1 = BIT5", "BIT 5 <> 1", "BIT5 > 0", "0 < BIT5", "BIT 5 >= 1", "NOT BIT 5 = 1"] {
            assert_eq!(condition(wrong), [wrong]);
        }
        assert_eq!(condition("P0 = 1 AND (Ready) = 1"), ["(Ready) = 1"]);
    }

    #[test]
    fn comparisons_that_tell_the_states_apart() {
        for right in
            ["BIT 5 = 0", "BIT 5 = -1", "BIT5 <> 0", "BIT5 < 0", "P5 = 1", "BIT 5 = P1", "BIT5 = BIT6", "BIT5 AND 1"]
        {
            assert_eq!(condition(right), [""; 0], "{right}");
        }
    }

    #[test]
    fn the_fix_says_what_was_meant() {
        assert_eq!(fixed("BIT 5 = 1").as_deref(), Some("BIT 5"));
        assert_eq!(fixed("Ready <> 1").as_deref(), Some("NOT Ready"));
        assert_eq!(fixed("0 < BIT5").as_deref(), Some("BIT5"));
        assert_eq!(fixed("BIT5 < 1").as_deref(), Some("NOT BIT5"));
        assert_eq!(fixed("BIT5 = 2"), None);
    }

    #[test]
    fn sums_count_down() {
        assert_eq!(spans_of("ACR305", "P0 = BIT0 + BIT1 * 2 + 4 * BIT2\nLV0 = LV0 + (BIT 5)\n"), ["BIT0", "BIT 5"]);
        let right = "P0 = P0 - BIT5\nP0 = -(BIT0 + BIT1 * 2)\nP0 = ABS(BIT0 + BIT1)\nP0 = BIT 5\nBIT 6 = BIT 7 + BIT 8\nP0 = P1 + P2\n";
        assert_eq!(spans_of("ACR305", right), [""; 0]);
        assert_eq!(lint(&[("test.8K", "P0 = P0 + BIT5\n")])[0][0].severity, Severity::Advice);
    }
}
