//! `ACR201`: too few or too many arguments.

use acrc_catalog::{Command as Row, ObjectKind, Shape, command};
use acrc_diagnostics::{Code, Severity, Span};
use acrc_syntax::ast::{Argument, Command, Dim, Expr, ExprKind, Statement, StatementKind};

use super::groups::{Group as Values, Values as Written, groups, items, takes_axes};
use crate::Context;
use crate::rule::{Check, Group, On, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR201", name: "argument-count" },
        group: Group::Names,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "A command, an axis of a command, or a function has too few or too many values.",
        why: "The controller refuses the statement when it gets there, or takes the missing value to be a question and \
              prints an answer instead of acting.",
        bad: "PROG0\nPROGRAM\nDWL\nENDP",
        good: "PROG0\nPROGRAM\nDWL 0.5\nENDP",
        guide: "Programming Basics / Command Syntax",
    },
    checks: &[Check::Statement(check_statement), Check::Expression(On::Compound, check_call)],
};

/// Stands for any number in the catalogue.
const ANY: usize = u8::MAX as usize;

fn check_statement(context: &mut Context<'_>, statement: &Statement) {
    match &statement.kind {
        StatementKind::Command(command) => check_command(context, command, statement.span),
        StatementKind::Dim(dim) => check_dim(context, dim, statement.span),
        _ => {}
    }
}

fn check_command(context: &mut Context<'_>, command: &Command, span: Span) {
    let row = command.id.info();
    if row.shape == Shape::Free {
        return;
    }
    let count = items(command, row);
    let unit = if takes_axes(row.shape) { "axis" } else { "argument" };
    if !judge(context, row, span, count, unit) {
        return;
    }
    if lacks_signal(command) {
        let message = "ATTACH AXIS needs an output signal besides its feedback";
        context.report(RULE.at(span, message).with_help(format!("its form is {}", row.signature)));
    }
    for group in groups(command) {
        check_group(context, &group);
    }
}

/// A drive on the network is feedback and output in one; any other feedback needs an output.
fn lacks_signal(command: &Command) -> bool {
    let is_drive = |argument: &Argument| matches!(argument, Argument::Object(o) if o.kind == ObjectKind::Epld);
    command.id == command::ATTACH_AXIS && command.arguments.len() == 2 && !command.arguments.iter().any(is_drive)
}

/// Counts the items; returns whether their number is right.
fn judge(context: &mut Context<'_>, row: &'static Row, span: Span, count: usize, unit: &str) -> bool {
    let (min, max) = (usize::from(row.min_args), usize::from(row.max_args));
    let limit = if count < min {
        format!("needs {}", counted(min, max, unit))
    } else if count > max && max != ANY {
        format!("takes {}", counted(min, max, unit))
    } else {
        return true;
    };
    let message = format!("{} {limit}, and has {}", row.name, number(count));
    context.report_by(row.confidence, RULE.at(span, message).with_help(format!("its form is {}", row.signature)));
    false
}

fn check_group(context: &mut Context<'_>, group: &Values<'_>) {
    let row = group.row;
    let (min, max) = (usize::from(row.tuple_min), usize::from(row.tuple_max));
    let written = match group.values {
        Written::Given(values) => values.len(),
        Written::Missing if !row.bare_axis && max > 0 && is_known_axis(context, group) => 0,
        Written::Missing | Written::Other => return,
    };
    // A scalar of a shape without tuples is a tuple of one.
    let (min, max) = if max == 0 { (1, 1) } else { (min, max) };
    let bare = written == 0 && row.bare_axis;
    if bare || (min..=max).contains(&written) {
        return;
    }
    let whose = group.axis.map_or_else(String::new, |axis| format!(" of {}", context.slice(axis)));
    let message = format!("{}{whose} takes {}, and has {}", row.name, counted(min, max, "value"), number(written));
    let diagnostic = RULE.at(group.span, message).with_help(format!("its form is {}", row.signature));
    context.report_by(row.confidence, diagnostic);
}

/// A name without a value where a statement could start may be a misspelt command; that is another rule.
fn is_known_axis(context: &Context<'_>, group: &Values<'_>) -> bool {
    let is_declared =
        |axis| context.environment().axes_at(context.level()).is_some_and(|axes| axes.has(context.slice(axis)));
    group.axis.is_some_and(|axis| group.row.id != command::AXIS_MOVE || is_declared(axis))
}

fn check_dim(context: &mut Context<'_>, dim: &Dim, span: Span) {
    judge(context, dim.id.info(), span, dim.sizes.len(), "size");
}

fn check_call(context: &mut Context<'_>, expr: &Expr) {
    let ExprKind::Call(function, arguments) = &expr.kind else { return };
    let function = function.info();
    let (min, max) = (usize::from(function.min_args), usize::from(function.max_args));
    if !(min..=max).contains(&arguments.len()) {
        let name = function.name;
        let message = format!("{name} takes {}, and has {}", counted(min, max, "argument"), number(arguments.len()));
        context.report_by(function.confidence, RULE.at(expr.span, message));
    }
}

fn counted(min: usize, max: usize, unit: &str) -> String {
    let plural = |count: usize| match (count, unit) {
        (1, _) => unit.to_owned(),
        (_, "axis") => "axes".to_owned(),
        _ => format!("{unit}s"),
    };
    match max {
        0 => format!("no {}", plural(2)),
        ANY => format!("at least {min} {}", plural(min)),
        _ if min == max => format!("{min} {}", plural(min)),
        _ if min == 0 => format!("at most {max} {}", plural(max)),
        _ => format!("{min} to {max} {}", plural(max)),
    }
}

fn number(count: usize) -> String {
    if count == 0 { "none".to_owned() } else { count.to_string() }
}

#[cfg(test)]
mod tests {
    use crate::testing::codes;

    #[test]
    fn axes_need_their_values() {
        assert_eq!(codes("JOG ABS X\nJOG ABS X10\nSLM X(24,0) Y10\nSLM X(24,0,1)\n"), [(1, "ACR201"), (4, "ACR201")]);
        assert_eq!(codes("AXIS0 SLM (24,0)\nAXIS0 PPU 4000\nAXIS0 PPU (1,2)\n"), [(3, "ACR201")]);
    }

    #[test]
    fn an_interpolation_keyword_changes_what_an_axis_takes() {
        assert_eq!(codes("X2 SINE Y(0,90,90,100)\nX2 SINE Y(0,90)\n"), [(2, "ACR201")]);
    }

    #[test]
    fn reports_need_no_value() {
        assert_eq!(codes("VEL\nPPU X\nDIM\nATTACH\nHALT ALL\nRUN\n"), []);
    }

    #[test]
    fn tuples_behind_a_parameter() {
        assert_eq!(codes("IHPOS P6160 (40000,5)\nIHPOS P6160 (40000)\n"), [(2, "ACR201")]);
    }

    #[test]
    fn functions_count_too() {
        assert_eq!(codes("P0 = SQRT(P1)\nP0 = SQRT(P1, 2)\n"), [(2, "ACR201")]);
    }

    #[test]
    fn a_network_drive_is_feedback_and_output() {
        assert_eq!(codes("ATTACH AXIS8 EPLD0\nATTACH AXIS0 ENC0 DAC0\nATTACH AXIS1 ENC1\n"), [(3, "ACR201")]);
    }
}
