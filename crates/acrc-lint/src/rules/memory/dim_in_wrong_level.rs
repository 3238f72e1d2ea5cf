//! `ACR413`: a `DIM` at a prompt that does not know it.

use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{Statement, StatementKind};
use acrc_syntax::units::{Level, SectionKind};

use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR413", name: "dim-in-wrong-level" },
        group: Group::Memory,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "Memory is shared out at two levels: programs, PLC programs, user parameters, aliases and stream buffers at \
               the SYS prompt, local variables, arrays and the move buffer at the prompt of a program or in it. This DIM \
               stands at the other one.",
        why: "The controller refuses it there, and what it was for has no memory.",
        bad: "PROG0\nDIM P(100)",
        good: "SYS\nDIM P(100)\nPROG0\nDIM LV(4)",
        guide: "System Configuration / Memory Allocations / System and Program Memory Levels",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    let StatementKind::Dim(dim) = &statement.kind else { return };
    let (row, level) = (dim.id.info(), context.level());
    // At which prompt a piece of code is entered is not known.
    let unknown = context.environment().fragment && level == Level::System;
    let accepted = match level {
        Level::System => row.levels.sys(),
        Level::Program(_) => row.levels.prog(),
        Level::Plc(_) => row.levels.plc(),
    };
    if accepted || unknown {
        return;
    }
    let stored = context.section().is_some_and(|section| section.section.kind == SectionKind::Stored);
    let here = match level {
        Level::System => "at the SYS prompt".to_owned(),
        _ if stored => format!("in the text of {}", level_name(level)),
        _ => format!("at the prompt of {}", level_name(level)),
    };
    let place = if row.levels.sys() { "at the SYS prompt" } else { "at the prompt of a program or in its text" };
    let message = format!("{} is not possible {here}", row.name);
    let diagnostic = RULE.at(statement.span, message).with_help(format!("it belongs {place}"));
    context.report_by(row.confidence, diagnostic);
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, lint};

    #[test]
    fn system_memory_is_given_at_the_system_prompt() {
        assert_eq!(codes("SYS\nDIM P(10)\nDIM DEF(10)\nDIM PLC0(10)\n"), []);
        assert_eq!(
            codes("PROG0\nDIM P(10)\nDIM DEF(10)\nDIM PROG1(10)\n"),
            [(2, "ACR413"), (3, "ACR413"), (4, "ACR413")]
        );
        assert_eq!(codes("PROG0\nPROGRAM\nDIM P(10)\nENDP\n"), [(3, "ACR413")]);
    }

    #[test]
    fn variables_are_given_memory_at_the_prompt_of_their_program() {
        assert_eq!(codes("PROG0\nDIM LV(10)\nDIM $V(1,10)\nPROGRAM\nCLEAR\nDIM LA(1)\nENDP\n"), []);
        assert_eq!(codes("PROG0\nSYS\nDIM LV(10)\n"), [(3, "ACR413")]);
        let found = lint(&[("test.8K", "PROG0\nSYS\nDIM LV(10)\n")]).concat();
        assert_eq!(found[0].message, "DIM LV is not possible at the SYS prompt");
    }

    #[test]
    fn the_prompt_of_a_piece_of_code_is_not_known() {
        assert_eq!(codes("DIM LV(10)\n"), []);
    }
}
