//! `ACR520`: electronic gearing without a source.

use acrc_analysis::Deed;
use acrc_diagnostics::{Code, Severity};

use super::{axis_name, first_motions_of_attached};
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR520", name: "gear-without-source" },
        group: Group::Motion,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A program switches the gear of an axis on, and nothing in the project says what it follows, with GEAR \
               SRC.",
        why: "The gear follows its source, and without one there is nothing to follow: the axis stays where it is, or \
              goes after a source that was set long ago.",
        bad: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nGEAR RATIO X2\nGEAR ON X\n\
              ENDP",
        good: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nGEAR SRC X ENC4\nGEAR RATIO \
               X2\nGEAR ON X\nENDP",
        guide: "Making Motion / Gear Profiler",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    for motion in first_motions_of_attached(context, &[Deed::Gear]) {
        if context.machine().never(Deed::GearSource, motion.axis) {
            let axis = axis_name(context, &motion);
            let message = format!("{axis} is geared, but nothing in the project sets the source of its gear");
            let help = format!("say what it follows: GEAR SRC {} ENC0", context.slice(motion.span));
            context.report(RULE.at(motion.span, message).with_help(help));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(program: &str) -> Vec<String> {
        let text = format!(
            "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \
             \"Y\"\nPROGRAM\n{program}\nENDP\n"
        );
        spans_of("ACR520", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn each_axis_has_its_source() {
        assert_eq!(found("GEAR SRC X ENC2\nGEAR ON X Y"), ["Y"]);
        assert_eq!(found("AXIS1 GEAR SRC P6160\nGEAR ON AXIS1"), [""; 0]);
        assert_eq!(found("GEAR SRC Y CLOCK\nGEAR ON Y\nGEAR OFF X"), [""; 0]);
    }
}
