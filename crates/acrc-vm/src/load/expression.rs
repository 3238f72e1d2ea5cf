//! Expressions (guide, "Parametric Evaluation").
//!
//! Types are known at load except for parameters: two longs give a long that wraps at 32 bits, two 32-bit numbers a
//! 32-bit number, everything else 64 bits. `/` and `**` never give a long. Logical operators, `MOD` and shifts work on
//! longs. A real constant takes part with 32 bits beside a 32-bit number, else with 64 bits.

use acrc_catalog::{Confidence, Operator, UnaryOperator};
use acrc_image::Node;

use super::Loader;
use super::error::LoadErrorKind;
use super::place::{Kind, Place};
use crate::code::Doubt;
use crate::fault::FaultKind;
use crate::op::{LongOperator, Op, Relation, Slot};

/// A slot that the result may be computed into, so that `LV0 = LV0 + 1` is one instruction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Hint {
    #[default]
    None,
    Long(Slot),
    Double(Slot),
}

/// The four operators that every type of number has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Arithmetic {
    Add,
    Sub,
    Mul,
    Div,
}

/// What kind of operator it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum OperatorKind {
    Arithmetic(Arithmetic),
    Long(LongOperator),
    Relation(Relation),
    Power,
}

/// The kind of an operator.
pub(super) const fn kind_of(operator: Operator) -> OperatorKind {
    match operator {
        Operator::Add => OperatorKind::Arithmetic(Arithmetic::Add),
        Operator::Sub => OperatorKind::Arithmetic(Arithmetic::Sub),
        Operator::Mul => OperatorKind::Arithmetic(Arithmetic::Mul),
        Operator::Div => OperatorKind::Arithmetic(Arithmetic::Div),
        Operator::Pow => OperatorKind::Power,
        Operator::Mod => OperatorKind::Long(LongOperator::Rem),
        Operator::And => OperatorKind::Long(LongOperator::And),
        Operator::Nand => OperatorKind::Long(LongOperator::Nand),
        Operator::Or => OperatorKind::Long(LongOperator::Or),
        Operator::Nor => OperatorKind::Long(LongOperator::Nor),
        Operator::Xor => OperatorKind::Long(LongOperator::Xor),
        Operator::Xnor => OperatorKind::Long(LongOperator::Xnor),
        Operator::Shl => OperatorKind::Long(LongOperator::ShiftLeft),
        Operator::Shr => OperatorKind::Long(LongOperator::ShiftRight),
        Operator::Eq => OperatorKind::Relation(Relation::EQUAL),
        Operator::Ne => OperatorKind::Relation(Relation::NOT_EQUAL),
        Operator::Lt => OperatorKind::Relation(Relation::LESS),
        Operator::Gt => OperatorKind::Relation(Relation::GREATER),
        Operator::Le => OperatorKind::Relation(Relation::LESS_OR_EQUAL),
        Operator::Ge => OperatorKind::Relation(Relation::GREATER_OR_EQUAL),
    }
}

impl Loader<'_> {
    /// Evaluates an expression.
    pub(super) fn expression(&mut self, node: &Node) -> Result<Place, LoadErrorKind> {
        self.expression_into(node, Hint::None)
    }

    /// Evaluates an expression, into the slot of the hint if that is as good as any other.
    pub(super) fn expression_into(&mut self, node: &Node, hint: Hint) -> Result<Place, LoadErrorKind> {
        match node {
            Node::Long(value) => Ok(Place::LongConst(*value)),
            Node::Single(value) => Ok(Place::Real(*value)),
            Node::Double(value) => Ok(Place::DoubleConst(*value)),
            Node::String { bytes, .. } => Ok(Place::TextConst(bytes.as_slice().into())),
            Node::Alias { .. } => {
                let node = self.resolve(node)?;
                self.expression_into(node, hint)
            }
            Node::Scalar { .. } | Node::Array { .. } => match self.target(node)? {
                Some(target) => self.load(target),
                None => Err(LoadErrorKind::NotAValue),
            },
            Node::Unary { op, operand, .. } => self.unary(*op, operand, hint),
            Node::Binary { op, left, right, .. } => self.binary(*op, left, right, hint),
            Node::Call { function, arguments, .. } => self.call(*function, arguments, hint),
            _ => Err(LoadErrorKind::NotAValue),
        }
    }

    /// The slot for a long result: that of the hint or a new one.
    pub(super) fn long_result(&mut self, hint: Hint) -> Result<Slot, LoadErrorKind> {
        if let Hint::Long(slot) = hint { Ok(slot) } else { self.long_slot() }
    }

    /// The slot for a double result: that of the hint or a new one.
    pub(super) fn double_result(&mut self, hint: Hint) -> Result<Slot, LoadErrorKind> {
        if let Hint::Double(slot) = hint { Ok(slot) } else { self.double_slot() }
    }

    fn unary(&mut self, operator: UnaryOperator, operand: &Node, hint: Hint) -> Result<Place, LoadErrorKind> {
        let mark = self.scratch;
        let place = self.expression(operand)?;
        if operator == UnaryOperator::Not {
            let from = self.long(&place)?;
            self.scratch = mark;
            let to = self.long_result(hint)?;
            self.emit(Op::LongNot { to, from });
            return Ok(Place::Long(to));
        }
        if place.kind() == Kind::Text {
            self.raise(FaultKind::NumberExpected);
            return Ok(Place::LongConst(0));
        }
        if operator == UnaryOperator::Plus {
            return Ok(place);
        }
        self.scratch = mark;
        self.negate(&place, hint)
    }

    /// The operand's slot may be used again for the result.
    fn negate(&mut self, place: &Place, hint: Hint) -> Result<Place, LoadErrorKind> {
        match *place {
            Place::LongConst(value) => Ok(Place::LongConst(value.wrapping_neg())),
            Place::DoubleConst(value) => Ok(Place::DoubleConst(-value)),
            Place::Real(value) => Ok(Place::Real(-value)),
            Place::Long(from) => {
                let to = self.long_result(hint)?;
                self.emit(Op::LongNegate { to, from });
                Ok(Place::Long(to))
            }
            Place::Double(from) => {
                let to = self.double_result(hint)?;
                self.emit(Op::DoubleNegate { to, from });
                Ok(Place::Double(to))
            }
            Place::Single(from) => {
                let to = self.double_slot()?;
                self.emit(Op::DoubleNegate { to, from });
                Ok(Place::Single(to))
            }
            Place::Value(from) | Place::Text(from) => {
                let to = self.value_slot()?;
                self.emit(Op::ValueNegate { to, from });
                Ok(Place::Value(to))
            }
            Place::TextConst(_) => Err(LoadErrorKind::NotAValue),
        }
    }

    fn binary(&mut self, operator: Operator, left: &Node, right: &Node, hint: Hint) -> Result<Place, LoadErrorKind> {
        if operator.confidence() == Confidence::Low {
            self.doubt(operator.symbol(), Doubt::Existence);
        }
        let mark = self.scratch;
        let (left, right) = (self.expression(left)?, self.expression(right)?);
        match kind_of(operator) {
            OperatorKind::Arithmetic(operator) => self.arithmetic(operator, &left, &right, mark, hint),
            OperatorKind::Long(operator) => self.long_operation(operator, &left, &right, mark, hint),
            OperatorKind::Relation(relation) => self.compare(relation, &left, &right, mark, hint),
            OperatorKind::Power => {
                let (left, right) = (self.double(&left)?, self.double(&right)?);
                self.scratch = mark;
                let to = self.double_result(hint)?;
                self.emit(Op::DoublePower { to, left, right });
                Ok(Place::Double(to))
            }
        }
    }
}
