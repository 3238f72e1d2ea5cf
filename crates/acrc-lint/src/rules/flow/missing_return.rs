//! `ACR117`: a subroutine that runs into the end of the program.

use acrc_analysis::SectionIndex;
use acrc_diagnostics::{Code, Severity, Span};
use acrc_syntax::units::SectionKind;

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR117", name: "missing-return" },
        group: Group::Flow,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A subroutine that is called with GOSUB can run into ENDP without a RETURN. A way that leaves it through \
               a GOTO counts only if the subroutine has no RETURN at all.",
        why: "The program ends inside of the subroutine: what stands behind the GOSUB is never done.",
        bad: "PROG0\nPROGRAM\nGOSUB Open\nDWL 1\nEND\n_Open\nSET 32\nENDP",
        good: "PROG0\nPROGRAM\nGOSUB Open\nDWL 1\nEND\n_Open\nSET 32\nRETURN\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    let Some(end) = end_of_text(context, section) else { return };
    let mut called: Vec<(u32, Span)> =
        section.jumps.iter().filter(|jump| jump.call).filter_map(|jump| Some((jump.to?, jump.target.span()))).collect();
    called.sort_unstable();
    called.dedup_by_key(|(statement, _)| *statement);
    if called.is_empty() {
        return;
    }
    let Some(flow) = context.flow(section) else { return };
    called.retain(|(entry, _)| flow.runs_off_the_end(*entry));
    let Some((_, first)) = called.first() else { return };
    let names: Vec<_> = called.iter().map(|(_, name)| format!("`{}`", context.slice(*name))).collect();
    let (what, verb) = if names.len() == 1 { ("subroutine", "runs") } else { ("subroutines", "run") };
    let message = format!("the {what} {} {verb} into the end of the program without RETURN", names.join(", "));
    let mut diagnostic = RULE.at(end, message).with_related(*first, "called here");
    for (entry, _) in &called {
        diagnostic = diagnostic.with_related(context.statement_span(*entry), "begins here");
    }
    context.report(diagnostic.with_help("end the subroutine with RETURN"));
}

/// Where the text of a stored program ends. What is typed at a prompt, and numbered lines, may go on elsewhere.
fn end_of_text(context: &Context<'_>, section: &SectionIndex) -> Option<Span> {
    let section = &section.section;
    let last = match section.closer {
        Some(closer) => closer,
        None if section.kind == SectionKind::Stored && context.index().implicit_program => {
            section.statements.end.checked_sub(1)?
        }
        None => return None,
    };
    Some(context.statement_span(last))
}

#[cfg(test)]
mod tests {
    use crate::testing::codes;

    fn sub(body: &str) -> Vec<(u32, &'static str)> {
        codes(&format!("PROG0\nPROGRAM\nGOSUB Sub\nEND\n_Sub\n{body}\nENDP\n"))
    }

    #[test]
    fn every_way_must_end_in_return_or_end() {
        assert_eq!(sub("IF (BIT 1) THEN RETURN"), [(7, "ACR117")]);
        assert_eq!(sub("IF (BIT 1)\nRETURN\nENDIF"), [(9, "ACR117")]);
        assert_eq!(sub("IF (BIT 1)\nRETURN\nELSE\nRETURN\nENDIF"), []);
        assert_eq!(sub("IF (BIT 1)\nRETURN\nELSEIF (BIT 2)\nRETURN\nENDIF"), [(11, "ACR117")]);
        assert_eq!(sub("WHILE (BIT 1)\nWEND\nEND"), []);
    }

    #[test]
    fn loops_end_where_they_are_left() {
        assert_eq!(sub("WHILE (1)\nSET 32\nWEND"), []);
        assert_eq!(sub("WHILE (1)\nIF (BIT 1) THEN BREAK\nWEND"), [(9, "ACR117")]);
        assert_eq!(sub("FOR P0 = 1 TO 3\nRETURN\nNEXT"), [(9, "ACR117")]);
        assert_eq!(sub("GOTO Sub"), []);
    }

    #[test]
    fn an_abort_through_goto_is_left_alone_beside_a_return() {
        assert_eq!(sub("IF (BIT 1) THEN GOTO Failed\nRETURN\n_Failed\nPRINT \"failed\""), []);
        assert_eq!(sub("GOTO Failed\n_Failed\nPRINT \"failed\""), [(9, "ACR117")]);
    }
}
