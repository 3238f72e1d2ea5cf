//! `ACR509`: homing of an axis whose travel limits are off.

use acrc_analysis::Deed;
use acrc_diagnostics::{Code, Severity};

use super::{axis_name, first_motions_of_attached};
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR509", name: "homing-without-limits" },
        group: Group::Motion,
        severity: Severity::Advice,
        enabled: true,
        what: "A program homes an axis, and nothing in the project enables its hardware limits: neither HLIM nor their \
               enable flags (16148 and 16149, + 32 * axis). They are off by default.",
        why: "Homing turns round at a limit and looks for the switch on the other side. Without limits an axis that \
              starts beyond its switch, or whose switch is broken, runs into the end of its travel.",
        bad: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nJOG VEL X5\nJOG HOME X-1\n\
              ENDP",
        good: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nHLIM X3\nPROGRAM\nJOG VEL X5\nJOG \
               HOME X-1\nENDP",
        guide: "Making Motion / Homing",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    for motion in first_motions_of_attached(context, &[Deed::Home]) {
        if context.machine().never(Deed::HardLimitsOn, motion.axis) {
            let axis = axis_name(context, &motion);
            let message = format!("{axis} is homed, but nothing in the project enables its hardware limits");
            let help = format!("where it has limit switches, enable them: HLIM {} 3", context.slice(motion.span));
            context.report(RULE.at(motion.span, message).with_help(help));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(setup: &str) -> Vec<String> {
        let text = format!(
            "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n{setup}\nPROGRAM\nJOG HOME X1\nENDP\n"
        );
        spans_of("ACR509", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn limits_are_off_until_they_are_switched_on() {
        assert_eq!(found("HLBIT X0"), ["X"]);
        assert_eq!(found("HLIM X0"), ["X"]);
    }

    #[test]
    fn every_way_of_enabling() {
        for enable in ["HLIM X3", "AXIS0 HLIM 1", "HLIM X(P0)", "SET 16148", "SET BIT16149"] {
            assert_eq!(found(enable), [""; 0], "{enable}");
        }
    }
}
