//! `ACR503`: a second master for one program.

use acrc_analysis::Contradiction;
use acrc_diagnostics::{Code, Severity};

use super::contradictions;
use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR503", name: "second-master" },
        group: Group::Motion,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "A program attaches a master while it holds another one, with no DETACH in between.",
        why: "A program has one master. The second is refused, and the slaves behind it go to the first: axes that \
              were meant to move apart share one path.",
        bad: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH MASTER1\nATTACH SLAVE1 AXIS1 \"Y\"",
        good: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROG1\nATTACH MASTER1\nATTACH SLAVE0 AXIS1 \"Y\"",
        guide: "System Configuration / Attachments",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    for (what, place, level) in contradictions(context) {
        if let Contradiction::SecondMaster { first } = what {
            let message = format!("{} already has MASTER{first}", level_name(level));
            context.report(RULE.at(place, message).with_help("DETACH first, or attach it to another program"));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(text: &str) -> Vec<&str> {
        spans_of("ACR503", text)
    }

    #[test]
    fn one_program_wants_two_masters() {
        assert_eq!(found("PROG0\nATTACH MASTER0\nATTACH MASTER1\n"), ["ATTACH MASTER1"]);
        assert_eq!(found("PROG0\nPROGRAM\nATTACH MASTER0\nATTACH MASTER1\nENDP\n"), ["ATTACH MASTER1"]);
    }

    #[test]
    fn the_same_again_or_another_after_detach() {
        assert_eq!(found("PROG0\nATTACH MASTER0\nATTACH MASTER0\n"), [""; 0]);
        assert_eq!(found("PROG0\nATTACH MASTER0\nDETACH\nATTACH MASTER1\n"), [""; 0]);
        assert_eq!(found("PROG0\nPROGRAM\nIF (BIT 1)\nATTACH MASTER0\nELSE\nATTACH MASTER1\nENDIF\nENDP\n"), [""; 0]);
    }
}
