//! `ACR213`: a whole number that 32 bits can't hold.

use acrc_catalog::UnaryOperator;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{Expr, ExprKind};

use crate::Context;
use crate::rule::{Check, Group, On, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR213", name: "large-constant" },
        group: Group::Names,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "A whole number is beyond 32 bits: above 4294967295, or below -2147483648.",
        why: "Whole numbers have 32 bits on the controller. What it makes of a longer one is not documented; written \
              with a decimal point it is a floating-point number and says what is meant.",
        bad: "P0 = 5000000000",
        good: "P0 = 5000000000.0",
        guide: "System Configuration / Memory Allocations",
    },
    checks: &[Check::Expression(On::Number, check)],
};

/// The smallest number is the negative of this.
const LOWEST: u64 = 1 << 31;

fn check(context: &mut Context<'_>, expr: &Expr) {
    let too_large = match &expr.kind {
        ExprKind::Integer(value) => u32::try_from(*value).is_err(),
        ExprKind::Unary(UnaryOperator::Minus, inner) => {
            matches!(inner.kind, ExprKind::Integer(value) if value > LOWEST && u32::try_from(value).is_ok())
        }
        _ => false,
    };
    if too_large {
        let written = context.slice(expr.span);
        let diagnostic = RULE.at(expr.span, format!("{written} does not fit into 32 bits"));
        context.report(diagnostic.with_help(format!("write {written}.0 for a floating-point number")));
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::codes;

    #[test]
    fn thirty_two_bits() {
        assert_eq!(codes("P0 = 4294967295\nP0 = -2147483648\n"), []);
        assert_eq!(
            codes("P0 = 4294967296\nP0 = -2147483649\nP0 = -99999999999\n"),
            [(1, "ACR213"), (2, "ACR213"), (3, "ACR213")]
        );
    }
}
