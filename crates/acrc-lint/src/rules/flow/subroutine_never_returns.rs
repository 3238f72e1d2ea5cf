//! `ACR122`: code behind the call of a subroutine that goes round for ever.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Severity};

use crate::Context;
use crate::flow::does_something;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR122", name: "subroutine-never-returns" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A GOSUB calls a subroutine that is an endless loop without RETURN and END, and something stands behind the \
               GOSUB. Where nothing but END does, as when a program calls its cycle, it is left alone.",
        why: "What stands behind the GOSUB is never carried out.",
        bad: "PROG0\nPROGRAM\nGOSUB Cycle\nCLR 32\nEND\n_Cycle\nSET 32\nDWL 1\nGOTO Cycle\nENDP",
        good: "PROG0\nPROGRAM\nGOSUB Cycle\nCLR 32\nEND\n_Cycle\nSET 32\nDWL 1\nIF (BIT 24) THEN RETURN\nGOTO Cycle\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    if !section.jumps.iter().any(|jump| jump.call) {
        return;
    }
    let Some(flow) = context.flow(section) else { return };
    for call in section.jumps.iter().filter(|jump| jump.call) {
        let Some(entry) = call.to else { continue };
        let next = context.tree().statements().get(call.statement as usize + 1);
        let goes_on = call.statement + 1 < section.section.statements.end && next.is_some_and(does_something);
        if goes_on && flow.never_ends(entry) {
            let name = context.slice(call.target.span());
            let message =
                format!("the subroutine `{name}` never returns: what stands behind this GOSUB is never reached");
            let diagnostic = RULE.at(context.statement_span(call.statement), message);
            let diagnostic = diagnostic.with_related(context.statement_span(entry), "an endless loop begins here");
            context.report(diagnostic.with_help("leave the loop with a condition and end the subroutine with RETURN"));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(behind: &str, body: &str) -> usize {
        spans_of("ACR122", &format!("PROG0\nPROGRAM\nGOSUB A\n{behind}\nEND\n_A\n{body}\nENDP\n")).len()
    }

    #[test]
    fn an_endless_loop_is_marked_at_its_call() {
        let text = "PROG0\nPROGRAM\nGOSUB A : SET 33\nEND\n_A\nWHILE (1)\nSET 32\nWEND\nENDP\n";
        assert_eq!(spans_of("ACR122", text), ["GOSUB A"]);
        assert_eq!(found("SET 33", "SET 32\nGOTO A"), 1);
    }

    #[test]
    fn a_way_out_is_enough() {
        assert_eq!(found("SET 33", "WHILE (1)\nIF (BIT 1) THEN RETURN\nWEND"), 0);
        assert_eq!(found("SET 33", "WHILE (BIT 1)\nWEND\nRETURN"), 0);
        assert_eq!(found("SET 33", "IF (BIT 1) THEN END\nGOTO A"), 0);
        assert_eq!(found("SET 33", "IF (BIT 1) THEN HALT ALL\nGOTO A"), 0);
        assert_eq!(found("SET 33", "WHILE (1)\nBREAK\nWEND"), 0, "it runs off the end, which is another finding");
    }

    #[test]
    fn a_call_of_the_cycle_may_be_the_last_thing_that_a_program_does() {
        assert_eq!(found("END", "SET 32\nGOTO A"), 0);
        assert_eq!(found("REM cycle", "SET 32\nGOTO A"), 0);
    }
}
