//! `ACR609`: a variable that is set to itself.

use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{Expr, ExprKind, Statement, StatementKind};

use crate::Context;
use crate::operands::{Reference, bare, is_repeatable, same_text};
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR609", name: "self-assignment" },
        group: Group::Style,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "An assignment sets a variable or a user parameter to itself. Writing a bit or a parameter of the system may \
               have an effect of its own, and is left alone.",
        why: "The statement does nothing; another variable was meant.",
        bad: "PROG0\nPROGRAM\nP1 = P0\nP0 = P0\nENDP",
        good: "PROG0\nPROGRAM\nP1 = P0\nP0 = P2\nENDP",
        guide: "Programming Basics / Parametric Evaluation",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    let StatementKind::Assign(assign) = &statement.kind else { return };
    let value = bare(&assign.value);
    let is_reference = |expr: &Expr| matches!(expr.kind, ExprKind::Operand(_) | ExprKind::Alias);
    if !is_reference(value) || !is_repeatable(value) || !same_text(context, assign.target.span, value.span) {
        return;
    }
    let is_plain = match Reference::of(context, &assign.target) {
        Some(Reference::Known(variable)) => variable.class.is_local() || variable.is_user_parameter(),
        Some(Reference::Computed(class)) => class.is_local(),
        None => false,
    };
    if is_plain {
        context.report(RULE.at(statement.span, "this sets a variable to itself"));
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(text: &str) -> Vec<&str> {
        spans_of("ACR609", text)
    }

    #[test]
    fn the_statement_is_marked() {
        assert_eq!(found("P0 = (P0)\n"), ["P0 = (P0)"]);
        assert_eq!(found("SET 32 : LA0(LV0+1) = LA0(lv0 + 1)\n"), ["LA0(LV0+1) = LA0(lv0 + 1)"]);
    }

    #[test]
    fn what_changes_something_is_left_alone() {
        assert_eq!(found("P0 = P1\nP0 = P0 + 1\nLA0(0) = LA0(1)\nLA0(RND(3)) = LA0(RND(3))\n"), [""; 0]);
        assert_eq!(found("P12288 = P12288\nBIT 32 = BIT 32\n"), [""; 0]);
    }
}
