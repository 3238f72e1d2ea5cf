//! `ACR128`: a `PBOOT` that is not the first statement of its program.

use acrc_analysis::SectionIndex;
use acrc_catalog::command;
use acrc_diagnostics::{Code, Edit, Fix, Severity, Span};
use acrc_syntax::ast::{Separator, StatementKind};
use acrc_syntax::units::SectionKind;

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR128", name: "pboot-not-first" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A program has a PBOOT that is not its first statement. Remarks before it are left alone.",
        why: "The controller looks for PBOOT at the start of a program when it powers up. Further down it does not start \
              the program, and the machine stands still after the next power failure.",
        bad: "PROG0\nPROGRAM\nDIM LV(2)\nPBOOT\nSET 32\nENDP",
        good: "PROG0\nPROGRAM\nPBOOT\nDIM LV(2)\nSET 32\nENDP",
        guide: "Basic Setup / Startup Programs",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, index: &SectionIndex) {
    let section = &index.section;
    let is_whole_text = section.opener.is_some() || context.index().implicit_program;
    if section.kind != SectionKind::Stored || !is_whole_text {
        return;
    }
    let kind = |at: &u32| context.tree().statements().get(*at as usize).map(|statement| &statement.kind);
    let mut others = section.statements.clone();
    let Some(first) = others.find(|at| !matches!(kind(at), Some(StatementKind::Remark(_)))) else { return };
    let is_pboot = |at: &u32| matches!(kind(at), Some(StatementKind::Command(c)) if c.id == command::PBOOT);
    let found: Vec<u32> = others.filter(is_pboot).collect();
    for at in found {
        report(context, first, at);
    }
}

fn report(context: &mut Context<'_>, first: u32, at: u32) {
    let message = "PBOOT is not the first statement: the program does not start at power-up";
    let mut diagnostic =
        RULE.at(context.statement_span(at), message).with_related(context.statement_span(first), "the first statement");
    if let Some(fix) = fix(context, first, at) {
        diagnostic = diagnostic.with_fix(fix);
    }
    context.report(diagnostic.with_help("put PBOOT directly behind PROGRAM"));
}

/// Moves a PBOOT that is alone on its line before the line of the first statement.
fn fix(context: &Context<'_>, first: u32, at: u32) -> Option<Fix> {
    let tree = context.tree();
    let line_of = |statement: u32| tree.lines().get(tree.line_of(statement) as usize);
    let line = line_of(at)?;
    let next = tree.lines().get(tree.line_of(at) as usize + 1)?;
    let before = line_of(first)?;
    let separator = tree.statements().get(first as usize)?.separator;
    let is_alone = line.statements.len() == 1 && line.comment.is_none() && line.number.is_none();
    if !is_alone || before.number.is_some() || separator != Separator::Line {
        return None;
    }
    let whole = Span::new(line.span.start, next.span.start);
    let edits = vec![Edit::insert(before.span.start, context.slice(whole)), Edit::delete(whole)];
    Some(Fix::unsafe_("move PBOOT to the start of the program", edits))
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, fixed, lines_of, lint, spans_of};

    fn found(body: &str) -> usize {
        spans_of("ACR128", &format!("PROG0\nPROGRAM\n{body}\nENDP\n")).len()
    }

    #[test]
    fn only_remarks_may_stand_before_it() {
        assert_eq!(found("PBOOT : REM first\nSET 32"), 0);
        assert_eq!(found("REM Lamp\n'of the door\n\nPBOOT"), 0);
        assert_eq!(found("SET 32\nPBOOT"), 1);
        assert_eq!(found("PBOOT\nPBOOT"), 1);
        assert_eq!(found("IF (BIT 1) THEN PBOOT"), 1);
    }

    #[test]
    fn a_program_file_is_a_program() {
        assert_eq!(lines_of("ACR128", &[("Prog0.8K", "SET 32\nPBOOT\n")]), [[2]]);
    }

    #[test]
    fn at_a_prompt_it_starts_programs() {
        assert_eq!(codes("PROG0\nPROGRAM\nSET 32\nENDP\nSYS\nRUN PROG0\nPBOOT\n"), []);
    }

    #[test]
    fn it_is_moved() {
        let text = "PROG0\nPROGRAM\nREM Lamp\n  SET 32\n  PBOOT\nCLR 32\nENDP\n";
        assert_eq!(fixed("ACR128", text), "PROG0\nPROGRAM\nREM Lamp\n  PBOOT\n  SET 32\nCLR 32\nENDP\n");
        assert_eq!(lint(&[("test.8K", "PROG0\nPROGRAM\nSET 32 : PBOOT\nENDP\n")]).concat()[0].fixes, []);
    }
}
