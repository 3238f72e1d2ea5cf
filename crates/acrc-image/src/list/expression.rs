//! Expressions as the lister writes them.

use acrc_catalog::{Operator, UnaryOperator};

use super::Lister;
use crate::constant::{format_double, format_single};
use crate::error::Problem;
use crate::node::Node;
use crate::text;

impl Lister<'_> {
    /// An expression with the parentheses that were written around it.
    pub(super) fn expression(&mut self, node: &Node) -> Result<(), Problem> {
        let parens = usize::from(node.parens());
        self.out.push_str(&"(".repeat(parens));
        self.bare(node)?;
        self.out.push_str(&")".repeat(parens));
        Ok(())
    }

    /// An expression in at least one pair of parentheses.
    pub(super) fn parenthesised(&mut self, node: &Node) -> Result<(), Problem> {
        if node.parens() > 0 {
            return self.expression(node);
        }
        self.out.push('(');
        self.bare(node)?;
        self.out.push(')');
        Ok(())
    }

    /// Expressions with commas between, in parentheses.
    pub(super) fn tuple<'n>(&mut self, nodes: impl IntoIterator<Item = &'n Node>) -> Result<(), Problem> {
        self.out.push('(');
        for (place, node) in nodes.into_iter().enumerate() {
            if place > 0 {
                self.out.push_str(", ");
            }
            self.expression(node)?;
        }
        self.out.push(')');
        Ok(())
    }

    fn bare(&mut self, node: &Node) -> Result<(), Problem> {
        match node {
            Node::Long(value) => self.out.push_str(&value.to_string()),
            Node::Single(value) => self.out.push_str(&format_single(*value)),
            Node::Double(value) => self.out.push_str(&format_double(*value)),
            Node::String { bytes, .. } => {
                self.out.push('"');
                self.out.push_str(&text::decode(bytes));
                self.out.push('"');
            }
            Node::Scalar { class, index, .. } => {
                self.out.push_str(class.name());
                self.index(index)?;
            }
            Node::Array { class, array, element, .. } => {
                self.out.push_str(class.name());
                self.index(array)?;
                self.tuple([element.as_ref()])?;
            }
            Node::Alias { index, .. } => {
                let unknown = Problem::NoSuchAlias { index: *index, aliases: self.aliases.len() };
                self.out.push_str(&self.aliases.get(usize::from(*index)).ok_or(unknown)?.name);
            }
            Node::Unary { op, operand, .. } => self.unary(*op, operand)?,
            Node::Binary { op, left, right, .. } => self.binary(*op, left, right)?,
            Node::Call { function, arguments, .. } => {
                self.out.push_str(function.info().name);
                self.tuple(arguments)?;
            }
            _ => self.item(node)?,
        }
        Ok(())
    }

    /// The number of an operand: glued to its word when it is a plain whole number.
    pub(super) fn index(&mut self, node: &Node) -> Result<(), Problem> {
        let plain = match node {
            Node::Long(value) => *value >= 0,
            Node::Double(value) => format_double(*value).bytes().all(|byte| byte.is_ascii_digit()),
            _ => false,
        };
        if plain { self.expression(node) } else { self.tuple([node]) }
    }

    fn unary(&mut self, op: UnaryOperator, operand: &Node) -> Result<(), Problem> {
        self.out.push_str(op.name());
        if op == UnaryOperator::Not {
            self.out.push(' ');
        }
        let binary = matches!(operand, Node::Binary { parens: 0, .. });
        if binary { self.parenthesised(operand) } else { self.expression(operand) }
    }

    /// Parentheses that the tree needs are written even when nobody wrote them.
    fn binary(&mut self, op: Operator, left: &Node, right: &Node) -> Result<(), Problem> {
        let looser =
            |node: &Node, than: u8| matches!(node, Node::Binary { op, parens: 0, .. } if op.precedence() >= than);
        if looser(left, op.precedence().saturating_add(1)) {
            self.parenthesised(left)?;
        } else {
            self.expression(left)?;
        }
        self.out.push(' ');
        self.out.push_str(op.name());
        self.out.push(' ');
        if looser(right, op.precedence()) { self.parenthesised(right) } else { self.expression(right) }
    }
}
