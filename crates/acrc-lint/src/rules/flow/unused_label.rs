//! `ACR103`: a label that nothing jumps to.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::Target;

use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR103", name: "unused-label" },
        group: Group::Flow,
        severity: Severity::Advice,
        what: "No GOTO or GOSUB of the program goes to this label.",
        why: "Either the code behind it is never called, or the label is left over and misleads the reader.",
        bad: "PROG0\nPROGRAM\n_Start\nSET 32\nDWL 1\nCLR 32\nENDP",
        good: "PROG0\nPROGRAM\nSET 32\nDWL 1\nCLR 32\nENDP",
        guide: "Programming Basics / Program Labels",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    let level = section.section.level;
    let mut targets: Vec<&str> = context
        .index()
        .sections
        .iter()
        .filter(|other| other.section.level == level)
        .flat_map(|other| &other.jumps)
        .map(|jump| match jump.target {
            Target::Label(span) | Target::Line(_, span) => context.slice(span),
        })
        .collect();
    targets.sort_unstable();
    for label in &section.labels {
        let name = context.slice(label.name);
        if targets.binary_search(&name).is_err() {
            let program = level_name(level);
            context.report(RULE.at(label.name, format!("nothing in {program} jumps to the label `{name}`")));
        }
    }
}
