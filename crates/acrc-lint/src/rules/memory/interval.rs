//! Between which bounds a whole number lies, where the text of the program shows it.

use acrc_analysis::index::AliasTarget;
use acrc_analysis::{AliasFact, SectionIndex, walk};
use acrc_catalog::{OperandClass, Operator, UnaryOperator};
use acrc_syntax::ast::{Expr, ExprKind, For, StatementKind};
use acrc_syntax::blocks::{Block, BlockKind};

use crate::Context;

/// No more statements, and no more jumps, are looked through for each number.
const LOOKED_THROUGH: usize = 500;

/// The bounds of a number, as far as they are known.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Interval {
    /// It is not less.
    pub(super) low: Option<i64>,
    /// It is not more.
    pub(super) high: Option<i64>,
}

const UNKNOWN: Interval = Interval { low: None, high: None };

impl Interval {
    fn exact(value: i64) -> Self {
        Self { low: Some(value), high: Some(value) }
    }

    fn negated(self) -> Self {
        let negate = |bound: Option<i64>| bound.and_then(i64::checked_neg);
        Self { low: negate(self.high), high: negate(self.low) }
    }

    fn plus(self, other: Self) -> Self {
        let sum = |a: Option<i64>, b: Option<i64>| a?.checked_add(b?);
        Self { low: sum(self.low, other.low), high: sum(self.high, other.high) }
    }

    /// Of numbers that are not negative; other products are of no use as a number of something.
    fn times(self, other: Self) -> Self {
        let positive = |interval: Self| interval.low.is_some_and(|low| low >= 0);
        if !positive(self) || !positive(other) {
            return UNKNOWN;
        }
        let product = |a: Option<i64>, b: Option<i64>| a?.checked_mul(b?);
        Self { low: product(self.low, other.low), high: product(self.high, other.high) }
    }

    /// The remainder has the sign of the dividend. Of an unknown one only the larger bound is sure.
    fn modulo(self, divisor: Self) -> Self {
        let Some(most) = divisor.high.filter(|high| divisor.low == Some(*high) && *high > 0).map(|high| high - 1)
        else {
            return UNKNOWN;
        };
        let low = match self.low {
            Some(low) if low >= 0 => Some(0),
            Some(low) => Some(low.max(-most)),
            None => None,
        };
        Self { low, high: Some(self.high.map_or(most, |high| high.clamp(0, most))) }
    }

    /// Masking with a number that is not negative.
    fn and(self, other: Self) -> Self {
        let mask = |interval: Self| interval.high.filter(|_| interval.low.is_some_and(|low| low >= 0));
        match (mask(self), mask(other)) {
            (Some(a), Some(b)) => Self { low: Some(0), high: Some(a.min(b)) },
            (Some(mask), None) | (None, Some(mask)) => Self { low: Some(0), high: Some(mask) },
            (None, None) => UNKNOWN,
        }
    }
}

/// What is known of an expression at the present statement.
pub(super) fn of(context: &Context<'_>, expr: &Expr) -> Interval {
    match &expr.kind {
        ExprKind::Integer(value) => i64::try_from(*value).map_or(UNKNOWN, Interval::exact),
        ExprKind::Paren(inner) | ExprKind::Unary(UnaryOperator::Plus, inner) => of(context, inner),
        ExprKind::Unary(UnaryOperator::Minus, inner) => of(context, inner).negated(),
        ExprKind::Binary(operator, _, sides) => {
            let [left, right] = &**sides;
            let (left, right) = (of(context, left), of(context, right));
            match operator {
                Operator::Add => left.plus(right),
                Operator::Sub => left.plus(right.negated()),
                Operator::Mul => left.times(right),
                Operator::Mod => left.modulo(right),
                Operator::And => left.and(right),
                _ => UNKNOWN,
            }
        }
        ExprKind::Operand(_) | ExprKind::Alias => match variable(context, expr) {
            Variable::One(class, number) if is_local_number(class) => counter(context, class, number),
            _ => UNKNOWN,
        },
        _ => UNKNOWN,
    }
}

fn is_local_number(class: OperandClass) -> bool {
    matches!(class, OperandClass::Lv | OperandClass::Sv | OperandClass::Dv)
}

