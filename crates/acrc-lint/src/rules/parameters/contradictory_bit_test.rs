//! `ACR314`: a condition that asks for a bit and for its opposite.

use acrc_catalog::{OperandClass, Operator, UnaryOperator};
use acrc_diagnostics::{Code, Severity, Span};
use acrc_syntax::ast::{Expr, ExprKind};

use crate::Context;
use crate::references::meaning;
use crate::rule::{Check, Group, On, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR314", name: "contradictory-bit-test" },
        group: Group::Parameters,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A bit and its NOT are joined with AND, which is never true, or with OR, which always is.",
        why: "One of the two was meant to be another bit, mostly that of the neighbouring axis: the condition does not \
              look at it.",
        bad: "PROG0\nPROGRAM\nIF (BIT 5 AND NOT BIT 5) THEN SET 32\nENDP",
        good: "PROG0\nPROGRAM\nIF (BIT 5 AND NOT BIT 6) THEN SET 32\nENDP",
        guide: "Programming Basics / Parametric Evaluation",
    },
    checks: &[Check::Expression(On::Compound, check)],
};

/// A bit in a chain.
struct Term {
    number: u64,
    negated: bool,
    span: Span,
}

/// What is left of the last operator of a chain is compared with what is right of it, so that each pair is told once.
fn check(context: &mut Context<'_>, expr: &Expr) {
    let ExprKind::Binary(operator @ (Operator::And | Operator::Or), _, sides) = &expr.kind else { return };
    let (mut left, mut right) = (Vec::new(), Vec::new());
    terms(context, *operator, &sides[0], &mut left);
    terms(context, *operator, &sides[1], &mut right);
    let pair = right.iter().find_map(|term| {
        let opposite = left.iter().find(|other| other.number == term.number && other.negated != term.negated)?;
        Some((opposite, term))
    });
    if let Some((first, second)) = pair {
        let always = if *operator == Operator::And { "never true" } else { "always true" };
        let message = format!("this is {always}: it asks for bit {} and for its opposite", first.number);
        let (here, there) = ("the opposite is asked for here", "the bit is asked for here");
        context.report(RULE.at(second.span, message).with_label(here).with_related(first.span, there));
    }
}

fn terms(context: &Context<'_>, chain: Operator, expr: &Expr, found: &mut Vec<Term>) {
    match &expr.kind {
        ExprKind::Paren(inner) => terms(context, chain, inner, found),
        ExprKind::Binary(operator, _, sides) if *operator == chain => {
            sides.iter().for_each(|side| terms(context, chain, side, found));
        }
        _ => found.extend(term(context, expr)),
    }
}

fn term(context: &Context<'_>, expr: &Expr) -> Option<Term> {
    match &expr.kind {
        ExprKind::Paren(inner) => term(context, inner).map(|term| Term { span: expr.span, ..term }),
        ExprKind::Unary(UnaryOperator::Not, inner) => {
            term(context, inner).map(|term| Term { negated: !term.negated, span: expr.span, ..term })
        }
        _ => match meaning(context, expr)? {
            (OperandClass::Bit, number) => Some(Term { number, negated: false, span: expr.span }),
            _ => None,
        },
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn condition(condition: &str) -> Vec<String> {
        let text = format!("#DEFINE Ready BIT5\nIF ({condition}) THEN SET 32\n");
        spans_of("ACR314", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn a_bit_and_its_opposite() {
        assert_eq!(condition("BIT 5 AND NOT BIT 5"), ["NOT BIT 5"]);
        assert_eq!(condition("(NOT BIT5) OR (BIT6 OR Ready)"), ["Ready"]);
        assert_eq!(condition("BIT5 AND BIT6 AND P0 > 1 AND NOT BIT6"), ["NOT BIT6"]);
    }

    #[test]
    fn other_bits_and_mixed_chains() {
        for right in ["BIT5 AND NOT BIT6", "BIT5 AND BIT5", "BIT5 OR (NOT BIT5 AND BIT6)", "BIT5 XOR NOT BIT5"] {
            assert_eq!(condition(right), [""; 0], "{right}");
        }
    }
}
