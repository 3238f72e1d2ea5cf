//! `ACR311`: a program writes what code of the vendor's wizard uses.

use acrc_analysis::is_wizards;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::units::SectionKind;

use crate::Context;
use crate::references::{Reference, Usage};
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR311", name: "wizard-number" },
        group: Group::Parameters,
        severity: Severity::Advice,
        enabled: true,
        what: "A program writes one of the parameters P100 to P131 or flags 1952 to 2047, and the setup of the project \
               writes such numbers too, as code of the vendor's wizard does.",
        why: "The wizard keeps software travel limits and the states of drive faults there. Who uses one of them as a \
              variable moves a limit or clears a fault.",
        bad: "SYS\nP100 = 24 : P116 = 0\nPROG0\nPROGRAM\nP100 = P100 + 1\nENDP",
        good: "SYS\nP100 = 24 : P116 = 0\nPROG0\nPROGRAM\nP10 = P10 + 1\nENDP",
        guide: "Configuration / Resources Reserved for Generated Code",
    },
    checks: &[Check::Reference(check)],
};

fn check(context: &mut Context<'_>, reference: &Reference) {
    let is_stored = context.section().is_some_and(|section| section.section.kind == SectionKind::Stored);
    if reference.usage != Usage::Write || !is_stored || !context.usage().wizard {
        return;
    }
    let is_wizards = reference.small().is_some_and(|number| is_wizards(reference.class, number));
    if is_wizards {
        let message = format!("code of the wizard keeps its own data in {}", reference.name());
        let finding = RULE.at(reference.span, message).with_help("take a user parameter or flag of your own");
        context.report(reference.labelled(finding));
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    #[test]
    fn numbers_that_the_setup_uses_too() {
        let setup = "SYS\nP100 = 24\nP116 = 0\nCLR 1952\n";
        let text = format!("{setup}PROG0\nPROGRAM\nP116 = 5\nSET 1984 CLR 128\nP1 = P100\nP132 = 5\nENDP\n");
        assert_eq!(spans_of("ACR311", &text), ["P116", "1984"]);
    }

    #[test]
    fn without_such_a_setup_they_are_ordinary_numbers() {
        assert_eq!(spans_of("ACR311", "PROG0\nPROGRAM\nP116 = 5\nSET 1984\nENDP\n"), [""; 0]);
        assert_eq!(
            spans_of("ACR311", "SYS\nP100 = 5\nPROG0\nPROGRAM\nP100 = 6\nENDP\n"),
            [""; 0],
            "a variable of the author"
        );
    }
}
