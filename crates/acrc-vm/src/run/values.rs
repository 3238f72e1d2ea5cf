//! Instructions on the file of values: strings, and numbers whose type is known at run time only.

use acrc_catalog::OperandClass;

use super::arithmetic::{absolute, negate, value_operate};
use super::steps::{missing, undimensioned};
use crate::code::Code;
use crate::fault::FaultKind;
use crate::locals::Block;
use crate::op::{Op, Slot};
use crate::text::Text;
use crate::value::Value;

/// The files that instructions work on.
pub(super) struct Files<'a> {
    pub(super) longs: &'a mut [i32],
    pub(super) doubles: &'a mut [f64],
    pub(super) values: &'a mut [Value],
}

impl Files<'_> {
    pub(super) fn long(&self, slot: Slot) -> Result<i32, FaultKind> {
        let value = self.longs.get(usize::from(slot)).copied();
        value.ok_or_else(|| missing(OperandClass::Lv, slot, self.longs.len()))
    }

    pub(super) fn double(&self, slot: Slot) -> Result<f64, FaultKind> {
        let value = self.doubles.get(usize::from(slot)).copied();
        value.ok_or_else(|| missing(OperandClass::Dv, slot, self.doubles.len()))
    }

    /// A slot of the file of values is always there.
    pub(super) fn value(&self, slot: Slot) -> Result<&Value, FaultKind> {
        self.values.get(usize::from(slot)).ok_or(FaultKind::NumberExpected)
    }

    pub(super) fn set_long(&mut self, slot: Slot, value: i32) -> Result<(), FaultKind> {
        let count = self.longs.len();
        let place = self.longs.get_mut(usize::from(slot));
        *place.ok_or_else(|| missing(OperandClass::Lv, slot, count))? = value;
        Ok(())
    }

    pub(super) fn set_double(&mut self, slot: Slot, value: f64) -> Result<(), FaultKind> {
        let count = self.doubles.len();
        let place = self.doubles.get_mut(usize::from(slot));
        *place.ok_or_else(|| missing(OperandClass::Dv, slot, count))? = value;
        Ok(())
    }

    pub(super) fn set_value(&mut self, slot: Slot, value: Value) -> Result<(), FaultKind> {
        *self.values.get_mut(usize::from(slot)).ok_or(FaultKind::NumberExpected)? = value;
        Ok(())
    }

    fn set_truth(&mut self, slot: Slot, state: bool) -> Result<(), FaultKind> {
        self.set_long(slot, -i32::from(state))
    }
}

/// Executes an instruction on values.
pub(super) fn execute(op: Op, code: &Code, mut files: Files, texts: &mut Block<Text>) -> Result<(), FaultKind> {
    match op {
        Op::ValueConst { to, index } => match code.constants.get(index as usize) {
            Some(constant) => files.set_value(to, constant.clone()),
            None => Err(FaultKind::NumberExpected),
        },
        Op::ValueMove { to, from } => files.set_value(to, files.value(from)?.clone()),
        Op::ValueNegate { to, from } => files.set_value(to, negate(files.value(from)?)?),
        Op::ValueAbs { to, from } => files.set_value(to, absolute(files.value(from)?)?),
        Op::ValueOperate { operator, to, left, right } => {
            files.set_value(to, value_operate(operator, files.value(left)?, files.value(right)?)?)
        }
        Op::RealCompare { relation, to, left, index } => {
            let real = code.reals.get(index as usize).ok_or(FaultKind::NumberExpected)?;
            let state = match files.value(left)? {
                Value::Single(value) => relation.holds(value, &real.single),
                value => relation.holds(&value.to_f64()?, &real.decimal),
            };
            files.set_truth(to, state)
        }
        Op::TextJoin { to, left, right } => {
            let joined = files.value(left)?.as_text()?.joined(files.value(right)?.as_text()?);
            files.set_value(to, Value::Text(joined))
        }
        Op::TextCompare { relation, to, left, right } => {
            let state = relation.holds(files.value(left)?.as_text()?, files.value(right)?.as_text()?);
            files.set_truth(to, state)
        }
        Op::LongToValue { to, from } => files.set_value(to, Value::Long(files.long(from)?)),
        Op::DoubleToValue { to, from } => files.set_value(to, Value::Double(files.double(from)?)),
        Op::SingleToValue { to, from } => files.set_value(to, Value::Single(files.double(from)? as f32)),
        Op::ValueToLong { to, from } => files.set_long(to, files.value(from)?.to_long()?),
        Op::ValueToDouble { to, from } => files.set_double(to, files.value(from)?.to_f64()?),
        Op::ValueTruth { to, from } => files.set_truth(to, files.value(from)?.truth()?),
        Op::LoadText { to, index } => match texts.items.get(index as usize) {
            Some(text) => files.set_value(to, Value::Text(text.clone())),
            None => Err(undimensioned(OperandClass::StringV, index, texts.items.len())),
        },
        Op::StoreText { index, from } => {
            let text = files.value(from)?.as_text()?.clone().truncated(texts.length);
            let count = texts.items.len();
            let place = texts.items.get_mut(index as usize);
            *place.ok_or_else(|| undimensioned(OperandClass::StringV, index, count))? = text;
            Ok(())
        }
        _ => Ok(()),
    }
}
