//! Relations and conditions.
//!
//! A condition that is one relation becomes a jump that compares; any other is evaluated to a number, and every number
//! but zero is true.

use acrc_catalog::{OperandClass, UnaryOperator};
use acrc_image::Node;

use super::arithmetic::{beside_single, constant_double};
use super::error::LoadErrorKind;
use super::expression::{Hint, OperatorKind, kind_of};
use super::place::{Kind, Place};
use super::{Jump, Loader, Scratch, Step};
use crate::code::Real;
use crate::fault::FaultKind;
use crate::op::{LongRange, Op, Relation, SCRATCH, Slot};

/// The operands of a relation, brought to one file.
enum Operands {
    Long(Slot, Slot),
    LongConst(Slot, i32),
    Double(Slot, Slot),
    DoubleConst(Slot, f64),
    /// A value against a real constant.
    Real(Slot, u32),
    Text(Slot, Slot),
}

impl Loader<'_> {
    /// A relation as a value: -1 or 0.
    pub(super) fn compare(
        &mut self,
        relation: Relation,
        left: &Place,
        right: &Place,
        mark: Scratch,
        hint: Hint,
    ) -> Result<Place, LoadErrorKind> {
        let Some((relation, operands)) = self.operands(relation, left, right)? else { return Ok(Place::LongConst(0)) };
        let operands = match operands {
            Operands::LongConst(left, value) => Operands::Long(left, self.long(&Place::LongConst(value))?),
            Operands::DoubleConst(left, value) => Operands::Double(left, self.double(&Place::DoubleConst(value))?),
            other => other,
        };
        self.scratch = mark;
        let to = self.long_result(hint)?;
        self.emit(match operands {
            Operands::Long(left, right) => Op::LongCompare { relation, to, left, right },
            Operands::LongConst(left, _) => Op::LongCompare { relation, to, left, right: left },
            Operands::Double(left, right) => Op::DoubleCompare { relation, to, left, right },
            Operands::DoubleConst(left, _) => Op::DoubleCompare { relation, to, left, right: left },
            Operands::Real(left, index) => Op::RealCompare { relation, to, left, index },
            Operands::Text(left, right) => Op::TextCompare { relation, to, left, right },
        });
        Ok(Place::Long(to))
    }

    /// Brings two values to one file. `None` when they cannot be compared, which is then a fault of the statement.
    fn operands(
        &mut self,
        relation: Relation,
        left: &Place,
        right: &Place,
    ) -> Result<Option<(Relation, Operands)>, LoadErrorKind> {
        let operands = match (left, right) {
            (Place::LongConst(value), Place::Long(slot)) => {
                return Ok(Some((relation.swapped(), Operands::LongConst(*slot, *value))));
            }
            (Place::Real(single), Place::Value(slot)) => {
                let index = self.real(*single);
                return Ok(Some((relation.swapped(), Operands::Real(*slot, index))));
            }
            (Place::Value(slot), Place::Real(single)) => Operands::Real(*slot, self.real(*single)),
            _ => match (left.kind(), right.kind()) {
                (Kind::Long, Kind::Long) => match right {
                    Place::LongConst(value) => Operands::LongConst(self.long(left)?, *value),
                    _ => Operands::Long(self.long(left)?, self.long(right)?),
                },
                (Kind::Text, Kind::Text) => Operands::Text(self.value(left)?, self.value(right)?),
                (Kind::Text, _) | (_, Kind::Text) => {
                    self.raise(FaultKind::NumberExpected);
                    return Ok(None);
                }
                (Kind::Single, Kind::Real) | (Kind::Real, Kind::Single) => {
                    let (left, right) = (beside_single(left), beside_single(right));
                    Operands::Double(self.double(&left)?, self.double(&right)?)
                }
                _ => match (constant_double(left), constant_double(right)) {
                    (_, Some(value)) => Operands::DoubleConst(self.double(left)?, value),
                    (Some(value), None) => {
                        return Ok(Some((relation.swapped(), Operands::DoubleConst(self.double(right)?, value))));
                    }
                    (None, None) => Operands::Double(self.double(left)?, self.double(right)?),
                },
            },
        };
        Ok(Some((relation, operands)))
    }

    /// A real constant that is compared with a value.
    fn real(&mut self, single: f32) -> u32 {
        let index = self.reals.len() as u32;
        self.reals.push(Real::new(single));
        index
    }

    /// Jumps when a condition is false.
    pub(super) fn jump_unless(&mut self, condition: &Node, to: Jump) -> Result<(), LoadErrorKind> {
        if let Some((number, state)) = self.constant_flag(condition)? {
            self.emit_jump(Op::JumpUnlessBit { number, state, target: 0 }, to);
            return Ok(());
        }
        if let Node::Binary { op, left, right, .. } = self.resolve(condition)?
            && let OperatorKind::Relation(relation) = kind_of(*op)
        {
            let (left, right) = (self.expression(left)?, self.expression(right)?);
            return self.jump_unless_related(relation, &left, &right, to);
        }
        let place = self.expression(condition)?;
        let from = self.truth(&place)?;
        self.emit_jump(Op::JumpUnless { from, target: 0 }, to);
        Ok(())
    }

    fn jump_unless_related(
        &mut self,
        relation: Relation,
        left: &Place,
        right: &Place,
        to: Jump,
    ) -> Result<(), LoadErrorKind> {
        let Some((relation, operands)) = self.operands(relation, left, right)? else { return Ok(()) };
        let target = 0;
        let jump = match operands {
            Operands::Long(left, right) => Op::JumpUnlessLong { relation, left, right, target },
            Operands::LongConst(left, value) => match self.take_remainder(left) {
                Some((left, divisor)) => Op::JumpUnlessRem { relation, left, divisor, value, target },
                None => {
                    let (range, inside) = LongRange::new(relation, value);
                    Op::JumpUnlessLongConst { range, inside, left, target }
                }
            },
            Operands::Double(left, right) => Op::JumpUnlessDouble { relation, left, right, target },
            Operands::DoubleConst(left, value) => Op::JumpUnlessDoubleConst { relation, left, value, target },
            Operands::Real(left, index) => {
                let from = self.long_slot()?;
                self.emit(Op::RealCompare { relation, to: from, left, index });
                Op::JumpUnless { from, target }
            }
            Operands::Text(left, right) => {
                let from = self.long_slot()?;
                self.emit(Op::TextCompare { relation, to: from, left, right });
                Op::JumpUnless { from, target }
            }
        };
        self.emit_jump(jump, to);
        Ok(())
    }

    /// Takes the latest instruction back if it computed a remainder into a scratch slot: its dividend and its divisor.
    fn take_remainder(&mut self, slot: Slot) -> Option<(Slot, i32)> {
        let Step { op: Op::LongRemConst { to, left, value }, begins } = *self.steps.last()? else { return None };
        if to != slot || usize::from(to) >= SCRATCH {
            return None;
        }
        self.steps.pop();
        self.begins = begins;
        Some((left, value))
    }

    /// The flag of a condition such as `BIT 24` or `NOT BIT 24`, and the state that makes it true.
    fn constant_flag(&self, condition: &Node) -> Result<Option<(i32, bool)>, LoadErrorKind> {
        Ok(match self.resolve(condition)? {
            Node::Scalar { class: OperandClass::Bit, index, .. } => match **index {
                Node::Long(number) => Some((number, true)),
                _ => None,
            },
            Node::Unary { op: UnaryOperator::Not, operand, .. } => {
                self.constant_flag(operand)?.map(|(number, state)| (number, !state))
            }
            _ => None,
        })
    }
}
