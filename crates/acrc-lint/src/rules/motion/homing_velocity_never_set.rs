//! `ACR518`: homing that comes back to the edge, without a velocity for it.

use acrc_analysis::Deed;
use acrc_diagnostics::{Code, Severity};

use super::{axis_name, first_motions_of_attached};
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR518", name: "homing-velocity-never-set" },
        group: Group::Motion,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A program homes an axis whose backup to home is switched on (flag 16152 + 32 * axis), and nothing in \
               the project sets the velocity of the last approach, JOG HOMVF.",
        why: "With backup the axis stops behind the switch and comes back to its edge at JOG HOMVF, whatever the \
              controller holds for it: too fast and the position is not repeatable, zero and homing never ends.",
        bad: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nJOG VEL X5\nSET 16152\nJOG \
              HOME X1\nENDP",
        good: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nJOG VEL X5\nJOG HOMVF X0.1\n\
               SET 16152\nJOG HOME X1\nENDP",
        guide: "Making Motion / Homing",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    let machine = context.machine();
    for motion in first_motions_of_attached(context, &[Deed::Home]) {
        let backup = machine.axes_with(Deed::HomeBackup).has(motion.axis);
        if backup && machine.never(Deed::HomeVelocity, motion.axis) {
            let axis = axis_name(context, &motion);
            let message = format!("{axis} comes back to its home edge, but nothing in the project sets JOG HOMVF");
            let help = format!("set the velocity of the last approach: JOG HOMVF {} value", context.slice(motion.span));
            context.report(RULE.at(motion.span, message).with_help(help));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(program: &str) -> Vec<String> {
        let text = format!(
            "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\n{program}\nJOG HOME X1\nENDP\n"
        );
        spans_of("ACR518", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn backup_needs_a_velocity() {
        assert_eq!(found("SET BIT16152"), ["X"]);
        assert_eq!(found("SET 16152\nJOG HOMVF AXIS0 0.1"), [""; 0]);
    }

    #[test]
    fn without_backup_none_is_used() {
        assert_eq!(found("CLR 16152"), [""; 0]);
        assert_eq!(found("SET 16184"), [""; 0], "the backup of another axis");
    }
}
