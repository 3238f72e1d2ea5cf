//! `ACR206`: a slave slot, an axis or an axis name that is attached a second time.

use acrc_analysis::{Contradiction, Taken};
use acrc_diagnostics::{Code, Severity};

use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR206", name: "duplicate-attachment" },
        group: Group::Names,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "An ATTACH SLAVE takes a slot, an axis or a name that an earlier one already took, with no DETACH in \
               between.",
        why: "An axis can follow one master only, and a slot holds one axis. The second attachment is refused, and the \
              axis keeps moving with the first program.",
        bad: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS0 \"Y\"",
        good: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"",
        guide: "System Configuration / Attachments",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    for conflict in &context.environment().conflicts {
        let Contradiction::Slave { taken, slot, axis } = conflict.what else { continue };
        if let Some(site) = context.index().attachments.get(conflict.attachment as usize) {
            let diagnostic = RULE.at(site.statement, message(taken, slot, axis, &level_name(conflict.level)));
            context.report(diagnostic.with_help("DETACH first, or take another one"));
        }
    }
}

fn message(taken: Taken, slot: u32, axis: u32, program: &str) -> String {
    match taken {
        Taken::Slot => format!("SLAVE{slot} of {program} already holds AXIS{axis}"),
        Taken::Axis => format!("AXIS{axis} is already attached to SLAVE{slot} of {program}"),
        Taken::Name => format!("{program} already has an axis of this name: AXIS{axis} on SLAVE{slot}"),
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, codes_in, lint};

    const FIRST: &str = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n";

    fn then(rest: &str) -> Vec<(u32, &'static str)> {
        codes(&format!("{FIRST}{rest}\n"))
    }

    #[test]
    fn slot_axis_and_name_are_taken() {
        assert_eq!(then("ATTACH SLAVE0 AXIS1 \"Y\""), [(4, "ACR206")]);
        assert_eq!(then("ATTACH SLAVE1 AXIS0 \"Y\""), [(4, "ACR206")]);
        assert_eq!(then("ATTACH SLAVE1 AXIS1 \"x\""), [(4, "ACR206")]);
        assert_eq!(then("PROG1\nATTACH MASTER1\nATTACH SLAVE0 AXIS0 \"X\""), [(6, "ACR206")]);
    }

    #[test]
    fn detach_frees_them() {
        assert_eq!(then("DETACH\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"Y\""), []);
        assert_eq!(then("DETACH SLAVE0\nATTACH SLAVE0 AXIS1 \"X\""), []);
        assert_eq!(then("PROG1\nDETACH ALL\nATTACH MASTER1\nATTACH SLAVE0 AXIS0 \"X\""), []);
    }

    #[test]
    fn what_may_not_happen_proves_nothing() {
        let program = "PROG0\nATTACH MASTER0\nPROGRAM\nIF (BIT 1)\nATTACH SLAVE0 AXIS0 \"X\"\nELSE\nATTACH SLAVE0 AXIS1 \"X\"\nENDIF\nENDP\n";
        assert_eq!(codes(program), []);
    }

    #[test]
    fn a_conflict_is_found_across_files() {
        let second = "PROG1\nATTACH MASTER1\nATTACH SLAVE0 AXIS0 \"Z\"\n";
        let found = lint(&[("Setup.8K", FIRST), ("more.8K", second)]);
        assert_eq!(codes_in(FIRST, &found[0]), []);
        assert_eq!(codes_in(second, &found[1]), [(3, "ACR206")]);
    }
}
