//! `ACR121`: the main code, or another subroutine, runs on into a subroutine.

use acrc_analysis::SectionIndex;
use acrc_analysis::index::Jump;
use acrc_diagnostics::{Code, Diagnostic, Severity, Span};
use acrc_syntax::ast::{Separator, StatementKind};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR121", name: "fall-into-subroutine" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "The main code runs, in the order of the text, into a subroutine that GOSUB calls and RETURN ends. Where one \
               subroutine runs on into another it is advice: sharing the end of a subroutine is an old habit.",
        why: "The subroutine is carried out once more than it is called, and its RETURN then has no GOSUB to go back to. \
              Between two subroutines the RETURN of the first may be missing.",
        bad: "PROG0\nPROGRAM\nGOSUB Open\nDWL 1\n_Open\nSET 32\nRETURN\nENDP",
        good: "PROG0\nPROGRAM\nGOSUB Open\nDWL 1\nEND\n_Open\nSET 32\nRETURN\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    if !section.jumps.iter().any(|jump| jump.call) {
        return;
    }
    let Some(flow) = context.flow(section) else { return };
    let mut calls: Vec<&Jump> = section.jumps.iter().filter(|jump| jump.call).collect();
    calls.sort_by_key(|call| call.to);
    let call_of = |to: u32| {
        calls.get(calls.partition_point(|call| call.to < Some(to))).filter(|call| call.to == Some(to)).copied()
    };
    for (from, to) in &flow.main().fallen_into {
        let call = call_of(*to);
        let message = format!("the program runs into the subroutine{}", name(context, call));
        let diagnostic = finding(context, (line_before(context, *from), *to), call, message);
        context.report(diagnostic.with_help("end the main program with END, or with a GOTO, before its subroutines"));
    }
    for (first, second) in flow.subroutines_run_into() {
        let call = call_of(second);
        let names = (name(context, call_of(first)), name(context, call));
        let message = format!("the subroutine{} runs on into the subroutine{}", names.0, names.1);
        let before = line_before(context, second.saturating_sub(1));
        let diagnostic = finding(context, (before, second), call, message);
        let help = "end the first one with RETURN, or call the second one with GOSUB before its RETURN";
        context.report(Diagnostic { severity: Severity::Advice, ..diagnostic.with_help(help) });
    }
}

/// The name that a GOSUB calls, as a part of a message.
fn name(context: &Context<'_>, call: Option<&Jump>) -> String {
    call.map(|call| format!(" `{}`", context.slice(call.target.span()))).unwrap_or_default()
}

/// A finding at the beginning of a subroutine that is come to from a piece of text.
fn finding(context: &Context<'_>, way: (Span, u32), call: Option<&Jump>, message: String) -> Diagnostic {
    let (from, to) = way;
    let diagnostic = RULE.at(context.statement_span(to), message).with_related(from, "from here");
    match call {
        Some(call) => diagnostic.with_related(context.statement_span(call.statement), "called here"),
        None => diagnostic,
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
    use acrc_diagnostics::Severity;

    use crate::testing::{found_by, lint, spans_of};

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
    fn one_subroutine_that_runs_into_the_next_is_advice() {
        let text = "PROG0\nPROGRAM\nGOSUB A\nGOSUB B\nEND\n_A\nSET 32\n_B\nRETURN\nENDP\n";
        assert_eq!(spans_of("ACR121", text), ["_B"]);
        let found = found_by("ACR121", text);
        assert_eq!(found[0].message, "the subroutine `A` runs on into the subroutine `B`");
        assert_eq!(found[0].severity, Severity::Advice);
        let labels: Vec<_> = found[0].labels.iter().map(|label| &text[label.span.range()]).collect();
        assert_eq!(labels, ["SET 32", "GOSUB B"]);
    }

    #[test]
    fn a_subroutine_may_have_labels_and_loops_of_its_own() {
        assert_eq!(found("GOSUB A\nEND\n_A\nSET 32\n_B\nIF (BIT 1) THEN GOTO B\nRETURN"), 0, "B is not called");
        assert_eq!(found("GOSUB A\nGOSUB B\nEND\n_A\nRETURN\n_B\nRETURN"), 0);
        assert_eq!(found("GOSUB B\nEND\n_Again\nSET 32\n_B\nIF (BIT 1) THEN GOTO Again\nRETURN"), 0, "its own code");
        assert_eq!(found("GOSUB A\nGOSUB B\nEND\n_A\nGOTO C\nSET 33\n_B\nRETURN\n_C\nRETURN"), 0, "never reached");
        assert_eq!(found("GOSUB A\nGOSUB B\nEND\n_A\nIF (BIT 1) THEN RETURN\n_B\nRETURN"), 1);
    }

    #[test]
    fn a_label_that_is_only_jumped_to_is_no_subroutine() {
        assert_eq!(found("_A\nSET 32\nGOTO A"), 0);
        assert_eq!(found("GOSUB A\n_A\nSET 32"), 0, "it never returns, and that is another finding");
    }
}
