//! `ACR302`: writing what only the controller writes.

use acrc_catalog::{Access, Confidence, Known, OperandClass, parameter_number};
use acrc_diagnostics::{Code, Severity};

use crate::Context;
use crate::references::{Reference, Usage};
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR302", name: "read-only" },
        group: Group::Parameters,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "A statement writes a parameter or bit that reports a state of the controller.",
        why: "The controller writes it again with the next servo period, so the statement has no effect, and the code \
              behind it goes on as if it had one.",
        bad: "PROG0\nPROGRAM\nCLR 792\nENDP",
        good: "PROG0\nPROGRAM\nINH -792\nENDP",
        guide: "Programming Basics / Parameters and Bits",
    },
    checks: &[Check::Reference(check)],
};

/// Reports beside which there is a setting of the same quantity, with that.
const SETTINGS: [(&str, &str); 2] =
    [("jog_velocity_current", "jog_velocity"), ("jog_acceleration_current", "jog_acceleration")];

fn check(context: &mut Context<'_>, reference: &Reference) {
    if reference.usage != Usage::Write {
        return;
    }
    let Some(number) = reference.small() else { return };
    let (field, object, title, known, access, confidence) = match reference.class {
        OperandClass::Parameter => {
            let info = acrc_catalog::parameter(number);
            (info.field, info.object_index, info.title, info.known, info.access, info.confidence)
        }
        OperandClass::Bit => {
            let info = acrc_catalog::bit(number);
            (info.field, info.object_index, info.title, info.known, info.access, info.confidence)
        }
        _ => return,
    };
    if known != Known::Row || access != Access::Read || confidence != Confidence::High {
        return;
    }
    let message = format!("{} ({title}) is written by the controller only", reference.name());
    let finding = reference.labelled(RULE.at(reference.span, message));
    let setting = SETTINGS.iter().find(|(report, _)| *report == field).map(|(_, setting)| *setting);
    let setting = setting.and_then(|setting| parameter_number(setting, object?));
    context.report(match setting {
        Some(setting) => finding.with_help(format!("the setting is P{setting}")),
        None => finding,
    });
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, lint, spans_of};

    #[test]
    fn every_way_of_writing() {
        assert_eq!(codes("P12291 = 5\nBIT 792 = 1\nSET BIT792\n"), [(1, "ACR302"), (2, "ACR302"), (3, "ACR302")]);
        assert_eq!(codes("P12288 = 0\nSET 8467\nCLR 522\nP0 = P12290\n"), []);
    }

    #[test]
    fn every_bit_of_a_list_and_every_constant() {
        assert_eq!(spans_of("ACR302", "CLR 8467 CLR792\nSET BIT(768+32)\n"), ["792", "BIT(768+32)"]);
        assert_eq!(spans_of("ACR302", "FOR P12291 = 1 TO 2\nNEXT\nINPUT P12292\n"), ["P12291", "P12292"]);
    }

    #[test]
    fn through_an_alias() {
        let text = "#DEFINE Jogging BIT792\nCLR Jogging\n";
        assert_eq!(codes(text), [(2, "ACR302")]);
        assert_eq!(lint(&[("test.8K", text)])[0][0].label.as_deref(), Some("this is bit 792"));
    }

    #[test]
    fn the_setting_of_the_same_quantity_is_named() {
        assert_eq!(lint(&[("test.8K", "P12602 = 5\n")])[0][0].help.as_deref(), Some("the setting is P12604"));
    }
}
