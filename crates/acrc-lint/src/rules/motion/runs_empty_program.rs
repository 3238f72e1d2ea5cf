//! `ACR517`: a start of a program that has no text.

use acrc_analysis::Deed;
use acrc_analysis::deed::{On, acts};
use acrc_catalog::ObjectKind;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{Statement, StatementKind};
use acrc_syntax::units::Level;

use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR517", name: "runs-empty-program" },
        group: Group::Motion,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A RUN or LRUN names a program for which the project holds no text.",
        why: "Nothing runs, or what somebody left in the controller does. A number that is one off starts the wrong \
              half of a machine.",
        bad: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nSET 32\nENDP\nRUN PROG1",
        good: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nSET 32\nENDP\nRUN PROG0",
        guide: "Programming Basics / Programs and Commands",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    let StatementKind::Command(command) = &statement.kind else { return };
    let machine = context.machine();
    // A project without programs is a setup whose programs are elsewhere.
    if !machine.complete || machine.programs.is_empty() {
        return;
    }
    for act in acts(command).filter(|act| act.deed == Deed::Run) {
        let level = match act.on {
            On::Object(ObjectKind::Prog, Some(number)) => u8::try_from(number).map(Level::Program),
            On::Object(ObjectKind::Plc, Some(number)) => u8::try_from(number).map(Level::Plc),
            _ => continue,
        };
        let Ok(level) = level else { continue };
        if machine.programs.binary_search(&level).is_err() {
            let message = format!("{} is started, but the project holds no text for it", level_name(level));
            context.report(RULE.at(act.span, message));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::lines_of;

    const SETUP: &str = "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\n";

    fn found(program: &str) -> Vec<u32> {
        lines_of("ACR517", &[("Setup.8K", SETUP), ("Prog0.8K", program), ("PLC2.8K", "PROGRAM\nLD 5\nOUT 32\nENDP\n")])
            .concat()
    }

    #[test]
    fn programs_without_text() {
        assert_eq!(found("PROGRAM\nRUN PROG3\nRUN PLC1\nLRUN PROG4\nENDP\n"), [2, 3, 4]);
    }

    #[test]
    fn programs_with_text_and_commands_that_start_nothing() {
        assert_eq!(found("PROGRAM\nRUN PLC2\nRUN PROG0\nRUN ALL\nHALT PROG3\nRUN\nENDP\n"), [0; 0]);
    }
}
