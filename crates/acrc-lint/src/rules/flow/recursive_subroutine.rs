//! `ACR123`: a subroutine that calls itself.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Severity};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR123", name: "recursive-subroutine" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A subroutine calls itself, directly or through others, before it has returned.",
        why: "Each level takes four bytes of the program's memory, and all levels share the same variables: what the inner \
              call changes is changed for the outer one too.",
        bad: "PROG0\nPROGRAM\nGOSUB Retry\nEND\n_Retry\nSET 32\nDWL 1\nIF (NOT BIT 24) THEN GOSUB Retry\nRETURN\nENDP",
        good: "PROG0\nPROGRAM\nGOSUB Retry\nEND\n_Retry\nSET 32\nDWL 1\nIF (NOT BIT 24) THEN GOTO Retry\nRETURN\nENDP",
        guide: "Programming Basics / Program Flow; System Configuration / Memory Allocations",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    if !section.jumps.iter().any(|jump| jump.call && jump.to.is_some_and(|to| to <= jump.statement)) {
        return;
    }
    let Some(flow) = context.flow(section) else { return };
    for (from, to) in flow.recursive_calls() {
        let call = section.jumps.get(section.jumps.partition_point(|jump| jump.statement < from));
        let name = call.map(|call| format!(" `{}`", context.slice(call.target.span()))).unwrap_or_default();
        let message = format!("the subroutine{name} calls itself: each level takes 4 bytes, without a bound");
        let diagnostic = RULE.at(context.statement_span(from), message);
        let diagnostic = diagnostic.with_related(context.statement_span(to), "begins here, and has not returned");
        context.report(diagnostic.with_help("repeat with a loop, or with a GOTO inside of the subroutine"));
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(body: &str) -> Vec<String> {
        let text = format!("PROG0\nPROGRAM\nGOSUB A\nEND\n{body}\nENDP\n");
        spans_of("ACR123", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn the_call_that_closes_the_ring_is_marked() {
        assert_eq!(found("_A\nIF (BIT 1) THEN GOSUB A\nRETURN"), ["GOSUB A"]);
        assert_eq!(found("_A\nGOSUB B\nRETURN\n_B\nIF (BIT 1)\nGOSUB A\nENDIF\nRETURN"), ["GOSUB A"]);
    }

    #[test]
    fn each_ring_is_one_finding() {
        let two =
            "_A\nGOSUB B\nGOSUB A\nRETURN\n_B\nGOSUB A\nGOSUB C\nRETURN\n_C\nGOSUB D\nRETURN\n_D\nGOSUB D\nRETURN";
        assert_eq!(found(two), ["GOSUB A", "GOSUB D"]);
    }

    #[test]
    fn calls_of_what_has_returned_are_no_rings() {
        assert_eq!(found("_A\nGOSUB B\nGOSUB B\nRETURN\n_B\nRETURN"), [""; 0]);
        assert_eq!(found("_B\nRETURN\n_A\nGOSUB B\nFOR LV0 = 1 TO 3\nGOSUB B\nNEXT\nRETURN"), [""; 0]);
    }

    #[test]
    fn the_cycle_of_a_program_may_call_what_stands_before_it() {
        let text = "PROG0\nPROGRAM\nGOTO Main\n_A\nSET 32\nRETURN\n_Main\nGOSUB A\nGOTO Main\nENDP\n";
        assert_eq!(spans_of("ACR123", text), [""; 0]);
    }
}
