//! `ACR501`: a slave without a master to follow.

use acrc_analysis::Contradiction;
use acrc_diagnostics::{Code, Severity};

use super::contradictions;
use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR501", name: "slave-before-master" },
        group: Group::Motion,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "An ATTACH SLAVE stands where its program has no master yet. A project that attaches no master at all is \
               judged only when it says what its axes are (ATTACH AXIS) or frees all of them (DETACH ALL): another one may \
               find its masters on its controller.",
        why: "A slave is a place of the program's master. Without the master the controller refuses the attachment, \
              the axis has no name in the program, and all its moves are refused too.",
        bad: "PROG0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH MASTER0",
        good: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"",
        guide: "System Configuration / Attachments",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    for (what, place, level) in contradictions(context) {
        if what == Contradiction::NoMaster {
            let program = level_name(level);
            let message = format!("a slave is attached before {program} has a master");
            context.report(RULE.at(place, message).with_help("put ATTACH MASTER before the slaves"));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{lines_of, spans_of};

    const SLAVE: &str = "ATTACH SLAVE0 AXIS0 \"X\"";

    fn found(text: &str) -> Vec<&str> {
        spans_of("ACR501", text)
    }

    #[test]
    fn the_first_slave_without_a_master() {
        assert_eq!(found(&format!("PROG0\n{SLAVE}\nATTACH SLAVE1 AXIS1 \"Y\"\nATTACH MASTER0\n")), [SLAVE]);
        assert_eq!(found(&format!("PROG0\nATTACH MASTER0\nPROG1\n{SLAVE}\n")), [SLAVE]);
        assert_eq!(found(&format!("PROG0\nATTACH MASTER0\nDETACH\n{SLAVE}\n")), [SLAVE]);
        assert_eq!(found(&format!("PROG0\nATTACH MASTER0\nDETACH ALL\n{SLAVE}\n")), [SLAVE]);
        assert_eq!(found(&format!("PROG0\nATTACH MASTER0\nPROG1\nPROGRAM\n{SLAVE}\nENDP\n")), [SLAVE]);
    }

    #[test]
    fn a_master_before_it_or_perhaps_before_it() {
        for text in [
            format!("PROG0\nATTACH MASTER0\n{SLAVE}\n"),
            format!("PROG0\nATTACH MASTER0\nDETACH SLAVE0\n{SLAVE}\n"),
            format!("PROG0\nATTACH MASTER0\nIF (BIT 5) THEN DETACH\n{SLAVE}\n"),
            format!("PROG0\nIF (BIT 5) THEN ATTACH MASTER0\n{SLAVE}\n"),
            format!("PROG0\nATTACH MASTER0\nPROGRAM\n{SLAVE}\nENDP\n"),
            format!("PROG0\nPROGRAM\nGOSUB A\n{SLAVE}\nEND\n_A\nATTACH MASTER0\nRETURN\nENDP\n"),
            format!("PROG0\n{SLAVE}\n"),
            format!("PROG0\nATTACH MASTER0\nSYS\n{SLAVE}\n"),
        ] {
            assert_eq!(found(&text), [""; 0], "{text}");
        }
    }

    #[test]
    fn a_setup_that_forgets_the_master() {
        assert_eq!(found(&format!("DETACH ALL\nPROG0\n{SLAVE}\nATTACH SLAVE1 AXIS1 \"Y\"\n")), [SLAVE]);
        assert_eq!(found(&format!("ATTACH AXIS0 ENC0 DAC0 ENC0\nPROG0\n{SLAVE}\n")), [SLAVE]);
        assert_eq!(found(&format!("PROG0\nPROGRAM\nDETACH ALL\n{SLAVE}\nENDP\n")), [""; 0], "another one attaches it");
    }

    #[test]
    fn the_order_of_files_is_not_certain() {
        let slave = format!("PROG0\n{SLAVE}\n");
        let files = [("a.8K", slave.as_str()), ("b.8K", "PROG0\nATTACH MASTER0\n")];
        assert_eq!(lines_of("ACR501", &files), [[0; 0], []]);
    }
}
