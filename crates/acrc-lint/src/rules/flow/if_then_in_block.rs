//! `ACR124`: a one-line `IF` inside of a block `IF`.

use acrc_diagnostics::{Code, Edit, Fix, Severity, Span};
use acrc_syntax::ast::{If, Separator, Statement, StatementKind};
use acrc_syntax::blocks::{Block, BlockKind};

use crate::Context;
use crate::flow::NESTING;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR124", name: "if-then-in-block" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "An IF with THEN stands inside of a block IF that ENDIF closes.",
        why: "The guide forbids it: the outcome may be another than the text says. It does not say which; a branch may be \
              skipped, or carried out when it should not.",
        bad: "PROG0\nPROGRAM\nIF (BIT 24)\nIF (BIT 25) THEN SET 32\nELSE\nCLR 32\nENDIF\nENDP",
        good: "PROG0\nPROGRAM\nIF (BIT 24)\nIF (BIT 25)\nSET 32\nENDIF\nELSE\nCLR 32\nENDIF\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    let StatementKind::If(head) = &statement.kind else { return };
    let (Some(then), Some(section)) = (head.then, context.section()) else { return };
    let blocks = &section.blocks;
    let around = std::iter::successors(blocks.enclosing(context.statement()), |block| blocks.parent(block));
    let Some(block) = around.take(NESTING).find(|block| is_if(block)) else { return };
    // A THEN with nothing behind it opens a block; the parser reports it.
    if blocks.block_of(context.statement()).is_some() {
        return;
    }
    let span = Span::cover(statement.span, then);
    let mut diagnostic = RULE
        .at(span, "IF with THEN inside of a block IF")
        .with_related(context.statement_span(block.opener), "the block IF");
    if let Some(fix) = fix(context, statement, head) {
        diagnostic = diagnostic.with_fix(fix);
    }
    context.report(diagnostic.with_help("write it as a block of its own, without THEN and with ENDIF"));
}

fn is_if(block: &Block) -> bool {
    block.kind == BlockKind::If
}

/// Takes the line apart: the condition, what depends on it, ENDIF. Only for a line that holds nothing else.
fn fix(context: &Context<'_>, statement: &Statement, head: &If) -> Option<Fix> {
    let tree = context.tree();
    let line = tree.lines().get(tree.line_of(context.statement()) as usize)?;
    let rest = tree.statements().get(context.statement() as usize + 1..line.statements.end as usize)?;
    let (first, last) = (rest.first()?, rest.last()?);
    let is_simple = statement.separator == Separator::Line
        && line.number.is_none()
        && line.comment.is_none()
        && rest.iter().all(|inner| !matches!(inner.kind, StatementKind::If(_) | StatementKind::Error));
    if !is_simple {
        return None;
    }
    let indent = context.slice(Span::new(line.span.start, statement.span.start));
    let end_of_line = context.slice(Span::new(line.span.end, line.span.end + 2));
    let line_break = if end_of_line == "\r\n" { "\r\n" } else { "\n" };
    let gap = Span::new(head.condition.span.end, first.span.start);
    let edits = vec![
        Edit::replace(gap, format!("{line_break}{indent}    ")),
        Edit::insert(last.span.end, format!("{line_break}{indent}ENDIF")),
    ];
    Some(Fix::unsafe_("write it as a block with ENDIF", edits))
}

#[cfg(test)]
mod tests {
    use crate::testing::{fixed, spans_of};

    fn found(body: &str) -> Vec<&str> {
        spans_of("ACR124", body)
    }

    #[test]
    fn every_branch_and_every_depth_counts() {
        assert_eq!(found("IF (BIT 1)\nIF (BIT 2) THEN SET 32\nENDIF\n"), ["IF (BIT 2) THEN"]);
        assert_eq!(found("IF (BIT 1)\nELSE\nIF (BIT 2) THEN SET 32\nENDIF\n"), ["IF (BIT 2) THEN"]);
        assert_eq!(found("IF (BIT 1)\nWHILE (BIT 3)\nIF (BIT 2) THEN BREAK\nWEND\nENDIF\n"), ["IF (BIT 2) THEN"]);
    }

    #[test]
    fn loops_and_lines_may_hold_it() {
        assert_eq!(found("WHILE (BIT 1)\nIF (BIT 2) THEN BREAK\nWEND\n"), [""; 0]);
        assert_eq!(found("IF (BIT 1)\nENDIF\nIF (BIT 2) THEN SET 32\n"), [""; 0]);
        assert_eq!(found("IF (BIT 1) THEN IF (BIT 2) THEN SET 32\n"), [""; 0]);
    }

    #[test]
    fn the_line_is_taken_apart() {
        let text = "IF (BIT 1)\r\n  IF (BIT 2) THEN SET 32 : CLR 33 : REM lamps\r\nENDIF\r\n";
        let good = "IF (BIT 1)\r\n  IF (BIT 2)\r\n      SET 32 : CLR 33 : REM lamps\r\n  ENDIF\r\nENDIF\r\n";
        assert_eq!(fixed("ACR124", text), good);
        let nested = "IF (BIT 1)\nIF (BIT 2) THEN IF (BIT 3) THEN SET 32\nENDIF\n";
        assert_eq!(fixed("ACR124", nested), nested, "for a person to untangle");
    }
}
