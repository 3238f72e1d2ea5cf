//! `ACR311`: a program writes what code of the vendor's wizard uses.

use acrc_analysis::{is_wizards, is_wizards_program};
use acrc_diagnostics::{Code, Diagnostic, Severity};
use acrc_syntax::units::SectionKind;

use crate::Context;
use crate::references::{Reference, Usage};
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR311", name: "wizard-number" },
        group: Group::Parameters,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A program writes one of the parameters P100 to P131 or flags 1952 to 2047. It is a warning when the setup of \
               the project writes such numbers too, as code of the vendor's wizard does, or when PROG7 or one of PLC5 to \
               PLC7, in which older firmware has that code, writes both limits of an axis. Otherwise it is advice, once \
               a file. A lone piece of code is not judged.",
        why: "The wizard keeps software travel limits and the states of drive faults there. Who uses one of them as a \
              variable moves a limit or clears a fault; in a project without its code, as soon as the wizard writes some.",
        bad: "SYS\nP100 = 24 : P116 = 0\nPROG0\nPROGRAM\nP100 = P100 + 1\nENDP",
        good: "SYS\nP100 = 24 : P116 = 0\nPROG0\nPROGRAM\nP10 = P10 + 1\nENDP",
        guide: "Configuration / Resources Reserved for Generated Code",
    },
    checks: &[Check::Reference(check)],
};

fn check(context: &mut Context<'_>, reference: &Reference) {
    let is_stored = context.section().is_some_and(|section| section.section.kind == SectionKind::Stored);
    if reference.usage != Usage::Write || !is_stored {
        return;
    }
    if !reference.small().is_some_and(|number| is_wizards(reference.class, number)) {
        return;
    }
    let (name, help) = (reference.name(), "take a user parameter or flag of your own");
    let in_program = context.usage().wizard_program && !context.usage().wizard;
    if in_program && is_wizards_program(context.level()) {
        return;
    }
    let finding = if context.usage().wizard || in_program {
        RULE.at(reference.span, format!("code of the wizard keeps its own data in {name}"))
    } else if context.environment().fragment || std::mem::replace(&mut context.reported_wizard_number, true) {
        return;
    } else {
        let message = format!("{name} is reserved for code of the wizard");
        Diagnostic { severity: Severity::Advice, ..RULE.at(reference.span, message) }
    };
    context.report(reference.labelled(finding.with_help(help)));
}

#[cfg(test)]
mod tests {
    use acrc_diagnostics::Severity;

    use crate::testing::{found_by, spans_of};

    #[test]
    fn numbers_that_the_setup_uses_too() {
        let setup = "SYS\nP100 = 24\nP116 = 0\nCLR 1952\n";
        let text = format!("{setup}PROG0\nPROGRAM\nP116 = 5\nSET 1984 CLR 128\nP1 = P100\nP132 = 5\nENDP\n");
        assert_eq!(spans_of("ACR311", &text), ["P116", "1984"]);
        assert_eq!(found_by("ACR311", &text)[0].severity, Severity::Warning);
    }

    #[test]
    fn older_code_of_the_wizard_is_in_a_program() {
        let text = |seven: &str| {
            format!(
                "PROG7\nPROGRAM\nP100 = 24\n{seven}\nSET 2000\nENDP\nPROG0\nATTACH MASTER0\nPROGRAM\nP101 = 5\nENDP\n"
            )
        };
        assert_eq!(spans_of("ACR311", &text("P116 = 0")), ["P101"]);
        assert_eq!(found_by("ACR311", &text("P116 = 0"))[0].severity, Severity::Warning);
        assert_eq!(spans_of("ACR311", &text("P1 = 0")), ["P100"], "half of a pair");
        assert_eq!(found_by("ACR311", &text("P1 = 0"))[0].severity, Severity::Advice);
    }

    #[test]
    fn without_such_a_setup_they_are_advice_once_a_file() {
        let text = "PROG0\nPROGRAM\nP116 = 5\nSET 1984\nENDP\nPROG1\nPROGRAM\nP100 = 5\nENDP\n";
        assert_eq!(spans_of("ACR311", text), ["P116"]);
        assert_eq!(found_by("ACR311", text)[0].severity, Severity::Advice);
        let author = "SYS\nP100 = 5\nPROG0\nPROGRAM\nP100 = 6\nENDP\n";
        assert_eq!(found_by("ACR311", author)[0].severity, Severity::Advice, "a variable of the author");
        assert_eq!(spans_of("ACR311", "PROGRAM\nP116 = 5\nENDP\n"), [""; 0], "a piece of code");
    }
}
