//! `ACR502`: a master that serves another program already.

use acrc_analysis::Contradiction;
use acrc_diagnostics::{Code, Severity};

use super::contradictions;
use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR502", name: "master-in-two-programs" },
        group: Group::Motion,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "An ATTACH MASTER takes a master that another program holds, with no DETACH in between.",
        why: "A master computes the path of one program. The controller refuses to share it, so that the second \
              program has no master and none of its moves is executed.",
        bad: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROG1\nATTACH MASTER0\nATTACH SLAVE0 AXIS1 \"Y\"",
        good: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROG1\nATTACH MASTER1\nATTACH SLAVE0 AXIS1 \"Y\"",
        guide: "System Configuration / Attachments",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    for (what, place, level) in contradictions(context) {
        if let Contradiction::MasterElsewhere { master } = what {
            let message = format!("MASTER{master} is already attached to {}", level_name(level));
            context.report(RULE.at(place, message).with_help("take a master of its own for each program"));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{lines_of, spans_of};

    fn found(text: &str) -> Vec<&str> {
        spans_of("ACR502", text)
    }

    #[test]
    fn two_programs_want_one_master() {
        assert_eq!(found("PROG0\nATTACH MASTER0\nPROG1\nATTACH MASTER0\n"), ["ATTACH MASTER0"]);
        let files = [("Setup.8K", "PROG0\nATTACH MASTER2\n"), ("more.8K", "SYS\nPROG3\nATTACH MASTER2\n")];
        assert_eq!(lines_of("ACR502", &files), [vec![], vec![3]]);
    }

    #[test]
    fn a_master_of_its_own_or_one_that_was_freed() {
        for text in [
            "PROG0\nATTACH MASTER0\nPROG1\nATTACH MASTER1\n",
            "PROG0\nATTACH MASTER0\nDETACH\nPROG1\nATTACH MASTER0\n",
            "PROG0\nATTACH MASTER0\nSYS\nDETACH ALL\nPROG1\nATTACH MASTER0\n",
            "PROG0\nATTACH MASTER0\nIF (BIT 5) THEN DETACH\nPROG1\nATTACH MASTER0\n",
            "PROG0\nATTACH MASTER0\nATTACH MASTER0\n",
            "PROG0\nPROGRAM\nATTACH MASTER0\nENDP\nPROG1\nPROGRAM\nATTACH MASTER0\nENDP\n",
        ] {
            assert_eq!(found(text), [""; 0], "{text}");
        }
    }
}
