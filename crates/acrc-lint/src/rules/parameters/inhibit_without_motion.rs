//! `ACR309`: INH, and DWL, in a program that moves nothing.

use acrc_analysis::SectionIndex;
use acrc_catalog::{CommandId, command};
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
        mark: None,
        what: "A program that attaches no master waits with INH. In programs 8 to 15, when another one of them has code, \
               each is a warning, and the first DWL is advice; elsewhere the first INH is advice. Projects that attach no \
               master at all are left alone.",
        why: "Programs 8 to 15 share one slice of time: while one of them waits in INH, the others stand still, also the \
              one that watches for errors; so they do while one waits in DWL. The guide advises against INH in every program without motion.",
        bad: "PROG0\nATTACH MASTER0\nPROG8\nPROGRAM\nINH 24\nSET 32\nENDP\nPROG9\nPROGRAM\nSET 33\nENDP",
        good: "PROG0\nATTACH MASTER0\nPROG8\nPROGRAM\nWHILE (NOT BIT 24)\nWEND\nSET 32\nENDP\nPROG9\nPROGRAM\nSET 33\nENDP",
        guide: "Programming Basics / INH",
    },
    checks: &[Check::Section(check)],
};

const HELP: &str = "test the bit in a loop instead: WHILE (..) and WEND let the others run";

/// The programs that share one slice.
const SHARED: std::ops::RangeInclusive<u8> = 8..=15;

fn check(context: &mut Context<'_>, section: &SectionIndex) {
    let Level::Program(program) = section.section.level else { return };
    let machine = context.machine();
    let moves = machine.masters.iter().any(|(_, level)| *level == section.section.level);
    if section.section.kind != SectionKind::Stored || moves || machine.masters.is_empty() || machine.open {
        return;
    }
    let others = if SHARED.contains(&program) { others(context, program) } else { Vec::new() };
    let [inhibits, dwells] = [command::INH, command::DWL].map(|wait| places(context, section, wait));
    let held = match others.as_slice() {
        [] => {
            if let Some(first) = inhibits.first() {
                let message = format!("INH in program {program}, which attaches no master");
                let finding = Diagnostic { severity: Severity::Advice, ..RULE.at(*first, message) };
                context.report(finding.with_help(HELP));
            }
            return;
        }
        [other] => format!("program {other}, too, while program {program} waits"),
        _ => format!("programs {}, too, while program {program} waits", list(&others)),
    };
    for inhibit in inhibits {
        context.report(RULE.at(inhibit, format!("this INH holds {held}")).with_help(HELP));
    }
    if let Some(first) = dwells.first() {
        let finding = RULE.at(*first, format!("this DWL holds {held}"));
        let finding = finding.with_help("move the program to one of 0 to 7, which have time of their own");
        context.report(Diagnostic { severity: Severity::Advice, ..finding });
    }
}

/// Where a section has a command.
fn places(context: &Context<'_>, section: &SectionIndex, wanted: CommandId) -> Vec<Span> {
    let range = section.section.statements.start as usize..section.section.statements.end as usize;
    let statements = context.tree().statements().get(range).unwrap_or_default();
    let is_wanted = |kind: &StatementKind| matches!(kind, StatementKind::Command(c) if c.id == wanted);
    statements.iter().filter(|statement| is_wanted(&statement.kind)).map(|statement| statement.span).collect()
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
        let waits = "PROG8\nPROGRAM\nINH 24\nDWL 1\nINH -24\nDWL 1\nENDP\nPROG9\nPROGRAM\nSET 32\nENDP\n";
        let text = format!("{MOTION}{waits}");
        assert_eq!(spans_of("ACR309", &text), ["INH 24", "DWL 1", "INH -24"]);
        assert_eq!(severities(&text), [Severity::Warning, Severity::Advice, Severity::Warning]);
    }

    #[test]
    fn nothing_is_known_of_a_piece_of_code() {
        assert_eq!(spans_of("ACR309", "PROG8\nPROGRAM\nINH 24\nENDP\n"), [""; 0]);
        assert_eq!(spans_of("ACR309", "PROG8\nATTACH MASTER7\nPROGRAM\nINH -516\nENDP\n"), [""; 0]);
    }
}
