//! `ACR525`: a wait for the end of a jog that watches another axis.

use acrc_analysis::Deed;
use acrc_diagnostics::{Code, Severity, Span};
use acrc_syntax::ast::Statement;

use super::straight::{self, Wait};
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR525", name: "wait-for-other-axis" },
        group: Group::Motion,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "An INH, or a loop that only waits, directly behind a jog or a homing waits for a jog or home flag of an \
               axis that the program never moves, or that it already waited for in the same way and did not move \
               since.",
        why: "The flags of an axis are 32 numbers apart from those of the next one, and they stay when a machine is \
              rewired. The program waits for an axis that stands still: for ever, or not at all, so that it goes on \
              while its own axis is still on its way.",
        bad: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nJOG VEL X5\nJOG HOME X-1\nINH 16166\nENDP",
        good: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nJOG VEL X5\nJOG HOME X-1\nINH 16134\nENDP",
        guide: "Making Motion / Homing",
    },
    checks: &[Check::Statement(check)],
};

/// The flags of an axis that tell of its jog profiler.
const FLAGS: [&str; 4] = ["jog_active", "home_found", "home_failed", "home_input"];

fn check(context: &mut Context<'_>, statement: &Statement) {
    let waits = straight::waits(context, statement);
    let Some(Wait { span, flag, .. }) = waits.first() else { return };
    let Some(axis) = flag.object_index else { return };
    if !waits.iter().all(|wait| FLAGS.contains(&wait.flag.field) && wait.flag.object_index == Some(axis)) {
        return;
    }
    let level = context.level();
    let moves = context.motions().iter().any(|motion| motion.level == level && motion.axis == axis);
    let (jogged, over) = if moves {
        let Some((jogged, over)) = jogged_since_wait(context, axis, &waits) else { return };
        (jogged, Some(over))
    } else {
        let Some(jogged) = jogged_before(context) else { return };
        (jogged, None)
    };
    let right = acrc_catalog::bit_number(flag.field, jogged);
    let message = format!("flag {} is that of AXIS{axis}, and the jog before is one of AXIS{jogged}", flag.number);
    let mut diagnostic = RULE.at(*span, message);
    if let Some(over) = over {
        diagnostic = diagnostic.with_related(over, format!("AXIS{axis} was waited for here, and did not move since"));
    }
    context.report(match right {
        Some(right) => diagnostic.with_help(format!("the same flag of AXIS{jogged} is {right}")),
        None => diagnostic,
    });
}

/// The axis of the nearest jog, when all axes that are jogged directly before the wait are known, and none of them is
/// waited for.
fn jogged_before(context: &Context<'_>) -> Option<u32> {
    let mut jogged = Vec::new();
    let mut awaited = Vec::new();
    for statement in straight::before(context) {
        awaited.extend(straight::waits(context, statement).iter().filter_map(|wait| wait.flag.object_index));
        for (deed, axis) in straight::deeds(context, statement) {
            if matches!(deed, Deed::Jog | Deed::Home) {
                jogged.push(axis?);
            }
        }
    }
    let nearest = jogged.first().copied()?;
    (!jogged.iter().any(|axis| awaited.contains(axis))).then_some(nearest)
}

/// The axis of the nearest jog since all `waits` for another axis were over once, with the place of the first of them:
/// when that axis was not jogged since, nobody else moves it, and no axis that was jogged is waited for.
fn jogged_since_wait(context: &Context<'_>, axis: u32, waits: &[Wait]) -> Option<(u32, Span)> {
    if context.machine().programs_moving(axis).iter().any(|(level, _)| *level != context.level()) {
        return None;
    }
    let (mut jogged, mut awaited) = (Vec::new(), Vec::new());
    for statement in straight::before(context) {
        let earlier = straight::waits(context, statement);
        let same = |wait: &Wait| earlier.iter().find(|e| e.flag.number == wait.flag.number && e.on == wait.on);
        if earlier.len() == waits.len() && waits.iter().all(|wait| same(wait).is_some()) {
            let nearest = *jogged.first()?;
            let over = same(waits.first()?)?.span;
            return (!jogged.iter().any(|axis| awaited.contains(axis))).then_some((nearest, over));
        }
        awaited.extend(earlier.iter().filter_map(|wait| wait.flag.object_index));
        for (deed, moved) in straight::deeds(context, statement) {
            if deed.is_motion() && moved == Some(axis) {
                return None;
            }
            if matches!(deed, Deed::Jog | Deed::Home) {
                jogged.push(moved?);
            }
        }
        if straight::writes(context, statement, axis) {
            return None;
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_in_program;

    fn found(program: &str) -> Vec<String> {
        spans_in_program("ACR525", program)
    }

    #[test]
    fn the_flag_of_an_axis_that_is_not_moved() {
        assert_eq!(found("JOG HOME X-1\nINH 16166\nSET 32"), ["16166"]);
        assert_eq!(found("JOG INC X5 Y5\nSET 32 : INH -BIT856"), ["-BIT856"]);
        assert_eq!(found("JOG HOME X-1 Y1\nINH 16194\nINH 16226"), ["16194", "16226"]);
    }

    #[test]
    fn the_flag_of_an_axis_that_is_no_longer_moved() {
        assert_eq!(found("JOG INC X5\nINH -792\nJOG INC Y5\nINH -792"), ["-792"]);
        let wait = "WHILE (NOT BIT 16134 AND NOT BIT 16135)\nWEND";
        assert_eq!(found(&format!("JOG HOME X1\n{wait}\nSET 16184\nJOG HOME Y1\n{wait}")), ["BIT 16134"]);
    }

    #[test]
    fn waits_that_are_meant() {
        for program in [
            "JOG HOME X-1\nINH 16134",
            "JOG HOME X-1\nINH 16130",
            "JOG INC X5\nINH -792\nINH -824",
            "JOG INC X5\nINH -824\nGOSUB A\nEND\n_A\nJOG INC Y5\nRETURN",
            "INH -824\nJOG INC X5",
            "JOG INC X5\nINH 792\nJOG INC Y5\nINH -792",
            "JOG INC X5\nINH -792\nJOG INC Y5 X2\nINH -792\nINH -824",
            "JOG INC X5\nINH -792\nJOG INC Y5\nINH -824\nINH -792",
            "JOG HOME X1\nINH 16134\nCLR 16134\nJOG HOME Y1\nINH 16134",
            "JOG INC X5\nINH -792\nWHILE (BIT 1)\nJOG INC X5\nWEND\nJOG INC Y5\nINH -792",
            "JOG INC X5\n_A\nINH -824",
            "X10\nINH -824",
            "JOG INC X5\nINH 24",
            "JOG INC AXIS 5\nINH -824",
        ] {
            assert_eq!(found(program), [""; 0], "{program}");
        }
    }
}
