//! `ACR202`: a text where a number is expected, a number where a text is, or the wrong kind of object.

use acrc_catalog::{ObjectKind, Operator, Shape, command};
use acrc_diagnostics::{Code, Severity};
use acrc_syntax::ast::{Argument, Assign, Command, Expr, ExprKind, Print, Statement, StatementKind};

use super::groups::{Values, groups, takes_axes};
use super::value_kind::ValueKind;
use crate::Context;
use crate::rule::{Check, Group, On, Rule, RuleDoc};

pub(crate) static RULE: Rule = Rule {
    doc: RuleDoc {
        code: Code { id: "ACR202", name: "argument-kind" },
        group: Group::Names,
        severity: Severity::Error,
        enabled: true,
        mark: None,
        what: "A value is a text where a number is needed, or the other way round, an array stands where one value is \
               needed, an object is not of the kind that its place asks for, or the bit of SET or CLR has a minus.",
        why: "The controller refuses the statement when it gets there.",
        bad: "PROG0\nPROGRAM\nDIM $V(1,10)\n$V0 = 5\nENDP",
        good: "PROG0\nPROGRAM\nDIM $V(1,10)\n$V0 = STR$(5)\nENDP",
        guide: "Programming Basics / Command Syntax",
    },
    checks: &[Check::Statement(check_statement), Check::Expression(On::Compound, check_expression)],
};

fn check_statement(context: &mut Context<'_>, statement: &Statement) {
    match &statement.kind {
        StatementKind::Assign(assign) => check_assignment(context, assign),
        StatementKind::Print(print) => check_picture(context, print),
        StatementKind::Command(command) => match command.id.info().shape {
            Shape::Attach => check_objects(context, command),
            Shape::Bit => check_bit(context, command),
            _ => check_values(context, command),
        },
        _ => {}
    }
}

/// The picture behind `USING`.
fn check_picture(context: &mut Context<'_>, print: &Print) {
    let Some(picture) = &print.using else { return };
    if ValueKind::of(context, picture) == Some(ValueKind::Number) {
        let diagnostic = RULE.at(picture.span, "the picture of PRINT USING is a text, not a number");
        context.report(diagnostic.with_help("it shows the places of the digits: PRINT USING \"###.##\"; P0"));
    }
}

/// An array as a whole where one value is wanted; returns whether it is one.
fn check_whole_array(context: &mut Context<'_>, value: &Expr) -> bool {
    let ExprKind::Operand(operand) = &value.kind else { return false };
    let is_whole = operand.class.is_array() && operand.element.is_none();
    if is_whole {
        let name = context.slice(value.span);
        let diagnostic = RULE.at(value.span, format!("{name} is an array, and one of its elements is needed"));
        context.report(diagnostic.with_help(format!("write the index of the element: {name}(0)")));
    }
    is_whole
}

fn check_assignment(context: &mut Context<'_>, assign: &Assign) {
    let arrays = [&assign.target, &assign.value].map(|side| check_whole_array(context, side));
    if arrays.contains(&true) {
        return;
    }
    let (Some(target), Some(value)) = (ValueKind::of(context, &assign.target), ValueKind::of(context, &assign.value))
    else {
        return;
    };
    if target != value {
        let name = context.slice(assign.target.span);
        let message = format!("{} can't be stored in {name}, which holds {}", value.name(), target.name());
        let help = match value {
            ValueKind::Number => "STR$(...) makes a text of a number",
            ValueKind::Text => "VAL(...) makes a number of a text",
        };
        context.report(RULE.at(assign.value.span, message).with_help(help));
    }
}

/// Values against the kinds in the row of the command, place by place.
fn check_values(context: &mut Context<'_>, command: &Command) {
    let own = command.id.info();
    let by_axis = takes_axes(own.shape);
    let mut place = 0;
    for group in groups(command) {
        let Values::Given(values) = group.values else { continue };
        for (within, value) in values.iter().enumerate() {
            let at = if by_axis { within } else { place + within };
            let Some(argument) = group.row.arguments.get(at) else { continue };
            let wanted = match argument.kind {
                "FP32" | "long" => ValueKind::Number,
                "string" => ValueKind::Text,
                _ => continue,
            };
            let given = ValueKind::of(context, value).filter(|given| *given != wanted);
            if let Some(given) = given {
                let message =
                    format!("the {} of {} is {}, not {}", argument.name, group.row.name, wanted.name(), given.name());
                let diagnostic = RULE.at(value.span, message).with_help(format!("its form is {}", group.row.signature));
                context.report_by(group.row.confidence, diagnostic);
            }
        }
        place += values.len();
    }
}

