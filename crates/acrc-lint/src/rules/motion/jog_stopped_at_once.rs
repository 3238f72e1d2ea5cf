//! `ACR527`: a jog that is stopped in the statement behind it.

use acrc_analysis::Deed;
use acrc_analysis::deed::On;
use acrc_catalog::{ObjectKind, command};
use acrc_diagnostics::{Code, Severity, Span};
use acrc_syntax::ast::{Argument, Command, Statement, StatementKind};

use super::straight;
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR527", name: "jog-stopped-at-once" },
        group: Group::Motion,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A JOG OFF of an axis follows directly on the jog of that axis.",
        why: "A jog command returns at once, and the next statement is executed while the axis begins to move. JOG OFF \
              does not end a jog that has arrived, it breaks off one that runs: the axis stops where it started.",
        bad: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nJOG VEL X5\nJOG ABS X10\nJOG OFF X\nENDP",
        good: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nJOG VEL X5\nJOG ABS X10\nINH -792\nENDP",
        guide: "Making Motion / Jog Profiler",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    let StatementKind::Command(command) = &statement.kind else { return };
    if command.id != command::JOG_OFF {
        return;
    }
    let is_remark = |statement: &&&Statement| matches!(statement.kind, StatementKind::Remark(_));
    let Some(jog) = straight::before(context).into_iter().find(|statement| !is_remark(&statement)) else { return };
    let jogged: Vec<_> = straight::deeds(context, jog)
        .into_iter()
        .filter(|(deed, _)| *deed == Deed::Jog)
        .map(|(_, axis)| axis)
        .collect();
    let stopped = stopped(context, command).into_iter().find(|(axis, _)| jogged.contains(&Some(*axis)));
    if let Some((axis, span)) = stopped {
        let message = format!("AXIS{axis} is stopped in the statement behind its jog: it does not get anywhere");
        let diagnostic = RULE.at(span, message).with_related(jog.span, "the jog begins here, and the program goes on");
        context.report(match acrc_catalog::bit_number("jog_active", axis) {
            Some(flag) => diagnostic.with_help(format!("wait for the end of the jog instead: INH -{flag}")),
            None => diagnostic,
        });
    }
}

/// The axes of a JOG OFF, as far as they are known.
fn stopped(context: &Context<'_>, command: &Command) -> Vec<(u32, Span)> {
    let prefix =
        command.prefix.as_deref().into_iter().map(|prefix| (On::Object(prefix.kind, prefix.index), prefix.name));
    let arguments = command.arguments.iter().filter_map(|argument| match argument {
        Argument::Axis(axis) => Some((On::Axis(axis.name), axis.name)),
        Argument::Object(object) if object.kind == ObjectKind::Axis => {
            Some((On::Object(object.kind, object.index), object.name))
        }
        _ => None,
    });
    prefix.chain(arguments).filter_map(|(on, span)| Some((straight::axis_of(context, on)?, span))).collect()
}

#[cfg(test)]
mod tests {
    use crate::testing::spans_in_program;

    fn found(program: &str) -> Vec<String> {
        spans_in_program("ACR527", program)
    }

    #[test]
    fn the_jog_and_its_end() {
        assert_eq!(found("JOG ABS X10\nJOG OFF X"), ["X"]);
        assert_eq!(found("JOG FWD X Y : REM run\nAXIS1 JOG OFF"), ["AXIS1"]);
    }

    #[test]
    fn something_between_or_another_axis() {
        for program in [
            "JOG FWD X\nDWL 1\nJOG OFF X",
            "JOG FWD X\nINH 5\nJOG OFF X",
            "JOG FWD X\nJOG OFF Y",
            "IF (BIT 1) THEN JOG FWD X\nJOG OFF X",
            "IF (BIT 1)\nJOG FWD X\nELSE\nJOG OFF X\nENDIF",
            "JOG HOME X1\nJOG OFF X",
            "JOG VEL X5\nJOG OFF X",
        ] {
            assert_eq!(found(program), [""; 0], "{program}");
        }
    }
}
