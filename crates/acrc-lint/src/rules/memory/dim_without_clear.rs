//! `ACR410`: a program that dimensions its variables each time it runs, or each time a loop goes round.

use acrc_analysis::SectionIndex;
use acrc_analysis::index::Jump;
use acrc_analysis::memory::IssueKind;
use acrc_catalog::command;
use acrc_diagnostics::{Code, Edit, Fix, Severity, Span};
use acrc_syntax::ast::{Separator, Statement, StatementKind};
use acrc_syntax::blocks::BlockKind;
use acrc_syntax::units::SectionKind;

use super::sites;
use crate::Context;
use crate::flow::NESTING;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR410", name: "dim-without-clear" },
        group: Group::Memory,
        severity: Severity::Advice,
        enabled: true,
        mark: None,
        what: "A stored program dimensions its variables and never clears them. The guide's own programs are of both \
               kinds; no document says that RUN frees the variables, and the dry run does not. A DIM in a loop, with no \
               CLEAR on the way round, is a warning, and advice where an IF or a GOTO may lead past it.",
        why: "The first RUN, or the first pass, works. The second finds the variables of the first and may stop with \
              \"Re-dimensioned block\": the program runs once after power-up and never again.",
        bad: "PROG0\nPROGRAM\nDIM LV(2)\nLV0 = 1\nENDP",
        good: "PROG0\nPROGRAM\nCLEAR\nDIM LV(2)\nLV0 = 1\nENDP",
        guide: "System Configuration / Memory Allocations / Clearing Allocated Memory",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    let repeated = check_loops(context);
    for (site, kind) in sites::issues(context) {
        let IssueKind::NotCleared(block) = kind else { continue };
        let span = sites::span(context, site);
        if repeated.contains(&span) {
            continue;
        }
        let message = format!("a second RUN may find that {block} has memory already");
        let before = context.text().get(..span.start as usize).unwrap_or_default();
        // The line break is that of the line before.
        let clear = match before {
            line if line.ends_with("\r\n") => "CLEAR\r\n",
            line if line.ends_with('\n') => "CLEAR\n",
            _ => "CLEAR : ",
        };
        let fix = Fix::unsafe_("clear the variables first", vec![Edit::insert(span.start, clear)]);
        context.report(RULE.at(span, message).with_help("CLEAR before the first DIM of the program").with_fix(fix));
    }
}

/// Reports the first DIM of each loop of the stored programs that nothing clears; gives their places.
fn check_loops(context: &mut Context<'_>) -> Vec<Span> {
    let mut repeated = Vec::new();
    for section in &context.index().sections {
        if section.section.kind != SectionKind::Stored {
            continue;
        }
        let dims = statements_of(context, section, is_local_dim);
        if dims.is_empty() {
            continue;
        }
        let Some(flow) = context.flow(section) else { continue };
        for statement in flow.repeated(&dims, &statements_of(context, section, is_clear)) {
            let span = context.statement_span(statement);
            let message = "this DIM is in a loop without CLEAR: from the second pass on there is memory already";
            let mut finding = RULE.at(span, message).with_help("dimension before the loop, or CLEAR on each pass");
            if !may_be_passed_by(context, section, statement) {
                finding.severity = Severity::Warning;
            }
            context.report(finding);
            repeated.push(span);
        }
    }
    repeated
}

/// The statements of a section of some kind.
fn statements_of(context: &Context<'_>, section: &SectionIndex, is: fn(&Statement) -> bool) -> Vec<u32> {
    let statements = context.tree().statements();
    let range = section.section.statements.clone();
    range.filter(|at| statements.get(*at as usize).is_some_and(is)).collect()
}

/// A `DIM` of variables of the program itself. Without a size it is a report.
fn is_local_dim(statement: &Statement) -> bool {
    matches!(&statement.kind, StatementKind::Dim(dim) if !dim.id.info().levels.sys() && !dim.sizes.is_empty())
}

/// A `CLEAR` of the program's variables.
fn is_clear(statement: &Statement) -> bool {
    matches!(&statement.kind, StatementKind::Command(command) if command.id == command::CLEAR && command.arguments.is_empty())
}

/// Whether an IF around a statement, or a GOTO over it, can keep a pass of a loop from it.
fn may_be_passed_by(context: &Context<'_>, section: &SectionIndex, statement: u32) -> bool {
    let around = std::iter::successors(section.blocks.enclosing(statement), |block| section.blocks.parent(block));
    let in_branch = around.take(NESTING).any(|block| block.kind == BlockKind::If);
    let over = |jump: &Jump| !jump.call && jump.statement < statement && jump.to.is_some_and(|to| to > statement);
    in_branch || section.jumps.iter().any(over) || is_behind_then(context, statement)
}

