//! `ACR513`: software limits without positions.

use acrc_analysis::Deed;
use acrc_diagnostics::{Code, Severity};

use super::{axis_name, first_motions_of_attached};
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR513", name: "software-limits-not-set" },
        group: Group::Motion,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "The software limits of an axis that programs move are switched on (SLIM, or flags 16150 and 16151, + 32 \
               * axis), and nothing in the project says where they are.",
        why: "The limits act at whatever positions the controller holds. If both are zero, the first move crosses one, \
              which stops the master and all its axes.",
        bad: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nVEL 5\nSLIM X3\nPROGRAM\nX10\nENDP",
        good: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nVEL 5\nSLM X(24,0) SLIM X3\nPROGRAM\n\
               X10\nENDP",
        guide: "System Configuration / End-of-Travel Limits",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    let machine = context.machine();
    for motion in first_motions_of_attached(context, &Deed::MOTION) {
        let on = machine.axes_with(Deed::SoftLimitsOn).has(motion.axis);
        if on && machine.never(Deed::SoftLimits, motion.axis) {
            let axis = axis_name(context, &motion);
            let message =
                format!("the software limits of {axis} are on, but nothing in the project sets their positions");
            let help = format!("set them before: SLM {} (positive, negative)", context.slice(motion.span));
            context.report(RULE.at(motion.span, message).with_help(help));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(setup: &str) -> Vec<String> {
        let text =
            format!("AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n{setup}\nPROGRAM\nX10\nENDP\n");
        spans_of("ACR513", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn limits_that_are_on_have_positions() {
        for on in ["SLIM X3", "AXIS0 SLIM 1", "SET BIT16150"] {
            assert_eq!(found(on), ["X"], "{on}");
            assert_eq!(found(&format!("{on}\nAXIS0 SLM (24,0)")), [""; 0], "{on}");
        }
    }

    #[test]
    fn limits_that_are_off_need_none() {
        assert_eq!(found("SLIM X0"), [""; 0]);
        assert_eq!(found("CLR BIT16150"), [""; 0]);
        assert_eq!(found("SET (16150 + P0)"), [""; 0], "perhaps another axis");
    }
}
