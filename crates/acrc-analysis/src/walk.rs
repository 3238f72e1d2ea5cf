//! Walks over the parts of a statement that several layers look at: expressions and axis names.

use acrc_catalog::{Operator, UnaryOperator};
use acrc_syntax::ast::{Argument, Axis, BitArgument, Dim, Expr, ExprKind, Input, Print, Statement, StatementKind};

/// Calls `visit` for every expression of `statement`, the outer before the inner ones.
pub fn expressions<'t>(statement: &'t Statement, visit: &mut impl FnMut(&'t Expr)) {
    match &statement.kind {
        StatementKind::Assign(assign) => {
            each(&assign.target, visit);
            each(&assign.value, visit);
        }
        StatementKind::If(branch) => each(&branch.condition, visit),
        StatementKind::For(counted) => {
            for expr in [&counted.variable, &counted.start, &counted.end] {
                each(expr, visit);
            }
            all(&counted.step, visit);
        }
        StatementKind::Print(print) => in_print(print, visit),
        StatementKind::Input(input) => in_input(input, visit),
        StatementKind::Dim(dim) => in_dim(dim, visit),
        StatementKind::Define(define) => each(&define.operand, visit),
        StatementKind::Command(command) => command.arguments.iter().for_each(|argument| in_argument(argument, visit)),
        StatementKind::Remark(_) | StatementKind::Label(_) | StatementKind::Error => {}
    }
}

fn in_print<'t>(print: &'t Print, visit: &mut impl FnMut(&'t Expr)) {
    all(&print.device, visit);
    all(&print.using, visit);
    all(print.items.iter().map(|item| &item.value), visit);
}

fn in_input<'t>(input: &'t Input, visit: &mut impl FnMut(&'t Expr)) {
    all(&input.device, visit);
    all(input.prompt.iter().map(|(prompt, _)| prompt), visit);
    all(&input.variables, visit);
}

fn in_dim<'t>(dim: &'t Dim, visit: &mut impl FnMut(&'t Expr)) {
    all(&dim.index, visit);
    all(&dim.sizes, visit);
}

fn in_argument<'t>(argument: &'t Argument, visit: &mut impl FnMut(&'t Expr)) {
    match argument {
        Argument::Value(expr) | Argument::Device(expr) => each(expr, visit),
        Argument::Tuple(tuple) => all(&tuple.values, visit),
        Argument::Bit(bit) => each(&bit.index, visit),
        Argument::Axis(axis) => axis.value.iter().for_each(|value| in_argument(value, visit)),
        Argument::Object(object) => object.value.iter().for_each(|value| in_argument(value, visit)),
        Argument::Word(_) | Argument::Interpolation(..) | Argument::Target(_) => {}
    }
}

fn all<'t>(expressions: impl IntoIterator<Item = &'t Expr>, visit: &mut impl FnMut(&'t Expr)) {
    for expr in expressions {
        each(expr, visit);
    }
}

/// Calls `visit` for `expr` and everything inside it. The parser bounds how deep expressions nest.
pub fn each<'t>(expr: &'t Expr, visit: &mut impl FnMut(&'t Expr)) {
    visit(expr);
    match &expr.kind {
        ExprKind::Operand(operand) => {
            each(&operand.index, visit);
            all(&operand.element, visit);
        }
        ExprKind::Paren(inner) | ExprKind::Unary(_, inner) => each(inner, visit),
        ExprKind::Binary(_, _, sides) => all(sides.as_ref(), visit),
        ExprKind::Call(_, arguments) => all(arguments, visit),
        ExprKind::Integer(_) | ExprKind::Real(_) | ExprKind::String(_) | ExprKind::Alias | ExprKind::Error => {}
    }
}

/// The axis names that a statement uses, with their values.
pub fn axes(statement: &Statement) -> impl Iterator<Item = &Axis> {
    let arguments = match &statement.kind {
        StatementKind::Command(command) => command.arguments.as_slice(),
        _ => &[],
    };
    arguments.iter().filter_map(|argument| match argument {
        Argument::Axis(axis) => Some(axis),
        _ => None,
    })
}

/// The bits that a statement names as its arguments: those of `SET`, `CLR`, `INH` and of ladder instructions.
pub fn bits(statement: &Statement) -> impl Iterator<Item = &BitArgument> {
    let arguments = match &statement.kind {
        StatementKind::Command(command) => command.arguments.as_slice(),
        _ => &[],
    };
    arguments.iter().filter_map(|argument| match argument {
        Argument::Bit(bit) => Some(bit),
        _ => None,
    })
}

/// The number that a literal stands for, signs and parentheses included. `None` for everything that is computed.
pub fn literal(expr: &Expr) -> Option<f64> {
    match &expr.kind {
        ExprKind::Integer(value) => Some(*value as f64),
        ExprKind::Real(value) => Some(*value),
        ExprKind::Paren(inner) | ExprKind::Unary(UnaryOperator::Plus, inner) => literal(inner),
        ExprKind::Unary(UnaryOperator::Minus, inner) => literal(inner).map(|value| -value),
        _ => None,
    }
}

/// The number of something that is addressed by a constant: a literal, or literals added and multiplied, as in
/// `P(12288+256)`. `None` for everything else, and where the number is negative or not whole.
pub fn whole(expr: &Expr) -> Option<u64> {
    match &expr.kind {
        ExprKind::Integer(value) => Some(*value),
        ExprKind::Paren(inner) | ExprKind::Unary(UnaryOperator::Plus, inner) => whole(inner),
        ExprKind::Binary(operator, _, sides) => {
            let [left, right] = [whole(&sides[0])?, whole(&sides[1])?];
            match operator {
                Operator::Add => left.checked_add(right),
                Operator::Sub => left.checked_sub(right),
                Operator::Mul => left.checked_mul(right),
                _ => None,
            }
        }
        _ => None,
    }
}
