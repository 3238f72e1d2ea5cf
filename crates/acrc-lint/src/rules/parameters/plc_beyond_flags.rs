//! `ACR310`: a PLC program uses a flag that it can't reach on this model.

use acrc_catalog::OperandClass;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::units::Level;

use crate::Context;
use crate::references::{Reference, Usage};
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR310", name: "plc-beyond-flags" },
        group: Group::Parameters,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A PLC program uses a flag above 8191, and the project names the model ACR9000. Where no model is named \
               nothing is said.",
        why: "PLC programs of the ACR9000 do not reach these flags: a rung that waits for the kill flag of an axis, or \
              for a CANopen input at its own place, does nothing.",
        bad: "SYS\nDIM PLC0(1000)\nPLC0\nPROGRAM\nLD 8467\nOUT 33\nENDP",
        good: "SYS\nDIM PLC0(1000)\nPLC0\nPROGRAM\nLD 522\nOUT 33\nENDP",
        guide: "CANopen / Alternate Mapping of Digital I/O",
    },
    checks: &[Check::Reference(check)],
};

fn check(context: &mut Context<'_>, reference: &Reference) {
    let in_plc = matches!(context.level(), Level::Plc(_));
    if !in_plc || reference.class != OperandClass::Bit || reference.usage == Usage::Define {
        return;
    }
    let Some(model) = context.given_model() else { return };
    if let Some(last) = model.plc_last_flag.filter(|last| reference.number > u64::from(*last)) {
        let message = format!("PLC programs of the {} reach flags up to {last}, not {}", model.name, reference.number);
        let finding = RULE.at(reference.span, message).with_help("copy the flag to a user flag in a program");
        context.report_by(model.confidence, reference.labelled(finding));
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes_in, lint_as, spans_of};

    const PLC: &str =
        "SYS\n#DEFINE Killed BIT8467\nPLC0\nPROGRAM\nLD 8191 AND NOT 8467\nOUT 33\nLD Killed\nOUT 34\nENDP\n";

    #[test]
    fn flags_beyond_8191_on_the_model_that_has_the_limit() {
        assert_eq!(codes_in(PLC, &lint_as("ACR9000", PLC)), [(5, "ACR310"), (7, "ACR310")]);
        assert_eq!(codes_in(PLC, &lint_as("ACR9040", PLC)), []);
        assert_eq!(spans_of("ACR310", PLC), [""; 0], "no model is named");
    }

    #[test]
    fn programs_reach_all_flags() {
        let text = "PROG0\nPROGRAM\nINH -8467\nENDP\n";
        assert_eq!(codes_in(text, &lint_as("ACR9000", text)), []);
    }
}
