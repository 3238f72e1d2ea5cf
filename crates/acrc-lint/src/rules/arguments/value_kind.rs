//! Whether an expression is a number or a text, as far as that can be told without running it.

use acrc_analysis::AliasFact;
use acrc_analysis::index::AliasTarget;
use acrc_catalog::{OperandClass, Operator, TypeClass, ValueType};
use acrc_syntax::ast::{Expr, ExprKind};

use crate::Context;

/// What a value is.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum ValueKind {
    Number,
    Text,
}

impl ValueKind {
    /// The word for it in messages.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Number => "a number",
            Self::Text => "a text",
        }
    }

    fn of_class(class: OperandClass) -> Self {
        if class.value_type() == Some(ValueType::String) { Self::Text } else { Self::Number }
    }

    /// What a function takes or gives; `None` when that depends on its argument.
    pub(super) fn of_type(class: TypeClass) -> Option<Self> {
        match class {
            TypeClass::Number | TypeClass::Long | TypeClass::Float => Some(Self::Number),
            TypeClass::String => Some(Self::Text),
            TypeClass::Same | TypeClass::LongOrString => None,
        }
    }

    /// What `expr` gives; `None` when that can't be told.
    pub(super) fn of(context: &Context<'_>, expr: &Expr) -> Option<Self> {
        match &expr.kind {
            // Only a sum can be a text.
            ExprKind::Binary(Operator::Add, _, sides) => Self::of(context, &sides[0]),
            ExprKind::Integer(_) | ExprKind::Real(_) | ExprKind::Unary(..) | ExprKind::Binary(..) => Some(Self::Number),
            ExprKind::String(_) => Some(Self::Text),
            ExprKind::Operand(operand) => Some(Self::of_class(operand.class)),
            ExprKind::Alias => match context.alias(expr.span)? {
                AliasFact::Defined { operand, .. } => match operand.target {
                    AliasTarget::Operand(class, _) => Some(Self::of_class(class)),
                    AliasTarget::Number => Some(Self::Number),
                    AliasTarget::Text => Some(Self::Text),
                    AliasTarget::Other => None,
                },
                AliasFact::Undefined { .. } => None,
            },
            ExprKind::Paren(inner) => Self::of(context, inner),
            ExprKind::Call(function, _) => Self::of_type(function.info().result),
            ExprKind::Error => None,
        }
    }
}
