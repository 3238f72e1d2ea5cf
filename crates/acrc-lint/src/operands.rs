//! Variables and expressions as rules compare them.

use acrc_analysis::AliasFact;
use acrc_analysis::index::AliasTarget;
use acrc_analysis::walk;
use acrc_catalog::{OperandClass, Operator, command, function};
use acrc_diagnostics::Span;
use acrc_syntax::ast::{Argument, Expr, ExprKind, Statement, StatementKind};

use crate::Context;

/// A variable, parameter or flag with its number; an array as a whole.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct Variable {
    pub(crate) class: OperandClass,
    pub(crate) number: u64,
}

/// What an expression refers to, when it is a variable or an alias of one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Reference {
    /// This one.
    Known(Variable),
    /// One of a class; its number is computed.
    Computed(OperandClass),
}

impl Reference {
    /// What `expr` refers to. Parentheses around it do not count as a part of it.
    pub(crate) fn of(context: &Context<'_>, expr: &Expr) -> Option<Self> {
        let new = |class, number: Option<u64>| match number {
            Some(number) => Self::Known(Variable { class, number }),
            None => Self::Computed(class),
        };
        match &expr.kind {
            ExprKind::Operand(operand) => Some(new(operand.class, whole_number(&operand.index))),
            ExprKind::Alias => match context.alias(expr.span)? {
                AliasFact::Defined { operand, .. } => match operand.target {
                    AliasTarget::Operand(class, number) => Some(new(class, number)),
                    _ => None,
                },
                AliasFact::Undefined { .. } => None,
            },
            _ => None,
        }
    }

    /// Its class.
    pub(crate) fn class(self) -> OperandClass {
        match self {
            Self::Known(variable) => variable.class,
            Self::Computed(class) => class,
        }
    }
}

impl Variable {
    /// Whether it is a user parameter. What is written to the others may move something.
    pub(crate) fn is_user_parameter(self) -> bool {
        self.class == OperandClass::Parameter && self.number < u64::from(acrc_catalog::FIRST_FLAG_WORD)
    }

    /// The variable that `expr` is, by its number or through an alias.
    pub(crate) fn of(context: &Context<'_>, expr: &Expr) -> Option<Self> {
        match Reference::of(context, expr)? {
            Reference::Known(variable) => Some(variable),
            Reference::Computed(_) => None,
        }
    }
}

/// A number written as one, in parentheses or not.
fn whole_number(expr: &Expr) -> Option<u64> {
    match &expr.kind {
        ExprKind::Integer(number) => Some(*number),
        ExprKind::Paren(inner) => whole_number(inner),
        _ => None,
    }
}

/// Whether an expression has the same value when it is computed again, as long as its operands have theirs, and does
/// nothing else: it draws no random number, reads no device and no clock.
pub(crate) fn is_repeatable(expr: &Expr) -> bool {
    const OTHERS: [acrc_catalog::FunctionId; 6] = [
        function::RND,
        function::GETCH,
        function::INKEY_DOLLAR,
        function::KBHIT,
        function::DATE_DOLLAR,
        function::TIME_DOLLAR,
    ];
    let mut repeatable = true;
    walk::each(expr, &mut |inner| match &inner.kind {
        ExprKind::Call(function, _) => repeatable &= !OTHERS.contains(function),
        ExprKind::Error => repeatable = false,
        _ => {}
    });
    repeatable
}

/// Whether two pieces of the text say the same, blanks and the case of letters in words of the language aside. Names
/// that differ in case are different.
pub(crate) fn same_text(context: &Context<'_>, a: Span, b: Span) -> bool {
    let first = |span: Span| context.text().as_bytes().get(span.start as usize).map(u8::to_ascii_lowercase);
    if first(a) != first(b) {
        return false;
    }
    let (a, b) = (context.tree().tokens_in(a), context.tree().tokens_in(b));
    a.len() == b.len()
        && a.iter().zip(b).all(|(a, b)| {
            let (a, b) = (context.slice(a.span), context.slice(b.span));
            a == b || (a.eq_ignore_ascii_case(b) && acrc_catalog::word(a).is_some())
        })
}

/// Whether an operator compares its two sides.
pub(crate) fn is_relation(operator: Operator) -> bool {
    use Operator::{Eq, Ge, Gt, Le, Lt, Ne};
    matches!(operator, Eq | Ne | Lt | Gt | Le | Ge)
}

/// The condition of an `IF`, `ELSEIF` or `WHILE`.
pub(crate) fn condition(statement: &Statement) -> Option<&Expr> {
    match &statement.kind {
        StatementKind::If(head) => Some(&head.condition),
        StatementKind::Command(head) if matches!(head.id, command::WHILE | command::ELSEIF | command::ELSE_IF) => {
            head.arguments.iter().find_map(|argument| match argument {
                Argument::Value(expr) => Some(expr),
                _ => None,
            })
        }
        _ => None,
    }
}

/// An expression without the parentheses around it.
pub(crate) fn bare(expr: &Expr) -> &Expr {
    match &expr.kind {
        ExprKind::Paren(inner) => bare(inner),
        _ => expr,
    }
}
