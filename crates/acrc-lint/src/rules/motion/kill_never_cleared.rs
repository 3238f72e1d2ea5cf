//! `ACR511`: an axis that can be killed, and that nothing sets free again.

use acrc_analysis::Deed;
use acrc_diagnostics::{Code, Severity};

use super::{axis_name, first_motions};
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR511", name: "kill-never-cleared" },
        group: Group::Motion,
        severity: Severity::Advice,
        enabled: true,
        what: "An axis that programs move has hardware limits, or the response to an excess of following error, \
               switched on; and nothing in the project clears its kill request (8467 + 32 * axis), in words or by a \
               DRIVE ON in a program.",
        why: "A limit sets the kill request of the axis and of all axes of its master. Every motion is refused until \
              somebody clears it, and then Kill All Moves of the master: without a program that does so the machine \
              stands until a person at a terminal sends Ctrl-Y.",
        bad: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nHLIM X3\nVEL 5\nPROGRAM\nX10\nENDP",
        good: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nHLIM X3\nVEL 5\nPROGRAM\nX10\nEND\n\
               _Recover\nCLR 8467 : CLR 522\nRETURN\nENDP",
        guide: "Programming Basics / Kill All Motion Request vs. Kill All Moves",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    let machine = context.machine();
    let [limits, response] = [Deed::HardLimitsOn, Deed::ErrorResponse].map(|deed| machine.axes_with(deed));
    for motion in first_motions(context, &Deed::MOTION) {
        let by = match (limits.has(motion.axis), response.has(motion.axis)) {
            (true, _) => "a limit switch",
            (false, true) => "an excess of following error",
            (false, false) => continue,
        };
        if machine.never(Deed::KillCleared, motion.axis) {
            let axis = axis_name(context, &motion);
            let message = format!("{by} kills the motion of {axis}, and nothing in the project sets it free again");
            let flag = acrc_catalog::bit_number("kill_all_motion_request", motion.axis);
            let flag = flag.map(|flag| format!(" (CLR {flag})")).unwrap_or_default();
            context.report(RULE.at(motion.span, message).with_help(format!(
                "where the program recovers from a stop, clear the kill request of the axis{flag}, then Kill All Moves \
                 of its master"
            )));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(setup: &str, program: &str) -> Vec<String> {
        let text = format!(
            "#DEFINE KillX BIT8467\nAXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH \
             SLAVE1 AXIS1 \"Y\"\n{setup}\nPROGRAM\nX10 Y10\n{program}\nENDP\n"
        );
        spans_of("ACR511", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn limits_and_error_response_kill() {
        assert_eq!(found("HLIM X3", ""), ["X"]);
        assert_eq!(found("SET 8501", ""), ["Y"]);
        assert_eq!(found("HLIM X3\nDRIVE ON X", ""), ["X"], "the setup is not executed again");
        assert_eq!(found("", ""), [""; 0]);
    }

    #[test]
    fn every_way_of_recovering() {
        for recover in ["CLR 8467", "CLR KillX", "BIT8467 = 0", "DRIVE ON X", "DRIVE ON AXIS0", "CLR (8467 + 32 * LV0)"]
        {
            assert_eq!(found("HLIM X3", recover), [""; 0], "{recover}");
        }
        assert_eq!(found("HLIM X3", "SET 8467"), ["X"]);
    }
}
