//! `ACR406`: user parameters without memory.

use acrc_catalog::OperandClass;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::Expr;
use acrc_syntax::units::Level;

use super::operands::{self, Index, Room};
use crate::Context;
use crate::rule::{Check, Group, On, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR406", name: "undimensioned-parameters" },
        group: Group::Memory,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "User parameters (P0 to P4095) are used, and the setup gives and clears memory but has no DIM P. It is \
               reported once a file.",
        why: "With factory settings there are no user parameters; the program stops at the first one.",
        bad: "SYS\nCLEAR\nDIM PROG0(4096)\nPROG0\nPROGRAM\nP5 = 1\nENDP",
        good: "SYS\nCLEAR\nDIM PROG0(4096)\nDIM P(6)\nPROG0\nPROGRAM\nP5 = 1\nENDP",
        guide: "System Configuration / Memory Allocations / System and Program Memory Levels",
    },
    checks: &[Check::Expression(On::Operand, check), Check::Expression(On::Alias, check)],
};

fn check(context: &mut Context<'_>, expr: &Expr) {
    if !context.memory().managed || context.memory().parameters.is_some() {
        return;
    }
    for place in operands::places(context, expr) {
        let Index::Number(number) = place.index else { continue };
        let name = (Level::System, OperandClass::Parameter, None);
        if place.room != Room::Parameters || !context.reported_variables.insert(name) {
            continue;
        }
        let written = context.slice(place.span);
        let message = if written.eq_ignore_ascii_case(&format!("P{number}")) {
            format!("{written} has no memory: the setup has no DIM P(n)")
        } else {
            format!("`{written}` (P{number}) has no memory: the setup has no DIM P(n)")
        };
        context.report(RULE.at(place.span, message).with_help(format!("DIM P({}) at the SYS prompt", number + 1)));
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, codes_in, lint};

    #[test]
    fn once_a_file() {
        let (setup, program) = ("SYS\nCLEAR\nDIM PROG0(4096)\n", "PROGRAM\nP5 = 1\nP6 = 1\nP4097 = 1\nENDP\n");
        let found = lint(&[("Setup.8K", setup), ("Prog0.8K", program)]);
        assert_eq!(codes_in(program, &found[1]), [(2, "ACR406")]);
        assert_eq!(found[1][0].help.as_deref(), Some("DIM P(6) at the SYS prompt"));
    }

    #[test]
    fn an_alias_is_one() {
        let text = "SYS\nCLEAR\nDIM PROG0(4096)\nDIM DEF(1)\n#DEFINE Count P7\nPROG0\nPROGRAM\nCount = 1\nENDP\n";
        assert_eq!(codes(text), [(8, "ACR406")]);
    }

    #[test]
    fn without_a_setup_nothing_is_known() {
        assert_eq!(codes("PROG0\nPROGRAM\nP5 = 1\nENDP\n"), []);
        assert_eq!(codes("SYS\nCLEAR\nDIM PROG0(4096)\nDIM P(P4100)\nPROG0\nPROGRAM\nP5 = 1\nENDP\n"), []);
    }
}
