//! Arithmetic of expressions: which file an operation works on, and constants as parts of instructions.

use super::error::LoadErrorKind;
use super::expression::{Arithmetic, Hint};
use super::place::{Kind, Place};
use super::{Loader, Scratch};
use crate::code::Real;
use crate::fault::FaultKind;
use crate::op::{LongOperator, Op, ValueOperator};

impl Loader<'_> {
    /// An operator that works on longs.
    pub(super) fn long_operation(
        &mut self,
        operator: LongOperator,
        left: &Place,
        right: &Place,
        mark: Scratch,
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

    /// `+ - * /`, which every type of number has.
    pub(super) fn arithmetic(
        &mut self,
        operator: Arithmetic,
        left: &Place,
        right: &Place,
        mark: Scratch,
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
                let (left, right) = (beside_single(left), beside_single(right));
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

    fn join(&mut self, left: &Place, right: &Place, mark: Scratch) -> Result<Place, LoadErrorKind> {
        let (left, right) = (self.value(left)?, self.value(right)?);
        self.scratch = mark;
        let to = self.value_slot()?;
        self.emit(Op::TextJoin { to, left, right });
        Ok(Place::Text(to))
    }

    fn long_arithmetic(
        &mut self,
        operator: Arithmetic,
        left: &Place,
        right: &Place,
        mark: Scratch,
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
        mark: Scratch,
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
        mark: Scratch,
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

/// A real constant that meets a 32-bit number.
pub(super) fn beside_single(place: &Place) -> Place {
    match place {
        Place::Real(value) => Place::DoubleConst(f64::from(*value)),
        _ => place.clone(),
    }
}

/// A constant as a double.
pub(super) fn constant_double(place: &Place) -> Option<f64> {
    match *place {
        Place::LongConst(value) => Some(f64::from(value)),
        Place::DoubleConst(value) => Some(value),
        Place::Real(value) => Some(Real::new(value).decimal),
        _ => None,
    }
}
