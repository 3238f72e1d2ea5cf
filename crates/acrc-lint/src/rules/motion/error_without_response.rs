//! `ACR523`: a limit of the following error that stops nothing.

use acrc_analysis::Deed;
use acrc_diagnostics::{Code, Severity};

use super::{axis_name, first_motions_of_attached};
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR523", name: "error-without-response" },
        group: Group::Motion,
        severity: Severity::Advice,
        enabled: true,
        mark: None,
        what: "The band of the following error (EXC) of an axis that programs move is set, and nothing in the project \
               switches on the response to it (flag 8469 + 32 * axis).",
        why: "EXC by itself only changes a flag (769 + 32 * axis). An axis that is blocked, or has lost its encoder, \
              goes on pushing unless a program watches that flag or the response kills the motion.",
        bad: "AXIS0 PPU 1000\nAXIS0 EXC (0.5,-0.5)\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nVEL 25\nPROGRAM\n\
              X10\nENDP",
        good: "AXIS0 PPU 1000\nAXIS0 EXC (0.5,-0.5)\nSET BIT8469\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n\
               VEL 25\nPROGRAM\nX10\nENDP",
        guide: "Basic Setup / Configuration",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    let machine = context.machine();
    for motion in first_motions_of_attached(context, &Deed::MOTION) {
        let band = machine.axes_with(Deed::ErrorBand).has(motion.axis);
        if band && machine.never(Deed::ErrorResponse, motion.axis) {
            let axis = axis_name(context, &motion);
            let message = format!("the EXC of {axis} stops nothing: nothing in the project switches its response on");
            let flag = acrc_catalog::bit_number("exc_response_enable", motion.axis);
            let help = flag.map(|flag| format!("SET BIT{flag}, or watch the flag of the axis in a program"));
            let diagnostic = RULE.at(motion.span, message);
            context.report(match help {
                Some(help) => diagnostic.with_help(help),
                None => diagnostic,
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(setup: &str) -> Vec<String> {
        let text =
            format!("AXIS0 PPU 1000\n{setup}\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nX10\nENDP\n");
        spans_of("ACR523", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn a_band_has_a_response() {
        assert_eq!(found("AXIS0 EXC (0.5,-0.5)"), ["X"]);
        assert_eq!(found("AXIS0 EXC 0.5\nCLR BIT8469"), ["X"]);
        assert_eq!(found("AXIS0 EXC 0.5\nSET BIT8469"), [""; 0]);
        assert_eq!(found(""), [""; 0]);
    }
}
