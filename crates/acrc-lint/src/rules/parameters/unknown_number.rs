//! `ACR301`: a parameter or bit number that no controller, or not this one, has.

use acrc_catalog::{Known, OperandClass, Space};
use acrc_diagnostics::{Code, Diagnostic, Severity, Span};
use acrc_syntax::ast::{Argument, Expr, ExprKind, Statement, StatementKind};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR301", name: "unknown-number" },
        group: Group::Parameters,
        severity: Severity::Error,
        what: "A parameter or bit number lies beyond what controllers have, or belongs to an axis or master that the \
               model of the project does not have.",
        why: "A digit too many or too few reads or writes something else, or nothing: a wait for such a bit never ends, \
              a safety check of it never trips.",
        bad: "PROG0\nPROGRAM\nINH 161340\nENDP",
        good: "PROG0\nPROGRAM\nINH 16134\nENDP",
        guide: "Programming Basics / Parameters and Bits",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    acrc_analysis::walk::expressions(statement, &mut |expr| {
        if let ExprKind::Operand(operand) = &expr.kind {
            match (operand.class, number(&operand.index)) {
                (OperandClass::Parameter, Some(number)) => parameter(context, expr.span, number),
                (OperandClass::Bit, Some(number)) => bit(context, expr.span, number),
                _ => {}
            }
        }
    });
    let StatementKind::Command(command) = &statement.kind else { return };
    for argument in &command.arguments {
        if let Argument::Bit(argument) = argument
            && let Some(number) = number(&argument.index)
        {
            bit(context, argument.span, number);
        }
    }
}

/// Numbers in parentheses are numbers too: `BIT(516)`.
fn number(expr: &Expr) -> Option<u64> {
    match &expr.kind {
        ExprKind::Integer(number) => Some(*number),
        ExprKind::Paren(inner) => number(inner),
        _ => None,
    }
}

fn parameter(context: &mut Context<'_>, span: Span, number: u64) {
    let info = u32::try_from(number).map(acrc_catalog::parameter);
    match info {
        Ok(info) if info.known != Known::OutOfSpace => {
            report_missing_object(context, span, &format!("P{number}"), info.object, info.object_index);
        }
        _ => context.report(RULE.at(span, format!("there is no parameter P{number}"))),
    }
}

fn bit(context: &mut Context<'_>, span: Span, number: u64) {
    let info = u32::try_from(number).map(acrc_catalog::bit);
    match info {
        Ok(info) if info.known != Known::OutOfSpace => {
            report_missing_object(context, span, &format!("bit {number}"), info.object, info.object_index);
        }
        _ => context.report(RULE.at(span, format!("there is no bit {number}"))),
    }
}

/// Axes and masters are counted for the model only when the project names it: a default model may be the wrong one.
fn report_missing_object(context: &mut Context<'_>, span: Span, name: &str, object: Space, index: Option<u32>) {
    let Some(model) = context.given_model() else { return };
    let (word, count) = match object {
        Space::Axis => ("axis", model.axes),
        Space::Master => ("master", model.masters),
        _ => return,
    };
    if let Some(index) = index.filter(|index| *index >= u32::from(count)) {
        let message = format!(
            "{name} belongs to {word} {index}, and the {} has {word} 0 to {}",
            model.name,
            count.saturating_sub(1)
        );
        let diagnostic = Diagnostic { severity: Severity::Warning, ..RULE.at(span, message) };
        context.report_by(model.confidence, diagnostic);
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::codes;

    #[test]
    fn numbers_are_found_wherever_they_stand() {
        assert_eq!(codes("IF (BIT 999999) THEN P999999 = 1\nSET 999999\nINH -BIT999999\n").len(), 4);
        assert_eq!(codes("P0 = P(12290) + BIT(516)\n"), []);
    }
}
