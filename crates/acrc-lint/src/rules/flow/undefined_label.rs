//! `ACR101`: a jump to a label or line that its program does not have.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Diagnostic, Edit, Fix, Severity};
use acrc_syntax::ast::Target;

use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR101", name: "undefined-label" },
        group: Group::Flow,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "A GOTO or GOSUB names a label or a line number that is not in the same program.",
        why: "The controller finds out when it gets to the statement, not when the program is downloaded: the program \
              stops there, in whatever state the machine is then.",
        bad: "PROG0\nPROGRAM\n_Cycle\nSET 32\nGOTO cycle\nENDP",
        good: "PROG0\nPROGRAM\n_Cycle\nSET 32\nGOTO Cycle\nENDP",
        guide: "Programming Basics / Program Labels",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    for jump in &section.jumps {
        if jump.to.is_none() && !is_defined_elsewhere(context, section, jump.target) {
            context.report(finding(context, section, jump.target));
        }
    }
}

/// What is typed at a prompt may jump into any part of the program of that level, and numbered lines are parts of it.
fn is_defined_elsewhere(context: &Context<'_>, section: &SectionIndex, target: Target) -> bool {
    section.section.opener.is_none()
        && same_level(context, section).any(|other| other.resolve(context.text(), target).is_some())
}

fn same_level<'a>(context: &Context<'a>, section: &SectionIndex) -> impl Iterator<Item = &'a SectionIndex> + use<'a> {
    let level = section.section.level;
    context.index().sections.iter().filter(move |other| other.section.level == level)
}

fn finding(context: &Context<'_>, section: &SectionIndex, target: Target) -> Diagnostic {
    let program = level_name(section.section.level);
    let span = target.span();
    let name = match target {
        Target::Label(name) => context.slice(name),
        Target::Line(number, _) => return RULE.at(span, format!("{program} has no line {number}")),
    };
    let diagnostic = RULE.at(span, format!("{program} has no label `{name}`"));
    if let Some(near) = near(context, section, name) {
        let fix = Fix::unsafe_(format!("jump to `{near}`"), vec![Edit::replace(span, near)]);
        return diagnostic.with_help(format!("did you mean `{near}`? Labels are case-sensitive")).with_fix(fix);
    }
    let elsewhere = context.index().sections.iter().find(|other| !other.labels_named(context.text(), name).is_empty());
    match elsewhere {
        Some(other) => {
            let other = level_name(other.section.level);
            diagnostic
                .with_help(format!("the label of this name is in {other}; a label is valid in its own program only"))
        }
        None => diagnostic.with_help(format!("define it with a line `_{name}` between PROGRAM and ENDP")),
    }
}

fn near<'a>(context: &Context<'a>, section: &SectionIndex, name: &str) -> Option<&'a str> {
    let labels = || section.labels.iter().map(|label| context.slice(label.name));
    labels().find(|label| label.eq_ignore_ascii_case(name)).or_else(|| acrc_analysis::nearest(name, labels()))
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, codes_in, lint};

    #[test]
    fn a_jump_finds_labels_and_line_numbers_of_its_own_program() {
        assert_eq!(codes("PROG0\nPROGRAM\nGOTO A\n_A\nENDP\nPROG1\nPROGRAM\nGOTO A\nENDP\n"), [(8, "ACR101")]);
        assert_eq!(codes("PROG0\n10 GOTO 20\n20 GOTO 30\n"), [(3, "ACR101")]);
        assert_eq!(codes("PROG0\n10 SET 32\nLIST\n20 GOTO 10\n"), []);
        assert_eq!(codes("PROG0\nPROGRAM\n_100\nGOTO 100\nENDP\n"), []);
    }

    #[test]
    fn a_jump_at_a_prompt_finds_labels_of_the_stored_program() {
        assert_eq!(codes("PROG0\nPROGRAM\n_A\nSET 32\nGOTO A\nENDP\nGOTO A\n"), []);
    }

    #[test]
    fn a_program_file_without_program_is_one_program() {
        let text = "GOSUB Open\nEND\n_Open\nSET 32\nRETURN\n";
        assert_eq!(codes_in(text, &lint(&[("Prog0.8K", text)]).concat()), []);
    }
}
