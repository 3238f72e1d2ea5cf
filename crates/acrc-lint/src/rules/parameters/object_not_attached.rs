//! `ACR304`: a parameter or bit of an axis or master that the project does not use.

use acrc_catalog::{Confidence, OperandClass, Space};
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::units::SectionKind;

use crate::Context;
use crate::references::{Reference, Usage};
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR304", name: "object-not-attached" },
        group: Group::Parameters,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A program uses a parameter or bit of an axis that the project neither attaches, configures nor commands, \
               or of a master that no program attaches. Prompts, prints and setup code are left alone, and so are \
               projects that attach nothing.",
        why: "Nothing moves behind such a number: a wait for its motion ends at once, or never. Mostly the number is one \
              stride of 32 or 256 off, and the right axis is not looked at.",
        bad: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nX10\nINH -548\nENDP",
        good: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nX10\nINH -516\nENDP",
        guide: "System Configuration / Attachments",
    },
    checks: &[Check::Reference(check)],
};

fn check(context: &mut Context<'_>, reference: &Reference) {
    let is_stored = context.section().is_some_and(|section| section.section.kind == SectionKind::Stored);
    let machine = context.machine();
    if !is_stored || matches!(reference.usage, Usage::Define | Usage::Print) || machine.open {
        return;
    }
    let Some((object, index, confidence)) = owner(reference) else { return };
    let (word, missing, known) = match object {
        Space::Axis => {
            let used = machine.has_axis(index) || context.usage().axes.contains(&index);
            ("axis", !machine.axes.is_empty() && !used, &machine.axes)
        }
        Space::Master => {
            let used = machine.has_master(index) || context.usage().masters.contains(&index);
            ("master", !machine.masters.is_empty() && !used, &machine.masters)
        }
        _ => return,
    };
    if !missing || context.environment().fragment {
        return;
    }
    let mut attached: Vec<String> = known.iter().map(|(number, _)| number.to_string()).collect();
    attached.dedup();
    let message = format!("{} belongs to {word} {index}, which no program attaches", reference.name());
    let many = if attached.len() == 1 { format!("{word} {}", attached.concat()) } else { plural(word, &attached) };
    let finding = RULE.at(reference.span, message).with_help(format!("the project attaches {many}"));
    context.report_by(confidence, reference.labelled(finding));
}

fn plural(word: &str, numbers: &[String]) -> String {
    let word = if word == "axis" { "axes" } else { "masters" };
    format!("{word} {}", numbers.join(", "))
}

/// The axis or master that a number belongs to.
fn owner(reference: &Reference) -> Option<(Space, u32, Confidence)> {
    let number = reference.small()?;
    match reference.class {
        OperandClass::Parameter => {
            let info = acrc_catalog::parameter(number);
            Some((info.object, info.object_index?, info.confidence))
        }
        OperandClass::Bit => {
            let info = acrc_catalog::bit(number);
            Some((info.object, info.object_index?, info.confidence))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{lines_of, spans_of};

    const SETUP: &str = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n";

    fn found(program: &str) -> Vec<String> {
        let text = format!("{SETUP}PROGRAM\n{program}\nENDP\n");
        spans_of("ACR304", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn bits_and_parameters_of_absent_axes_and_masters() {
        assert_eq!(
            found("INH -548\nIF (P12546 > 5 AND BIT 16166) THEN CLR 8499"),
            ["-548", "P12546", "BIT 16166", "8499"]
        );
        assert_eq!(found("INH -516\nP0 = P12290 : CLR 8467\nSET 128 : P1 = P6160"), [""; 0]);
    }

    #[test]
    fn showing_them_to_a_person_is_fine() {
        assert_eq!(found("PRINT P12546, BIT 548\nFOR LV0 = 0 TO 7\nP10 = P(12290 + 256 * LV0)\nNEXT"), [""; 0]);
        assert_eq!(spans_of("ACR304", &format!("{SETUP}?P12546\nCLR 8499\n")), [""; 0]);
    }

    #[test]
    fn an_axis_that_is_configured_or_commanded_is_used() {
        assert_eq!(found("AXIS1 JOG INC 5\nINH -824\nINH -548"), ["-548"]);
        let setup = format!("ATTACH AXIS1 ENC1 DAC1 ENC1\n{SETUP}");
        assert_eq!(spans_of("ACR304", &format!("{setup}PROGRAM\nINH -824\nENDP\n")), [""; 0]);
    }

    #[test]
    fn other_files_attach_too() {
        let files = [("Setup.8K", SETUP), ("Prog0.8K", "PROGRAM\nINH -516\nINH -580\nENDP\n")];
        assert_eq!(lines_of("ACR304", &files), [vec![], vec![3]]);
        assert_eq!(spans_of("ACR304", "PROGRAM\nINH -580\nENDP\n"), [""; 0], "a piece of code");
        assert_eq!(spans_of("ACR304", "PROG0\nPROGRAM\nINH -580\nENDP\n"), [""; 0], "nothing is attached");
    }
}
