//! `ACR405`: a local variable that nothing gives memory to.

use acrc_analysis::memory::LocalBlock;
use acrc_diagnostics::{Code, Diagnostic, Severity};
use acrc_syntax::ast::{Expr, ExprKind};
use acrc_syntax::units::SectionKind;

use super::operands::{self, Index, Room};
use super::sites;
use crate::rule::{Check, Group, On, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR405", name: "undimensioned-variable" },
        group: Group::Memory,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "A program uses local variables of a class, or an array, that no DIM gives memory to: neither at the prompt \
               of the program nor in its text. It is a warning when the project neither dimensions nor clears anything \
               else: allocations outlive a download, so that the controller may have the memory from before. A lone \
               piece of code is not judged.",
        why: "With factory settings a program has no local variables. It stops with an error at the first one.",
        bad: "PROG0\nPROGRAM\nCLEAR\nDIM LV(2)\nDV0 = 0.5\nENDP",
        good: "PROG0\nPROGRAM\nCLEAR\nDIM LV(2)\nDIM DV(1)\nDV0 = 0.5\nENDP",
        guide: "System Configuration / Memory Allocations / System and Program Memory Levels",
    },
    checks: &[Check::Expression(On::Operand, check), Check::Expression(On::Alias, check)],
};

fn check(context: &mut Context<'_>, expr: &Expr) {
    let level = context.level();
    let known = context.memory().locals(level).is_some_and(|dims| !dims.is_empty()) || context.memory().managed;
    if !known && !is_complete(context) {
        return;
    }
    for place in operands::places(context, expr) {
        if place.room == Room::Parameters || place.room.extent(context).is_some() {
            continue;
        }
        let class = place.room.class();
        let array = match place.room {
            Room::Elements(_, array) => Some(u64::from(array)),
            _ => None,
        };
        // What has no reference has no elements either, and that is said; a number beyond the references is outside.
        if let Some(array) = array {
            let references =
                context.memory().locals(level).and_then(|dims| dims.extent(LocalBlock::References(class), 0));
            if references.is_none_or(|extent| extent.count.is_some_and(|count| array >= count)) {
                continue;
            }
        }
        let name = (level, class, array);
        if !context.reported_variables.insert(name) {
            continue;
        }
        let (program, dim) = (level_name(level), place.room.dim());
        let written = context.slice(place.span);
        let what = match (place.room, place.index) {
            (Room::Elements(class, array), _) => format!("{class}{array} has no elements: {program} has no {dim}(n)"),
            (_, Index::Number(number)) if matches!(expr.kind, ExprKind::Alias) => {
                format!("`{written}` ({class}{number}) has no memory: {program} has no {dim}(n)")
            }
            (_, Index::Number(number)) => format!("{class}{number} has no memory: {program} has no {dim}(n)"),
            (_, Index::Computed(_)) => format!("{written} has no memory: {program} has no {dim}(n)"),
        };
        let help = match place.index {
            Index::Number(number) => format!("{dim}({}) at its prompt or at its beginning", number.saturating_add(1)),
            Index::Computed(_) => format!("{dim}(n) at its prompt or at its beginning"),
        };
        let diagnostic = RULE.at(place.span, what).with_help(help);
        let diagnostic = if known { diagnostic } else { Diagnostic { severity: Severity::Warning, ..diagnostic } };
        context.report_by(sites::confidence(class), diagnostic);
    }
}

/// Whether the statement belongs to a stored program of a project that shows more than a piece of code.
fn is_complete(context: &Context<'_>) -> bool {
    let is_stored = context.section().is_some_and(|section| section.section.kind == SectionKind::Stored);
    is_stored && !context.environment().fragment
}

#[cfg(test)]
mod tests {
    use acrc_diagnostics::Severity;

    use crate::testing::{codes, codes_in, found_by, lint};

    #[test]
    fn a_class_is_reported_once_a_program() {
        assert_eq!(
            codes(
                "SYS\nCLEAR\nDIM PROG0(900)\nDIM PROG1(900)\nPROG0\nPROGRAM\nLV0=1\nLV1=DV0\nENDP\nPROG1\nPROGRAM\nLV0=1\nENDP\n"
            ),
            [(7, "ACR405"), (8, "ACR405"), (12, "ACR405")]
        );
    }

    #[test]
    fn any_dim_of_the_program_counts() {
        assert_eq!(codes("PROG0\nDIM LV(1)\nPROGRAM\nLV0=1\nENDP\n"), []);
        assert_eq!(codes("PROG0\nPROGRAM\nGOSUB A\nLV0=1\nEND\n_A\nCLEAR\nDIM LV(1)\nRETURN\nENDP\n"), []);
        let (setup, program) = ("PROG2\nDIM SV(3)\n", "PROGRAM\nSV2 = LV0\nENDP\n");
        let found = lint(&[("Setup.8K", setup), ("Prog2.8K", program)]);
        assert_eq!(codes_in(program, &found[1]), [(2, "ACR405")]);
        let message = found[1].iter().find(|found| found.code.id == "ACR405").map(|found| found.message.as_str());
        assert_eq!(message, Some("LV0 has no memory: program 2 has no DIM LV(n)"));
    }

    #[test]
    fn arrays_need_references_and_elements() {
        let text = |dims: &str| format!("PROG0\nDIM LV(1)\n{dims}PROGRAM\nLA0(LV0)=1\nENDP\n");
        let found = found_by("ACR405", &text(""));
        assert_eq!(found.len(), 1, "{found:#?}");
        assert_eq!(found[0].message, "LA0 has no memory: program 0 has no DIM LA(n)");
        let found = found_by("ACR405", &text("DIM LA(1)\n"));
        assert_eq!(found[0].message, "LA0 has no elements: program 0 has no DIM LA0(n)");
        assert_eq!(codes(&text("DIM LA(1)\nDIM LA0(5)\n")), []);
    }

    #[test]
    fn without_any_dim_nothing_is_known() {
        assert_eq!(codes("FOR LV0=1 TO 5\nSET (LV0)\nNEXT\n"), [], "a piece of code");
        assert_eq!(found_by("ACR405", "PROG0\nPROGRAM\nLV0=1\nENDP\n")[0].severity, Severity::Warning);
        assert_eq!(found_by("ACR405", "PROG0\nCLEAR\nDIM DV(1)\nPROGRAM\nLV0=1\nENDP\n")[0].severity, Severity::Error);
        assert_eq!(codes("PLC0\nPROGRAM\nLD 5\nENDP\n"), []);
    }
}
