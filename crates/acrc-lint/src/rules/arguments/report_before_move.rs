//! `ACR208`: a setting of the master without its value, directly before a move.

use acrc_catalog::{Shape, command};
use acrc_diagnostics::{Code, Severity, Span};
use acrc_syntax::ast::{Argument, Command, Separator, Statement, StatementKind};

use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR208", name: "report-before-move" },
        group: Group::Names,
        severity: Severity::Warning,
        enabled: true,
        mark: None,
        what: "A setting of the velocity profile has no value, and a move follows it on the line with nothing between \
               them: the value of the move looks as if it belonged to the setting.",
        why: "A setting without a value only prints what is set, and the axis moves at once: `VEL X10` changes no \
              velocity, it sends X to 10.",
        bad: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nVEL X10\nENDP",
        good: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nPROGRAM\nVEL 10\nENDP",
        guide: "Making Motion / Command Syntax",
    },
    checks: &[Check::Statement(check)],
};

/// The group of the catalogue with the settings of a master's velocity profile.
const GROUP: &str = "Velocity Profile";

fn check(context: &mut Context<'_>, statement: &Statement) {
    let StatementKind::Command(setting) = &statement.kind else { return };
    if !is_report(setting) {
        return;
    }
    let next = context.tree().statements().get(context.statement() as usize + 1);
    let Some(next) = next.filter(|next| next.separator == Separator::Blank) else { return };
    let StatementKind::Command(motion) = &next.kind else { return };
    let Some(Argument::Axis(axis)) = motion.arguments.first() else { return };
    if motion.id == command::AXIS_MOVE && axis.value.is_some() {
        let (name, written) = (setting.id.info().name, context.slice(axis.span));
        let message = format!("{name} without a value only reports; {written} is a move of its own");
        context.report(
            RULE.at(Span::cover(statement.span, next.span), message)
                .with_help(format!("give {name} a value, or part the two with a colon")),
        );
    }
}

/// Whether this rule tells of the present statement together with the one before it.
pub(crate) fn follows_report(context: &Context<'_>, statement: &Statement) -> bool {
    let StatementKind::Command(motion) = &statement.kind else { return false };
    if statement.separator != Separator::Blank || motion.id != command::AXIS_MOVE {
        return false;
    }
    let before = context.statement().checked_sub(1).and_then(|at| context.tree().statements().get(at as usize));
    let has_target = matches!(motion.arguments.first(), Some(Argument::Axis(axis)) if axis.value.is_some());
    has_target
        && matches!(before.map(|before| &before.kind), Some(StatementKind::Command(setting)) if is_report(setting))
}

/// A setting that has a value, and is written without one.
fn is_report(setting: &Command) -> bool {
    let row = setting.id.info();
    row.group == GROUP && row.shape == Shape::Value && !row.report.is_empty() && setting.arguments.is_empty()
}

#[cfg(test)]
mod tests {
    use crate::testing::codes;

    #[test]
    fn the_value_of_the_setting_is_missing() {
        assert_eq!(codes("ACC X10\nVEL X/10\nFOV ARM(P0)\n"), [(1, "ACR208"), (2, "ACR208"), (3, "ACR208")]);
    }

    #[test]
    fn reports_and_moves_may_stand_side_by_side() {
        assert_eq!(codes("ACC\nX10\nACC : X10\nACC 5 X10\nVEL(P0) X10\n? VEL\nVEL\n"), []);
    }
}