/// The flag of `SET`, `CLR`, `INH`: a whole number.
fn check_bit(context: &mut Context<'_>, command: &Command) {
    for argument in &command.arguments {
        let Argument::Bit(bit) = argument else { continue };
        if bit.negative && [command::SET, command::CLR].contains(&command.id) {
            let name = command.id.info().name;
            let diagnostic = RULE.at(bit.span, format!("{name} takes no minus"));
            context.report(diagnostic.with_help("SET switches a bit on, CLR switches it off"));
        }
        if matches!(bit.index.kind, ExprKind::Real(_) | ExprKind::String(_)) {
            let written = context.slice(bit.index.span);
            context.report(RULE.at(bit.index.span, format!("{written} is no bit: a bit has a whole number")));
        }
    }
}

/// `ATTACH AXIS0 ENC0 DAC0`: which objects fit at which place is in the row.
fn check_objects(context: &mut Context<'_>, command: &Command) {
    let row = command.id.info();
    for (argument, expected) in command.arguments.iter().zip(row.arguments) {
        let Argument::Object(object) = argument else { continue };
        let choices: Vec<_> = expected.range.split('|').map(object_of).collect();
        let is_known = expected.kind == "object" && choices.iter().all(Option::is_some);
        if is_known && !choices.contains(&Some(object.kind)) {
            let name = context.slice(object.name);
            let message = format!("{name} can't be the {} of {}", expected.name, row.name);
            let diagnostic =
                RULE.at(object.span, message).with_help(format!("possible are {}", expected.range.replace('|', ", ")));
            context.report_by(row.confidence, diagnostic);
        }
    }
}

/// The kind that `ENCn` stands for.
fn object_of(choice: &str) -> Option<ObjectKind> {
    ObjectKind::from_name(choice.strip_suffix('n')?)
}

fn check_expression(context: &mut Context<'_>, expr: &Expr) {
    match &expr.kind {
        ExprKind::Call(function, arguments) => {
            let function = function.info();
            for (argument, class) in arguments.iter().zip(function.argument_types) {
                let Some(wanted) = ValueKind::of_type(*class) else { continue };
                let given = ValueKind::of(context, argument).filter(|given| *given != wanted);
                if let Some(given) = given {
                    let message = format!("{} takes {}, not {}", function.name, wanted.name(), given.name());
                    context.report_by(function.confidence, RULE.at(argument.span, message));
                }
            }
        }
        ExprKind::Binary(operator, span, sides) => {
            for side in sides.iter() {
                check_whole_array(context, side);
            }
            let [Some(left), Some(right)] = [&sides[0], &sides[1]].map(|side| ValueKind::of(context, side)) else {
                return;
            };
            let joins = matches!(operator, Operator::Add | Operator::Eq | Operator::Ne);
            if left != right {
                let message = format!("{operator} between {} and {}", left.name(), right.name());
                context.report(RULE.at(*span, message).with_help("STR$(...) and VAL(...) convert between the two"));
            } else if left == ValueKind::Text && !joins {
                context.report(RULE.at(
                    *span,
                    format!(
                        "{operator} has no meaning for texts: they can be joined with + and compared with = and <>"
                    ),
                ));
            }
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::codes;

    #[test]
    fn texts_and_numbers() {
        assert_eq!(codes("P0 = \"1\"\n$V0 = $V1 + \"a\"\nP0 = VAL($V0)\nP0 = $V0\n"), [(1, "ACR202"), (4, "ACR202")]);
        assert_eq!(codes("IF ($V0 = \"a\") THEN SET 32\nIF ($V0 = 1) THEN SET 32\n"), [(2, "ACR202")]);
        assert_eq!(codes("P0 = LEN(5)\nP0 = SQRT(\"a\")\n"), [(1, "ACR202"), (2, "ACR202")]);
        assert_eq!(codes("DWL \"a\"\nDTALK X : VEL \"a\"\n"), [(1, "ACR202"), (2, "ACR202")]);
    }

    #[test]
    fn an_alias_has_the_kind_of_its_operand() {
        assert_eq!(codes("#DEFINE Name $V0\nName = 5\nName = \"a\"\n"), [(2, "ACR202")]);
    }

    #[test]
    fn a_bit_is_a_whole_number() {
        assert_eq!(codes("SET 32\nSET 3.2\n"), [(2, "ACR202")]);
    }

    #[test]
    fn only_an_inhibit_has_a_sign() {
        assert_eq!(codes("SET -32\nCLR -33\nINH -516\nINH 516\n"), [(1, "ACR202"), (2, "ACR202")]);
    }

    #[test]
    fn an_array_is_no_value() {
        assert_eq!(
            codes("LA0 = 3\nP0 = SA1\nP0 = DA0 + 1\nLA0(1) = LA0(P0)\n"),
            [(1, "ACR202"), (2, "ACR202"), (3, "ACR202")]
        );
    }

    #[test]
    fn a_picture_is_a_text() {
        assert_eq!(codes("PRINT USING 5; P0\nPRINT USING \"##\"; P0\nPRINT USING $V0; P0\n"), [(1, "ACR202")]);
    }

    #[test]
    fn objects_fit_their_place() {
        assert_eq!(codes("ATTACH AXIS0 ENC0 DAC0\nATTACH AXIS0 DAC0 ENC0\n"), [(2, "ACR202"), (2, "ACR202")]);
    }
}
