//! Variables, parameters and flags: reading, writing and naming them.

use acrc_catalog::memory::USER_PARAMETERS;
use acrc_catalog::{OperandClass, ValueType};
use acrc_image::{Alias, Node};

use super::Loader;
use super::error::LoadErrorKind;
use super::place::{Kind, Place};
use crate::account::Begins;
use crate::fault::FaultKind;
use crate::locals::variable_slot;
use crate::op::{Op, Relation, Slot};
use crate::plan::{Index, Named};

/// An operand with its numbers evaluated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Target {
    /// `LV` in the file of longs.
    Long(Slot),
    /// `DV` in the file of doubles.
    Double(Slot),
    Single(u32),
    Text(u32),
    Variable(OperandClass, Slot),
    LongElement(u16, Slot),
    DoubleElement(u16, Slot),
    Element(OperandClass, Slot, Slot),
    /// `P0` to `P4095`, which have 64 bits.
    User(u16),
    Parameter(Index),
    Bit(Index),
    /// `LA0` without an element, which has no value.
    Whole(OperandClass, Index),
}

impl<'a> Loader<'a> {
    /// The node behind an alias.
    pub(super) fn resolve<'n>(&self, node: &'n Node) -> Result<&'n Node, LoadErrorKind>
    where
        'a: 'n,
    {
        let aliases: &'a [Alias] = self.aliases;
        match node {
            Node::Alias { index, .. } => {
                let alias = aliases.get(usize::from(*index));
                alias.map(|alias| &alias.target).ok_or(LoadErrorKind::UnknownAlias(*index))
            }
            _ => Ok(node),
        }
    }
}

