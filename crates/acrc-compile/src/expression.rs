//! Expressions to nodes (guide, "Parametric Evaluation").

use acrc_catalog::UnaryOperator;
use acrc_diagnostics::Span;
use acrc_image::{Node, integer, negate, real};
use acrc_syntax::ast::{Expr, ExprKind, Operand};

use crate::encoder::Encoder;
use crate::error::CompileErrorKind;

/// Parentheses around one node that the words count.
const MAX_PARENS: u8 = 7;

impl Encoder<'_> {
    /// An expression. Constants lose their parentheses and take in their sign.
    pub(crate) fn expression(&mut self, expr: &Expr) -> Node {
        self.nested(expr.span, |encoder| encoder.bare(expr))
    }

    fn bare(&mut self, expr: &Expr) -> Node {
        let span = expr.span;
        match &expr.kind {
            ExprKind::Integer(value) => {
                integer(*value).unwrap_or_else(|| self.too_large(span, "whole numbers go up to 9007199254740992"))
            }
            ExprKind::Real(_) => real(self.slice(span)).unwrap_or_else(|| self.too_large(span, "no double holds it")),
            ExprKind::String(span) => self.string(*span),
            ExprKind::Operand(operand) => self.operand(operand),
            ExprKind::Alias => {
                let name = self.slice(span);
                match self.scope.alias(name) {
                    Some(index) => Node::Alias { index, parens: 0 },
                    None => self.mistake(span, CompileErrorKind::UndefinedAlias(name.to_owned())),
                }
            }
            ExprKind::Paren(inner) => {
                let node = self.expression(inner);
                self.parenthesise(span, node)
            }
            ExprKind::Unary(op, operand) => match (*op, self.expression(operand)) {
                (UnaryOperator::Minus, node) => negate(node),
                (UnaryOperator::Plus, node) if node.is_constant() => node,
                (op, node) => Node::Unary { op, operand: Box::new(node), parens: 0 },
            },
            ExprKind::Binary(op, _, sides) => {
                let [left, right] = &**sides;
                let (left, right) = (self.expression(left), self.expression(right));
                Node::Binary { op: *op, left: Box::new(left), right: Box::new(right), parens: 0 }
            }
            ExprKind::Call(function, arguments) => {
                let arguments = arguments.iter().map(|argument| self.expression(argument)).collect();
                Node::Call { function: *function, arguments, parens: 0 }
            }
            ExprKind::Error => self.mistake(span, CompileErrorKind::Syntax),
        }
    }

    fn operand(&mut self, operand: &Operand) -> Node {
        let (class, parens) = (operand.class, 0);
        let number = Box::new(self.unwrapped(&operand.index));
        match &operand.element {
            Some(element) => Node::Array { class, array: number, element: Box::new(self.expression(element)), parens },
            None => Node::Scalar { class, index: number, parens },
        }
    }

    /// An expression whose outermost parentheses belong to the form around it: `P(LV0)`.
    pub(crate) fn unwrapped(&mut self, expr: &Expr) -> Node {
        match &expr.kind {
            ExprKind::Paren(inner) => self.expression(inner),
            _ => self.expression(expr),
        }
    }

    /// One pair of parentheses more around a node.
    fn parenthesise(&mut self, span: Span, mut node: Node) -> Node {
        match node.parens_mut() {
            Some(parens) if *parens == MAX_PARENS => {
                let what = "the number of parentheses around an operand";
                self.mistake(
                    span,
                    CompileErrorKind::Limit { what, value: u64::from(MAX_PARENS) + 1, limit: MAX_PARENS.into() },
                )
            }
            Some(parens) => {
                *parens += 1;
                node
            }
            None => node,
        }
    }

    /// A number that does not fit.
    pub(crate) fn too_large(&mut self, span: Span, limit: &'static str) -> Node {
        let text = self.slice(span).to_owned();
        self.mistake(span, CompileErrorKind::NumberTooLarge { text, limit })
    }
}
