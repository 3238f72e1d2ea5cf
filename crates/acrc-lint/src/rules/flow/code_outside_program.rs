//! `ACR129`: code between the programs of a file.

use acrc_analysis::SectionIndex;
use acrc_catalog::command;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::StatementKind;
use acrc_syntax::units::SectionKind;

use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR129", name: "code-outside-program" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        what: "A file with PROGRAM .. ENDP defines a label outside of them, at a prompt. The first label of such a stretch \
               stands for it.",
        why: "Without PROGRAM nothing is stored: each line is carried out once, when it is sent, motion included, and a \
              label means nothing at a prompt.",
        bad: "PROG0\nPROGRAM\nSET 32\nENDP\nPROG1\n_Watch\nINH 24\nCLR 32\nGOTO Watch",
        good: "PROG0\nPROGRAM\nSET 32\nENDP\nPROG1\nPROGRAM\n_Watch\nINH 24\nCLR 32\nGOTO Watch\nENDP",
        guide: "Programming Basics / Program Labels",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    let sections = &context.index().sections;
    if !sections.iter().any(|index| index.section.opener.is_some()) {
        return;
    }
    for index in sections {
        if index.section.kind != SectionKind::Immediate || has_endp(context, index) {
            continue;
        }
        let Some(label) = index.labels.iter().min_by_key(|label| label.statement) else { continue };
        let name = context.slice(label.name);
        let prompt = level_name(index.section.level);
        let message = format!("the label `{name}` stands outside of PROGRAM .. ENDP");
        let diagnostic = RULE.at(context.statement_span(label.statement), message);
        let note = format!("at the prompt of {prompt} each line is carried out as it arrives, and none is stored");
        context.report(diagnostic.with_note(note).with_help("begin the text of the program with a line PROGRAM"));
    }
}

/// An ENDP without PROGRAM is reported by itself.
fn has_endp(context: &Context<'_>, index: &SectionIndex) -> bool {
    let statements = context.tree().statements();
    let is_endp = |at: u32| {
        let statement = statements.get(at as usize);
        statement.is_some_and(|s| matches!(&s.kind, StatementKind::Command(c) if c.id == command::ENDP))
    };
    !index.labels.is_empty() && index.section.statements.clone().any(is_endp)
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, spans_of};

    #[test]
    fn a_forgotten_program_is_seen_beside_another() {
        let text = "PROG0\nPROGRAM\nSET 32\nENDP\nPROG1\nX10\n_A\n_B\nGOTO B\n";
        assert_eq!(spans_of("ACR129", text), ["_A"]);
        assert_eq!(codes("PROG1\n_A\nSET 32\nGOTO A\n"), [], "the editor adds PROGRAM and ENDP to a file without them");
        assert_eq!(spans_of("ACR129", "PROG0\n10 _A\n20 GOTO A\nPROG1\nPROGRAM\nENDP\n"), [""; 0]);
    }

    #[test]
    fn without_its_program_an_endp_is_the_finding() {
        assert_eq!(codes("PROG0\nPROGRAM\nENDP\nPROG1\n_A\nSET 32\nGOTO A\nENDP\n"), [(8, "ACR114")]);
    }
}
