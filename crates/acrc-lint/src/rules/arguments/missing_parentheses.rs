//! `ACR207`: a condition, or a variable as an argument, without parentheses.

use acrc_catalog::{Command as Row, Confidence, Shape};
use acrc_diagnostics::{Code, Diagnostic, Edit, Fix, Severity};
use acrc_syntax::ast::{Argument, Command, Expr, ExprKind, Statement, StatementKind};

use super::groups::{Values, groups, takes_axes};
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR207", name: "missing-parentheses" },
        group: Group::Names,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "The condition of an IF, ELSEIF or WHILE, or a variable that is the argument of a command, stands without \
               parentheses.",
        why: "The guide asks for them in both places. Whether a controller reads the statement without them is not \
              documented: it may refuse it, or take the variable to be the next statement.",
        bad: "PROG0\nPROGRAM\nIF BIT 24 THEN VEL P1\nENDP",
        good: "PROG0\nPROGRAM\nIF (BIT 24) THEN VEL (P1)\nENDP",
        guide: "Programming Basics / Command Syntax",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    match &statement.kind {
        StatementKind::If(head) => judge_condition(context, "IF", &head.condition),
        StatementKind::Command(command) if command.id.info().shape == Shape::Condition => {
            for argument in &command.arguments {
                if let Argument::Value(condition) = argument {
                    judge_condition(context, command.id.info().name, condition);
                }
            }
        }
        StatementKind::Command(command) => check_values(context, command),
        _ => {}
    }
}

fn judge_condition(context: &mut Context<'_>, word: &str, condition: &Expr) {
    if !matches!(condition.kind, ExprKind::Paren(_) | ExprKind::Error) {
        context.report(finding(condition, format!("the condition of {word} stands without parentheses")));
    }
}

/// Numbers may stand as they are, everything that is looked up or computed may not. Objects, arrays and texts are no
/// values in this sense: the row of the command says which places take numbers.
fn check_values(context: &mut Context<'_>, command: &Command) {
    let by_axis = takes_axes(command.id.info().shape);
    let mut place = 0;
    for group in groups(command) {
        let Values::Given(values) = group.values else { continue };
        if let [value] = values
            && is_computed(value)
            && takes_number(group.row, if by_axis { 0 } else { place })
        {
            report_value(context, group.row, value);
        }
        place += values.len();
    }
}

fn is_computed(value: &Expr) -> bool {
    match &value.kind {
        ExprKind::Operand(_) | ExprKind::Alias | ExprKind::Call(..) | ExprKind::Binary(..) => true,
        ExprKind::Unary(_, inner) => is_computed(inner),
        _ => false,
    }
}

fn takes_number(row: &Row, place: usize) -> bool {
    row.confidence != Confidence::Low
        && row.arguments.get(place).is_some_and(|argument| matches!(argument.kind, "FP32" | "long"))
}

fn report_value(context: &mut Context<'_>, row: &Row, value: &Expr) {
    let written = context.slice(value.span);
    context.report(finding(value, format!("{written} is an argument of {} and stands without parentheses", row.name)));
}

fn finding(value: &Expr, message: String) -> Diagnostic {
    let edits = vec![Edit::insert(value.span.start, "("), Edit::insert(value.span.end, ")")];
    RULE.at(value.span, message).with_fix(Fix::safe("put it in parentheses", edits))
}

#[cfg(test)]
mod tests {
    use crate::testing::codes;

    #[test]
    fn what_is_computed_needs_them() {
        assert_eq!(codes("VEL P1\nX-P0\nJOG VEL X LV0\nDWL SQRT(4)\n").len(), 4);
        assert_eq!(codes("VEL (P1)\nX(-P0)\nJOG VEL X(LV0)\nDWL (SQRT(4))\nX-5\nSLM X(P0, P1)\n"), []);
        assert_eq!(codes("WHILE BIT 24\nWEND\n"), [(1, "ACR207")]);
    }

    #[test]
    fn sources_bits_and_texts_do_not() {
        assert_eq!(codes("SRC P12288\nINH BIT516\nIHPOS P6160 (1,2)\nPRINT P0\nFOR LV0 = P0 TO P1\nNEXT\n"), []);
    }
}
