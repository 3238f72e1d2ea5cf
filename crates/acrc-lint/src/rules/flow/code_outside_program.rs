//! `ACR129`: code between the programs of a file.

use acrc_analysis::SectionIndex;
use acrc_catalog::{CommandId, Shape, command};
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::StatementKind;
use acrc_syntax::units::{Level, SectionKind};

use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR129", name: "code-outside-program" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A file with PROGRAM .. ENDP defines a label outside of them, at a prompt; the first label of such a stretch \
               stands for it. Or moves, waits or loops follow directly behind an ENDP, with no change of the prompt \
               and no RUN between; the first of them stands for all.",
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
    let mut before: Option<&SectionIndex> = None;
    for index in sections {
        let follows = before.is_some_and(|before| goes_on_behind(before, index));
        before = Some(index);
        if index.section.kind != SectionKind::Immediate || has_endp(context, index) {
            continue;
        }
        let label = index.labels.iter().min_by_key(|label| label.statement);
        let (at, what) = match label {
            Some(label) => (label.statement, format!("the label `{}`", context.slice(label.name))),
            None if follows => match first_of_program(context, index) {
                Some(at) => (at, format!("`{}`", context.slice(context.statement_span(at)))),
                None => continue,
            },
            None => continue,
        };
        let prompt = level_name(index.section.level);
        let message = format!("{what} stands outside of PROGRAM .. ENDP");
        let diagnostic = RULE.at(context.statement_span(at), message);
        let note = format!("at the prompt of {prompt} each line is carried out as it arrives, and none is stored");
        let help = if label.is_some() {
            "begin the text of the program with a line PROGRAM"
        } else {
            "move ENDP behind it, where it belongs to the program"
        };
        context.report(diagnostic.with_note(note).with_help(help));
    }
}

/// Whether a section stands directly behind the ENDP of a program, at its prompt.
fn goes_on_behind(before: &SectionIndex, index: &SectionIndex) -> bool {
    let (before, section) = (&before.section, &index.section);
    before.opener.is_some()
        && before.closer.is_some_and(|closer| closer + 1 == section.statements.start)
        && before.level == section.level
        && matches!(section.level, Level::Program(_))
}

/// The first statement that makes sense in a program only: a coordinated move, a wait, a loop. A
/// GOTO is typed to start a program at a label.
fn first_of_program(context: &Context<'_>, index: &SectionIndex) -> Option<u32> {
    const OF_PROGRAMS: [CommandId; 3] = [command::INH, command::RETURN, command::WHILE];
    let statements = context.tree().statements();
    let kind = |at: u32| statements.get(at as usize).map(|statement| &statement.kind);
    let is_of_program = |at: &u32| match kind(*at) {
        Some(StatementKind::Command(command)) => {
            OF_PROGRAMS.contains(&command.id) || command.id.info().shape == Shape::Move
        }
        Some(StatementKind::For(_)) => true,
        _ => false,
    };
    // What follows a RUN is typed on purpose, while the program runs.
    let starts_one = |at: &u32| match kind(*at) {
        Some(StatementKind::Command(command)) => [command::RUN, command::LRUN].contains(&command.id),
        _ => false,
    };
    index.section.statements.clone().take_while(|at| !starts_one(at)).find(is_of_program)
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
    fn code_behind_the_end_of_a_program() {
        let found = |behind: &str| {
            let text = format!("PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nX5\nENDP\n{behind}\n");
            spans_of("ACR129", &text).into_iter().map(str::to_owned).collect::<Vec<_>>()
        };
        assert_eq!(found("SET 32\nX10\nINH -516"), ["X10"]);
        assert_eq!(found("WHILE (BIT 5)\nWEND"), ["WHILE (BIT 5)"]);
        assert_eq!(found("VEL 20 : SET 32\nRUN PROG0\nGOTO Loop"), [""; 0]);
        assert_eq!(found("RUN\nINH -516\nX10"), [""; 0], "typed while the program runs");
        assert_eq!(found("SYS\nPROG0\nX10"), [""; 0], "a new start");
    }

    #[test]
    fn without_its_program_an_endp_is_the_finding() {
        assert_eq!(codes("PROG0\nPROGRAM\nENDP\nPROG1\n_A\nSET 32\nGOTO A\nENDP\n"), [(8, "ACR114")]);
    }
}
