//! `ACR110`: a block that is not closed.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::blocks::BlockErrorKind;

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR110", name: "unclosed-block" },
        group: Group::Flow,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "An IF without THEN has no ENDIF, a FOR no NEXT, or a WHILE no WEND.",
        why: "Where the block ends decides what the machine does and how often. The controller looks for the end when \
              the program runs, and does not find it.",
        bad: "PROG0\nPROGRAM\nIF (BIT 24)\nSET 32\nDWL 1\nENDP",
        good: "PROG0\nPROGRAM\nIF (BIT 24)\nSET 32\nENDIF\nDWL 1\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    for error in section.blocks.errors() {
        if let BlockErrorKind::Unclosed(kind) = error.kind {
            let (opener, closer) = (kind.opener(), kind.closer());
            let span = context.statement_span(error.statement);
            let diagnostic = RULE.at(span, format!("{opener} has no {closer}"));
            context.report(diagnostic.with_help(format!("close the block with a line {closer}")));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::codes;

    #[test]
    fn each_kind_of_block_must_be_closed() {
        assert_eq!(
            codes("WHILE (BIT 1)\nFOR LV0 = 0 TO 3\nIF (BIT 2)\n"),
            [(1, "ACR110"), (2, "ACR110"), (3, "ACR110")]
        );
    }

    #[test]
    fn else_if_in_two_words_shares_the_endif() {
        assert_eq!(codes("IF (BIT 1)\nSET 32\nELSE IF (BIT 2)\nSET 33\nELSE\nSET 34\nENDIF\n"), []);
    }
}
