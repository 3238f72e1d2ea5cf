//! `ACR315`: writing the position that an axis has, and not the one that it should have.

use acrc_catalog::OperandClass;
use acrc_diagnostics::{Code, Severity};

use crate::Context;
use crate::references::{Reference, Usage};
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR315", name: "actual-position-written" },
        group: Group::Parameters,
        severity: Severity::Advice,
        enabled: true,
        mark: None,
        what: "A statement assigns the actual position of an axis (P12290 + 256 * axis). No document says what that does.",
        why: "If the controller takes the value, the setpoint stays where it was: the difference is following error at once, \
              and the axis jumps or is killed. If it does not, the statement has no effect. RES sets the setpoints and the \
              encoder together.",
        bad: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nP12290 = 0\nENDP",
        good: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nRES X\nENDP",
        guide: "Making Motion / Velocity Profile Commands",
    },
    checks: &[Check::Reference(check)],
};

/// The field of the catalogue.
const ACTUAL: &str = "actual_position";

fn check(context: &mut Context<'_>, reference: &Reference) {
    if reference.usage != Usage::Write || reference.class != OperandClass::Parameter {
        return;
    }
    let Some(info) = reference.small().map(acrc_catalog::parameter).filter(|info| info.field == ACTUAL) else { return };
    let Some(axis) = info.object_index else { return };
    let message = format!("{} is the position that AXIS{axis} has: assigning it sets no setpoint", reference.name());
    let help =
        format!("RES AXIS{axis} sets setpoint and encoder, REN AXIS{axis} makes the setpoint the actual position");
    context.report(reference.labelled(RULE.at(reference.span, message).with_help(help)));
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    #[test]
    fn the_actual_position_of_each_axis() {
        assert_eq!(spans_of("ACR315", "P12290 = 0\nP12546 = P0\nP0 = P12290\nP12288 = 0\n"), ["P12290", "P12546"]);
        assert_eq!(spans_of("ACR315", "#DEFINE Here P12290\nHere = 0\nP0 = Here\n"), ["Here"]);
    }
}