impl Loader<'_> {
    /// The operand that a node names, aliases included; `None` for anything else.
    pub(super) fn target(&mut self, node: &Node) -> Result<Option<Target>, LoadErrorKind> {
        let Some(Named { class, index, element }) = self.named(node)? else { return Ok(None) };
        let target = match (class, index) {
            (OperandClass::Parameter, _) => user(index).map_or(Target::Parameter(index), Target::User),
            (OperandClass::Bit, _) => Target::Bit(index),
            _ => match element {
                Some(element) => self.element_target(class, index, element)?,
                None if class.is_array() => Target::Whole(class, index),
                None => self.variable_target(class, index)?,
            },
        };
        Ok(Some(target))
    }

    /// The operand that a node names, as arguments take it.
    pub(super) fn named(&mut self, node: &Node) -> Result<Option<Named>, LoadErrorKind> {
        match self.resolve(node)? {
            Node::Scalar { class, index, .. } => {
                let index = self.expression(index)?;
                Ok(Some(Named { class: *class, index: self.index(&index)?, element: None }))
            }
            Node::Array { class, array, element, .. } => {
                let array = self.expression(array)?;
                let index = self.index(&array)?;
                let element = self.expression(element)?;
                Ok(Some(Named { class: *class, index, element: Some(self.index(&element)?) }))
            }
            _ => Ok(None),
        }
    }

    fn variable_target(&mut self, class: OperandClass, index: Index) -> Result<Target, LoadErrorKind> {
        if let Index::Const(number) = index {
            let place = u32::try_from(number).ok();
            let target = match class {
                OperandClass::Lv => variable_slot(number).map(Target::Long),
                OperandClass::Dv => variable_slot(number).map(Target::Double),
                OperandClass::Sv => place.map(Target::Single),
                _ => place.map(Target::Text),
            };
            if let Some(target) = target {
                return Ok(target);
            }
        }
        Ok(Target::Variable(class, self.index_slot(index)?))
    }

    fn element_target(&mut self, class: OperandClass, array: Index, element: Index) -> Result<Target, LoadErrorKind> {
        let element = self.index_slot(element)?;
        let number = match array {
            Index::Const(number) => u16::try_from(number).ok(),
            Index::Slot(_) => None,
        };
        match (class, number) {
            (OperandClass::La, Some(number)) => Ok(Target::LongElement(number, element)),
            (OperandClass::Da, Some(number)) => Ok(Target::DoubleElement(number, element)),
            _ => Ok(Target::Element(class, self.index_slot(array)?, element)),
        }
    }

    /// The value of an operand.
    pub(super) fn load(&mut self, target: Target) -> Result<Place, LoadErrorKind> {
        match target {
            Target::Long(slot) => Ok(Place::Long(slot)),
            Target::Double(slot) => Ok(Place::Double(slot)),
            Target::Single(index) => {
                let to = self.double_slot()?;
                self.emit(Op::LoadSingle { to, index });
                Ok(Place::Single(to))
            }
            Target::Text(index) => {
                let to = self.value_slot()?;
                self.emit(Op::LoadText { to, index });
                Ok(Place::Text(to))
            }
            Target::LongElement(array, element) => {
                let to = self.long_slot()?;
                self.emit(Op::LoadLongElement { to, array, element });
                Ok(Place::Long(to))
            }
            Target::DoubleElement(array, element) => {
                let to = self.double_slot()?;
                self.emit(Op::LoadDoubleElement { to, array, element });
                Ok(Place::Double(to))
            }
            Target::User(number) => {
                let to = self.double_slot()?;
                self.emit(Op::LoadUser { to, number });
                Ok(Place::Double(to))
            }
            Target::Variable(..) | Target::Element(..) => self.load_computed(target),
            Target::Parameter(_) | Target::Bit(_) => self.load_shared(target),
            Target::Whole(class, index) => {
                let array = if let Index::Const(number) = index { i64::from(number) } else { 0 };
                self.raise(FaultKind::ArrayAsValue { class, array });
                Ok(Place::LongConst(0))
            }
        }
    }

    /// A variable or element that goes through the file of values.
    fn load_computed(&mut self, target: Target) -> Result<Place, LoadErrorKind> {
        let from = self.value_slot()?;
        let class = match target {
            Target::Variable(class, index) => {
                self.emit(Op::LoadVariable { class, to: from, index });
                class
            }
            Target::Element(class, array, element) => {
                self.emit(Op::LoadElement { class, to: from, array, element });
                class
            }
            _ => return Ok(Place::Value(from)),
        };
        match class.value_type() {
            Some(ValueType::Long) => {
                let to = self.long_slot()?;
                self.emit(Op::ValueToLong { to, from });
                Ok(Place::Long(to))
            }
            Some(ValueType::String) => Ok(Place::Text(from)),
            other => {
                let to = self.double_slot()?;
                self.emit(Op::ValueToDouble { to, from });
                Ok(if other == Some(ValueType::Single) { Place::Single(to) } else { Place::Double(to) })
            }
        }
    }

    /// A parameter or a flag.
    fn load_shared(&mut self, target: Target) -> Result<Place, LoadErrorKind> {
        if let Target::Bit(index) = target {
            let to = self.long_slot()?;
            self.emit(match index {
                Index::Const(number) => Op::LoadBit { to, number },
                Index::Slot(number) => Op::LoadBitAt { to, number },
            });
            return Ok(Place::Long(to));
        }
        let to = self.value_slot()?;
        match target {
            Target::Parameter(Index::Const(number)) => self.emit(Op::LoadParameter { to, number }),
            Target::Parameter(Index::Slot(number)) => self.emit(Op::LoadParameterAt { to, number }),
            _ => {}
        }
        Ok(Place::Value(to))
    }

    /// Stores a value.
    pub(super) fn store(&mut self, target: Target, place: &Place) -> Result<(), LoadErrorKind> {
        match target {
            Target::Long(to) => self.long_to(place, to),
            Target::Double(to) => self.double_to(place, to),
            Target::Single(index) => {
                let from = self.double(place)?;
                self.emit(Op::StoreSingle { index, from });
            }
            Target::Text(index) => {
                let from = self.text(place)?;
                self.emit(Op::StoreText { index, from });
            }
            Target::LongElement(array, element) => {
                let from = self.long(place)?;
                if !self.add_in_place(target, from) {
                    self.emit(Op::StoreLongElement { array, element, from });
                }
            }
            Target::DoubleElement(array, element) => {
                let from = self.double(place)?;
                if !self.add_in_place(target, from) {
                    self.emit(Op::StoreDoubleElement { array, element, from });
                }
            }
            Target::Variable(class, index) => {
                let from = self.value(place)?;
                self.emit(Op::StoreVariable { class, index, from });
            }
            Target::Element(class, array, element) => {
                let from = self.value(place)?;
                self.emit(Op::StoreElement { class, array, element, from });
            }
            Target::User(number) => {
                let from = self.double(place)?;
                if !self.add_in_place(target, from) {
                    self.emit(Op::StoreUser { number, from });
                }
            }
            Target::Parameter(index) => {
                let from = self.number(place)?;
                self.emit(match index {
                    Index::Const(number) => Op::StoreParameter { number, from },
                    Index::Slot(number) => Op::StoreParameterAt { number, from },
                });
            }
            Target::Bit(index) => {
                let from = self.truth(place)?;
                self.emit(match index {
                    Index::Const(number) => Op::StoreBit { number, from },
                    Index::Slot(number) => Op::StoreBitAt { number, from },
                });
            }
            Target::Whole(..) => return Err(LoadErrorKind::NotAssignable),
        }
        Ok(())
    }

    /// Replaces the latest two instructions if they add something to the old value of what their sum is to be stored in.
    fn add_in_place(&mut self, target: Target, sum: Slot) -> bool {
        let [.., load, add] = self.steps.as_slice() else { return false };
        let op = match (target, load.op, add.op) {
            (
                Target::LongElement(array, element),
                Op::LoadLongElement { to: old, array: of, element: at },
                Op::LongAdd { to, left, right },
            ) if (of, at, left, to) == (array, element, old, sum) && right != old => {
                Op::AddLongElement { array, element, right }
            }
            (
                Target::DoubleElement(array, element),
                Op::LoadDoubleElement { to: old, array: of, element: at },
                Op::DoubleAdd { to, left, right },
            ) if (of, at, left, to) == (array, element, old, sum) && right != old => {
                Op::AddDoubleElement { array, element, right }
            }
            (Target::User(number), Op::LoadUser { to: old, number: of }, Op::DoubleAddConst { to, left, value })
                if (of, left, to) == (number, old, sum) =>
            {
                Op::AddUserConst { number, value }
            }
            _ => return false,
        };
        // The sum belongs to the statement that the load began, if it began any.
        if add.begins != Begins::Nothing {
            return false;
        }
        self.begins = load.begins;
        self.steps.truncate(self.steps.len() - 2);
        self.emit(op);
        true
    }

    /// A long that is zero only when the place is zero.
    pub(super) fn truth(&mut self, place: &Place) -> Result<Slot, LoadErrorKind> {
        match place.kind() {
            Kind::Long => self.long(place),
            Kind::Value => {
                let (from, to) = (self.value(place)?, self.long_slot()?);
                self.emit(Op::ValueTruth { to, from });
                Ok(to)
            }
            Kind::Double | Kind::Single | Kind::Real | Kind::Text => {
                let left = self.double(place)?;
                let right = self.double(&Place::DoubleConst(0.0))?;
                let to = self.long_slot()?;
                self.emit(Op::DoubleCompare { relation: Relation::NOT_EQUAL, to, left, right });
                Ok(to)
            }
        }
    }
}

/// The number of a user variable, if it is one whatever the program does.
fn user(index: Index) -> Option<u16> {
    match index {
        Index::Const(number) => u16::try_from(number).ok().filter(|number| u32::from(*number) < USER_PARAMETERS),
        Index::Slot(_) => None,
    }
}
