//! `ACR134`: a block with nothing in it.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Severity, Span};
use acrc_syntax::blocks::{Block, BlockKind};

use crate::Context;
use crate::rule::{Check, Group, Mark, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR134", name: "empty-block" },
        group: Group::Flow,
        severity: Severity::Advice,
        enabled: true,
        mark: Some(Mark::Unnecessary),
        what: "A branch of a block IF, or a FOR, holds no statement and no remark. An empty WHILE waits for its condition \
               and is left alone.",
        why: "Something was left out, or is left over. An empty FOR as a delay takes another time on another controller, \
              and while other programs run.",
        bad: "PROG0\nPROGRAM\nIF (BIT 24)\nELSE\nSET 32\nENDIF\nENDP",
        good: "PROG0\nPROGRAM\nIF (NOT BIT 24)\nSET 32\nENDIF\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    for block in section.blocks.all().iter().filter(|block| block.kind != BlockKind::While) {
        let Some(closer) = block.closer else { continue };
        let heads = std::iter::once(block.opener).chain(block.branches.iter().copied());
        let ends = block.branches.iter().copied().chain([closer]);
        let empty: Vec<u32> = heads.zip(ends).filter(|pair| is_empty(context, *pair)).map(|(head, _)| head).collect();
        if empty.len() == block.branches.len() + 1 {
            report(context, block.opener, block);
            continue;
        }
        for head in empty {
            report(context, head, block);
        }
    }
}

fn report(context: &mut Context<'_>, head: u32, block: &Block) {
    let (message, help) = match block.kind {
        BlockKind::For => ("this FOR only counts", "to wait use DWL"),
        _ if head != block.opener => ("this branch is empty", "delete it, or say in a remark why nothing is done"),
        _ if block.branches.is_empty() => ("this IF is empty", "delete it, or say in a remark why nothing is done"),
        _ => ("this branch is empty", "turn the condition round with NOT, or say in a remark why nothing is done"),
    };
    let diagnostic = RULE.at(context.statement_span(head), message);
    context.report(diagnostic.with_help(help));
}

/// Whether nothing stands between two statements, a comment included.
fn is_empty(context: &Context<'_>, (head, end): (u32, u32)) -> bool {
    let between = Span::new(context.statement_span(head).end, context.statement_span(end).start);
    end == head + 1 && context.slice(between).chars().all(|c| c.is_whitespace() || c == ':')
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(text: &str) -> Vec<&str> {
        spans_of("ACR134", text)
    }

    #[test]
    fn each_empty_branch_is_marked() {
        assert_eq!(found("IF (BIT 1)\nENDIF\n"), ["IF (BIT 1)"]);
        assert_eq!(found("IF (BIT 1)\nELSE\nENDIF\n"), ["IF (BIT 1)"]);
        assert_eq!(found("IF (BIT 1)\nSET 32\nELSEIF (BIT 2)\n\nELSE\nENDIF\n"), ["ELSEIF (BIT 2)", "ELSE"]);
        assert_eq!(found("FOR LV0 = 1 TO 1000\nNEXT\n"), ["FOR LV0 = 1 TO 1000"]);
    }

    #[test]
    fn a_wait_and_a_reason_are_left_alone() {
        assert_eq!(found("WHILE (BIT 1)\nWEND\n"), [""; 0]);
        assert_eq!(found("IF (BIT 1)\n'nothing to do\nELSE\nSET 32\nENDIF\n"), [""; 0]);
        assert_eq!(found("IF (BIT 1)\nREM nothing to do\nENDIF\n"), [""; 0]);
        assert_eq!(found("IF (BIT 1) THEN SET 32\n"), [""; 0]);
    }
}
