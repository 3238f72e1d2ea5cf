//! `ACR608`: a branch that is never taken, since an earlier one has its condition.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::Expr;
use acrc_syntax::blocks::BlockKind;

use super::branches::branches;
use crate::Context;
use crate::operands::{is_repeatable, same_text};
use crate::rule::{Check, Group, Rule, RuleDoc};

/// How many earlier branches a condition is compared with, which bounds the work for very long chains.
const REACH: usize = 64;

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR608", name: "duplicate-condition" },
        group: Group::Style,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "An ELSEIF has the same condition as the IF or an earlier ELSEIF of its chain.",
        why: "The first branch whose condition is true is taken: the later one never is.",
        bad: "PROG0\nPROGRAM\nIF (P0 = 1)\nSET 32\nELSEIF (P0 = 1)\nSET 33\nENDIF\nENDP",
        good: "PROG0\nPROGRAM\nIF (P0 = 1)\nSET 32\nELSEIF (P0 = 2)\nSET 33\nENDIF\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    for block in section.blocks.all() {
        if block.kind != BlockKind::If || block.branches.is_empty() {
            continue;
        }
        let conditions: Vec<&Expr> = branches(context, block).iter().filter_map(|branch| branch.condition).collect();
        for (place, condition) in conditions.iter().enumerate() {
            let earlier = conditions.get(place.saturating_sub(REACH)..place).unwrap_or_default();
            let same = earlier.iter().find(|other| same_text(context, other.span, condition.span));
            if let Some(other) = same.filter(|_| is_repeatable(condition)) {
                let diagnostic =
                    RULE.at(condition.span, "an earlier branch has this condition: this one is never taken");
                let diagnostic = diagnostic.with_related(other.span, "the same condition");
                context.report(diagnostic.with_help("delete the branch, or correct its condition"));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(text: &str) -> Vec<&str> {
        spans_of("ACR608", text)
    }

    #[test]
    fn the_later_condition_is_marked() {
        assert_eq!(found("IF (BIT 1)\nSET 32\nELSEIF (BIT 2)\nSET 33\nELSE IF (BIT1)\nSET 34\nENDIF\n"), ["(BIT1)"]);
    }

    #[test]
    fn other_conditions_and_other_chains_are_left_alone() {
        assert_eq!(found("IF (BIT 1)\nSET 32\nELSEIF (BIT 2)\nSET 33\nENDIF\nIF (BIT 1)\nSET 34\nENDIF\n"), [""; 0]);
        assert_eq!(found("IF (KBHIT(1))\nSET 32\nELSEIF (KBHIT(1))\nSET 33\nENDIF\n"), [""; 0]);
    }
}
