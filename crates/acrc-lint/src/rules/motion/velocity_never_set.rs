//! `ACR506`: coordinated moves without a velocity.

use acrc_analysis::{Deed, walk};
use acrc_catalog::command;
use acrc_diagnostics::{Code, Severity, Span};
use acrc_syntax::ast::{Argument, Statement, StatementKind};
use acrc_syntax::units::Level;

use super::first_moves;
use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR506", name: "velocity-never-set" },
        group: Group::Motion,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A program has coordinated moves, and nothing in the project sets the velocity of its master, with \
               VEL or F, to anything but zero.",
        why: "The moves run at whatever velocity the controller holds. With zero the motor does not move and the \
              program waits for ever; with a value that somebody saved long ago it moves as nobody expects.",
        bad: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nACC 100 STP 100\nPROGRAM\nX10\nENDP",
        good: "AXIS0 PPU 1000\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nACC 100 STP 100 VEL 25\nPROGRAM\nX10\n\
               ENDP",
        guide: "Making Motion / What are Motion Profiles?",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    for motion in first_moves(context) {
        if !context.machine().never_at(Deed::Velocity, motion.level) {
            continue;
        }
        let program = level_name(motion.level);
        let (span, message) = match zero_velocity(context, motion.level) {
            Some(zero) => (zero, format!("{program} moves, and no other velocity than this zero is set for its moves")),
            None => (motion.span, format!("{program} moves, but nothing in the project gives its moves a velocity")),
        };
        context.report(RULE.at(span, message).with_help(format!(
            "set VEL (units/s) or F (units/min) beside the attachments of {program}, or before the move"
        )));
    }
}

/// A `VEL 0` of this file for the master of a program.
fn zero_velocity(context: &Context<'_>, level: Level) -> Option<Span> {
    let sections = context.index().sections.iter().filter(|section| section.section.level == level);
    let statements = sections.flat_map(|section| {
        let range = section.section.statements.start as usize..section.section.statements.end as usize;
        context.tree().statements().get(range).unwrap_or_default()
    });
    statements.filter(|statement| is_zero_velocity(statement)).map(|statement| statement.span).next()
}

fn is_zero_velocity(statement: &Statement) -> bool {
    let StatementKind::Command(command) = &statement.kind else { return false };
    (command.id == command::VEL || command.id == command::F)
        && command.prefix.is_none()
        && matches!(command.arguments.first(), Some(Argument::Value(value)) if walk::literal(value) == Some(0.0))
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(setup: &str, program: &str) -> Vec<String> {
        let text = format!(
            "AXIS0 PPU 1000\nPROG0\nATTACH MASTER3\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \
             \"Y\"\n{setup}\nPROG0\nPROGRAM\n{program}\nENDP\n"
        );
        spans_of("ACR506", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn the_first_move_of_the_program() {
        assert_eq!(found("", "JOG FWD X\nX\nVEL\nMOV Y5\nX10"), ["Y"]);
        assert_eq!(found("VEL 0", "X10"), ["VEL 0"]);
        assert_eq!(found("VEL 0", "F (P0)\nX10"), [""; 0]);
        assert_eq!(found("PROG1\nVEL 5", "X10"), ["X"], "the velocity of another program");
        assert_eq!(found("SYS\nMASTER0 VEL 5", "X10"), ["X"], "the velocity of another master");
    }

    #[test]
    fn every_way_of_setting_it() {
        for (setup, program) in [
            ("VEL 5", ""),
            ("F 300", ""),
            ("SYS\nMASTER3 VEL 5", ""),
            ("", "VEL (P0)"),
            ("", "IF (BIT 1) THEN F 300"),
            ("", "P(8192 + 256 * LV0) = 5"),
            ("SYS\nP8961 = 5", ""),
            ("PROG1\nPROGRAM\nMASTER3 VEL 5\nENDP", ""),
        ] {
            assert_eq!(found(setup, &format!("{program}\nX10")), [""; 0], "{setup} {program}");
        }
    }
}
