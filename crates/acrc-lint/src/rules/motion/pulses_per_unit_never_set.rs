//! `ACR521`: an axis that moves in pulses.

use acrc_analysis::Deed;
use acrc_diagnostics::{Code, Severity};

use super::{axis_name, first_motions_of_attached, verb};
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR521", name: "pulses-per-unit-never-set" },
        group: Group::Motion,
        severity: Severity::Advice,
        enabled: true,
        mark: None,
        what: "A program moves an axis, and nothing in the project sets its pulses per unit, PPU.",
        why: "Targets, velocities and accelerations count in units. Without a scale of its own an axis counts in \
              whatever the controller holds, from the factory in pulses of its encoder: a move of 10 mm becomes one of \
              10 pulses.",
        bad: "ATTACH AXIS0 ENC0 DAC0 ENC0\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nVEL 25\nPROGRAM\nX10\n\
              ENDP",
        good: "ATTACH AXIS0 ENC0 DAC0 ENC0\nAXIS0 PPU 4000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nVEL 25\n\
               PROGRAM\nX10\nENDP",
        guide: "Making Motion / Velocity Profile Commands",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    for motion in first_motions_of_attached(context, &Deed::MOTION) {
        if context.machine().never(Deed::PulsesPerUnit, motion.axis) {
            let (axis, verb) = (axis_name(context, &motion), verb(&motion));
            let message = format!("{axis} {verb}, but nothing in the project sets its pulses per unit");
            let help = format!("set them in the setup: AXIS{} PPU value", motion.axis);
            context.report(RULE.at(motion.span, message).with_help(help));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(setup: &str) -> Vec<String> {
        let text = format!(
            "ATTACH AXIS0 ENC0 DAC0 ENC0\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \
             \"Y\"\n{setup}\nPROGRAM\nX10 Y10\nENDP\n"
        );
        spans_of("ACR521", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn each_axis_has_its_scale() {
        assert_eq!(found(""), ["X", "Y"]);
        assert_eq!(found("PPU X4000"), ["Y"]);
        assert_eq!(found("PPU X4000 Y"), ["Y"], "a report");
        assert_eq!(found("PPU X4000 Y4000"), [""; 0]);
        assert_eq!(found("AXIS0 PPU 4000\nP12631 = 4000"), [""; 0]);
    }
}
