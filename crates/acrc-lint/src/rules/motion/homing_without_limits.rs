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
        mark: None,
        what: "A program homes an axis, and nothing in the project enables its hardware limits, neither HLIM nor their \
               enable flags (16148 and 16149, + 32 * axis): they are off by default. Or nothing says with HLBIT which \
               inputs the limits and the home switch are.",
        why: "Homing turns round at a limit and looks for the switch on the other side. Without limits an axis that \
              starts beyond its switch, or whose switch is broken, runs into the end of its travel. Without HLBIT the axis takes the inputs of \
              its number: 3 * axis and the two behind it.",
        bad: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nJOG VEL X5\nJOG HOME X-1\n\
              ENDP",
        good: "AXIS0 PPU 1000\nAXIS0 HLBIT 0\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nHLIM X3\nPROGRAM\nJOG VEL X5\nJOG \
               HOME X-1\nENDP",
        guide: "Making Motion / Homing",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    let machine = context.machine();
    for motion in first_motions_of_attached(context, &[Deed::Home]) {
        let (axis, name) = (axis_name(context, &motion), context.slice(motion.span));
        let [no_limits, no_inputs] =
            [Deed::HardLimitsOn, Deed::LimitInputs].map(|deed| machine.never(deed, motion.axis));
        let (lacks, help) = match (no_limits, no_inputs) {
            (false, false) => continue,
            (true, _) => {
                ("enables its hardware limits", format!("where it has limit switches, enable them: HLIM {name} 3"))
            }
            (false, true) => {
                let input = motion.axis.saturating_mul(INPUTS);
                (
                    "says which inputs its switches are",
                    format!("say so, also where it is the default: HLBIT {name} {input}"),
                )
            }
        };
        let message = format!("{axis} is homed, but nothing in the project {lacks}");
        context.report(RULE.at(motion.span, message).with_help(help));
    }
}

/// The inputs of an axis: positive limit, negative limit, home (guide, "Input Assignment").
const INPUTS: u32 = 3;

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
            assert_eq!(found(&format!("HLBIT X0\n{enable}")), [""; 0], "{enable}");
        }
    }

    #[test]
    fn inputs_that_nobody_names() {
        assert_eq!(found("HLIM X3"), ["X"]);
        assert_eq!(found("HLIM X3\nAXIS0 HLBIT 24"), [""; 0]);
    }
}
