//! `ACR111`: the end or a branch of a block that is not open.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::blocks::BlockErrorKind;

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR111", name: "unopened-block-end" },
        group: Group::Flow,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "An ELSE, ELSEIF or ENDIF stands outside of a block IF, a NEXT outside of a FOR, a WEND outside of a WHILE. \
               Often the IF has a THEN, which needs no ENDIF.",
        why: "The statements that were meant to depend on a condition are carried out always.",
        bad: "PROG0\nPROGRAM\nIF (BIT 24) THEN SET 32\nENDIF\nENDP",
        good: "PROG0\nPROGRAM\nIF (BIT 24) THEN SET 32\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    for error in section.blocks.errors() {
        if let BlockErrorKind::Unopened(word) = error.kind {
            let (what, opener) = match word {
                "NEXT" => ("a loop", "FOR"),
                "WEND" => ("a loop", "WHILE"),
                _ => ("a block", "IF without THEN"),
            };
            let diagnostic = RULE.at(context.statement_span(error.statement), format!("{word} outside of {what}"));
            context.report(diagnostic.with_help(format!("{what} with {word} begins with {opener}")));
        }
    }
}
