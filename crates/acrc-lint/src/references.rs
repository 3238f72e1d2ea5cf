//! The parameters and bits that a statement names, as rules see them.

use acrc_analysis::index::AliasTarget;
use acrc_analysis::{AliasFact, references};
use acrc_catalog::OperandClass;
use acrc_diagnostics::Span;
use acrc_syntax::ast::{Expr, Statement};

pub(crate) use acrc_analysis::references::{Reference, Usage};

use crate::Context;

/// Puts the references of a statement into `found`, in the order of the text.
pub(crate) fn collect(context: &Context<'_>, statement: &Statement, found: &mut Vec<Reference>) {
    references::collect(&|span| target(context, span), statement, found);
}

/// The operand that an expression is, when its number is known.
pub(crate) fn meaning(context: &Context<'_>, expr: &Expr) -> Option<(OperandClass, u64)> {
    references::meaning(&|span| target(context, span), expr)
}

fn target(context: &Context<'_>, span: Span) -> Option<AliasTarget> {
    match context.alias(span)? {
        AliasFact::Defined { operand, .. } => Some(operand.target),
        AliasFact::Undefined { .. } => None,
    }
}
