//! `ACR301`: a parameter or bit number that no controller, or not this one, has.

use acrc_catalog::{Known, OperandClass, Space};
use acrc_diagnostics::{Code, Diagnostic, Severity, Span};
use acrc_syntax::ast::{Argument, Expr, ExprKind, Statement, StatementKind};

use crate::Context;
use crate::rule::{Check, Group, On, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR301", name: "unknown-number" },
        group: Group::Parameters,
        severity: Severity::Error,
        enabled: true,
        what: "A parameter or bit number lies beyond what controllers have, or belongs to an axis or master that the \
               model of the project does not have.",
        why: "A digit too many or too few reads or writes something else, or nothing: a wait for such a bit never ends, \
              a safety check of it never trips.",
        bad: "PROG0\nPROGRAM\nINH 161340\nENDP",
        good: "PROG0\nPROGRAM\nINH 16134\nENDP",
        guide: "Programming Basics / Parameters and Bits",
    },
    checks: &[Check::Expression(On::Operand, check_operand), Check::Statement(check_flags)],
};

/// The two kinds of numbers.
#[derive(Clone, Copy)]
enum Numbered {
    Parameter,
    Bit,
}

fn check_operand(context: &mut Context<'_>, expr: &Expr) {
    let ExprKind::Operand(operand) = &expr.kind else { return };
    let kind = match operand.class {
        OperandClass::Parameter => Numbered::Parameter,
        OperandClass::Bit => Numbered::Bit,
        _ => return,
    };
    judge(context, expr.span, kind, &operand.index);
}

fn check_flags(context: &mut Context<'_>, statement: &Statement) {
    let StatementKind::Command(command) = &statement.kind else { return };
    for argument in &command.arguments {
        if let Argument::Bit(bit) = argument {
            judge(context, bit.span, Numbered::Bit, &bit.index);
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

fn judge(context: &mut Context<'_>, span: Span, kind: Numbered, index: &Expr) {
    let Some(number) = number(index) else { return };
    let small = u32::try_from(number).ok();
    let place = match kind {
        Numbered::Parameter => {
            small.map(acrc_catalog::parameter).map(|info| (info.known, info.object, info.object_index))
        }
        Numbered::Bit => small.map(acrc_catalog::bit).map(|info| (info.known, info.object, info.object_index)),
    };
    let name = || match kind {
        Numbered::Parameter => format!("parameter P{number}"),
        Numbered::Bit => format!("bit {number}"),
    };
    match place {
        Some((known, object, index)) if known != Known::OutOfSpace => {
            report_missing_object(context, span, name, object, index);
        }
        _ => context.report(RULE.at(span, format!("there is no {}", name()))),
    }
}

/// Axes and masters are counted for the model only when the project names it: a default model may be the wrong one.
fn report_missing_object(
    context: &mut Context<'_>,
    span: Span,
    name: impl Fn() -> String,
    object: Space,
    index: Option<u32>,
) {
    let Some(model) = context.given_model() else { return };
    let (word, count) = match object {
        Space::Axis => ("axis", model.axes),
        Space::Master => ("master", model.masters),
        _ => return,
    };
    if let Some(index) = index.filter(|index| *index >= u32::from(count)) {
        let (name, model_name, last) = (name(), model.name, count.saturating_sub(1));
        let message = format!("{name} belongs to {word} {index}, and the {model_name} has {word} 0 to {last}");
        let diagnostic = Diagnostic { severity: Severity::Warning, ..RULE.at(span, message) };
        context.report_by(model.confidence, diagnostic);
    }
}

#[cfg(test)]
mod tests {
    use acrc_diagnostics::Severity;

    use crate::testing::{codes, codes_in, lint_as};

    #[test]
    fn numbers_are_found_wherever_they_stand() {
        assert_eq!(codes("IF (BIT 999999) THEN P999999 = 1\nSET 999999\nINH -BIT999999\n").len(), 4);
        assert_eq!(codes("P0 = P(12290) + BIT(516)\n"), []);
    }

    #[test]
    fn axes_are_counted_for_a_model_that_the_project_names() {
        let text = "P0 = P14594\n";
        assert_eq!(codes(text), [], "actual position of axis 9: another model may have it");
        let found = lint_as("ACR9000", text);
        assert_eq!(codes_in(text, &found), [(1, "ACR301")]);
        assert!(found[0].severity == Severity::Warning && found[0].message.contains("axis 9"));
    }
}
