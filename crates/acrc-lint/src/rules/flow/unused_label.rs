//! `ACR103`: a label that nothing jumps to.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Severity};

use crate::rule::{Check, Group, Mark, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR103", name: "unused-label" },
        group: Group::Flow,
        severity: Severity::Advice,
        enabled: true,
        mark: Some(Mark::Unnecessary),
        what: "No GOTO or GOSUB of the program goes to this label.",
        why: "Either the code behind it is never called, or the label is left over and misleads the reader.",
        bad: "PROG0\nPROGRAM\n_Start\nSET 32\nDWL 1\nCLR 32\nENDP",
        good: "PROG0\nPROGRAM\nSET 32\nDWL 1\nCLR 32\nENDP",
        guide: "Programming Basics / Program Labels",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    let mut reached: Vec<u32> = section.jumps.iter().filter_map(|jump| jump.to).collect();
    reached.sort_unstable();
    for label in &section.labels {
        // A jump names all labels of one name; that there are two is another finding.
        let name = context.slice(label.name);
        let same_name = section.labels_named(context.text(), name);
        let is_reached = same_name.iter().any(|label| reached.binary_search(&label.statement).is_ok());
        if !is_reached && !is_used_elsewhere(context, section, name) {
            let program = level_name(section.section.level);
            context.report(RULE.at(label.name, format!("nothing in {program} jumps to the label `{name}`")));
        }
    }
}

/// What is typed at a prompt may jump into any part of the program of that level.
fn is_used_elsewhere(context: &Context<'_>, section: &SectionIndex, name: &str) -> bool {
    let level = section.section.level;
    let others = context.index().sections.iter().filter(|other| other.section.level == level);
    others.flat_map(|other| &other.jumps).any(|jump| jump.to.is_none() && context.slice(jump.target.span()) == name)
}

#[cfg(test)]
mod tests {
    use crate::testing::{lines_of, spans_of};

    fn unused(text: &str) -> Vec<&str> {
        spans_of("ACR103", text)
    }

    #[test]
    fn a_label_is_used_from_its_own_program() {
        let programs = "PROG0\nPROGRAM\n_A\nGOTO A\nENDP\nPROG1\nPROGRAM\n_A\nENDP\n";
        assert_eq!(lines_of("ACR103", &[("test.8K", programs)]), [[8]]);
        assert_eq!(unused("PROG0\nPROGRAM\n_A\nENDP\nGOTO A\n"), [""; 0]);
        assert_eq!(unused("_A\n_A\nGOTO A\n"), [""; 0], "the second one is a duplicate, and that is said");
        assert_eq!(unused("_100\nGOTO 100\n_B\n"), ["B"]);
    }
}
