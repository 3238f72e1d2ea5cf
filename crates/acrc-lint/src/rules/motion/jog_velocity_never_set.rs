//! `ACR507`: a jog or homing without a velocity.

use acrc_analysis::Deed;
use acrc_diagnostics::{Code, Severity};

use super::{axis_name, first_motions_of_attached, verb};
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR507", name: "jog-velocity-never-set" },
        group: Group::Motion,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A program jogs or homes an axis, and nothing in the project sets its jog velocity to anything but zero: \
               neither JOG VEL nor its parameter (12348 + 256 * axis).",
        why: "Jogging and homing do not use VEL. The axis runs at whatever jog velocity the controller holds: with \
              zero it stays where it is, and a program that waits for the end of homing waits for ever.",
        bad: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nVEL 10\nJOG INC X5\nENDP",
        good: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nJOG VEL X10\nJOG INC X5\n\
               ENDP",
        guide: "Making Motion / Jog Profiler",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    for motion in first_motions_of_attached(context, &[Deed::Jog, Deed::Home]) {
        if context.machine().never(Deed::JogVelocity, motion.axis) {
            let (axis, verb) = (axis_name(context, &motion), verb(&motion));
            let message =
                format!("{axis} {verb}, but nothing in the project sets its jog velocity to anything but zero");
            let help = format!("set it before: JOG VEL {} value, in units/s", context.slice(motion.span));
            context.report(RULE.at(motion.span, message).with_help(help));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(program: &str) -> Vec<String> {
        let text = format!(
            "#DEFINE SpeedY P12604\nAXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH \
             SLAVE1 AXIS1 \"Y\"\nPROGRAM\n{program}\nENDP\n"
        );
        spans_of("ACR507", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn each_axis_by_itself() {
        assert_eq!(found("JOG VEL X5\nJOG HOME X1 Y-1\nJOG FWD Y"), ["Y"]);
        assert_eq!(found("JOG INC AXIS1 5\nJOG VEL Y"), ["AXIS1"]);
        assert_eq!(found("JOG VEL Y0\nJOG FWD Y"), ["Y"]);
    }

    #[test]
    fn every_way_of_setting_it() {
        for set in
            ["JOG VEL Y5", "AXIS1 JOG VEL 5", "JOG VEL AXIS1 (P0)", "P12604 = 5", "SpeedY = 5", "P(12348 + P0) = 5"]
        {
            assert_eq!(found(&format!("{set}\nJOG FWD Y")), [""; 0], "{set}");
        }
    }
}
