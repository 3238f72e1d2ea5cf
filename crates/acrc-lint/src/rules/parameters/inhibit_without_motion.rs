//! `ACR309`: INH in a program that moves nothing.

use acrc_analysis::SectionIndex;
use acrc_catalog::command;
use acrc_diagnostics::{Code, Diagnostic, Severity, Span};
use acrc_syntax::ast::StatementKind;
use acrc_syntax::units::{Level, SectionKind};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR309", name: "inhibit-without-motion" },
        group: Group::Parameters,
        severity: Severity::Warning,
        enabled: true,
        what: "A program that attaches no master waits with INH. In programs 8 to 15, when another one of them has code, \
               that is a warning, elsewhere it is advice. Projects that attach no master at all are left alone.",
        why: "Programs 8 to 15 share one slice of time: while one of them waits in INH, the others stand still, also the \
              one that watches for errors. The guide advises against INH in every program without motion.",
        bad: "PROG0\nATTACH MASTER0\nPROG8\nPROGRAM\nINH 24\nSET 32\nENDP\nPROG9\nPROGRAM\nSET 33\nENDP",
        good: "PROG0\nATTACH MASTER0\nPROG8\nPROGRAM\nWHILE (NOT BIT 24)\nWEND\nSET 32\nENDP\nPROG9\nPROGRAM\nSET 33\nENDP",
        guide: "Programming Basics / INH",
    },
    checks: &[Check::Section(check)],
};

/// The programs that share one slice.
const SHARED: std::ops::RangeInclusive<u8> = 8..=15;

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    let Level::Program(program) = section.section.level else { return };
    let machine = context.machine();
    let moves = machine.masters.iter().any(|(_, level)| *level == section.section.level);
    if section.section.kind != SectionKind::Stored || moves || machine.masters.is_empty() || machine.open {
        return;
    }
    let Some(first) = first_inhibit(context, section) else { return };
    let others = if SHARED.contains(&program) { others(context, program) } else { Vec::new() };
    let finding = match others.as_slice() {
        [] => {
            let message = format!("INH in program {program}, which attaches no master");
            Diagnostic { severity: Severity::Advice, ..RULE.at(first, message) }
        }
        [other] => RULE.at(first, format!("this INH holds program {other}, too, while program {program} waits")),
        _ => RULE.at(first, format!("this INH holds programs {}, too, while program {program} waits", list(&others))),
    };
    context.report(finding.with_help("test the bit in a loop instead: WHILE (..) and WEND let the others run"));
}

fn first_inhibit(context: &Context<'_>, section: &SectionIndex) -> Option<Span> {
    let range = section.section.statements.start as usize..section.section.statements.end as usize;
    let statements = context.tree().statements().get(range)?;
    let inhibit = |kind: &StatementKind| matches!(kind, StatementKind::Command(c) if c.id == command::INH);
    statements.iter().find(|statement| inhibit(&statement.kind)).map(|statement| statement.span)
}

/// The other programs of the shared slice that have code.
fn others(context: &Context<'_>, program: u8) -> Vec<u8> {
    let programs = context.usage().programs.iter().filter_map(|level| match level {
        Level::Program(other) if SHARED.contains(other) && *other != program => Some(*other),
        _ => None,
    });
    programs.collect()
}

fn list(numbers: &[u8]) -> String {
    numbers.iter().map(u8::to_string).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use acrc_diagnostics::Severity;

    use crate::testing::{lint, spans_of};

    fn severities(text: &str) -> Vec<Severity> {
        let found = lint(&[("test.8K", text)]).concat();
        found.iter().filter(|found| found.code.id == "ACR309").map(|found| found.severity).collect()
    }

    const MOTION: &str = "PROG0\nATTACH MASTER0\nPROGRAM\nINH -516\nENDP\n";

    #[test]
    fn the_first_inhibit_of_a_program_without_master() {
        let text = format!("{MOTION}PROG1\nPROGRAM\nINH 24\nINH -24\nENDP\n");
        assert_eq!(spans_of("ACR309", &text), ["INH 24"]);
        assert_eq!(severities(&text), [Severity::Advice]);
    }

    #[test]
    fn programs_of_the_shared_slice_hold_each_other() {
        let waiting = "PROG8\nPROGRAM\nINH 24\nENDP\n";
        assert_eq!(severities(&format!("{MOTION}{waiting}")), [Severity::Advice], "alone");
        let text = format!("{MOTION}{waiting}PROG9\nPROGRAM\nSET 32\nENDP\nPROG10\nPROGRAM\nENDP\n");
        assert_eq!(severities(&text), [Severity::Warning]);
        let found = lint(&[("test.8K", &text)]).concat();
        assert_eq!(found[0].message, "this INH holds program 9, too, while program 8 waits");
    }

    #[test]
    fn nothing_is_known_of_a_piece_of_code() {
        assert_eq!(spans_of("ACR309", "PROG8\nPROGRAM\nINH 24\nENDP\n"), [""; 0]);
        assert_eq!(spans_of("ACR309", "PROG8\nATTACH MASTER7\nPROGRAM\nINH -516\nENDP\n"), [""; 0]);
    }
}
