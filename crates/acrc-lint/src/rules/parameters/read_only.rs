//! `ACR302`: writing what only the controller writes.

use acrc_analysis::AliasFact;
use acrc_analysis::index::AliasTarget;
use acrc_catalog::{Access, Confidence, Known, OperandClass, command};
use acrc_diagnostics::{Code, Severity, Span};
use acrc_syntax::ast::{Argument, Expr, ExprKind, Statement, StatementKind};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR302", name: "read-only" },
        group: Group::Parameters,
        severity: Severity::Error,
        enabled: true,
        what: "A statement writes a parameter or bit that reports a state of the controller.",
        why: "The controller writes it again with the next servo period, so the statement has no effect, and the code \
              behind it goes on as if it had one.",
        bad: "PROG0\nPROGRAM\nCLR 792\nENDP",
        good: "PROG0\nPROGRAM\nINH -792\nENDP",
        guide: "Programming Basics / Parameters and Bits",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    match &statement.kind {
        StatementKind::Assign(assign) => written(context, &assign.target),
        StatementKind::For(counted) => written(context, &counted.variable),
        StatementKind::Input(input) => input.variables.iter().for_each(|variable| written(context, variable)),
        StatementKind::Command(set) if set.id == command::SET || set.id == command::CLR => {
            for argument in &set.arguments {
                if let Argument::Bit(bit) = argument {
                    written_bit(context, bit.span, &bit.index);
                }
            }
        }
        _ => {}
    }
}

fn written(context: &mut Context<'_>, target: &Expr) {
    match &target.kind {
        ExprKind::Operand(operand) => {
            if let ExprKind::Integer(number) = operand.index.kind {
                judge(context, target.span, operand.class, number);
            }
        }
        ExprKind::Alias => written_alias(context, target.span),
        _ => {}
    }
}

fn written_bit(context: &mut Context<'_>, span: Span, index: &Expr) {
    match index.kind {
        ExprKind::Integer(number) => judge(context, span, OperandClass::Bit, number),
        ExprKind::Alias => written_alias(context, index.span),
        _ => {}
    }
}

fn written_alias(context: &mut Context<'_>, span: Span) {
    if let Some(AliasFact::Defined { operand, .. }) = context.alias(span)
        && let AliasTarget::Operand(class, Some(number)) = operand.target
    {
        judge(context, span, class, number);
    }
}

fn judge(context: &mut Context<'_>, span: Span, class: OperandClass, number: u64) {
    let Ok(number) = u32::try_from(number) else { return };
    let (word, title, known, access, confidence) = match class {
        OperandClass::Parameter => {
            let info = acrc_catalog::parameter(number);
            ("P", info.title, info.known, info.access, info.confidence)
        }
        OperandClass::Bit => {
            let info = acrc_catalog::bit(number);
            ("bit ", info.title, info.known, info.access, info.confidence)
        }
        _ => return,
    };
    if known == Known::Row && access == Access::Read && confidence == Confidence::High {
        context.report(RULE.at(span, format!("{word}{number} ({title}) is written by the controller only")));
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::codes;

    #[test]
    fn every_way_of_writing() {
        assert_eq!(codes("P12291 = 5\nBIT 792 = 1\nSET BIT792\n"), [(1, "ACR302"), (2, "ACR302"), (3, "ACR302")]);
        assert_eq!(codes("P12288 = 0\nSET 8467\nCLR 522\nP0 = P12290\n"), []);
    }

    #[test]
    fn through_an_alias() {
        assert_eq!(codes("#DEFINE Jogging BIT792\nCLR Jogging\n"), [(2, "ACR302")]);
    }
}
