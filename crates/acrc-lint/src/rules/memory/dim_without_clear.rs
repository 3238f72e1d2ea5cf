//! `ACR410`: a program that dimensions its variables each time it runs.

use acrc_analysis::memory::IssueKind;
use acrc_diagnostics::{Code, Edit, Fix, Severity};

use super::sites;
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR410", name: "dim-without-clear" },
        group: Group::Memory,
        severity: Severity::Advice,
        enabled: true,
        what: "A stored program dimensions its variables and never clears them. The guide's own programs are of both \
               kinds; no document says that RUN frees the variables, and the dry run does not.",
        why: "The first RUN works. The second finds the variables of the first and may stop with \"Re-dimensioned \
              block\": the program runs once after power-up and never again.",
        bad: "PROG0\nPROGRAM\nDIM LV(2)\nLV0 = 1\nENDP",
        good: "PROG0\nPROGRAM\nCLEAR\nDIM LV(2)\nLV0 = 1\nENDP",
        guide: "System Configuration / Memory Allocations / Clearing Allocated Memory",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    for (site, kind) in sites::issues(context) {
        let IssueKind::NotCleared(block) = kind else { continue };
        let span = sites::span(context, site);
        let message = format!("a second RUN may find that {block} has memory already");
        let before = context.text().get(..span.start as usize).unwrap_or_default();
        // The line break is that of the line before.
        let clear = match before {
            line if line.ends_with("\r\n") => "CLEAR\r\n",
            line if line.ends_with('\n') => "CLEAR\n",
            _ => "CLEAR : ",
        };
        let fix = Fix::unsafe_("clear the variables first", vec![Edit::insert(span.start, clear)]);
        context.report(RULE.at(span, message).with_help("CLEAR before the first DIM of the program").with_fix(fix));
    }
}

#[cfg(test)]
mod tests {
    use acrc_diagnostics::apply;

    use crate::testing::{lint, spans_of};

    #[test]
    fn the_first_dim_of_a_text_is_named() {
        assert_eq!(spans_of("ACR410", "PROG0\nPROGRAM\nDIM LV(2)\nDIM DV(1)\nENDP\n"), ["DIM LV(2)"]);
        assert_eq!(spans_of("ACR410", "PROG0\nDIM LV(2)\nPROGRAM\nLV0=1\nENDP\n"), [""; 0]);
    }

    #[test]
    fn a_clear_anywhere_in_the_text_is_enough() {
        assert_eq!(spans_of("ACR410", "PROG0\nPROGRAM\nDIM LV(2)\nLV0=1\nCLEAR\nENDP\n"), [""; 0]);
    }

    #[test]
    fn the_repair() {
        let text = "PROG0\nPROGRAM\nDIM LV(2)\nENDP\n";
        let found = lint(&[("test.8K", text)]).concat();
        let fixed = apply(text, &[&found[0].fixes[0]]).expect("a fix of one edit");
        assert_eq!(fixed, "PROG0\nPROGRAM\nCLEAR\nDIM LV(2)\nENDP\n");
        assert_eq!(lint(&[("test.8K", &fixed)]).concat(), []);
    }

    #[test]
    fn the_repair_keeps_line_breaks() {
        let text = "PROG0\r\nPROGRAM\r\nDIM LV(2)\r\nENDP\r\n";
        let found = lint(&[("test.8K", text)]).concat();
        let fixed = apply(text, &[&found[0].fixes[0]]).expect("a fix of one edit");
        assert_eq!(fixed, "PROG0\r\nPROGRAM\r\nCLEAR\r\nDIM LV(2)\r\nENDP\r\n");
    }
}
