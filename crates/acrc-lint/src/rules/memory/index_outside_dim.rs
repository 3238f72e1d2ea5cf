//! `ACR403`: a constant number beyond what is dimensioned.

use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{Expr, ExprKind};

use super::operands::{self, Index};
use super::sites;
use crate::Context;
use crate::rule::{Check, Group, On, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR403", name: "index-outside-dim" },
        group: Group::Memory,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "A variable, an array, an element or a user parameter has a number beyond what DIM makes room for. Numbers \
               begin at 0, so DIM LV(5) gives LV0 to LV4.",
        why: "The program stops with an error when it gets there, perhaps hours after it was started.",
        bad: "PROG0\nPROGRAM\nCLEAR\nDIM LV(2)\nLV2 = 1\nENDP",
        good: "PROG0\nPROGRAM\nCLEAR\nDIM LV(3)\nLV2 = 1\nENDP",
        guide: "System Configuration / Memory Allocations",
    },
    checks: &[Check::Expression(On::Operand, check), Check::Expression(On::Alias, check)],
};

fn check(context: &mut Context<'_>, expr: &Expr) {
    for place in operands::places(context, expr) {
        let Index::Number(number) = place.index else { continue };
        let Some(count) = place.room.extent(context).and_then(|extent| extent.count) else { continue };
        if u64::try_from(number).is_ok_and(|number| number < count) {
            continue;
        }
        let dim = place.room.dim();
        let written = context.slice(place.span);
        let name = match expr.kind {
            ExprKind::Alias => format!("`{written}` ({}{number})", place.room.class()),
            _ => written.to_owned(),
        };
        let message = format!("{name} is outside {dim}({count}): it gives {}", place.room.contents(count));
        let diagnostic = RULE.at(place.span, message);
        let diagnostic = match number.checked_add(1).filter(|needed| *needed > 0) {
            Some(needed) => diagnostic.with_help(format!("{dim}({needed}) makes room for it")),
            None => diagnostic.with_help("numbers begin at 0"),
        };
        context.report_by(sites::confidence(place.room.class()), diagnostic);
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, codes_in, lint};

    fn program(statements: &str) -> Vec<(u32, &'static str)> {
        codes(&format!(
            "PROG0\nPROGRAM\nCLEAR : DIM LV(2) : DIM $V(1,10) : DIM LA(1) : DIM LA0(5)\n{statements}\nENDP\n"
        ))
    }

    #[test]
    fn numbers_begin_at_zero() {
        assert_eq!(program("LV0 = LV1\n$V0 = \"\"\nLA0(0) = LA0(4)"), []);
        assert_eq!(program("LV2 = 1"), [(4, "ACR403")]);
        assert_eq!(program("$V1 = \"\""), [(4, "ACR403")]);
        assert_eq!(program("LA0(5) = 1"), [(4, "ACR403")]);
        assert_eq!(program("LA1(0) = 1"), [(4, "ACR403")]);
        assert_eq!(program("LV(-1) = 1"), [(4, "ACR403")]);
    }

    #[test]
    fn the_message_says_what_there_is() {
        let found = lint(&[("test.8K", "PROG0\nDIM LV(5)\nPROGRAM\nLV7 = 1\nENDP\n")]).concat();
        assert_eq!(found[0].message, "LV7 is outside DIM LV(5): it gives LV0 to LV4");
        assert_eq!(found[0].help.as_deref(), Some("DIM LV(8) makes room for it"));
    }

    #[test]
    fn user_parameters_are_the_same_for_all() {
        let (setup, program) = ("SYS\nDIM P(100)\n", "PROGRAM\nP99 = P100\nP4097 = 1\nP12288 = 0\nENDP\n");
        let found = lint(&[("Setup.8K", setup), ("Prog3.8K", program)]);
        assert_eq!(codes_in(program, &found[1]), [(2, "ACR403")]);
    }

    #[test]
    fn an_alias_names_what_it_stands_for() {
        let text = "SYS\nDIM P(10)\nDIM DEF(2)\n#DEFINE Cycles P10\n#DEFINE Count LV3\nPROG0\nDIM LV(3)\nPROGRAM\nCycles = Count\nENDP\n";
        let found = lint(&[("test.8K", text)]).concat();
        let messages: Vec<_> = found.iter().map(|found| found.message.as_str()).collect();
        assert_eq!(
            messages,
            [
                "`Cycles` (P10) is outside DIM P(10): it gives P0 to P9",
                "`Count` (LV3) is outside DIM LV(3): it gives LV0 to LV2"
            ]
        );
    }

    #[test]
    fn the_largest_of_several_sizes_counts() {
        assert_eq!(
            codes("PROG0\nPROGRAM\nCLEAR\nIF (BIT 1)\nDIM LV(3)\nELSE\nDIM LV(9)\nENDIF\nLV8 = 1\nLV9 = 1\nENDP\n"),
            [(10, "ACR403")]
        );
        assert_eq!(codes("PROG0\nDIM LV(P0)\nPROGRAM\nLV9 = 1\nENDP\n"), [], "a computed size");
    }

    #[test]
    fn a_piece_of_code_is_not_judged() {
        assert_eq!(codes("DIM LV(2)\nLV2 = 1\n"), []);
    }
}
