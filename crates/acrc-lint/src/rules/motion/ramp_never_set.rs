//! `ACR508`: coordinated moves without ramps.

use acrc_analysis::Deed;
use acrc_diagnostics::{Code, Severity};

use super::first_moves;
use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR508", name: "ramp-never-set" },
        group: Group::Motion,
        severity: Severity::Advice,
        enabled: true,
        mark: None,
        what: "A program has coordinated moves, and nothing in the project sets the acceleration (ACC) or the stop \
               ramp (STP) of its master.",
        why: "The moves use whatever the controller holds. Zero switches a ramp off: the velocity jumps, and the load \
              takes a blow at each start or stop.",
        bad: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nVEL 25\nPROGRAM\nX10\nENDP",
        good: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nACC 100 DEC 100 STP 100 VEL 25\n\
               PROGRAM\nX10\nENDP",
        guide: "Making Motion / What are Motion Profiles?",
    },
    checks: &[Check::File(check)],
};

const RAMPS: [(Deed, &str); 2] = [(Deed::Acceleration, "ACC"), (Deed::StopRamp, "STP")];

fn check(context: &mut Context<'_>) {
    for motion in first_moves(context) {
        let never = |deed| context.machine().never_at(deed, motion.level);
        let missing: Vec<_> = RAMPS.iter().filter(|(deed, _)| never(*deed)).map(|(_, name)| *name).collect();
        if !missing.is_empty() {
            let (program, missing) = (level_name(motion.level), missing.join(" and "));
            let message = format!("{program} moves, but nothing in the project sets {missing}");
            context.report(
                RULE.at(motion.span, message).with_help(format!("set {missing} beside the attachments of {program}")),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{lint, spans_of};

    fn text(setup: &str) -> String {
        format!(
            "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nVEL 5\n{setup}\nPROGRAM\nX10\n\
             X20\nENDP\n"
        )
    }

    #[test]
    fn either_ramp_is_missed() {
        assert_eq!(spans_of("ACR508", &text("")), ["X"]);
        assert_eq!(spans_of("ACR508", &text("ACC 5")), ["X"]);
        let found = lint(&[("test.8K", &text("ACC 5"))]).concat();
        assert!(found.iter().any(|found| found.message.ends_with("sets STP")), "{found:?}");
    }

    #[test]
    fn both_are_set() {
        assert_eq!(spans_of("ACR508", &text("ACC 5 STP 0")), [""; 0]);
    }
}
