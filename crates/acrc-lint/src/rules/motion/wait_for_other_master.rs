//! `ACR524`: a wait for the end of a move that watches another master.

use acrc_analysis::{Deed, walk};
use acrc_catalog::command;
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{ExprKind, Statement, StatementKind};

use super::straight::{self, Wait};
use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR524", name: "wait-for-other-master" },
        group: Group::Motion,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "An INH, or a loop that only waits, directly behind a move of the program waits for the in-motion flag of \
               another master: one without axes; or one of another program, while this program nowhere looks whether \
               its own motion is over, or switches something behind the wait and moves on without having looked.",
        why: "Each master has its own flag (516 + 32 * master, for the first eight). The flag of a master that stands \
              still is off, so the program does not wait at all: what should happen at the end of the move happens at \
              its start.",
        bad: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROG1\nATTACH MASTER1\nATTACH SLAVE0 AXIS1 \"Z\"\n\
              PROGRAM\nZ10\nINH -516\nSET 32\nENDP",
        good: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROG1\nATTACH MASTER1\nATTACH SLAVE0 AXIS1 \"Z\"\n\
               PROGRAM\nZ10\nINH -548\nSET 32\nENDP",
        guide: "Programming Basics / Program Flow",
    },
    checks: &[Check::Statement(check)],
};

/// The flag of a master that is on while its moves run.
const IN_MOTION: &str = "in_motion";

fn check(context: &mut Context<'_>, statement: &Statement) {
    let waits = straight::waits(context, statement);
    let [Wait { span, flag, .. }] = waits.as_slice() else { return };
    if flag.field != IN_MOTION {
        return;
    }
    let (Some(master), Some(own)) = (flag.object_index, straight::only_master(context)) else { return };
    let Some(right) = acrc_catalog::bit_number(IN_MOTION, own) else { return };
    if master == own || !follows_move(context) {
        return;
    }
    if has_axes(context, master) && looks_at_itself(context, right) && !acts_before_next_move(context) {
        return;
    }
    let number = flag.number;
    let message = format!("flag {number} is that of MASTER{master}, and the move before is one of MASTER{own}");
    let program = level_name(context.level());
    context.report(RULE.at(*span, message).with_help(format!("the moves of {program} are in motion at flag {right}")));
}

/// Whether a move stands directly before the wait, and no other wait between.
fn follows_move(context: &Context<'_>) -> bool {
    let nearest = straight::before(context).into_iter().take_while(|statement| !straight::is_wait(statement));
    nearest.into_iter().any(|statement| is_move(context, statement))
}

fn is_move(context: &Context<'_>, statement: &Statement) -> bool {
    straight::deeds(context, statement).iter().any(|(deed, _)| *deed == Deed::Move)
}

/// Whether flags are switched behind the wait, before the program makes its next move, and nothing else is waited for
/// between: what is switched belongs to the end of the move before.
fn acts_before_next_move(context: &Context<'_>) -> bool {
    let behind = straight::after(context);
    let until_move = behind.iter().position(|statement| is_move(context, statement) || straight::is_wait(statement));
    let Some((between, end)) = until_move.and_then(|at| Some((behind.get(..at)?, behind.get(at)?))) else {
        return false;
    };
    let switches = |statement: &&Statement| {
        let StatementKind::Command(command) = &statement.kind else { return false };
        matches!(command.id, command::SET | command::CLR)
    };
    is_move(context, end) && between.iter().any(switches)
}

/// Whether a master may move something.
fn has_axes(context: &Context<'_>, master: u32) -> bool {
    let machine = context.machine();
    let mut levels = machine.masters.iter().filter(|(other, _)| *other == master).map(|(_, level)| *level);
    levels.any(|level| machine.axes.iter().any(|(_, of)| *of == level))
}

/// Whether the present program looks somewhere whether its own motion is over: then it may well wait for other masters
/// besides.
fn looks_at_itself(context: &Context<'_>, in_motion: u32) -> bool {
    let (Some(section), level) = (context.section(), context.level()) else { return false };
    let axes = context.machine().axes.iter().filter(|(_, of)| *of == level);
    let in_position = axes.filter_map(|(axis, _)| acrc_catalog::bit_number("not_in_position", *axis));
    let flags: Vec<u32> = in_position.chain([in_motion]).collect();
    let is_own =
        |kind: &ExprKind| matches!(kind, ExprKind::Integer(n) if flags.iter().any(|flag| u64::from(*flag) == *n));

    let range = section.section.statements.start as usize..section.section.statements.end as usize;
    context.tree().statements().get(range).unwrap_or_default().iter().any(|statement| {
        let mut found = straight::waits(context, statement).iter().any(|wait| flags.contains(&wait.flag.number));
        walk::expressions(statement, &mut |expr| found |= is_own(&expr.kind));
        found
    })
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_of;

    fn found(program: &str) -> Vec<String> {
        let text = format!(
            "#DEFINE Moving BIT516\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROG2\nATTACH \
             MASTER2\nPROG1\nATTACH MASTER1\nATTACH SLAVE0 AXIS1 \"Z\"\nPROGRAM\n{program}\nENDP\n"
        );
        spans_of("ACR524", &text).into_iter().map(str::to_owned).collect()
    }

    #[test]
    fn the_flag_of_another_master() {
        assert_eq!(found("Z10\nINH -516\nSET 32"), ["-516"]);
        assert_eq!(found("Z10 : P0 = P0 + 1 : CLR 33\nREM wait\nINH -Moving"), ["-Moving"]);
        assert_eq!(found("IF (BIT 1) THEN Z10 : INH -516"), ["-516"]);
    }

    #[test]
    fn a_master_without_axes_is_never_in_motion() {
        assert_eq!(found("INH -548\nZ10\nINH -580"), ["-580"]);
    }

    #[test]
    fn something_is_switched_as_if_the_move_were_over() {
        assert_eq!(found("Z10\nINH -516\nSET 34\nDWL 1\nCLR 34\nZ0\nINH -548"), ["-516"]);
        assert_eq!(found("Z10\nWHILE (BIT 516)\nWEND\nSET 34\nZ0\nINH -548"), ["BIT 516"]);
    }

    #[test]
    fn waits_that_are_meant() {
        for program in [
            "Z10\nINH -548",
            "Z10\nINH -548\nINH -516",
            "INH -516\nZ10",
            "Z10\nINH -516\nZ0\nINH -548",
            "Z10\nINH -516\nSET 34\nINH -548\nZ0",
            "Z10\nINH -516\nSET 34\nIF (BIT 548) THEN SET 33\nZ0\nINH -548",
            "Z10\nINH -516\nSET 34\n_A\nZ0\nINH -548",
            "Z10\n_A\nINH -516",
            "IF (BIT 1) THEN Z10\nINH -516",
            "JOG INC Z5\nINH -516",
            "Z10\nINH -516\nIF (BIT 548) THEN SET 32",
            "Z10\nINH -516\nINH -800",
            "Z10\nINH 5\nINH -516",
        ] {
            assert_eq!(found(program), [""; 0], "{program}");
        }
    }
}
