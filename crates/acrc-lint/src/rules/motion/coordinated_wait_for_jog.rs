//! `ACR526`: a wait for the end of a jog that watches the master.

use acrc_analysis::Deed;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{Statement, StatementKind};

use super::straight;
use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR526", name: "coordinated-wait-for-jog" },
        group: Group::Motion,
        severity: Severity::Warning,
        enabled: true,
        what: "An INH directly behind a jog or a homing waits for the in-motion flag of the master to go off, in a \
               program without any coordinated move.",
        why: "A jog is no move of the master: its flag (516 + 32 * master, for the first eight) stays off, and the \
              program goes on while the axis is still jogging. Each axis has a flag of its own for that, 792 + 32 * \
              axis.",
        bad: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nJOG VEL X5\nJOG ABS X10\nINH -516\nSET 32\n\
              ENDP",
        good: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nJOG VEL X5\nJOG ABS X10\nINH -792\nSET 32\n\
               ENDP",
        guide: "Making Motion / Jog Profiler",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    let StatementKind::Command(command) = &statement.kind else { return };
    let Some((bit, flag)) = straight::awaited(context, command) else { return };
    let own = straight::only_master(context);
    if flag.field != "in_motion" || !bit.negative || own.is_none() || flag.object_index != own {
        return;
    }
    let level = context.level();
    let Some(axis) = jogged_before(context) else { return };
    // Moves of the program in another file count too.
    let moves = context.machine().first_file_moving(level).is_some();
    if moves || context.motions().iter().any(|motion| motion.level == level && motion.deed == Deed::Move) {
        return;
    }
    let message =
        format!("flag {} never comes on here: {} jogs and makes no coordinated move", flag.number, level_name(level));
    let diagnostic = RULE.at(bit.span, message);
    context.report(match acrc_catalog::bit_number("jog_active", axis) {
        Some(right) => diagnostic.with_help(format!("AXIS{axis} jogs while flag {right} is on: INH -{right}")),
        None => diagnostic,
    });
}

/// The axis of the nearest jog before the wait, when nothing else is waited for between and no move stands before.
fn jogged_before(context: &Context<'_>) -> Option<u32> {
    for statement in straight::before(context) {
        if straight::awaited_by(context, statement).is_some() {
            return None;
        }
        for (deed, axis) in straight::deeds(context, statement) {
            match deed {
                Deed::Jog | Deed::Home => return axis,
                Deed::Move => return None,
                _ => {}
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(program: &str) -> Vec<String> {
        let text = format!(
            "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \
             \"Y\"\nPROGRAM\n{program}\nENDP\n"
        );
        spans_of("ACR526", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn a_program_that_only_jogs() {
        assert_eq!(found("JOG ABS X10\nINH -516"), ["-516"]);
        assert_eq!(found("JOG HOME X1 Y1 : SET 32\nREM wait\nINH -BIT516"), ["-BIT516"]);
    }

    #[test]
    fn waits_that_are_meant() {
        for program in [
            "JOG ABS X10\nINH -792\nINH -516",
            "JOG ABS X10\nINH -516\nY10",
            "X10 : JOG ABS Y10\nINH -516",
            "JOG ABS X10\nINH 516",
            "INH -516\nJOG ABS X10",
            "JOG ABS X10\nINH -548",
        ] {
            assert_eq!(found(program), [""; 0], "{program}");
        }
    }
}