/// A variable as it is named.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Variable {
    /// This one.
    One(OperandClass, u64),
    /// One of the class; its number is computed.
    Some(OperandClass),
    /// Perhaps any.
    Unknown,
}

fn variable(context: &Context<'_>, expr: &Expr) -> Variable {
    match &expr.kind {
        ExprKind::Operand(operand) => match operand.index.kind {
            ExprKind::Integer(number) => Variable::One(operand.class, number),
            _ => Variable::Some(operand.class),
        },
        ExprKind::Alias => match context.alias(expr.span) {
            Some(AliasFact::Defined { operand, .. }) => match operand.target {
                AliasTarget::Operand(class, Some(number)) => Variable::One(class, number),
                AliasTarget::Operand(class, None) => Variable::Some(class),
                _ => Variable::Unknown,
            },
            _ => Variable::Unknown,
        },
        _ => Variable::Unknown,
    }
}

/// What is known of the counter of a loop in which the present statement stands.
fn counter(context: &Context<'_>, class: OperandClass, number: u64) -> Interval {
    let Some(section) = context.section() else { return UNKNOWN };
    let wanted = Variable::One(class, number);
    let around =
        std::iter::successors(section.blocks.enclosing(context.statement()), |block| section.blocks.parent(block));
    for block in around.filter(|block| block.kind == BlockKind::For) {
        let Some(head) = head(context, block) else { continue };
        if variable(context, &head.variable) == wanted {
            let stays = stays_in(context, section, block, class, number);
            return if stays { bounds(head) } else { UNKNOWN };
        }
    }
    UNKNOWN
}

fn head<'a>(context: &Context<'a>, block: &Block) -> Option<&'a For> {
    match &context.tree().statements().get(block.opener as usize)?.kind {
        StatementKind::For(head) => Some(head),
        _ => None,
    }
}

/// The bounds of a counter inside its loop. A fraction is cut off where the counter names something.
fn bounds(head: &For) -> Interval {
    let (Some(start), Some(end)) = (walk::literal(&head.start), walk::literal(&head.end)) else { return UNKNOWN };
    // A loop that is never run says nothing.
    if start > end || start.abs() > 1e15 || end.abs() > 1e15 {
        return UNKNOWN;
    }
    let step = head.step.as_ref().map_or(Some(1.0), walk::literal);
    // The last value that is reached, where the step shows it.
    let last = match step {
        Some(step) if step > 0.0 => start + ((end - start) / step).floor() * step,
        _ => return UNKNOWN,
    };
    Interval { low: Some(start.trunc() as i64), high: Some(last.trunc() as i64) }
}

/// Whether a counter has its value from its loop everywhere inside: the loop is entered at its head, and nothing but
/// the loop changes the counter.
fn stays_in(context: &Context<'_>, section: &SectionIndex, block: &Block, class: OperandClass, number: u64) -> bool {
    let end = block.closer.unwrap_or(section.section.statements.end);
    let body = block.opener + 1..end;
    if body.len() > LOOKED_THROUGH || section.jumps.len() > LOOKED_THROUGH {
        return false;
    }
    let inside = |statement: u32| (block.opener..=end).contains(&statement);
    let entered = |to: u32| to > block.opener && to <= end;
    if section.jumps.iter().any(|jump| !inside(jump.statement) && jump.to.is_none_or(entered)) {
        return false;
    }
    let calls = section.jumps.iter().any(|jump| jump.call && inside(jump.statement));
    // A subroutine may change it, wherever that stands.
    let range = if calls { section.section.statements.clone() } else { body };
    if range.len() > LOOKED_THROUGH {
        return false;
    }
    range.filter(|at| *at != block.opener).all(|at| !writes(context, at, class, number))
}

/// Whether a statement may change a variable.
fn writes(context: &Context<'_>, at: u32, class: OperandClass, number: u64) -> bool {
    let Some(statement) = context.tree().statements().get(at as usize) else { return true };
    let changes = |target: &Expr| match variable(context, target) {
        Variable::One(other, other_number) => other == class && other_number == number,
        Variable::Some(other) => other == class,
        Variable::Unknown => true,
    };
    match &statement.kind {
        StatementKind::Assign(assign) => changes(&assign.target),
        StatementKind::For(counted) => changes(&counted.variable),
        StatementKind::Input(input) => input.variables.iter().any(changes),
        StatementKind::Error => true,
        _ => false,
    }
}
