//! `ACR114`: `ENDP` without `PROGRAM`.

use acrc_catalog::command;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{Statement, StatementKind};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR114", name: "endp-without-program" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "An ENDP closes a program that no PROGRAM opened.",
        why: "Without PROGRAM the lines are carried out one by one as they are sent, instead of being stored: motion \
              starts during the download, and there is nothing to run afterwards.",
        bad: "PROG0\nSET 32\nDWL 1\nCLR 32\nENDP",
        good: "PROG0\nPROGRAM\nSET 32\nDWL 1\nCLR 32\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    // Between the sections stand only the PROGRAM and ENDP of a stored program.
    let Some(section) = context.section() else { return };
    if matches!(&statement.kind, StatementKind::Command(c) if c.id == command::ENDP)
        && section.section.closer != Some(context.statement())
        && !closes_swallowing(context)
    {
        let diagnostic = RULE.at(statement.span, "ENDP without PROGRAM");
        context.report(diagnostic.with_help("open the program with a line PROGRAM before its first statement"));
    }
}

/// A program inside of another one took the ENDP of the outer one, which is reported there.
fn closes_swallowing(context: &Context<'_>) -> bool {
    let sections = &context.index().sections;
    let behind = sections.partition_point(|other| other.section.statements.start <= context.statement());
    let closed = sections.iter().take(behind).rfind(|other| other.section.closer.is_some());
    closed.is_some_and(|other| other.swallowed.is_some())
}

#[cfg(test)]
mod tests {
    use crate::testing::codes;

    #[test]
    fn the_second_endp_has_no_program() {
        assert_eq!(codes("PROG0\nPROGRAM\nSET 32\nENDP\nENDP\n"), [(5, "ACR114")]);
    }
}
