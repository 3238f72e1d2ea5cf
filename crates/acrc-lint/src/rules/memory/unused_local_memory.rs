//! `ACR415`: memory for variables that the program does not have.

use acrc_analysis::memory::local_class;
use acrc_analysis::{SectionIndex, walk};
use acrc_catalog::OperandClass;
use acrc_diagnostics::{Code, Severity, Span};
use acrc_syntax::ast::{Dim, StatementKind};
use acrc_syntax::units::Level;

use crate::locals::Locals;
use crate::rule::{Check, Group, Mark, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR415", name: "unused-local-memory" },
        group: Group::Memory,
        severity: Severity::Advice,
        enabled: true,
        mark: Some(Mark::Unnecessary),
        what: "A DIM LV, DV, SV or $V makes room for variables of which the program uses none, or less than half. A round \
               number (5, 10, 20) of which some are used is room to grow, and left alone. Programs whose whole text stands \
               in the file of the DIM are judged, and classes of which no variable is chosen by a computed number. Arrays, which \
               other commands fill, and a lone piece of code are left alone.",
        why: "The memory is taken from the program, and a variable that nobody uses is often one that was meant somewhere.",
        bad: "PROG0\nPROGRAM\nCLEAR\nDIM LV(3)\nLV0 = P4096\nPRINT LV0\nENDP",
        good: "PROG0\nPROGRAM\nCLEAR\nDIM LV(1)\nLV0 = P4096\nPRINT LV0\nENDP",
        guide: "System Configuration / Memory Allocations",
    },
    checks: &[Check::File(check)],
};

/// Who takes a multiple of it has not counted.
const ROUND: u64 = 5;

fn check(context: &mut Context<'_>) {
    if context.environment().fragment {
        return;
    }
    let dims = dims(context);
    let mut levels: Vec<Level> = dims.iter().map(|(level, ..)| *level).collect();
    levels.sort_unstable();
    levels.dedup();
    for level in levels {
        let index = context.index();
        let sections: Vec<&SectionIndex> = index.sections.iter().filter(|index| index.section.level == level).collect();
        if !sections.iter().any(|section| context.is_whole_program(section)) {
            continue;
        }
        let locals: Vec<Locals> = sections.iter().map(|section| Locals::new(context, section)).collect();
        for (_, class, count, dim) in dims.iter().filter(|(at, ..)| *at == level) {
            if !locals.iter().any(|locals| locals.is_computed(*class)) {
                judge(context, level, &locals, (*class, *count), dim);
            }
        }
    }
}

/// The DIM of single variables in the file, each with its level and a count that is written as a number.
fn dims<'a>(context: &Context<'a>) -> Vec<(Level, OperandClass, u64, &'a Dim)> {
    let statements = context.tree().statements();
    let mut found: Vec<(Level, OperandClass, u64, &'a Dim)> = Vec::new();
    for section in &context.index().sections {
        let range = section.section.statements.start as usize..section.section.statements.end as usize;
        for statement in statements.get(range).unwrap_or_default() {
            let StatementKind::Dim(dim) = &statement.kind else { continue };
            // `DIM LV10` may mean another number, and is a finding of its own.
            if !dim.parenthesised {
                continue;
            }
            let class = local_class(dim.id).filter(|class| !class.is_array());
            if let (Some(class), Some(count)) = (class, dim.sizes.first().and_then(walk::whole)) {
                found.push((section.section.level, class, count, dim));
            }
        }
    }
    found
}

fn judge(context: &mut Context<'_>, level: Level, locals: &[Locals], (class, count): (OperandClass, u64), dim: &Dim) {
    let mut used: Vec<u64> = locals
        .iter()
        .flat_map(Locals::by_variable)
        .filter_map(|mentions| mentions.first())
        .filter(|mention| mention.variable.class == class)
        .map(|mention| mention.variable.number)
        .collect();
    used.sort_unstable();
    used.dedup();
    let uses = used.len() as u64;
    // A number beyond the room is another finding.
    let fits = used.last().is_none_or(|last| *last < count);
    let is_reserve = uses > 0 && count.is_multiple_of(ROUND);
    let is_much = !is_reserve && uses.saturating_mul(2) < count;
    let Some(size) = dim.sizes.first().filter(|_| fits && is_much) else { return };
    let program = level_name(level);
    let message = match uses {
        0 => format!("{class} has room for {count}, and {program} uses none of them"),
        _ => format!("{class} has room for {count}, and {program} uses {uses} of them"),
    };
    let diagnostic = RULE.at(Span::cover(dim.name, size.span), message);
    context.report(match used.last() {
        Some(last) => diagnostic.with_help(format!("the last one is {class}{last}: {class}({}) is enough", last + 1)),
        None => diagnostic.with_help("leave the DIM out"),
    });
}

#[cfg(test)]
mod tests {
    use crate::testing::{found_by, lines_of, spans_of};

    fn found(dim: &str, body: &str) -> usize {
        spans_of("ACR415", &format!("#DEFINE Count LV0\nPROG0\nPROGRAM\n{dim}\n{body}\nENDP\n")).len()
    }

    #[test]
    fn less_than_half_is_used() {
        assert_eq!(found("DIM LV(3)", "Count = P1\nPRINT LV0"), 1);
        assert_eq!(found("DIM LV(2)", "Count = P1\nPRINT LV0"), 0);
        assert_eq!(found("DIM DV(1) : DIM $V(2, 10)", "PRINT LV0"), 2);
        assert_eq!(found("DIM LV(10)", "PRINT LV0"), 0, "room to grow");
        assert_eq!(found("DIM LV(10)", "PRINT P0"), 1);
        assert_eq!(found("DIM LV(4)", "PRINT LV(P0)"), 0, "any of them");
        assert_eq!(found("DIM LA(5) : DIM LA0(9)", "PRINT LV0"), 0, "arrays");
        assert_eq!(found("DIM LV(P0)", "PRINT LV0"), 0);
    }

    #[test]
    fn the_count_is_named() {
        let text = "PROG0\nDIM LV(9)\nPROGRAM\nLV3 = LV1\nENDP\n";
        let found = found_by("ACR415", text);
        assert_eq!(found[0].message, "LV has room for 9, and program 0 uses 2 of them");
        assert_eq!(found[0].help.as_deref(), Some("the last one is LV3: LV(4) is enough"));
        assert_eq!(spans_of("ACR415", text), ["DIM LV(9"]);
    }

    #[test]
    fn text_in_another_file_may_use_them() {
        let files = [("Setup.8K", "PROG0\nDIM LV(9)\n"), ("Prog0.8K", "PROGRAM\nLV3 = LV1\nENDP\n")];
        assert_eq!(lines_of("ACR415", &files), [[0; 0]; 2]);
        assert_eq!(spans_of("ACR415", "DIM LV(9)\nLV0 = 1\n"), [""; 0]);
    }
}
