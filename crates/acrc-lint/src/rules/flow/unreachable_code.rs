//! `ACR125`: statements that no way leads to.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Severity};

use crate::Context;
use crate::flow::does_something;
use crate::rule::{Check, Group, Mark, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR125", name: "unreachable-code" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        mark: Some(Mark::Unnecessary),
        what: "No way leads to a statement: it stands behind a GOTO, END, RETURN or BREAK, or behind a loop that never \
               ends, and no label before it is jumped to. Code behind a label that nothing jumps to is another finding \
               (ACR103). END, RETURN and GOTO that are never reached are left alone.",
        why: "The statement takes memory and is never carried out. Often the jump before it lost its condition, or the \
              label its name.",
        bad: "PROG0\nPROGRAM\n_Cycle\nSET 32\nDWL 1\nGOTO Cycle\nCLR 32\nENDP",
        good: "PROG0\nPROGRAM\n_Cycle\nSET 32\nDWL 1\nIF (BIT 24) THEN GOTO Cycle\nCLR 32\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    let Some(flow) = context.flow(section).filter(|flow| flow.is_complete) else { return };
    let mut targets: Vec<u32> = section.jumps.iter().filter_map(|jump| jump.to).collect();
    targets.sort_unstable();
    // Whether such a label is left over, or jumped to from a prompt, is not asked again here.
    let entries = section.labels.iter().map(|label| label.statement).filter(|at| targets.binary_search(at).is_err());
    let mut reached = flow.reached(entries);
    let range = section.section.statements.clone();
    let statements = context.tree().statements().get(range.start as usize..range.end as usize).unwrap_or_default();
    for (place, statement) in statements.iter().enumerate() {
        let is_reached = reached.get(place).copied().unwrap_or(true);
        if is_reached || !does_something(statement) {
            continue;
        }
        let mut diagnostic = RULE.at(statement.span, "nothing leads to this statement").with_label("never reached");
        let before = reached.get(..place).unwrap_or_default().iter().rposition(|reached| *reached);
        if let Some(before) = before.and_then(|before| statements.get(before)) {
            diagnostic = diagnostic.with_related(before.span, "the program does not go on behind this");
        }
        context.report(diagnostic.with_help("delete it, or let a condition or a label lead to it"));
        flow.reach_also(range.start + place as u32, &mut reached);
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, spans_of};

    fn found(body: &str) -> Vec<String> {
        let text = format!("PROG0\nPROGRAM\n{body}\nENDP\n");
        spans_of("ACR125", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn the_first_statement_of_a_stretch_stands_for_it() {
        assert_eq!(found("END\nREM tail\nSET 32 : SET 33\nX10"), ["SET 32"]);
        assert_eq!(found("IF (BIT 1) THEN GOTO A : SET 32\n_A\nSET 33"), ["SET 32"]);
        assert_eq!(found("WHILE (1)\nDWL 1\nWEND\nSET 32"), ["SET 32"]);
        assert_eq!(found("WHILE (BIT 1)\nBREAK\nSET 32\nWEND"), ["SET 32"]);
        assert_eq!(found("IF (BIT 1)\nEND\nELSE\nEND\nENDIF\nSET 32"), ["SET 32"]);
    }

    #[test]
    fn a_stretch_that_only_jumps_to_itself_is_not_reached() {
        assert_eq!(found("END\n_A\nSET 32\nGOTO A"), ["SET 32"]);
        assert_eq!(found("END\n_A\nSET 32\nGOSUB B\nGOTO A\n_B\nSET 33\nRETURN"), ["SET 32"]);
    }

    #[test]
    fn an_unused_label_is_said_once() {
        assert_eq!(codes("PROG0\nPROGRAM\nEND\n_A\nSET 32\nGOSUB B\nRETURN\n_B\nSET 33\nRETURN\nENDP\n"), []);
    }

    #[test]
    fn ends_in_reserve_are_left_alone() {
        assert_eq!(found("_A\nDWL 1\nGOTO A\nEND\n_B\nRETURN\nRETURN"), [""; 0]);
        assert_eq!(found("_A\nIF (BIT 1)\nGOTO A\nELSE\nGOTO B\nENDIF\nGOTO A\n_B\nSET 32"), [""; 0]);
    }

    #[test]
    fn what_follows_a_call_or_a_halt_may_be_reached() {
        assert_eq!(found("GOSUB A\nSET 32\nEND\n_A\nGOTO A"), [""; 0]);
        assert_eq!(found("HALT ALL\nSET 32"), [""; 0]);
        assert_eq!(found("RUN PROG0\nSET 32"), [""; 0]);
    }

    #[test]
    fn an_unreadable_statement_or_an_unknown_label_may_have_led_there() {
        assert_eq!(found("GOTO B\n_A\nSET 32\nGOTO A\n_B\nP0 = = 1"), [""; 0]);
        assert_eq!(found("GOTO a\n_A\nSET 32\nGOTO A"), [""; 0]);
    }

    #[test]
    fn a_jump_from_the_prompt_leads_there() {
        assert_eq!(codes("PROG0\nPROGRAM\nSET 32\nEND\n_A\nSET 33\nENDP\nGOTO A\n"), []);
    }
}
