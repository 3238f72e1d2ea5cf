//! Expressions (guide, "Parametric Evaluation").
//!
//! Types are known at load except for parameters: two longs give a long that wraps at 32 bits, two 32-bit numbers a 32-bit number, everything else 64 bits.
//! `/` and `**` never give a long. Logical operators, `MOD` and shifts work on longs. A real constant takes part with 32 bits beside a 32-bit
//! number, else with 64 bits.

use acrc_catalog::{Confidence, Operator, UnaryOperator};
use acrc_image::Node;

use super::Loader;
use super::error::LoadErrorKind;
use super::place::{Kind, Place};
use crate::code::{Doubt, Real};
use crate::fault::FaultKind;
use crate::op::{LongOperator, Op, Slot, ValueOperator};

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
enum Arithmetic {
    Add,
    Sub,
    Mul,
    Div,
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
        let result = match operator {
            Operator::Add => self.arithmetic(Arithmetic::Add, &left, &right, mark, hint),
            Operator::Sub => self.arithmetic(Arithmetic::Sub, &left, &right, mark, hint),
            Operator::Mul => self.arithmetic(Arithmetic::Mul, &left, &right, mark, hint),
            Operator::Div => self.arithmetic(Arithmetic::Div, &left, &right, mark, hint),
            Operator::Pow => {
                let (left, right) = (self.double(&left)?, self.double(&right)?);
                self.scratch = mark;
                let to = self.double_result(hint)?;
                self.emit(Op::DoublePower { to, left, right });
                Ok(Place::Double(to))
            }
            Operator::Mod => self.long_operation(LongOperator::Rem, &left, &right, mark, hint),
            Operator::And => self.long_operation(LongOperator::And, &left, &right, mark, hint),
            Operator::Nand => self.long_operation(LongOperator::Nand, &left, &right, mark, hint),
            Operator::Or => self.long_operation(LongOperator::Or, &left, &right, mark, hint),
            Operator::Nor => self.long_operation(LongOperator::Nor, &left, &right, mark, hint),
            Operator::Xor => self.long_operation(LongOperator::Xor, &left, &right, mark, hint),
            Operator::Xnor => self.long_operation(LongOperator::Xnor, &left, &right, mark, hint),
            Operator::Shl => self.long_operation(LongOperator::ShiftLeft, &left, &right, mark, hint),
            Operator::Shr => self.long_operation(LongOperator::ShiftRight, &left, &right, mark, hint),
            Operator::Eq | Operator::Ne | Operator::Lt | Operator::Gt | Operator::Le | Operator::Ge => {
                self.compare(operator, &left, &right, mark, hint)
            }
        };
        result
    }

    fn long_operation(
        &mut self,
        operator: LongOperator,
        left: &Place,
        right: &Place,
        mark: super::Scratch,
        hint: Hint,
    ) -> Result<Place, LoadErrorKind> {
        let left = self.long(left)?;
        if let (LongOperator::Rem, Place::LongConst(value)) = (operator, right) {
            self.scratch = mark;
            let to = self.long_result(hint)?;
            self.emit(Op::LongRemConst { to, left, value: *value });
            return Ok(Place::Long(to));
        }
        let right = self.long(right)?;
        self.scratch = mark;
        let to = self.long_result(hint)?;
        self.emit(Op::LongOperate { operator, to, left, right });
        Ok(Place::Long(to))
    }

    fn arithmetic(
        &mut self,
        operator: Arithmetic,
        left: &Place,
        right: &Place,
        mark: super::Scratch,
        hint: Hint,
    ) -> Result<Place, LoadErrorKind> {
        use Kind::{Double, Long, Real, Single, Text, Value};
        match (left.kind(), right.kind()) {
            (Text, Text) if operator == Arithmetic::Add => self.join(left, right, mark),
            (Text, _) | (_, Text) => {
                self.raise(FaultKind::NumberExpected);
                Ok(Place::LongConst(0))
            }
            (Long, Long) if operator != Arithmetic::Div => self.long_arithmetic(operator, left, right, mark, hint),
            (Single, Single | Real) | (Real, Single) => {
                let (left, right) = (self.beside_single(left), self.beside_single(right));
                let exact = self.double_arithmetic(operator, &left, &right, mark, Hint::None)?;
                let from = self.double(&exact)?;
                self.emit(Op::DoubleRound { to: from, from });
                Ok(Place::Single(from))
            }
            (Value, Value | Single) | (Single, Value) => self.value_arithmetic(operator, left, right, mark),
            (Value, Long) | (Long, Value) if operator != Arithmetic::Div => {
                self.value_arithmetic(operator, left, right, mark)
            }
            (Long | Double | Single | Real | Value, _) => self.double_arithmetic(operator, left, right, mark, hint),
        }
    }

    fn join(&mut self, left: &Place, right: &Place, mark: super::Scratch) -> Result<Place, LoadErrorKind> {
        let (left, right) = (self.value(left)?, self.value(right)?);
        self.scratch = mark;
        let to = self.value_slot()?;
        self.emit(Op::TextJoin { to, left, right });
        Ok(Place::Text(to))
    }

    /// A real constant that meets a 32-bit number.
    pub(super) fn beside_single(&self, place: &Place) -> Place {
        match place {
            Place::Real(value) => Place::DoubleConst(f64::from(*value)),
            _ => place.clone(),
        }
    }

    fn long_arithmetic(
        &mut self,
        operator: Arithmetic,
        left: &Place,
        right: &Place,
        mark: super::Scratch,
        hint: Hint,
    ) -> Result<Place, LoadErrorKind> {
        // Constants go to the right, where the instructions take them.
        let (left, right) = match (operator, left) {
            (Arithmetic::Add | Arithmetic::Mul, Place::LongConst(_)) => (right, left),
            _ => (left, right),
        };
        if let (Place::LongConst(a), Place::LongConst(b)) = (left, right) {
            return Ok(Place::LongConst(match operator {
                Arithmetic::Add => a.wrapping_add(*b),
                Arithmetic::Sub => a.wrapping_sub(*b),
                Arithmetic::Mul | Arithmetic::Div => a.wrapping_mul(*b),
            }));
        }
        let left = self.long(left)?;
        let constant = if let Place::LongConst(value) = right { Some(*value) } else { None };
        let right = if constant.is_some() { left } else { self.long(right)? };
        self.scratch = mark;
        let to = self.long_result(hint)?;
        self.emit(match (operator, constant) {
            (Arithmetic::Add, Some(value)) => Op::LongAddConst { to, left, value },
            (Arithmetic::Sub, Some(value)) => Op::LongAddConst { to, left, value: value.wrapping_neg() },
            (_, Some(value)) => Op::LongMulConst { to, left, value },
            (Arithmetic::Add, None) => Op::LongAdd { to, left, right },
            (Arithmetic::Sub, None) => Op::LongSub { to, left, right },
            (_, None) => Op::LongMul { to, left, right },
        });
        Ok(Place::Long(to))
    }

    fn double_arithmetic(
        &mut self,
        operator: Arithmetic,
        left: &Place,
        right: &Place,
        mark: super::Scratch,
        hint: Hint,
    ) -> Result<Place, LoadErrorKind> {
        let (left, right) = match (operator, constant_double(left)) {
            (Arithmetic::Add | Arithmetic::Mul, Some(_)) => (right, left),
            _ => (left, right),
        };
        let constant = constant_double(right);
        let left = self.double(left)?;
        let right = if constant.is_some() { left } else { self.double(right)? };
        self.scratch = mark;
        let to = self.double_result(hint)?;
        self.emit(match (operator, constant) {
            (Arithmetic::Add, Some(value)) => Op::DoubleAddConst { to, left, value },
            (Arithmetic::Sub, Some(value)) => Op::DoubleAddConst { to, left, value: -value },
            (Arithmetic::Mul, Some(value)) => Op::DoubleMulConst { to, left, value },
            (Arithmetic::Div, Some(value)) => Op::DoubleDivConst { to, left, value },
            (Arithmetic::Add, None) => Op::DoubleAdd { to, left, right },
            (Arithmetic::Sub, None) => Op::DoubleSub { to, left, right },
            (Arithmetic::Mul, None) => Op::DoubleMul { to, left, right },
            (Arithmetic::Div, None) => Op::DoubleDiv { to, left, right },
        });
        Ok(Place::Double(to))
    }

    fn value_arithmetic(
        &mut self,
        operator: Arithmetic,
        left: &Place,
        right: &Place,
        mark: super::Scratch,
    ) -> Result<Place, LoadErrorKind> {
        let (left, right) = (self.value(left)?, self.value(right)?);
        self.scratch = mark;
        let to = self.value_slot()?;
        let operator = match operator {
            Arithmetic::Add => ValueOperator::Add,
            Arithmetic::Sub => ValueOperator::Sub,
            Arithmetic::Mul => ValueOperator::Mul,
            Arithmetic::Div => ValueOperator::Div,
        };
        self.emit(Op::ValueOperate { operator, to, left, right });
        Ok(Place::Value(to))
    }
}

/// A constant as a double.
fn constant_double(place: &Place) -> Option<f64> {
    match *place {
        Place::LongConst(value) => Some(f64::from(value)),
        Place::DoubleConst(value) => Some(value),
        Place::Real(value) => Some(Real::new(value).decimal),
        _ => None,
    }
}
