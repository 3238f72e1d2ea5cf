//! The values of a command in the groups that its row describes: those of each axis, or all of them together.

use acrc_catalog::{Command as Row, ObjectKind, Shape};
use acrc_diagnostics::Span;
use acrc_syntax::ast::{Argument, Command, Expr};

/// Values that belong together.
pub(super) struct Group<'t> {
    /// The row that describes them: that of the command, or of the interpolation keyword before them.
    pub(super) row: &'static Row,
    /// The axis with its values, or the values.
    pub(super) span: Span,
    /// The axis, for messages; nothing for values without one.
    pub(super) axis: Option<Span>,
    /// What is written.
    pub(super) values: Values<'t>,
}

/// The values of a group.
#[derive(Clone, Copy)]
pub(super) enum Values<'t> {
    /// None.
    Missing,
    /// A number or an expression, or several in parentheses.
    Given(&'t [Expr]),
    /// An object or a word.
    Other,
}

/// Whether the items of a shape are axes.
pub(super) fn takes_axes(shape: Shape) -> bool {
    matches!(shape, Shape::Axes | Shape::AxisValues | Shape::AxisSources | Shape::Move | Shape::BitMove)
}

/// The values of each axis, of an axis in front of the command (`AXIS0 PPU 4000`), and of tuples.
pub(super) fn groups(command: &Command) -> impl Iterator<Item = Group<'_>> {
    let mut row = command.id.info();
    command.arguments.iter().enumerate().filter_map(move |(at, argument)| {
        let (span, axis, values) = match argument {
            Argument::Axis(axis) => (axis.span, Some(axis.name), axis.value.as_deref().map_or(Values::Missing, values)),
            Argument::Object(object) if object.kind == ObjectKind::Axis && takes_axes(row.shape) => {
                (object.span, Some(object.name), object.value.as_deref().map_or(Values::Missing, values))
            }
            // The parameter of `IHPOS P6160 (40000, 5)` is no value of the tuple behind it.
            Argument::Value(_) if row.shape == Shape::ParameterTuple && at == 0 => return None,
            Argument::Value(expr) => (expr.span, None, values(argument)),
            Argument::Tuple(tuple) => (tuple.span, None, values(argument)),
            Argument::Interpolation(id, _) => {
                row = id.info();
                return None;
            }
            _ => return None,
        };
        Some(Group { row, span, axis, values })
    })
}

fn values(argument: &Argument) -> Values<'_> {
    match argument {
        Argument::Value(expr) => Values::Given(std::slice::from_ref(expr)),
        Argument::Tuple(tuple) => Values::Given(&tuple.values),
        _ => Values::Other,
    }
}

/// How many items of the row's shape a command has. An axis in front of it counts as its first axis.
pub(super) fn items(command: &Command, row: &Row) -> usize {
    let prefix = usize::from(command.prefix.as_ref().is_some_and(|prefix| prefix.kind == ObjectKind::Axis));
    if takes_axes(row.shape) {
        let is_axis = |argument: &&Argument| match argument {
            Argument::Axis(_) => true,
            Argument::Object(object) => object.kind == ObjectKind::Axis,
            _ => false,
        };
        return prefix + command.arguments.iter().filter(is_axis).count();
    }
    if row.shape == Shape::ParameterTuple {
        return command.arguments.iter().filter(|argument| matches!(argument, Argument::Value(_))).count().min(1);
    }
    command.arguments.len()
}
