//! `ACR102`: a label that a program defines twice.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Severity};

use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR102", name: "duplicate-label" },
        group: Group::Flow,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "A program defines the same label twice.",
        why: "A jump can go to one of them only, and no document says which. The other piece of code is never reached, \
              although it looks as if it were.",
        bad: "PROG0\nPROGRAM\nGOSUB Open\nEND\n_Open\nSET 32\nRETURN\n_Open\nCLR 32\nRETURN\nENDP",
        good: "PROG0\nPROGRAM\nGOSUB Open\nGOSUB Close\nEND\n_Open\nSET 32\nRETURN\n_Close\nCLR 32\nRETURN\nENDP",
        guide: "Programming Basics / Program Labels",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    let mut first = None;
    for label in &section.labels {
        let name = context.slice(label.name);
        match first {
            Some((known, span)) if known == name => {
                let program = level_name(section.section.level);
                let diagnostic = RULE.at(label.name, format!("{program} defines the label `{name}` twice"));
                context.report(diagnostic.with_label("defined again here").with_related(span, "first defined here"));
            }
            _ => first = Some((name, label.name)),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::codes;

    #[test]
    fn labels_of_different_programs_and_of_different_case_are_different() {
        assert_eq!(codes("PROG0\nPROGRAM\n_A\n_a\nGOTO A\nENDP\nPROG1\nPROGRAM\n_A\nGOTO A\nENDP\n"), []);
    }
}
