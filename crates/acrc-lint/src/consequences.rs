//! Findings that are left out because they only repeat, in other words, a mistake that is already reported.
//!
//! A statement that could not be read costs one finding, that of the parser: what a rule says about the readable part of
//! it rests on a guess. What stands behind a forgotten `ENDP` belongs to another program than it seems to.

use acrc_analysis::FileContext;
use acrc_diagnostics::{Diagnostic, Severity, Span};
use acrc_syntax::Tree;
use acrc_syntax::ast::{Separator, Statement, StatementKind};

/// The stretches of a file in which rules are not heard.
pub(crate) struct Consequences {
    /// In order and disjoint.
    spans: Vec<Span>,
}

impl Consequences {
    pub(crate) fn new(file: &FileContext<'_>) -> Self {
        let errors = file.tree.errors().iter().filter(|error| error.severity == Severity::Error);
        let mut spans: Vec<Span> = errors.filter_map(|error| broken_at(file.tree, error.span)).collect();
        spans.extend(file.index.sections.iter().filter_map(|section| {
            let statements = file.tree.statements();
            let first = statements.get(section.swallowed?.first as usize)?;
            let last = section.section.closer.unwrap_or(section.section.statements.end.checked_sub(1)?);
            Some(Span::cover(first.span, statements.get(last as usize)?.span))
        }));
        spans.sort_unstable_by_key(|span| (span.start, span.end));
        spans.dedup_by(|next, before| {
            let joins = next.start < before.end;
            if joins {
                *before = Span::cover(*before, *next);
            }
            joins
        });
        Self { spans }
    }

    /// Whether a finding lies in such a stretch.
    pub(crate) fn hide(&self, finding: &Diagnostic) -> bool {
        let after = self.spans.partition_point(|span| span.start <= finding.span.start);
        let before = after.checked_sub(1).and_then(|index| self.spans.get(index));
        before.is_some_and(|span| finding.span.end <= span.end)
    }

    /// Whether rules may have been silenced in a part of the text.
    pub(crate) fn touch(&self, part: Span) -> bool {
        let after = self.spans.partition_point(|span| span.start < part.end);
        let before = after.checked_sub(1).and_then(|index| self.spans.get(index));
        before.is_some_and(|span| part.start < span.end)
    }
}

/// The statement that an error of the parser is about, with the one before it when what follows that is the error.
fn broken_at(tree: &Tree, error: Span) -> Option<Span> {
    let statements = tree.statements();
    let mut at = statements.partition_point(|statement| statement.span.start <= error.start).checked_sub(1)?;
    let span = statements.get(at).filter(|statement| error.start <= statement.span.end)?.span;
    let is_rest =
        |statement: &Statement| statement.kind == StatementKind::Error && statement.separator == Separator::Blank;
    while at > 0 && statements.get(at).is_some_and(is_rest) {
        at -= 1;
    }
    Some(Span::cover(statements.get(at)?.span, span))
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, lint};

    #[test]
    fn a_broken_statement_costs_one_finding() {
        for statement in [
            "P0=FOO(1)",
            "P3=INT(2.7)",
            "GOSUB 5+",
            "P0=\"a",
            "X/ Y5",
            "P0 := 1",
            "P0=0x1F",
            "SET -",
            "IF (BIT 1) THEN",
            "FOR P0=1 TO 3\nDWL 1\nNEXT P0",
            "IF (BIT 1)\nEND IF",
        ] {
            let text = format!("PROG0\nPROGRAM\n{statement}\nENDP\n");
            let found = lint(&[("test.8K", &text)]).concat();
            assert_eq!(found.len(), 1, "{statement}: {found:#?}");
        }
    }

    #[test]
    fn the_statements_around_a_broken_one_are_still_judged() {
        assert_eq!(codes("DWL \"a\" : P0 = : DWL \"b\"\n"), [(1, "ACR202"), (1, "ACR001"), (1, "ACR202")]);
    }
}
