//! `ACR607`: branches that do the same.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::blocks::BlockKind;

use super::branches::branches;
use crate::Context;
use crate::operands::same_text;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR607", name: "duplicate-branch" },
        group: Group::Style,
        severity: Severity::Advice,
        enabled: true,
        mark: None,
        what: "A branch of a block IF holds the same statements as the one before it.",
        why: "Often one of them was copied and then not changed: the machine does the same in two cases that were told apart.",
        bad: "PROG0\nPROGRAM\nIF (BIT 24)\nSET 32\nELSE\nSET 32\nENDIF\nENDP",
        good: "PROG0\nPROGRAM\nIF (BIT 24)\nSET 32\nELSE\nCLR 32\nENDIF\nENDP",
        guide: "none: it is allowed",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    let has_branches = |kind: BlockKind, count: usize| kind == BlockKind::If && count > 0;
    for block in section.blocks.all().iter().filter(|block| has_branches(block.kind, block.branches.len())) {
        let branches = branches(context, block);
        for pair in branches.windows(2) {
            let [before, branch] = pair else { continue };
            let (Some(first), Some(second)) = (before.body, branch.body) else { continue };
            if same_text(context, first, second) {
                let diagnostic =
                    RULE.at(context.statement_span(branch.head), "this branch does the same as the one before");
                let diagnostic = diagnostic.with_related(context.statement_span(before.head), "the one before");
                context.report(diagnostic.with_help("make it one branch, or correct the copy"));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(text: &str) -> Vec<&str> {
        spans_of("ACR607", text)
    }

    #[test]
    fn blanks_and_the_case_of_words_do_not_make_a_difference() {
        assert_eq!(found("IF (BIT 1)\nSET 32\n X10\nELSEIF (BIT 2)\nset 32\nX 10\nENDIF\n"), ["ELSEIF (BIT 2)"]);
        assert_eq!(found("IF (BIT 1)\nSET 32\nELSEIF (BIT 2)\nSET 33\nELSE\nSET 33\nENDIF\n"), ["ELSE"]);
    }

    #[test]
    fn names_numbers_and_branches_apart_do() {
        assert_eq!(found("IF (BIT 1)\nSET 32\nELSE\nSET 33\nENDIF\n"), [""; 0]);
        assert_eq!(found("IF (BIT 1)\nGOSUB a\nELSE\nGOSUB A\nENDIF\n_a\n_A\nRETURN\n"), [""; 0]);
        assert_eq!(found("IF (BIT 1)\nSET 32\nELSEIF (BIT 2)\nSET 33\nELSE\nSET 32\nENDIF\n"), [""; 0]);
        assert_eq!(found("IF (BIT 1)\nELSE\nENDIF\n"), [""; 0]);
    }
}
