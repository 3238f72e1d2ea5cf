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
        what: "A PROGRAM has no ENDP behind it.",
        why: "Everything sent afterwards is stored as lines of this program instead of being carried out, the setup of \
              the next program included.",
        bad: "PROG0\nPROGRAM\nSET 32\nEND",
        good: "PROG0\nPROGRAM\nSET 32\nEND\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    let section = &section.section;
    if section.kind != SectionKind::Stored || section.closer.is_some() {
        return;
    }
    let Some(opener) = section.opener else { return };
    let program = level_name(section.level);
    let diagnostic = RULE.at(context.statement_span(opener), format!("PROGRAM of {program} has no ENDP"));
    context.report(diagnostic.with_label("opened here").with_help("end the text of the program with a line ENDP"));
}

#[cfg(test)]
mod tests {
    use crate::testing::codes;

    #[test]
    fn the_next_program_does_not_close_the_one_before() {
        assert_eq!(codes("PROG0\nPROGRAM\nSET 32\nPROG1\nPROGRAM\nSET 33\nENDP\n"), []);
        assert_eq!(codes("PROG0\nPROGRAM\nSET 32\n"), [(2, "ACR113")]);
    }
}
