//! `ACR126`: an endless loop that does nothing.

use acrc_analysis::{SectionIndex, walk};
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{Statement, StatementKind};
use acrc_syntax::blocks::{Block, BlockKind};

use crate::Context;
use crate::operands::{Reference, condition, is_repeatable};
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR126", name: "endless-loop-without-wait" },
        group: Group::Flow,
        severity: Severity::Advice,
        enabled: true,
        mark: None,
        what: "A loop that is never left only passes labels and remarks or sets variables of its own program. A loop that \
               watches inputs without waiting, as many programs have it, is left alone.",
        why: "The program is stuck there and uses up its time slices. One that has finished and ends with END uses none.",
        bad: "PROG0\nPROGRAM\nSET 32\nDWL 1\nCLR 32\n_Stop\nGOTO Stop\nENDP",
        good: "PROG0\nPROGRAM\nSET 32\nDWL 1\nCLR 32\nEND\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    for jump in section.jumps.iter().filter(|jump| !jump.call) {
        if let Some(target) = jump.to.filter(|target| *target <= jump.statement) {
            // From the jump backwards: the statements between two jumps are looked at once.
            if (target..jump.statement).rev().all(|at| is_idle_at(context, at)) {
                report(context, jump.statement);
            }
        }
    }
    for block in section.blocks.all().iter().filter(|block| block.kind == BlockKind::While) {
        if is_idle_loop(context, block) {
            report(context, block.opener);
        }
    }
}

fn report(context: &mut Context<'_>, at: u32) {
    let diagnostic = RULE.at(context.statement_span(at), "this loop is never left, and does nothing");
    context.report(diagnostic.with_help("end the program with END, or wait with INH for what is to happen next"));
}

fn is_idle_loop(context: &Context<'_>, block: &Block) -> bool {
    let Some(closer) = block.closer else { return false };
    let opener = context.tree().statements().get(block.opener as usize);
    let value = opener.and_then(condition).and_then(walk::literal);
    value.is_some_and(|value| value != 0.0) && (block.opener + 1..closer).all(|at| is_idle_at(context, at))
}

fn is_idle_at(context: &Context<'_>, at: u32) -> bool {
    context.tree().statements().get(at as usize).is_some_and(|statement| is_idle(context, statement))
}

/// Whether a statement does nothing that can be noticed outside of its program.
fn is_idle(context: &Context<'_>, statement: &Statement) -> bool {
    match &statement.kind {
        StatementKind::Label(_) | StatementKind::Remark(_) => true,
        StatementKind::Assign(assign) => {
            let target = Reference::of(context, &assign.target);
            target.is_some_and(|target| target.class().is_local()) && is_repeatable(&assign.value)
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(body: &str) -> Vec<String> {
        let text = format!("#DEFINE Count LV0\nPROG0\nPROGRAM\n{body}\nENDP\n");
        spans_of("ACR126", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn idle_loops_are_marked_where_they_go_round() {
        assert_eq!(found("_A\nGOTO A"), ["GOTO A"]);
        assert_eq!(found("_A\nREM wait here\nCount = Count + 1\nGOTO A"), ["GOTO A"]);
        assert_eq!(found("WHILE (1)\nWEND"), ["WHILE (1)"]);
        assert_eq!(found("WHILE (-1)\nLV0 = P6916\nWEND"), ["WHILE (-1)"]);
    }

    #[test]
    fn a_loop_that_is_left_waits_or_acts_is_right() {
        assert_eq!(found("_A\nIF (BIT 1) THEN GOTO A"), [""; 0]);
        assert_eq!(found("_A\nIF (BIT 1) THEN SET 32\nGOTO A"), [""; 0]);
        assert_eq!(found("_A\nDWL 1\nGOTO A"), [""; 0]);
        assert_eq!(found("_A\nP0 = P0 + 1\nGOTO A"), [""; 0]);
        assert_eq!(found("_A\nLV0 = GETCH(1)\nGOTO A"), [""; 0]);
        assert_eq!(found("WHILE (BIT 1)\nWEND"), [""; 0]);
        assert_eq!(found("WHILE (1)\nBREAK\nWEND"), [""; 0]);
    }
}
