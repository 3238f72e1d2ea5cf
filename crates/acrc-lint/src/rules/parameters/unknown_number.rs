//! `ACR301`: a parameter, bit or object that no controller, or not this one, has.

use acrc_catalog::{Known, Model, ObjectKind, OperandClass, Space, models};
use acrc_diagnostics::{Code, Diagnostic, Severity};
use acrc_syntax::ast::{Argument, Object, Statement, StatementKind};

use crate::Context;
use crate::references::Reference;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR301", name: "unknown-number" },
        group: Group::Parameters,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "The number of a parameter, bit, axis, master, slave or program lies beyond what controllers have, or \
               beyond what the model of the project has.",
        why: "A digit too many or too few reads or writes something else, or nothing: a wait for such a bit never ends, \
              a safety check of it never trips.",
        bad: "PROG0\nPROGRAM\nINH 161340\nENDP",
        good: "PROG0\nPROGRAM\nINH 16134\nENDP",
        guide: "Programming Basics / Parameters and Bits",
    },
    checks: &[Check::Reference(check_reference), Check::Statement(check_objects)],
};

/// The definition of an alias is reported, not each of its uses.
fn check_reference(context: &mut Context<'_>, reference: &Reference) {
    if reference.alias {
        return;
    }
    let place = match reference.class {
        OperandClass::Parameter => {
            reference.small().map(acrc_catalog::parameter).map(|info| (info.known, info.object, info.object_index))
        }
        OperandClass::Bit => {
            reference.small().map(acrc_catalog::bit).map(|info| (info.known, info.object, info.object_index))
        }
        _ => return,
    };
    match place {
        Some((known, object, index)) if known != Known::OutOfSpace => {
            report_missing_object(context, reference, object, index);
        }
        _ => {
            let word = if reference.class == OperandClass::Bit { "" } else { "parameter " };
            context.report(RULE.at(reference.span, format!("there is no {word}{}", reference.name())));
        }
    }
}

/// Axes and masters are counted for the model only when the project names it: a default model may be the wrong one.
fn report_missing_object(context: &mut Context<'_>, reference: &Reference, object: Space, index: Option<u32>) {
    let Some(model) = context.given_model() else { return };
    let (word, count) = match object {
        Space::Axis => ("axis", model.axes),
        Space::Master => ("master", model.masters),
        Space::Program => ("program", model.programs),
        Space::Plc => ("PLC program", model.plcs),
        _ => return,
    };
    if let Some(index) = index.filter(|index| *index >= u32::from(count)) {
        let (name, model_name, last) = (reference.name(), model.name, count.saturating_sub(1));
        let name = if reference.class == OperandClass::Bit { name } else { format!("parameter {name}") };
        let message = format!("{name} belongs to {word} {index}, and the {model_name} has {word} 0 to {last}");
        let diagnostic = Diagnostic { severity: Severity::Warning, ..RULE.at(reference.span, message) };
        context.report_by(model.confidence, diagnostic);
    }
}

fn check_objects(context: &mut Context<'_>, statement: &Statement) {
    let StatementKind::Command(command) = &statement.kind else { return };
    let behind = command.arguments.iter().filter_map(|argument| match argument {
        Argument::Object(object) => Some(object),
        _ => None,
    });
    for object in command.prefix.as_deref().into_iter().chain(behind) {
        judge_object(context, object);
    }
}

/// How many objects of a kind a model has. `None` for kinds that no document counts.
fn count(model: &Model, kind: ObjectKind) -> Option<u8> {
    Some(match kind {
        ObjectKind::Axis => model.axes,
        ObjectKind::Master => model.masters,
        ObjectKind::Slave => model.slaves,
        ObjectKind::Prog => model.programs,
        ObjectKind::Plc => model.plcs,
        _ => return None,
    })
}

fn judge_object(context: &mut Context<'_>, object: &Object) {
    let Some(index) = object.index else { return };
    let Some(most) = models().iter().filter_map(|model| count(model, object.kind)).max() else { return };
    let word = object.kind.name();
    if index >= u32::from(most) {
        let message =
            format!("there is no {word}{index}: controllers have {word}0 to {word}{}", most.saturating_sub(1));
        context.report(RULE.at(object.name, message));
    } else if let Some(model) = context.given_model()
        && let Some(count) = count(model, object.kind).filter(|count| index >= u32::from(*count))
    {
        let (name, last) = (model.name, count.saturating_sub(1));
        let message = format!("there is no {word}{index}: the {name} has {word}0 to {word}{last}");
        let diagnostic = Diagnostic { severity: Severity::Warning, ..RULE.at(object.name, message) };
        context.report_by(model.confidence, diagnostic);
    }
}

#[cfg(test)]
mod tests {
    use acrc_diagnostics::Severity;

    use crate::testing::{codes, codes_in, lint_as, spans_of};

    #[test]
    fn numbers_are_found_wherever_they_stand() {
        assert_eq!(codes("IF (BIT 999999) THEN P999999 = 1\nSET 999999\nINH -BIT999999\n").len(), 4);
        assert_eq!(codes("P0 = P(12290) + BIT(516)\n"), []);
    }

    #[test]
    fn constants_and_nested_places_count() {
        let text = "X(P999999) VEL (BIT 999998)\nP0 = SQRT(P(12288+9999999)) : PRINT P999997\n";
        let expected = ["P999999", "BIT 999998", "P(12288+9999999)", "P999997"];
        assert_eq!(spans_of("ACR301", text), expected);
        assert_eq!(spans_of("ACR301", "CLR 16134 CLR 999999\nSET BIT(100000+1)\n"), ["999999", "BIT(100000+1)"]);
        assert_eq!(spans_of("ACR301", "P0 = P(12288+256*7) : SET (100-1)\n"), [""; 0]);
    }

    #[test]
    fn an_alias_is_told_once_where_it_is_defined() {
        assert_eq!(spans_of("ACR301", "#DEFINE Far BIT999999\nSET Far\nINH -Far\n"), ["BIT999999"]);
    }

    #[test]
    fn axes_are_counted_for_a_model_that_the_project_names() {
        let text = "P0 = P14594\n";
        assert_eq!(codes(text), [], "actual position of axis 9: another model may have it");
        let found = lint_as("ACR9000", text);
        assert_eq!(codes_in(text, &found), [(1, "ACR301")]);
        assert!(found[0].severity == Severity::Warning && found[0].message.contains("axis 9"));
    }

    #[test]
    fn objects_are_counted_too() {
        let text = "ATTACH AXIS9 ENC0 DAC0 ENC0\nPROG0\nATTACH MASTER8\nATTACH SLAVE8 AXIS8 \"X\"\nAXIS7 PPU 1\n";
        assert_eq!(spans_of("ACR301", text), [""; 0]);
        let found = lint_as("ACR9000", text);
        assert_eq!(codes_in(text, &found), [(1, "ACR301"), (3, "ACR301"), (4, "ACR301"), (4, "ACR301")]);
        assert_eq!(spans_of("ACR301", "AXIS16 ON\nRUN PROG16\nATTACH AXIS15 ENC5 DAC15 ENC5\n"), ["AXIS16", "PROG16"]);
    }
}
