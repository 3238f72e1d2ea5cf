//! `ACR115`: `BREAK` with no loop around it.

use acrc_catalog::command;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{Statement, StatementKind};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR115", name: "break-outside-loop" },
        group: Group::Flow,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "A BREAK stands outside of FOR .. NEXT and WHILE .. WEND.",
        why: "BREAK leaves the innermost loop. With none around it there is nothing to leave.",
        bad: "PROG0\nPROGRAM\nIF (BIT 24)\nBREAK\nENDIF\nENDP",
        good: "PROG0\nPROGRAM\nWHILE (P0 < 10)\nP0 = P0 + 1\nIF (BIT 24)\nBREAK\nENDIF\nWEND\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    let Some(section) = context.section() else { return };
    if matches!(&statement.kind, StatementKind::Command(c) if c.id == command::BREAK)
        && section.blocks.enclosing_loop(context.statement()).is_none()
    {
        let diagnostic = RULE.at(statement.span, "BREAK outside of a loop");
        context.report(diagnostic.with_help("to end the program use END, to leave a subroutine use RETURN"));
    }
}
