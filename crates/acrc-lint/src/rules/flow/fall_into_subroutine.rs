//! `ACR121`: the main code runs on into a subroutine.

use acrc_analysis::SectionIndex;
use acrc_analysis::index::Jump;
use acrc_diagnostics::{Code, Severity, Span};
use acrc_syntax::ast::{Separator, StatementKind};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR121", name: "fall-into-subroutine" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        what: "The main code runs, in the order of the text, into a subroutine that GOSUB calls and RETURN ends.",
        why: "The subroutine is carried out once more than it is called, and its RETURN then has no GOSUB to go back to.",
        bad: "PROG0\nPROGRAM\nGOSUB Open\nDWL 1\n_Open\nSET 32\nRETURN\nENDP",
        good: "PROG0\nPROGRAM\nGOSUB Open\nDWL 1\nEND\n_Open\nSET 32\nRETURN\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    let Some(flow) = context.flow(section) else { return };
    let fallen_into = &flow.main().fallen_into;
    if fallen_into.is_empty() {
        return;
    }
    let mut calls: Vec<&Jump> = section.jumps.iter().filter(|jump| jump.call).collect();
    calls.sort_by_key(|call| call.to);
    for (from, to) in fallen_into {
        let span = context.statement_span(*to);
        let call = calls.get(calls.partition_point(|call| call.to < Some(*to))).filter(|call| call.to == Some(*to));
        let name = call.map(|call| format!(" `{}`", context.slice(call.target.span()))).unwrap_or_default();
        let message = format!("the program runs into the subroutine{name}");
        let mut diagnostic = RULE.at(span, message).with_related(line_before(context, *from), "from here");
        if let Some(call) = call {
            diagnostic = diagnostic.with_related(context.statement_span(call.statement), "called here");
        }
        context.report(diagnostic.with_help("end the main program with END, or with a GOTO, before its subroutines"));
    }
}

/// The line of a statement up to it; that of the statement before, where it is only a remark.
fn line_before(context: &Context<'_>, mut last: u32) -> Span {
    let statements = context.tree().statements();
    let at = |index: u32| statements.get(index as usize);
    while last > 0 && at(last).is_some_and(|statement| matches!(statement.kind, StatementKind::Remark(_))) {
        last -= 1;
    }
    let mut first = last;
    while first > 0 && at(first).is_some_and(|statement| statement.separator != Separator::Line) {
        first -= 1;
    }
    Span::cover(context.statement_span(first), context.statement_span(last))
}

#[cfg(test)]
mod tests {
    use crate::testing::{lint, spans_of};

    fn found(body: &str) -> usize {
        spans_of("ACR121", &format!("PROG0\nPROGRAM\n{body}\nENDP\n")).len()
    }

    #[test]
    fn the_label_is_marked_and_the_way_to_it() {
        let text = "PROG0\nPROGRAM\nGOSUB A\nX10 : SET 32\nREM -----\n_A\nRETURN\nENDP\n";
        assert_eq!(spans_of("ACR121", text), ["_A"]);
        let found = lint(&[("test.8K", text)]).concat();
        let labels: Vec<_> =
            found.iter().flat_map(|found| &found.labels).map(|label| &text[label.span.range()]).collect();
        assert_eq!(labels, ["X10 : SET 32", "GOSUB A"]);
    }

    #[test]
    fn conditions_and_loops_may_let_it_pass() {
        assert_eq!(found("GOSUB A\nIF (BIT 1) THEN END\n_A\nRETURN"), 1);
        assert_eq!(found("GOSUB A\nFOR LV0 = 1 TO 3\nNEXT\n_A\nRETURN"), 1);
        assert_eq!(found("GOSUB A\nWHILE (1)\nWEND\n_A\nRETURN"), 0);
        assert_eq!(found("_M\nGOSUB A\nIF (BIT 1) THEN GOTO M\nGOTO M\n_A\nRETURN"), 0);
    }

    #[test]
    fn one_subroutine_may_run_into_the_next() {
        assert_eq!(found("GOSUB A\nGOSUB B\nEND\n_A\nSET 32\n_B\nRETURN"), 0);
    }

    #[test]
    fn a_label_that_is_only_jumped_to_is_no_subroutine() {
        assert_eq!(found("_A\nSET 32\nGOTO A"), 0);
        assert_eq!(found("GOSUB A\n_A\nSET 32"), 0, "it never returns, and that is another finding");
    }
}
