//! `ACR215`: an alias that is taken for something else, by the controller or by a reader.

use acrc_analysis::AliasFact;
use acrc_diagnostics::{Code, Diagnostic, Severity};

use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR215", name: "alias-shadows" },
        group: Group::Names,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "An alias has the name of an axis of a program. As advice: it differs from another alias in case only.",
        why: "Within its program the word is the axis, elsewhere the alias: the same line moves an axis in one program \
              and uses a number in another. Names that differ in case only are taken for each other.",
        bad: "#DEFINE Lift BIT32\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"LIFT\"\nPROGRAM\nLift10\nENDP\nPROG1\nPROGRAM\nSET \
              Lift\nENDP",
        good: "#DEFINE LiftValve BIT32\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"LIFT\"\nPROGRAM\nLift10\nENDP\nPROG1\nPROGRAM\nSET \
               LiftValve\nENDP",
        guide: "Programming Basics / Aliases",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    for site in &context.index().defines {
        let name = context.slice(site.name);
        let Some(own) = context.environment().own_alias(name) else { continue };
        if let Some(level) = own.axis_of {
            let message = format!("the alias `{name}` has the name of an axis of {}", level_name(level));
            context.report(RULE.at(site.name, message).with_help("there the word is the axis: take another name"));
        }
        if let Some(twin) = &own.twin {
            let finding = RULE.at(site.name, format!("the alias `{name}` differs from `{twin}` in case only"));
            let finding = match context.environment().alias(twin) {
                Some(AliasFact::Defined { operand, .. }) => {
                    finding.with_note(format!("`{twin}` stands for {}", operand.text))
                }
                _ => finding,
            };
            context.report(Diagnostic { severity: Severity::Advice, ..finding });
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, lines_of, spans_of};

    #[test]
    fn an_axis_of_any_program_and_in_any_case() {
        let attach = "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n";
        assert_eq!(codes(&format!("#DEFINE x BIT32\n{attach}")), [(1, "ACR215")]);
        assert_eq!(
            lines_of("ACR215", &[("Setup.8K", attach), ("b.8K", "#DEFINE X P1\n#DEFINE XY P2\n")]),
            [vec![], vec![1]]
        );
    }

    #[test]
    fn names_that_differ_in_case_only() {
        let text = "#DEFINE Lamp BIT32\n#DEFINE LAMP BIT33\n#DEFINE Lamps BIT34\n#DEFINE Lamp BIT32\n";
        assert_eq!(spans_of("ACR215", text), ["LAMP"]);
        assert_eq!(codes(text), [], "it is advice");
    }
}
