//! `ACR516`: a program that nothing starts.

use acrc_analysis::{Deed, SectionIndex};
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::units::{Level, SectionKind};

use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR516", name: "program-never-started" },
        group: Group::Motion,
        severity: Severity::Advice,
        enabled: false,
        mark: None,
        what: "A program neither begins with PBOOT nor is started anywhere in the project, by RUN, LRUN or its run \
               request flag. A host or an operator often starts programs, so the rule is off until it is selected.",
        why: "After power-up the program stands still, and what it should watch goes on unwatched.",
        bad: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROG1\nPROGRAM\nINH 5\nSET 32\nENDP",
        good: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROG1\nPROGRAM\nPBOOT\nINH 5\nSET 32\n\
               ENDP",
        guide: "Basic Setup / Startup Programs",
    },
    checks: &[Check::Section(check)],
};

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    let section = &section.section;
    let machine = context.machine();
    let is_program = section.kind == SectionKind::Stored && matches!(section.level, Level::Program(_));
    if !is_program || !machine.complete || section.statements.is_empty() {
        return;
    }
    if machine.never_at(Deed::Run, section.level) && machine.never_at(Deed::Boot, section.level) {
        let span = context.statement_span(section.opener.unwrap_or(section.statements.start));
        let message = format!("nothing in the project starts {}", level_name(section.level));
        context.report(
            RULE.at(span, message).with_help("begin it with PBOOT, or start it with RUN from a program that runs"),
        );
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::lines_of;

    const SETUP: &str = "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n";

    fn found(setup: &str, program: &str) -> Vec<u32> {
        let setup = format!("{SETUP}SYS\n{setup}\n");
        lines_of("ACR516", &[("Setup.8K", &setup), ("Prog1.8K", program)]).concat()
    }

    #[test]
    fn nothing_starts_it() {
        assert_eq!(found("RUN PROG0", "PROGRAM\nSET 32\nENDP\n"), [1]);
        assert_eq!(found("", "REM text as a whole\nSET 32\n"), [1]);
    }

    #[test]
    fn every_way_of_starting() {
        for start in ["RUN PROG1", "LRUN PROG1", "RUN ALL", "PROG1\nRUN", "SET 1064", "SET (1032 + 32 * P0)"] {
            assert_eq!(found(start, "PROGRAM\nSET 32\nENDP\n"), [0; 0], "{start}");
        }
        assert_eq!(found("", "PROGRAM\nPBOOT\nSET 32\nENDP\n"), [0; 0]);
    }
}
