//! Where the value of an expression is, and how it gets to another file.

use acrc_image::Mark;

use super::Loader;
use super::error::LoadErrorKind;
use crate::code::Real;
use crate::fault::FaultKind;
use crate::op::{Op, SCRATCH, Slot};
use crate::plan::{Index, Operand, Part};
use crate::text::Text;
use crate::value::{Value, double_to_long};

/// The value of an expression: a constant, or a slot in one of the files.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Place {
    Long(Slot),
    LongConst(i32),
    /// A 64-bit number.
    Double(Slot),
    DoubleConst(f64),
    /// A 32-bit number, in the file of doubles.
    Single(Slot),
    /// A real constant of up to seven digits.
    Real(f32),
    /// A number whose type is known at run time.
    Value(Slot),
    /// A string in the file of values.
    Text(Slot),
    TextConst(Text),
}

/// The type of a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Long,
    Double,
    Single,
    Real,
    Value,
    Text,
}

impl Place {
    pub(super) const fn kind(&self) -> Kind {
        match self {
            Self::Long(_) | Self::LongConst(_) => Kind::Long,
            Self::Double(_) | Self::DoubleConst(_) => Kind::Double,
            Self::Single(_) => Kind::Single,
            Self::Real(_) => Kind::Real,
            Self::Value(_) => Kind::Value,
            Self::Text(_) | Self::TextConst(_) => Kind::Text,
        }
    }
}

/// First free scratch slot of each file.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Scratch {
    long: usize,
    double: usize,
    value: usize,
}

/// The next free slot of a file.
fn take(top: &mut usize) -> Result<Slot, LoadErrorKind> {
    let slot = *top;
    *top += 1;
    if slot < SCRATCH { Ok(slot as Slot) } else { Err(LoadErrorKind::TooComplex) }
}

