//! `ACR613`: fractions that are compared for being equal.

use acrc_analysis::{SectionIndex, walk};
use acrc_catalog::{OperandClass, Operator};
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{Expr, ExprKind};

use crate::Context;
use crate::operands::{Reference, condition};
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR613", name: "float-equality" },
        group: Group::Style,
        severity: Severity::Advice,
        enabled: false,
        mark: None,
        what: "A condition tests with = or <> a variable with a fraction (SV, DV, SA, DA), or a number with one.",
        why: "Fractions are rounded when they are computed: 0.1 added ten times is not 1. The test fails by the last digit, \
              and a loop that waits for it goes on.",
        bad: "PROG0\nDIM SV(1)\nPROGRAM\nSV0 = 0\nWHILE (SV0 <> 1)\nSV0 = SV0 + 0.1\nWEND\nENDP",
        good: "PROG0\nDIM SV(1)\nPROGRAM\nSV0 = 0\nWHILE (SV0 < 0.95)\nSV0 = SV0 + 0.1\nWEND\nENDP",
        guide: "Programming Basics / Parametric Evaluation",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, index: &SectionIndex) {
    for at in index.section.statements.clone() {
        let Some(statement) = context.tree().statements().get(at as usize) else { break };
        if let Some(condition) = condition(statement) {
            walk::each(condition, &mut |expr| judge(context, expr));
        }
    }
}

fn judge(context: &mut Context<'_>, expr: &Expr) {
    let ExprKind::Binary(Operator::Eq | Operator::Ne, operator, sides) = &expr.kind else { return };
    if sides.iter().any(|side| has_fraction(context, side)) {
        let diagnostic = RULE.at(*operator, "fractions are compared for being equal");
        context.report(diagnostic.with_help("compare with < or >, or with a small difference: `ABS(a - b) < 0.001`"));
    }
}

/// Whether an expression computes with fractions that are written or stored as such.
fn has_fraction(context: &Context<'_>, expr: &Expr) -> bool {
    use OperandClass::{Da, Dv, Sa, Sv};
    let mut found = false;
    walk::each(expr, &mut |inner| {
        found |= match &inner.kind {
            ExprKind::Real(value) => value.fract() != 0.0,
            ExprKind::Operand(_) | ExprKind::Alias => {
                Reference::of(context, inner).is_some_and(|inner| matches!(inner.class(), Sv | Dv | Sa | Da))
            }
            _ => false,
        };
    });
    found
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(condition: &str) -> Vec<String> {
        let text = format!("#DEFINE Ratio DV1\nIF ({condition}) THEN SET 32\n");
        spans_of("ACR613", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn the_comparison_is_marked() {
        assert_eq!(found("SV0 = 1"), ["="]);
        assert_eq!(found("BIT 1 AND P0 <> 0.5"), ["<>"]);
        assert_eq!(found("Ratio * 2 = LV0"), ["="]);
    }

    #[test]
    fn whole_numbers_texts_and_orders_are_exact_enough() {
        assert_eq!(found("LV0 = 1"), [""; 0]);
        assert_eq!(found("P0 = 1.0"), [""; 0]);
        assert_eq!(found("$V0 = \"A\""), [""; 0]);
        assert_eq!(found("SV0 >= 0.5"), [""; 0]);
    }
}
