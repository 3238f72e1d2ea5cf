//! `ACR203`: a constant outside of the values that a command takes.

use acrc_analysis::walk;
use acrc_catalog::Command as Row;
use acrc_diagnostics::{Code, Diagnostic, Severity};
use acrc_syntax::ast::{Command, Dim, Expr, Statement, StatementKind};

use super::groups::{Values, groups, takes_axes};
use super::range::ranges;
use crate::Context;
use crate::rule::{Check, Group, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR203", name: "argument-range" },
        group: Group::Names,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "A constant is outside of the values that the command takes. Only ranges that a document states exactly \
               are checked; where one is open to one side the finding is a warning.",
        why: "The controller refuses the value and keeps the old one: a limit that was to be switched on stays off.",
        bad: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nHLIM X4",
        good: "PROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nHLIM X3",
        guide: "Programming Basics / Command Syntax",
    },
    checks: &[Check::Statement(check)],
};

fn check(context: &mut Context<'_>, statement: &Statement) {
    match &statement.kind {
        StatementKind::Command(command) => check_command(context, command),
        StatementKind::Dim(dim) => check_dim(context, dim),
        _ => {}
    }
}

fn check_command(context: &mut Context<'_>, command: &Command) {
    if ranges(command.id.info()).is_empty() {
        return;
    }
    let by_axis = takes_axes(command.id.info().shape);
    let mut place = 0;
    for group in groups(command) {
        if let Values::Given(values) = group.values {
            let first = if by_axis { 0 } else { place };
            for (at, value) in (first..).zip(values) {
                judge(context, group.row, at, value);
            }
            place += values.len();
        }
    }
}

/// The number behind the word comes first in the row, when there is one.
fn check_dim(context: &mut Context<'_>, dim: &Dim) {
    let row = dim.id.info();
    if ranges(row).is_empty() {
        return;
    }
    let has_index = row.arguments.first().is_some_and(|argument| argument.name == "n");
    if let Some(index) = dim.index.as_ref().filter(|_| has_index) {
        judge(context, row, 0, index);
    }
    for (at, size) in (usize::from(has_index)..).zip(&dim.sizes) {
        judge(context, row, at, size);
    }
}

fn judge(context: &mut Context<'_>, row: &'static Row, at: usize, value: &Expr) {
    let Some(range) = ranges(row).get(at).and_then(Option::as_ref) else { return };
    let (Some(number), Some(argument)) = (walk::literal(value), row.arguments.get(at)) else { return };
    if range.holds(number) {
        return;
    }
    let message = format!("the {} of {} can't be {number}: it takes {range}", argument.name, row.name);
    let diagnostic = RULE.at(value.span, message);
    let severity = if range.is_closed() { Severity::Error } else { Severity::Warning };
    context.report(Diagnostic { severity, ..diagnostic });
}

#[cfg(test)]
mod tests {
    use acrc_diagnostics::Severity;

    use crate::testing::{codes, lint};

    #[test]
    fn closed_ranges_are_errors_and_open_ones_warnings() {
        let severities =
            |text: &str| lint(&[("test.8K", text)]).concat().iter().map(|d| d.severity).collect::<Vec<_>>();
        assert_eq!(severities("JOG HOME X1 Y-1\n"), []);
        assert_eq!(severities("JOG HOME X2\n"), [Severity::Error]);
        assert_eq!(severities("DWL -1\n"), [Severity::Warning]);
    }

    #[test]
    fn sizes_of_dim() {
        assert_eq!(codes("DIM P(4096)\nDIM P(5000)\nDIM PROG16(100)\n"), [(2, "ACR203"), (3, "ACR203")]);
    }

    #[test]
    fn what_is_computed_is_not_judged() {
        assert_eq!(codes("JOG HOME X(P0)\nHLIM X(1+5)\n"), []);
    }
}
