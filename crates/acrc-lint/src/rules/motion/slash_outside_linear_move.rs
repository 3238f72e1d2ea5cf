//! `ACR519`: an incremental target in a move that is not linear.

use acrc_catalog::{CommandId, command};
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{Argument, Statement, StatementKind};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR519", name: "slash-outside-linear-move" },
        group: Group::Motion,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "An axis of a circle, an arc or a sine has a slash before its target. Only linear moves take one.",
        why: "The slash makes a target relative to the one before. In the other moves it means nothing: the controller \
              refuses the move, or reads the target as a position, and the tool goes somewhere else.",
        bad: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"\nCIRCW X/(10,5) Y/(0,0)",
        good: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"\nCIRCW X(10,5) Y(0,0)",
        guide: "Making Motion / Move Types",
    },
    checks: &[Check::Statement(check)],
};

/// The moves that are not linear.
const CURVED: [CommandId; 4] = [command::CIRCW, command::CIRCCW, command::SINE, command::TARC];

fn check(context: &mut Context<'_>, statement: &Statement) {
    let StatementKind::Command(command) = &statement.kind else { return };
    let mut kind = command.id;
    for argument in &command.arguments {
        match argument {
            Argument::Interpolation(id, _) => kind = *id,
            Argument::Axis(axis) if CURVED.contains(&kind) => {
                if let Some(slash) = axis.slash {
                    let (row, axis) = (kind.info(), context.slice(axis.name));
                    let message = format!("the slash of `{axis}` has no place in {}: it is for linear moves", row.name);
                    // One finding a statement is enough.
                    context.report(RULE.at(slash, message).with_help("write the positions of the targets themselves"));
                    return;
                }
            }
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::lines_of;

    fn found(text: &str) -> Vec<u32> {
        lines_of("ACR519", &[("test.8K", text)]).concat()
    }

    #[test]
    fn curved_moves_take_no_slash() {
        assert_eq!(found("CIRCCW X/(1,2) Y/(3,4)\nX2 SINE Y/(0,90,90,100)\n"), [1, 2]);
    }

    #[test]
    fn linear_moves_do() {
        assert_eq!(found("X/2 Y/3\nMOV X/2\nX/2 SINE Y(0,90,90,100)\nCIRCW X(1,2) Y(3,4)\n"), [0; 0]);
    }
}
