//! `ACR120`: a `RETURN` to which the program comes without a `GOSUB`.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Severity};

use crate::Context;
use crate::flow::Way;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR120", name: "return-without-gosub" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "The program can come to a RETURN without having called a subroutine: in the order of its text, or by a \
               GOTO where a GOSUB was meant. One finding stands for all RETURNs behind the same GOTO.",
        why: "RETURN goes behind the latest GOSUB, and there is none. No document says what the controller does then; \
              the dry run stops the program.",
        bad: "PROG0\nPROGRAM\nIF (BIT 24) THEN GOTO Open\nEND\n_Open\nSET 32\nRETURN\nENDP",
        good: "PROG0\nPROGRAM\nIF (BIT 24) THEN GOSUB Open\nEND\n_Open\nSET 32\nRETURN\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    let Some(flow) = context.flow(section) else { return };
    let main = flow.main();
    let mut found: Vec<(Way, u32)> = main.returns.iter().map(|at| (main.way_to(*at), *at)).collect();
    found.sort_unstable();
    found.dedup_by_key(|(way, _)| *way);
    for (way, at) in found {
        let mut diagnostic = RULE.at(context.statement_span(at), "the program comes to this RETURN without a GOSUB");
        let help = match way {
            Way::Start => "a RETURN ends what a GOSUB has called; to end the program use END",
            Way::Goto(jump) => {
                diagnostic = diagnostic.with_related(context.statement_span(jump), "by this GOTO");
                "call the subroutine with GOSUB, or end this way with END"
            }
        };
        context.report(diagnostic.with_help(help));
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, spans_of};

    fn lines(body: &str) -> Vec<u32> {
        let found = codes(&format!("PROG0\nPROGRAM\n{body}\nENDP\n"));
        found.into_iter().filter(|(_, code)| *code == "ACR120").map(|(line, _)| line).collect()
    }

    #[test]
    fn the_main_code_has_nothing_to_return_from() {
        assert_eq!(spans_of("ACR120", "PROG0\nPROGRAM\nSET 32\nRETURN : REM done\nENDP\n"), ["RETURN"]);
        assert_eq!(lines("IF (BIT 1) THEN RETURN\nSET 32"), [3]);
        assert_eq!(lines("WHILE (BIT 1)\nWEND\nRETURN"), [5]);
    }

    #[test]
    fn one_finding_for_each_way_in() {
        let sub = "_A\nIF (BIT 3) THEN RETURN\nSET 32\nRETURN";
        assert_eq!(lines(&format!("GOSUB A\nGOTO A\nEND\n{sub}")), [7]);
        assert_eq!(lines(&format!("GOSUB A\nEND\n{sub}")), [0_u32; 0]);
    }

    #[test]
    fn a_subroutine_may_be_left_and_entered_as_it_likes() {
        assert_eq!(lines("GOSUB A\nEND\n_A\nGOTO B\n_B\nRETURN"), [0_u32; 0]);
        assert_eq!(lines("_Main\nGOSUB A\nGOTO Main\n_A\nGOSUB B\n_B\nRETURN"), [0_u32; 0]);
    }

    #[test]
    fn what_may_end_the_program_is_not_passed() {
        assert_eq!(lines("GOSUB A\nHALT\n_A\nRETURN"), [0_u32; 0]);
        assert_eq!(lines("GOSUB A\nHALT PROG0\n_A\nRETURN"), [0_u32; 0]);
        assert_eq!(lines("GOSUB Cycle\n_A\nRETURN\n_Cycle\nGOSUB A\nGOTO Cycle"), [0_u32; 0]);
    }

    #[test]
    fn running_into_a_subroutine_is_another_finding() {
        assert_eq!(codes("PROG0\nPROGRAM\nGOSUB A\n_A\nRETURN\nENDP\n"), [(4, "ACR121")]);
    }

    #[test]
    fn a_piece_of_a_program_proves_nothing() {
        assert_eq!(codes("_A\nRETURN\nGOSUB A\n"), []);
        assert_eq!(codes("PROG0\n10 SET 32\n20 RETURN\n"), []);
    }
}
