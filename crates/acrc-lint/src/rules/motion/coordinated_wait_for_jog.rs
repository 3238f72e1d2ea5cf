//! `ACR526`: a wait for the end of a jog that watches the master.

use acrc_analysis::Deed;
use acrc_diagnostics::{Code, Severity, Span};
use acrc_syntax::ast::Statement;

use super::straight::{self, Wait};
use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR526", name: "coordinated-wait-for-jog" },
        group: Group::Motion,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "An INH, or a loop that only waits, directly behind a jog or a homing waits for the in-motion flag of the \
               master to go off, in a program without any coordinated move, or with none since the last such wait.",
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
    let waits = straight::waits(context, statement);
    let [Wait { span, flag, on: false }] = waits.as_slice() else { return };
    let own = straight::only_master(context);
    if flag.field != "in_motion" || own.is_none() || flag.object_index != own {
        return;
    }
    let Some(Jogged { axis, stood_still }) = jogged_before(context, flag.number) else { return };
    let level = context.level();
    // Moves of the program in another file count too.
    let moves = || {
        context.machine().first_file_moving(level).is_some()
            || context.motions().iter().any(|motion| motion.level == level && motion.deed == Deed::Move)
    };
    if stood_still.is_none() && moves() {
        return;
    }
    let message = match stood_still {
        Some(_) => format!("flag {} is off here: only a jog stands between this wait and the last one", flag.number),
        None => {
            let program = level_name(level);
            format!("flag {} never comes on here: {program} jogs and makes no coordinated move", flag.number)
        }
    };
    let mut diagnostic = RULE.at(*span, message);
    if let Some(earlier) = stood_still {
        diagnostic = diagnostic.with_related(earlier, "the master stands still from here on");
    }
    context.report(match acrc_catalog::bit_number("jog_active", axis) {
        Some(right) => diagnostic.with_help(format!("AXIS{axis} jogs while flag {right} is on: INH -{right}")),
        None => diagnostic,
    });
}

/// A jog before the wait.
struct Jogged {
    /// Its axis.
    axis: u32,
    /// An earlier wait for the same flag, with no move between.
    stood_still: Option<Span>,
}

/// The nearest jog before the wait, when nothing else is waited for between and no move stands before.
fn jogged_before(context: &Context<'_>, flag: u32) -> Option<Jogged> {
    let mut jogged = None;
    for statement in straight::before(context) {
        let mut waits = straight::waits(context, statement).into_iter();
        if let Some(axis) = jogged {
            if let Some(wait) = waits.find(|wait| wait.flag.number == flag && !wait.on) {
                return Some(Jogged { axis, stood_still: Some(wait.span) });
            }
        } else if straight::is_wait(statement) {
            return None;
        }
        for (deed, axis) in straight::deeds(context, statement) {
            match deed {
                Deed::Jog | Deed::Home if jogged.is_none() => jogged = Some(axis?),
                Deed::Move => return None,
                _ => {}
            }
        }
    }
    jogged.map(|axis| Jogged { axis, stood_still: None })
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_in_program;

    fn found(program: &str) -> Vec<String> {
        spans_in_program("ACR526", program)
    }

    #[test]
    fn a_program_that_only_jogs() {
        assert_eq!(found("JOG ABS X10\nINH -516"), ["-516"]);
        assert_eq!(found("JOG HOME X1 Y1 : SET 32\nREM wait\nINH -BIT516"), ["-BIT516"]);
    }

    #[test]
    fn a_wait_that_was_over_before_the_jog() {
        assert_eq!(found("X10\nINH -516\nJOG VEL X5\nJOG INC X5\nINH -516"), ["-516"]);
        assert_eq!(found("X10\nWHILE (BIT 516)\nWEND\nJOG INC X5\nDWL 1\nINH -516\nX0"), ["-516"]);
        assert_eq!(found("X10\nINH -516\nJOG INC X5\nWHILE (BIT 516)\nDWL 0.1\nWEND"), ["BIT 516"]);
    }

    #[test]
    fn waits_that_are_meant() {
        for program in [
            "JOG ABS X10\nINH -792\nINH -516",
            "JOG ABS X10\nINH -516\nY10",
            "X10\nINH -516\nY10\nJOG INC X5\nINH -516",
            "X10\nINH -516\nGOSUB A\nJOG INC X5\nINH -516\nEND\n_A\nX5\nRETURN",
            "X10\nINH -516\nJOG INC X5\nINH -792\nINH -516",
            "X10\nWHILE (BIT 516)\nIF (BIT 3) THEN X20\nWEND\nJOG INC X5\nINH -516",
            "X10 : JOG ABS Y10\nINH -516",
            "JOG ABS X10\nINH 516",
            "INH -516\nJOG ABS X10",
            "JOG ABS X10\nINH -548",
        ] {
            assert_eq!(found(program), [""; 0], "{program}");
        }
    }
}
