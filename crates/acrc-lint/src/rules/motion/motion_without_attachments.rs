//! `ACR504`: motion of an axis that belongs to no master.

use acrc_analysis::Deed;
use acrc_diagnostics::{Code, Severity};

use super::{axis_name, first_motions, verb};
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR504", name: "motion-without-attachments" },
        group: Group::Motion,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A program jogs, homes or gears an axis by its number, and no program of the project attaches that axis \
               to a master.",
        why: "All profilers take the configuration of an axis from its attachments to a master: without them nothing \
              moves, even if no coordinated move is wanted.",
        bad: "ATTACH AXIS0 ENC0 DAC0 ENC0\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nJOG VEL AXIS1 5\n\
              JOG FWD AXIS1\nENDP",
        good: "ATTACH AXIS0 ENC0 DAC0 ENC0\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \
               \"Y\"\nPROGRAM\nJOG VEL AXIS1 5\nJOG FWD AXIS1\nENDP",
        guide: "Making Motion / Jog Profiler",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    if context.machine().open {
        return;
    }
    for motion in first_motions(context, &[Deed::Jog, Deed::Home, Deed::Gear, Deed::Cam]) {
        if !context.machine().has_axis(motion.axis) {
            let (axis, verb) = (axis_name(context, &motion), verb(&motion));
            let message = format!("{axis} {verb}, but no program of the project attaches it to a master");
            context.report(RULE.at(motion.span, message).with_help(format!(
                "attach it where the masters are attached: ATTACH SLAVEn AXIS{} \"name\"",
                motion.axis
            )));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{lint, spans_of};

    fn found(program: &str) -> Vec<String> {
        let text =
            format!("AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\n{program}\nENDP\n");
        spans_of("ACR504", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn axes_by_number() {
        assert_eq!(found("JOG ABS AXIS0 (5) AXIS3 (6)\nAXIS4 JOG HOME -1\nJOG OFF AXIS5"), ["AXIS3", "AXIS4"]);
    }

    #[test]
    fn one_finding_is_enough() {
        let text =
            "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nAXIS5 JOG HOME 1\nENDP\n";
        let found: Vec<_> = lint(&[("test.8K", text)]).concat().into_iter().map(|found| found.code.id).collect();
        assert_eq!(found, ["ACR504"]);
    }

    #[test]
    fn an_attachment_whose_axis_is_not_written_may_be_any() {
        assert_eq!(found("ATTACH SLAVE1 AXIS \"Y\"\nJOG FWD AXIS3"), [""; 0]);
    }
}
