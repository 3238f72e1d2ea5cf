//! `ACR113`: `PROGRAM` without `ENDP`.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::units::SectionKind;

use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR113", name: "program-not-closed" },
        group: Group::Flow,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "A PROGRAM has no ENDP behind it, or none before the next PROGRAM.",
        why: "Everything sent afterwards is stored as lines of this program instead of being carried out, the setup of \
              the next program included.",
        bad: "PROG0\nPROGRAM\nSET 32\nEND",
        good: "PROG0\nPROGRAM\nSET 32\nEND\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, index: &SectionIndex) {
    let section = &index.section;
    let is_closed = section.closer.is_some() && index.swallowed.is_none();
    if section.kind != SectionKind::Stored || is_closed {
        return;
    }
    let Some(opener) = section.opener else { return };
    let program = level_name(section.level);
    let before = if index.swallowed.is_some() { " before the next PROGRAM" } else { "" };
    let message = format!("PROGRAM of {program} has no ENDP{before}");
    let mut diagnostic = RULE.at(context.statement_span(opener), message).with_label("opened here");
    if let Some(swallowed) = index.swallowed {
        let inner = context.statement_span(swallowed.program);
        diagnostic = diagnostic.with_related(inner, format!("this one is stored as a part of {program}"));
    }
    context.report(diagnostic.with_help("end the text of the program with a line ENDP"));
}

#[cfg(test)]
mod tests {
    use crate::testing::codes;

    #[test]
    fn the_next_program_does_not_close_the_one_before() {
        assert_eq!(codes("PROG0\nPROGRAM\nP0=1\nPROG1\nPROGRAM\nP0=2\nENDP\n"), [(2, "ACR113")]);
        assert_eq!(codes("PROG0\nPROGRAM\nSET 32\n"), [(2, "ACR113")]);
    }

    #[test]
    fn a_program_in_a_program_is_one_mistake() {
        assert_eq!(codes("PROG0\nPROGRAM\nPROGRAM\nSET 32\nENDP\nENDP\n"), [(2, "ACR113")]);
        let first = "PROG0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\n_A\nX10\nGOTO A\n";
        let second = "PROG1\nATTACH SLAVE0 AXIS1 \"Y\"\nPROGRAM\n_A\nY10\nGOTO A\nENDP\n";
        assert_eq!(codes(&format!("{first}{second}")), [(3, "ACR113")]);
        assert_eq!(codes(&format!("{first}ENDP\n{second}")), []);
    }
}
