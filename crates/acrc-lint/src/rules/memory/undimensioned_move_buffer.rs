//! `ACR414`: the move buffer is switched on and has no memory.

use acrc_analysis::SectionIndex;
use acrc_analysis::memory::LocalDims;
use acrc_catalog::command;
use acrc_diagnostics::{Code, Diagnostic, Severity};
use acrc_syntax::ast::{Statement, StatementKind};
use acrc_syntax::units::{Level, SectionKind};

use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR414", name: "undimensioned-move-buffer" },
        group: Group::Memory,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A program switches its move buffer on with MBUF ON, and no DIM MBUF gives memory to it: neither at the prompt \
               of the program nor in its text. It is advice when the project neither dimensions nor clears anything \
               else: allocations outlive a download, so that the controller may have the memory from before. A lone \
               piece of code is not judged.",
        why: "Each move in the buffer takes 136 bytes of the program's memory, and with factory settings there is none for \
              it. The path that was to run without stops is cut at its corners, or the program ends there: no document \
              says which.",
        bad: "PROG0\nCLEAR\nDIM LV(2)\nATTACH MASTER0\nPROGRAM\nMBUF ON\nENDP",
        good: "PROG0\nCLEAR\nDIM LV(2)\nDIM MBUF(10)\nATTACH MASTER0\nPROGRAM\nMBUF ON\nENDP",
        guide: "System Configuration / Memory Allocations / How Much Memory?",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    let level = section.section.level;
    let range = section.section.statements.start as usize..section.section.statements.end as usize;
    let statements = context.tree().statements().get(range).unwrap_or_default();
    let Some(first) = statements.iter().find(|statement| switches_on(statement)) else { return };
    let dims = context.memory().locals(level);
    let is_complete = section.section.kind == SectionKind::Stored && !context.environment().fragment;
    let known = dims.is_some_and(|dims| !dims.is_empty()) || context.memory().managed;
    if !matches!(level, Level::Program(_)) || !(known || is_complete) || dims.is_some_and(LocalDims::has_moves) {
        return;
    }
    let program = level_name(level);
    let finding = RULE.at(first.span, format!("the move buffer has no memory: {program} has no DIM MBUF(n)"));
    let finding = finding.with_help("DIM MBUF(n) for n moves at its prompt or at its beginning");
    context.report(if known { finding } else { Diagnostic { severity: Severity::Advice, ..finding } });
}

/// `MBUF ON` for the program's own master. Behind `MASTERn` another program may have the memory.
fn switches_on(statement: &Statement) -> bool {
    matches!(&statement.kind, StatementKind::Command(command) if command.id == command::MBUF_ON && command.prefix.is_none())
}

#[cfg(test)]
mod tests {
    use acrc_diagnostics::Severity;

    use crate::testing::{found_by, lines_of, spans_of};

    fn found(text: &str) -> Vec<&str> {
        spans_of("ACR414", text)
    }

    #[test]
    fn once_a_program_text() {
        let text = "SYS\nCLEAR\nDIM PROG0(900)\nPROG0\nPROGRAM\nX1 : MBUF ON\nMBUF OFF\nMBUF ON\nENDP\n";
        assert_eq!(found(text), ["MBUF ON"]);
        assert_eq!(found_by("ACR414", text)[0].message, "the move buffer has no memory: program 0 has no DIM MBUF(n)");
        assert_eq!(found_by("ACR414", text)[0].severity, Severity::Warning);
    }

    #[test]
    fn any_dim_of_the_program_counts() {
        let text = |prompt: &str, inside: &str| {
            format!("SYS\nCLEAR\nDIM PROG0(900)\nPROG0\n{prompt}PROGRAM\n{inside}MBUF ON\nENDP\n")
        };
        assert_eq!(found(&text("DIM MBUF(5)\n", "")), [""; 0]);
        assert_eq!(found(&text("", "CLEAR\nDIM MBUF(P0)\n")), [""; 0]);
        assert_eq!(found(&text("DIM MBUF(5)\nPROG1\nDIM LV(1)\n", "")), ["MBUF ON"], "that of another program");
        let setup = "SYS\nCLEAR\nDIM PROG1(900)\nPROG1\nDIM MBUF(5)\n";
        let program = "PROGRAM\nMBUF ON\nENDP\n";
        let files = [("Setup.8K", setup), ("Prog0.8K", program), ("Prog1.8K", program)];
        assert_eq!(lines_of("ACR414", &files), [vec![], vec![2], vec![]]);
    }

    #[test]
    fn without_any_dim_nothing_is_known() {
        assert_eq!(found("MBUF ON\nX1\n"), [""; 0], "a piece of code");
        assert_eq!(found_by("ACR414", "PROG0\nPROGRAM\nMBUF ON\nENDP\n")[0].severity, Severity::Advice);
        assert_eq!(found("SYS\nCLEAR\nPROG0\nPROGRAM\nMASTER1 MBUF ON\nMBUF OFF\nENDP\n"), [""; 0]);
    }
}
