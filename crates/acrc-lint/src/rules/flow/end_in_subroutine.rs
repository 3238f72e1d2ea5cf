//! `ACR118`: a subroutine that ends the program where it should return.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Severity};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR118", name: "end-in-subroutine" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "Every way through a subroutine comes to END and none to RETURN, and something stands behind a GOSUB to it that \
               nothing else leads to. A subroutine that is called on a condition, to stop the program, is left alone, and \
               so is an END that the main code comes to as well.",
        why: "END stops the whole program, not the subroutine alone: what stands behind the GOSUB is never carried out, and \
              the machine stands still after one cycle.",
        bad: "PROG0\nPROGRAM\nGOSUB Open\nDWL 1\nCLR 32\nEND\n_Open\nSET 32\nEND\nENDP",
        good: "PROG0\nPROGRAM\nGOSUB Open\nDWL 1\nCLR 32\nEND\n_Open\nSET 32\nRETURN\nENDP",
        guide: "Programming Basics / Program Labels",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    if !section.jumps.iter().any(|jump| jump.call) {
        return;
    }
    let Some(flow) = context.flow(section) else { return };
    let mut told = Vec::new();
    for call in section.jumps.iter().filter(|jump| jump.call) {
        let Some(entry) = call.to else { continue };
        if !flow.is_lost_behind(context.tree(), call.statement) {
            continue;
        }
        for end in flow.only_ends(entry) {
            if told.contains(&end) {
                continue;
            }
            told.push(end);
            let name = context.slice(call.target.span());
            let message = format!("END stops the program in the subroutine `{name}`, which never returns");
            let diagnostic = RULE.at(context.statement_span(end), message);
            let called = context.statement_span(call.statement);
            let diagnostic = diagnostic.with_related(called, "what stands behind this GOSUB is never reached");
            context.report(diagnostic.with_help("end the subroutine with RETURN"));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, spans_of};

    fn found(main: &str, body: &str) -> usize {
        let text = format!("PROG0\nPROGRAM\n{main}\nEND\n_A\n{body}\n_Out\nSET 40\nEND\nENDP\n");
        spans_of("ACR118", &text).len()
    }

    #[test]
    fn an_end_where_a_return_was_meant() {
        let text = "PROG0\nPROGRAM\n_B\nGOSUB A\nSET 33\nGOTO B\n_A\nSET 32\nIF (BIT 1) THEN END\nSET 34 : END\nENDP\n";
        assert_eq!(codes(text), [(9, "ACR118"), (10, "ACR118")]);
        assert_eq!(spans_of("ACR118", text), ["END", "END"]);
        assert_eq!(found("IF (BIT 1)\nGOSUB A\nSET 33\nENDIF", "SET 32\nEND"), 1);
        assert_eq!(found("GOSUB A\nREM then\n_Then\nSET 33\nGOSUB A\nSET 34", "SET 32\nEND"), 1);
    }

    #[test]
    fn a_program_that_stops_in_a_subroutine_on_purpose() {
        assert_eq!(found("IF (BIT 1) THEN GOSUB A\nSET 33", "SET 32\nEND"), 0);
        assert_eq!(found("IF (BIT 1)\nGOSUB A\nENDIF\nSET 33", "SET 32\nEND"), 0);
        assert_eq!(found("SET 33\nGOSUB A", "SET 32\nEND"), 0);
        assert_eq!(found("GOSUB A\nSET 33", "IF (BIT 1) THEN END\nRETURN"), 0);
        assert_eq!(found("IF (BIT 2) THEN GOTO Out\nGOSUB A\nSET 33", "SET 32\nGOTO Out"), 0, "the end of the program");
    }

    #[test]
    fn numbered_lines() {
        let lines = "10 GOSUB 200\n20 SET 33\n30 GOTO 10\n200 SET 32\n210 END\n";
        let setup = "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n";
        assert_eq!(spans_of("ACR118", &format!("{setup}{lines}")), ["END"]);
        assert_eq!(spans_of("ACR118", &format!("PROG0\n{lines}")), [""; 0], "they may go on elsewhere");
    }
}
