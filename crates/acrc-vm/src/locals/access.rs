//! Reading and writing a local variable by its number.

use acrc_catalog::OperandClass;

use super::{Locals, place};
use crate::fault::FaultKind;
use crate::host::Reference;
use crate::op::SCRATCH;
use crate::text::Text;
use crate::value::Value;

impl Locals {
    /// The value of a local variable or element.
    ///
    /// # Errors
    /// When it does not exist, is a whole array, or is no local variable at all.
    pub fn read(&self, reference: Reference) -> Result<Value, FaultKind> {
        match reference {
            Reference::Variable { class, index } => self.read_variable(class, index),
            Reference::Element { class, array, element } => self.read_element(class, array, element),
            Reference::Array { class, array } => Err(FaultKind::ArrayAsValue { class, array }),
            Reference::Parameter(number) => Err(FaultKind::UnknownParameter(number)),
            Reference::Bit(number) => Err(FaultKind::UnknownBit(number)),
        }
    }

    /// Stores a value in a local variable or element, converted to its type; a string is cut to the dimensioned length.
    ///
    /// # Errors
    /// As [`Locals::read`], and when a string meets a number.
    pub fn write(&mut self, reference: Reference, value: &Value) -> Result<(), FaultKind> {
        match reference {
            Reference::Variable { class, index } => self.write_variable(class, index, value),
            Reference::Element { class, array, element } => self.write_element(class, array, element, value),
            Reference::Array { class, array } => Err(FaultKind::ArrayAsValue { class, array }),
            Reference::Parameter(number) => Err(FaultKind::UnknownParameter(number)),
            Reference::Bit(number) => Err(FaultKind::UnknownBit(number)),
        }
    }

    /// A string, and how many characters it may have. `None` for what does not exist or is no string.
    pub fn text(&self, reference: Reference) -> Option<(&Text, u32)> {
        let (block, index) = match reference {
            Reference::Variable { class: OperandClass::StringV, index } => (&self.texts, index),
            Reference::Element { class: OperandClass::StringA, array, element } => {
                (self.text_arrays.blocks().get(place(array)?)?, element)
            }
            _ => return None,
        };
        Some((block.items.get(place(index)?)?, block.length as u32))
    }

    /// How many elements an array has. `None` when it has no memory.
    pub fn array_size(&self, class: OperandClass, array: i64) -> Option<u32> {
        let array = place(array)?;
        let size = match class {
            OperandClass::La => self.long_arrays.blocks().get(array).map(|block| block.items.len()),
            OperandClass::Sa => self.single_arrays.blocks().get(array).map(|block| block.items.len()),
            OperandClass::Da => self.double_arrays.blocks().get(array).map(|block| block.items.len()),
            OperandClass::StringA => self.text_arrays.blocks().get(array).map(|block| block.items.len()),
            _ => None,
        };
        size.map(|size| size as u32)
    }

    /// The fault of a variable that does not exist.
    #[cold]
    pub(crate) fn undimensioned(&self, class: OperandClass, index: i64) -> FaultKind {
        FaultKind::Undimensioned { class, index, count: self.count(class) }
    }

    pub(crate) fn read_variable(&self, class: OperandClass, index: i64) -> Result<Value, FaultKind> {
        let place = place(index);
        let scratch = place.and_then(|place| place.checked_add(SCRATCH));
        let value = match class {
            OperandClass::Lv => scratch.and_then(|place| self.longs.get(place)).map(|value| Value::Long(*value)),
            OperandClass::Dv => scratch.and_then(|place| self.doubles.get(place)).map(|value| Value::Double(*value)),
            OperandClass::Sv => place.and_then(|place| self.singles.get(place)).map(|value| Value::Single(*value)),
            OperandClass::StringV => place.and_then(|place| self.texts.items.get(place)).cloned().map(Value::Text),
            _ => None,
        };
        value.ok_or_else(|| self.undimensioned(class, index))
    }

    pub(crate) fn write_variable(&mut self, class: OperandClass, index: i64, value: &Value) -> Result<(), FaultKind> {
        let place = place(index);
        let scratch = place.and_then(|place| place.checked_add(SCRATCH));
        let written = match class {
            OperandClass::Lv => store(scratch.and_then(|place| self.longs.get_mut(place)), value.to_long()),
            OperandClass::Dv => store(scratch.and_then(|place| self.doubles.get_mut(place)), value.to_f64()),
            OperandClass::Sv => store(place.and_then(|place| self.singles.get_mut(place)), to_single(value)),
            OperandClass::StringV => {
                let text = value.as_text().map(|text| text.clone().truncated(self.texts.length));
                store(place.and_then(|place| self.texts.items.get_mut(place)), text)
            }
            _ => None,
        };
        written.unwrap_or_else(|| Err(self.undimensioned(class, index)))
    }

    pub(crate) fn read_element(&self, class: OperandClass, array: i64, element: i64) -> Result<Value, FaultKind> {
        match class {
            OperandClass::La => self.long_arrays.get(array, element).map(|value| Value::Long(*value)),
            OperandClass::Sa => self.single_arrays.get(array, element).map(|value| Value::Single(*value)),
            OperandClass::Da => self.double_arrays.get(array, element).map(|value| Value::Double(*value)),
            OperandClass::StringA => self.text_arrays.get(array, element).cloned().map(Value::Text),
            _ => Err(FaultKind::NoSuchArray { class, array, arrays: 0 }),
        }
    }

    pub(crate) fn write_element(
        &mut self,
        class: OperandClass,
        array: i64,
        element: i64,
        value: &Value,
    ) -> Result<(), FaultKind> {
        match class {
            OperandClass::La => *self.long_arrays.get_mut(array, element)?.0 = value.to_long()?,
            OperandClass::Sa => *self.single_arrays.get_mut(array, element)?.0 = to_single(value)?,
            OperandClass::Da => *self.double_arrays.get_mut(array, element)?.0 = value.to_f64()?,
            OperandClass::StringA => {
                let text: Text = value.as_text()?.clone();
                let (slot, length) = self.text_arrays.get_mut(array, element)?;
                *slot = text.truncated(length);
            }
            _ => return Err(FaultKind::NoSuchArray { class, array, arrays: 0 }),
        }
        Ok(())
    }
}

/// Stores a value if there is a place for it. `None` when there is none.
fn store<T>(place: Option<&mut T>, value: Result<T, FaultKind>) -> Option<Result<(), FaultKind>> {
    let place = place?;
    Some(value.map(|value| *place = value))
}

/// A number as a 32-bit floating point number.
pub(crate) fn to_single(value: &Value) -> Result<f32, FaultKind> {
    match value {
        Value::Single(value) => Ok(*value),
        _ => value.to_f64().and_then(round_to_single),
    }
}

/// A 64-bit floating point number with 32 bits.
#[inline]
pub(crate) fn round_to_single(value: f64) -> Result<f32, FaultKind> {
    let single = value as f32;
    if single.is_finite() { Ok(single) } else { Err(FaultKind::NotSingle(value)) }
}
