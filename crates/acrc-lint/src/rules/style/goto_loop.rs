//! `ACR604`: a loop made of a label and a `GOTO`.

use acrc_analysis::SectionIndex;
use acrc_catalog::command;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{Separator, StatementKind};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR604", name: "goto-loop" },
        group: Group::Style,
        severity: Severity::Advice,
        enabled: false,
        mark: None,
        what: "A GOTO goes back to a label that nothing else jumps to, over statements without other jumps and labels.",
        why: "WHILE .. WEND says at its first line how long the loop runs, and BREAK leaves it. The guide too warns that GOTO \
              makes programs hard to read.",
        bad: "PROG0\nPROGRAM\n_Blink\nSET 32\nDWL 1\nCLR 32\nDWL 1\nGOTO Blink\nENDP",
        good: "PROG0\nPROGRAM\nWHILE (1)\nSET 32\nDWL 1\nCLR 32\nDWL 1\nWEND\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    if section.jumps.is_empty() || !section.blocks.errors().is_empty() {
        return;
    }
    let mut targets: Vec<u32> = section.jumps.iter().filter_map(|jump| jump.to).collect();
    targets.sort_unstable();
    for jump in section.jumps.iter().filter(|jump| !jump.call) {
        let Some(target) = jump.to.filter(|target| *target < jump.statement) else { continue };
        let first = targets.partition_point(|other| *other < target);
        let is_only = targets.get(first + 1).is_none_or(|other| *other != target);
        if is_only && is_simple(context, section, target, jump.statement) {
            let name = context.slice(jump.target.span());
            let span = context.statement_span(jump.statement);
            let diagnostic = RULE.at(span, format!("this GOTO closes a loop that begins at `{name}`"));
            let diagnostic = diagnostic.with_related(context.statement_span(target), "begins here");
            context.report(diagnostic.with_help("write it with WHILE and WEND"));
        }
    }
}

/// Whether a loop from the label `first` to the GOTO `last` is a block: both stand in the same block, nothing between
/// them is a label or a jump, and the GOTO begins its line or is all that an IF on its line does.
fn is_simple(context: &Context<'_>, section: &SectionIndex, first: u32, last: u32) -> bool {
    let at = |index: u32| context.tree().statements().get(index as usize);
    let passes = |index: u32| match at(index).map(|statement| &statement.kind) {
        Some(StatementKind::Label(_) | StatementKind::Error) | None => false,
        Some(StatementKind::Command(command)) => !matches!(command.id, command::GOTO | command::RETURN),
        Some(_) => true,
    };
    let starts_line = |index: u32| at(index).is_some_and(|statement| statement.separator == Separator::Line);
    let is_head = at(last).is_some_and(|jump| match jump.separator {
        Separator::Line => true,
        Separator::Then => last > first + 1 && starts_line(last - 1),
        Separator::Colon | Separator::Blank => false,
    });
    let is_label = at(first).is_some_and(|statement| matches!(statement.kind, StatementKind::Label(_)));
    let block_of = |index: u32| section.blocks.enclosing(index).map(|block| block.opener);
    is_head && is_label && block_of(first) == block_of(last) && (first + 1..last).rev().all(passes)
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(text: &str) -> Vec<&str> {
        spans_of("ACR604", text)
    }

    #[test]
    fn loops_without_and_with_a_condition() {
        assert_eq!(found("_A\nSET 32\nDWL 1\nGOTO A\n"), ["GOTO A"]);
        assert_eq!(found("_A\nDWL 1\nIF (BIT 1) THEN GOTO A\nSET 32\n"), ["GOTO A"]);
        assert_eq!(found("WHILE (BIT 1)\n_A\nIF (BIT 2)\nSET 32\nENDIF\nGOTO A\nWEND\n"), ["GOTO A"]);
    }

    #[test]
    fn more_than_a_loop_is_left_alone() {
        assert_eq!(found("_A\nDWL 1\nIF (BIT 1) THEN GOTO A\nGOTO A\n"), [""; 0]);
        assert_eq!(found("_A\nDWL 1\n_B\nGOTO A\n"), [""; 0]);
        assert_eq!(found("_A\nIF (BIT 1)\nGOTO A\nENDIF\n"), [""; 0]);
        assert_eq!(found("_A\nIF (BIT 1) THEN SET 32 : GOTO A\n"), [""; 0]);
        assert_eq!(found("GOTO A\nSET 32\n_A\n"), [""; 0]);
    }
}
