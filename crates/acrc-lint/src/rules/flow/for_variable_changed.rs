//! `ACR136`: the counter of a `FOR` that something else changes.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Severity, Span};
use acrc_syntax::ast::{Expr, Statement, StatementKind};
use acrc_syntax::blocks::{Block, BlockKind};

use crate::Context;
use crate::flow::NESTING;
use crate::operands::Variable;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR136", name: "for-variable-changed" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "Two FOR, one inside of the other, count with the same variable. An assignment or INPUT to the counter inside \
               of a loop is reported as advice.",
        why: "The inner loop leaves the counter beyond its own end: the outer loop ends too early, or starts over for ever.",
        bad: "PROG0\nDIM LV(1)\nPROGRAM\nFOR LV0 = 1 TO 3\nFOR LV0 = 1 TO 10\nPRINT LV0\nNEXT\nNEXT\nENDP",
        good: "PROG0\nDIM LV(2)\nPROGRAM\nFOR LV0 = 1 TO 3\nFOR LV1 = 1 TO 10\nPRINT LV0, LV1\nNEXT\nNEXT\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    let Some(section) = context.section().filter(|section| !section.blocks.all().is_empty()) else { return };
    match &statement.kind {
        StatementKind::Assign(assign) => check_write(context, section, &assign.target),
        StatementKind::Input(input) => {
            for variable in &input.variables {
                check_write(context, section, variable);
            }
        }
        StatementKind::For(head) => {
            if let Some(counter) = outer_counter(context, section, &head.variable) {
                let name = context.slice(head.variable.span);
                let message = format!("this FOR counts with {name}, as the one around it does");
                let diagnostic = RULE.at(head.variable.span, message).with_related(counter, "counted here already");
                context.report(diagnostic.with_help("count with another variable"));
            }
        }
        _ => {}
    }
}

fn check_write(context: &mut Context<'_>, section: &SectionIndex, target: &Expr) {
    if let Some(counter) = outer_counter(context, section, target) {
        let name = context.slice(target.span);
        let mut diagnostic = RULE.at(target.span, format!("the loop counts with {name}, and this changes it"));
        diagnostic.severity = Severity::Advice;
        let diagnostic = diagnostic.with_related(counter, "counted here");
        context.report(diagnostic.with_help("to leave the loop use BREAK"));
    }
}

/// The counter of a FOR around the present statement that is the same variable as `target`.
fn outer_counter(context: &Context<'_>, section: &SectionIndex, target: &Expr) -> Option<Span> {
    let blocks = &section.blocks;
    let innermost = blocks.enclosing(context.statement())?;
    let mut loops = std::iter::successors(Some(innermost), |block| blocks.parent(block))
        .take(NESTING)
        .filter(|block: &&Block| block.kind == BlockKind::For)
        .peekable();
    loops.peek()?;
    let variable = Variable::of(context, target).filter(|variable| !variable.class.is_array())?;
    loops.find_map(|block| match &context.tree().statements().get(block.opener as usize)?.kind {
        StatementKind::For(head) if Variable::of(context, &head.variable) == Some(variable) => Some(head.variable.span),
        _ => None,
    })
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, spans_of};

    fn found(body: &str) -> Vec<String> {
        let text = format!("#DEFINE Count LV0\n{body}\n");
        spans_of("ACR136", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn loops_in_each_other_need_their_own_counters() {
        let nested = "FOR LV0 = 1 TO 3\nWHILE (BIT 1)\nFOR Count = 1 TO 3\nX(Count)\nNEXT\nWEND\nNEXT";
        assert_eq!(found(nested), ["Count"]);
        assert_eq!(found("FOR LV0 = 1 TO 3\nX(LV0)\nNEXT\nFOR LV0 = 1 TO 3\nX(LV0)\nNEXT"), [""; 0]);
    }

    #[test]
    fn a_counter_that_is_set_is_advice() {
        let text = "FOR LV0 = 1 TO 3\nIF (BIT 1) THEN LV0 = 3\nNEXT\n";
        assert_eq!(found(text), ["LV0"]);
        assert_eq!(codes(text), []);
        assert_eq!(found("FOR LV0 = 1 TO 3\nLV1 = LV0\nLA0(0) = 1\nNEXT\nLV0 = 0"), [""; 0]);
    }
}