impl Loader<'_> {
    pub(super) fn long_slot(&mut self) -> Result<Slot, LoadErrorKind> {
        take(&mut self.scratch.long)
    }

    pub(super) fn double_slot(&mut self) -> Result<Slot, LoadErrorKind> {
        take(&mut self.scratch.double)
    }

    pub(super) fn value_slot(&mut self) -> Result<Slot, LoadErrorKind> {
        let slot = take(&mut self.scratch.value)?;
        self.value_slots = self.value_slots.max(self.scratch.value);
        Ok(slot)
    }

    /// A value slot that holds a constant.
    fn value_constant(&mut self, to: Slot, value: Value) {
        let index = self.constants.len() as u32;
        self.constants.push(value);
        self.emit(Op::ValueConst { to, index });
    }

    /// The place as a long.
    pub(super) fn long(&mut self, place: &Place) -> Result<Slot, LoadErrorKind> {
        if let Place::Long(slot) = place {
            return Ok(*slot);
        }
        let to = self.long_slot()?;
        self.long_to(place, to);
        Ok(to)
    }

    /// Puts the place into a long slot; the fraction is dropped.
    pub(super) fn long_to(&mut self, place: &Place, to: Slot) {
        match *place {
            Place::Long(from) if from == to => {}
            Place::Long(from) => self.emit(Op::LongMove { to, from }),
            Place::LongConst(value) => self.emit(Op::LongConst { to, value }),
            Place::DoubleConst(value) => self.emit(Op::LongConst { to, value: double_to_long(value) }),
            Place::Real(value) => self.emit(Op::LongConst { to, value: double_to_long(Real::new(value).decimal) }),
            Place::Double(from) | Place::Single(from) => self.emit(Op::DoubleToLong { to, from }),
            Place::Value(from) => self.emit(Op::ValueToLong { to, from }),
            Place::Text(_) | Place::TextConst(_) => self.raise(FaultKind::NumberExpected),
        }
    }

    /// The place as a double. A real constant is the decimal that was written.
    pub(super) fn double(&mut self, place: &Place) -> Result<Slot, LoadErrorKind> {
        if let Place::Double(slot) | Place::Single(slot) = place {
            return Ok(*slot);
        }
        let to = self.double_slot()?;
        self.double_to(place, to);
        Ok(to)
    }

    /// Puts the place into a double slot.
    pub(super) fn double_to(&mut self, place: &Place, to: Slot) {
        match *place {
            Place::Double(from) | Place::Single(from) if from == to => {}
            Place::Double(from) | Place::Single(from) => self.emit(Op::DoubleMove { to, from }),
            Place::Long(from) => self.emit(Op::LongToDouble { to, from }),
            Place::LongConst(value) => self.emit(Op::DoubleConst { to, value: f64::from(value) }),
            Place::DoubleConst(value) => self.emit(Op::DoubleConst { to, value }),
            Place::Real(value) => self.emit(Op::DoubleConst { to, value: Real::new(value).decimal }),
            Place::Value(from) => self.emit(Op::ValueToDouble { to, from }),
            Place::Text(_) | Place::TextConst(_) => self.raise(FaultKind::NumberExpected),
        }
    }

    /// The place as a value, number or string.
    pub(super) fn value(&mut self, place: &Place) -> Result<Slot, LoadErrorKind> {
        if let Place::Value(slot) | Place::Text(slot) = place {
            return Ok(*slot);
        }
        let to = self.value_slot()?;
        self.value_to(place, to);
        Ok(to)
    }

    /// Puts the place into a value slot.
    pub(super) fn value_to(&mut self, place: &Place, to: Slot) {
        match place.clone() {
            Place::Value(from) | Place::Text(from) if from == to => {}
            Place::Value(from) | Place::Text(from) => self.emit(Op::ValueMove { to, from }),
            Place::Long(from) => self.emit(Op::LongToValue { to, from }),
            Place::Double(from) => self.emit(Op::DoubleToValue { to, from }),
            Place::Single(from) => self.emit(Op::SingleToValue { to, from }),
            Place::LongConst(value) => self.value_constant(to, Value::Long(value)),
            Place::DoubleConst(value) => self.value_constant(to, Value::Double(value)),
            Place::Real(value) => self.value_constant(to, Value::Double(Real::new(value).decimal)),
            Place::TextConst(text) => self.value_constant(to, Value::Text(text)),
        }
    }

    /// The place as a number in the file of values.
    pub(super) fn number(&mut self, place: &Place) -> Result<Slot, LoadErrorKind> {
        if place.kind() == Kind::Text {
            self.raise(FaultKind::NumberExpected);
        }
        self.value(place)
    }

    /// The place as a string in the file of values.
    pub(super) fn text(&mut self, place: &Place) -> Result<Slot, LoadErrorKind> {
        if place.kind() != Kind::Text {
            self.raise(FaultKind::TextExpected);
        }
        self.value(place)
    }

    /// The place as the number of a variable, parameter or flag.
    pub(super) fn index(&mut self, place: &Place) -> Result<Index, LoadErrorKind> {
        match place {
            Place::LongConst(number) => Ok(Index::Const(*number)),
            Place::DoubleConst(value) => Ok(Index::Const(double_to_long(*value))),
            _ => self.long(place).map(Index::Slot),
        }
    }

    /// The number of a variable, parameter or flag in a slot.
    pub(super) fn index_slot(&mut self, index: Index) -> Result<Slot, LoadErrorKind> {
        match index {
            Index::Slot(slot) => Ok(slot),
            Index::Const(number) => self.long(&Place::LongConst(number)),
        }
    }

    /// The place as a value of an argument.
    pub(super) fn operand(place: Place) -> Operand {
        match place {
            Place::Long(slot) => Operand::Long(slot),
            Place::Double(slot) => Operand::Double(slot),
            Place::Single(slot) => Operand::Single(slot),
            Place::Value(slot) | Place::Text(slot) => Operand::Value(slot),
            Place::LongConst(value) => Operand::Const(Value::Long(value)),
            Place::DoubleConst(value) => Operand::Const(Value::Double(value)),
            Place::Real(value) => Operand::Const(Value::Double(Real::new(value).decimal)),
            Place::TextConst(text) => Operand::Const(Value::Text(text)),
        }
    }

    /// The place as an argument.
    pub(super) fn value_part(place: Place, mark: Mark) -> Part {
        Part::Value(Self::operand(place), mark)
    }
}
