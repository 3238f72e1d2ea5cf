//! `ACR206`: a slave slot, an axis or an axis name that is attached a second time.

use acrc_analysis::{Conflict, Taken};
use acrc_diagnostics::{Code, Severity};

use crate::rule::{Check, Group, Rule, RuleDoc};
use crate::{Context, level_name};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR206", name: "duplicate-attachment" },
        group: Group::Names,
        severity: Severity::Error,
        what: "An ATTACH SLAVE takes a slot, an axis or a name that an earlier one already took, with no DETACH in \
               between.",
        why: "An axis can follow one master only, and a slot holds one axis. The second attachment is refused, and the \
              axis keeps moving with the first program.",
        bad: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS0 \"Y\"",
        good: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"",
        guide: "Attachments / Master/Slave Attachments",
    },
    checks: &[Check::File(check)],
};

fn check(context: &mut Context<'_>) {
    for conflict in &context.environment().conflicts {
        if let Some(site) = context.index().attachments.get(conflict.attachment as usize) {
            let diagnostic = RULE.at(site.statement, message(conflict));
            context.report(diagnostic.with_help("DETACH first, or take another one"));
        }
    }
}

fn message(conflict: &Conflict) -> String {
    let Conflict { slot, axis, .. } = conflict;
    let program = level_name(conflict.level);
    match conflict.taken {
        Taken::Slot => format!("SLAVE{slot} of {program} already holds AXIS{axis}"),
        Taken::Axis => format!("AXIS{axis} is already attached to SLAVE{slot} of {program}"),
        Taken::Name => format!("{program} already has an axis of this name: AXIS{axis} on SLAVE{slot}"),
    }
}
