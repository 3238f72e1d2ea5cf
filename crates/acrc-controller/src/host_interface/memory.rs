//! Memory by address (guide, "Binary Peek Command" to "Binary Mask Command", "Binary Global Parameter Access").

use acrc_catalog::OperandClass;
use acrc_vm::{Locals, Reference, Value};

use super::address::{self, Block, Place};
use super::cell::{Cell, Conversion, Home};
use super::{HostError, strings};
use crate::controller::Controller;
use crate::flags::FIRST_WORD;
use crate::registers::is_of_unknown_form;

impl Controller {
    /// Where the count of a kind of variables of a program stands: of `DV`, `SV`, `LV` and `$V` themselves, or of the arrays of
    /// the other kinds. 0 when the program has none.
    pub fn address_of(&self, program: u8, class: OperandClass) -> u32 {
        let has_any = self.locals_of(program).is_some_and(|locals| locals.count(class) > 0);
        address::of_class(program, class).filter(|_| has_any).unwrap_or(0)
    }

    /// Where a parameter stands; 0 when there is none with this number, or no memory for it yet.
    pub fn parameter_address(&self, parameter: u32) -> u32 {
        if self.machine.read_parameter(i64::from(parameter)).is_err() {
            return 0;
        }
        let address = if parameter < FIRST_WORD {
            Some(address::of_users() + 1 + parameter * Conversion::Double.stride())
        } else {
            address::of_parameter(parameter)
        };
        address.unwrap_or(0)
    }

    /// Reads numbers from memory into the fields of a packet, from an address on.
    ///
    /// # Errors
    /// When nothing stands at one of the addresses, or something of another type than the conversion says.
    pub fn peek(&self, conversion: Conversion, address: u32, fields: &mut [u32]) -> Result<(), HostError> {
        for (address, field) in addresses(conversion, address).zip(fields) {
            let address = address?;
            let read = self.cell(address)?.read(conversion);
            *field = read.ok_or(HostError::Conversion { address, conversion })?;
        }
        Ok(())
    }

    /// What stands at an address.
    pub(super) fn cell(&self, address: u32) -> Result<Cell, HostError> {
        let cell = if self.machine.model.system_pointer == Some(address) {
            let users = if self.machine.memory.user_count() > 0 { address::of_users() } else { 0 };
            Some(Cell::Fixed(users))
        } else {
            Place::at(address).and_then(|place| self.cell_at(place))
        };
        cell.ok_or(HostError::NoAddress(address))
    }

    fn cell_at(&self, place: Place) -> Option<Cell> {
        match place {
            Place::Parameter(number) => {
                let value = self.machine.read_parameter(i64::from(number)).ok()?;
                let home = Home::Parameter(number);
                Some(if is_of_unknown_form(number) { Cell::Either(home, value) } else { Cell::Word(home, value) })
            }
            Place::User(word) => {
                let count = self.machine.memory.user_count() as u32;
                let Some((index, upper)) = split(word, Conversion::Double) else { return counted(count) };
                let value = self.machine.memory.user(index as usize)?;
                Some(Cell::Half { home: Home::Parameter(index), value, upper })
            }
            Place::Variables(block) => {
                let locals = self.locals_of(block.program)?;
                let count = locals.count(block.class);
                if block.class == OperandClass::StringV {
                    let start = address::of_class(block.program, block.class)?;
                    let text = |index| Reference::Variable { class: block.class, index: i64::from(index) };
                    let room = address::room(block.class);
                    let strings = strings::Block { start, room, count, locals, program: block.program, text: &text };
                    return strings.cell(block.word);
                }
                number_cell(locals, block, count, |index| Reference::Variable { class: block.class, index })
            }
            Place::Table(block) => {
                let locals = self.locals_of(block.program)?;
                let count = locals.count(block.class);
                let Some(array) = block.word.checked_sub(1) else { return counted(count) };
                (array < count).then(|| Cell::Fixed(array_address(locals, block, array)))
            }
            Place::Array(array, block) => {
                let locals = self.locals_of(block.program)?;
                let (class, array) = (block.class, i64::from(array));
                let count = locals.array_size(class, array)?;
                if class == OperandClass::StringA {
                    let start = address::of_array(block.program, class, array as u32)?;
                    let text = |index| Reference::Element { class, array, element: i64::from(index) };
                    let room = address::room(class);
                    let strings = strings::Block { start, room, count, locals, program: block.program, text: &text };
                    return strings.cell(block.word);
                }
                number_cell(locals, block, count, |element| Reference::Element { class, array, element })
            }
        }
    }

    fn locals_of(&self, program: u8) -> Option<&Locals> {
        self.programs.get(usize::from(program)).map(|program| &program.locals)
    }
}

/// The addresses of numbers that follow each other.
pub(super) fn addresses(conversion: Conversion, first: u32) -> impl Iterator<Item = Result<u32, HostError>> {
    (0..).map(move |index: u32| first.checked_add(index * conversion.stride()).ok_or(HostError::NoAddress(u32::MAX)))
}

/// The count at the begin of a block. A block of nothing has no address.
pub(super) fn counted(count: u32) -> Option<Cell> {
    (count > 0).then_some(Cell::Fixed(count))
}

/// Which number a word of a block belongs to, and whether it is the upper half of it. None for the count in front.
fn split(word: u32, conversion: Conversion) -> Option<(u32, bool)> {
    let word = word.checked_sub(1)?;
    let stride = conversion.stride();
    Some((word / stride, word % stride > 0))
}

/// A word of a block of numbers.
fn number_cell(locals: &Locals, block: Block, count: u32, reference: impl Fn(i64) -> Reference) -> Option<Cell> {
    let conversion = match block.class {
        OperandClass::Dv | OperandClass::Da => Conversion::Double,
        _ => Conversion::Long,
    };
    let Some((index, upper)) = split(block.word, conversion) else { return counted(count) };
    let reference = reference(i64::from(index));
    let home = Home::Local(block.program, reference);
    Some(match locals.read(reference).ok()? {
        Value::Double(value) => Cell::Half { home, value, upper },
        value => Cell::Word(home, value),
    })
}

/// Where an array begins; 0 while it has no elements, and behind the last one that has addresses.
fn array_address(locals: &Locals, block: Block, array: u32) -> u32 {
    let has_any = locals.array_size(block.class, i64::from(array)).is_some_and(|size| size > 0);
    address::of_array(block.program, block.class, array).filter(|_| has_any).unwrap_or(0)
}