/// Whether a statement stands behind a `THEN` of its line.
fn is_behind_then(context: &Context<'_>, statement: u32) -> bool {
    let before = context.tree().statements().get(..=statement as usize).unwrap_or_default();
    let starts = before.iter().rposition(|statement| statement.separator == Separator::Line).unwrap_or_default();
    let line = before.get(starts..).unwrap_or_default();
    line.iter().any(|statement| matches!(&statement.kind, StatementKind::If(head) if head.then.is_some()))
}

#[cfg(test)]
mod tests {
    use acrc_diagnostics::{Severity, apply};

    use crate::testing::{found_by, lint, spans_of};

    /// What is found in loops: the place and the severity.
    fn in_loops(body: &str) -> Vec<(String, Severity)> {
        let text = format!("PROG0\nPROGRAM\nCLEAR\n{body}\nENDP\n");
        let place = |span: acrc_diagnostics::Span| text[span.range()].to_owned();
        found_by("ACR410", &text).into_iter().map(|found| (place(found.span), found.severity)).collect()
    }

    #[test]
    fn a_dim_in_a_loop() {
        let warning = |dim: &str| vec![(dim.to_owned(), Severity::Warning)];
        assert_eq!(in_loops("DIM LA(1)\n_A\nDIM LA0(P0)\nDIM LV(2)\nDWL 1\nGOTO A"), warning("DIM LA0(P0)"));
        assert_eq!(in_loops("FOR P0 = 1 TO 3\nDIM LV(2)\nNEXT"), warning("DIM LV(2)"));
        assert_eq!(in_loops("WHILE (BIT 1)\nGOSUB A\nDIM LV(2)\nWEND\nEND\n_A\nRETURN"), warning("DIM LV(2)"));
    }

    #[test]
    fn a_dim_that_may_be_passed_by_is_advice() {
        let advice = || vec![("DIM LV(2)".to_owned(), Severity::Advice)];
        assert_eq!(in_loops("_A\nIF (BIT 1) THEN CLR 1 : DIM LV(2)\nGOTO A"), advice());
        assert_eq!(in_loops("_A\nIF (BIT 1)\nDIM LV(2)\nENDIF\nGOTO A"), advice());
        assert_eq!(in_loops("_A\nIF (BIT 1) THEN GOTO B\nDIM LV(2)\n_B\nDWL 1\nGOTO A"), advice());
    }

    #[test]
    fn a_clear_on_the_way_round_is_enough() {
        assert_eq!(in_loops("_A\nCLEAR\nDIM LV(2)\nDWL 1\nGOTO A"), []);
        assert_eq!(in_loops("_A\nGOSUB B\nDIM LV(2)\nGOTO A\n_B\nCLEAR\nRETURN"), []);
        assert_eq!(in_loops("DIM LV(2)\n_A\nDWL 1\nGOTO A"), [], "not in the loop");
        assert_eq!(in_loops("GOSUB B\nEND\n_B\nDIM LV(2)\nRETURN"), []);
    }

    #[test]
    fn a_dim_is_reported_once() {
        let text = "PROG0\nPROGRAM\n_A\nDIM LV(2)\nDWL 1\nGOTO A\nENDP\n";
        assert_eq!(spans_of("ACR410", text), ["DIM LV(2)"]);
    }

    #[test]
    fn the_first_dim_of_a_text_is_named() {
        assert_eq!(spans_of("ACR410", "PROG0\nPROGRAM\nDIM LV(2)\nDIM DV(1)\nENDP\n"), ["DIM LV(2)"]);
        assert_eq!(spans_of("ACR410", "PROG0\nDIM LV(2)\nPROGRAM\nLV0=1\nENDP\n"), [""; 0]);
    }

    #[test]
    fn a_clear_anywhere_in_the_text_is_enough() {
        assert_eq!(spans_of("ACR410", "PROG0\nPROGRAM\nDIM LV(2)\nLV0=1\nCLEAR\nENDP\n"), [""; 0]);
    }

    #[test]
    fn the_repair() {
        let text = "PROG0\nPROGRAM\nDIM LV(1)\nPRINT LV0\nENDP\n";
        let found = lint(&[("test.8K", text)]).concat();
        let fixed = apply(text, &[&found[0].fixes[0]]).expect("a fix of one edit");
        assert_eq!(fixed, "PROG0\nPROGRAM\nCLEAR\nDIM LV(1)\nPRINT LV0\nENDP\n");
        assert_eq!(lint(&[("test.8K", &fixed)]).concat(), []);
    }

    #[test]
    fn the_repair_keeps_line_breaks() {
        let text = "PROG0\r\nPROGRAM\r\nDIM LV(1)\r\nPRINT LV0\r\nENDP\r\n";
        let found = lint(&[("test.8K", text)]).concat();
        let fixed = apply(text, &[&found[0].fixes[0]]).expect("a fix of one edit");
        assert_eq!(fixed, "PROG0\r\nPROGRAM\r\nCLEAR\r\nDIM LV(1)\r\nPRINT LV0\r\nENDP\r\n");
    }
}
