//! `ACR112`: blocks that overlap, and branches behind an `ELSE`.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Diagnostic, Severity};
use acrc_syntax::blocks::{BlockError, BlockErrorKind};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR112", name: "crossed-blocks" },
        group: Group::Flow,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "A block is closed while another one that was opened inside it is still open, or a branch follows the ELSE \
               of its chain.",
        why: "Blocks lie within each other or one after the other. Crossed ones leave open what is inside, and a branch \
              behind ELSE is never taken.",
        bad: "PROG0\nPROGRAM\nWHILE (P0 < 10)\nIF (BIT 24)\nSET 32\nWEND\nENDIF\nENDP",
        good: "PROG0\nPROGRAM\nWHILE (P0 < 10)\nIF (BIT 24)\nSET 32\nENDIF\nWEND\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    for error in section.blocks.errors() {
        if let Some(diagnostic) = finding(context, *error) {
            context.report(diagnostic);
        }
    }
}

fn finding(context: &Context<'_>, error: BlockError) -> Option<Diagnostic> {
    let span = context.statement_span(error.statement);
    match error.kind {
        BlockErrorKind::Crossed { closes, open, open_kind } => {
            let (closer, inner) = (closes.closer(), open_kind.opener());
            let diagnostic = RULE
                .at(span, format!("{closer} comes before the {} of the {inner} inside the block", open_kind.closer()));
            let related = diagnostic.with_related(context.statement_span(open), format!("this {inner} is still open"));
            Some(related.with_help(format!("put {} before this {closer}", open_kind.closer())))
        }
        BlockErrorKind::ElseAfterElse { first } => {
            let diagnostic = RULE.at(span, "a branch stands behind the ELSE of its chain");
            let related =
                diagnostic.with_related(context.statement_span(first), "the ELSE, which takes everything that is left");
            Some(related.with_help("put ELSE last"))
        }
        BlockErrorKind::Unclosed(_) | BlockErrorKind::Unopened(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::codes;

    #[test]
    fn nothing_follows_else() {
        assert_eq!(codes("IF (BIT 1)\nELSE\nSET 32\nELSEIF (BIT 2)\nENDIF\n"), [(4, "ACR112")]);
    }
}
