//! `ACR409`: a text longer than the string that it is assigned to.

use acrc_catalog::OperandClass;
use acrc_diagnostics::{Code, Severity, Span};
use acrc_syntax::ast::{Expr, ExprKind, Statement, StatementKind};

use super::operands::{self, Room};
use super::sites;
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR409", name: "string-too-long" },
        group: Group::Memory,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A constant text is assigned to a string that DIM makes shorter.",
        why: "What does not fit is lost. A comparison with the whole text never holds, and an operator reads half a \
              message.",
        bad: "PROG0\nPROGRAM\nCLEAR\nDIM $V(1, 10)\n$V0 = \"waiting for the door\"\nENDP",
        good: "PROG0\nPROGRAM\nCLEAR\nDIM $V(1, 20)\n$V0 = \"waiting for the door\"\nENDP",
        guide: "System Configuration / Memory Allocations / How Much Memory?",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    let StatementKind::Assign(assign) = &statement.kind else { return };
    let Some(text) = constant(&assign.value) else { return };
    let target = operands::places(context, &assign.target).last();
    let Some(room) = target.map(|place| place.room) else { return };
    let extent = match room {
        Room::Variables(OperandClass::StringV) | Room::Elements(OperandClass::StringA, _) => room.extent(context),
        _ => return,
    };
    let Some((count, length)) = extent.and_then(|extent| Some((extent.count?, extent.length?))) else { return };
    let written = context.slice(text).chars().count() as u64;
    if written > length {
        let characters = sites::counted(written, "character");
        let dim = room.dim();
        let message = format!("the text has {characters} but {dim}({count}, {length}) holds {length}");
        context.report(RULE.at(assign.value.span, message).with_help(format!("{dim}({count}, {written})")));
    }
}

/// The characters of a constant text.
fn constant(value: &Expr) -> Option<Span> {
    match &value.kind {
        ExprKind::String(inner) => Some(*inner),
        ExprKind::Paren(inner) => constant(inner),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{codes, found_by};

    fn program(statements: &str) -> String {
        format!("PROG0\nPROGRAM\nCLEAR\nDIM $V(2,5)\nDIM $A(1)\nDIM $A0(3,4)\n{statements}\nENDP\n")
    }

    #[test]
    fn a_text_fits_to_the_character() {
        assert_eq!(codes(&program("$V0 = \"12345\"\n$A0(1) = \"1234\"")), []);
        assert_eq!(codes(&program("$V1 = \"123456\"")), [(7, "ACR409")]);
        assert_eq!(codes(&program("$A0(1) = \"12345\"")), [(7, "ACR409")]);
        let found = found_by("ACR409", &program("$V1 = \"123456\""));
        assert_eq!(found[0].message, "the text has 6 characters but DIM $V(2, 5) holds 5");
    }

    #[test]
    fn what_is_put_together_is_not_judged() {
        assert_eq!(codes(&program("$V1 = \"1234\" + \"56\"\nP0 = 1")), []);
    }

    #[test]
    fn an_alias_for_a_string() {
        let text = "SYS\nDIM DEF(1)\n#DEFINE Message $V0\nPROG0\nDIM $V(1,3)\nPROGRAM\nMessage = \"four\"\nENDP\n";
        assert_eq!(codes(text), [(7, "ACR409")]);
    }
}
