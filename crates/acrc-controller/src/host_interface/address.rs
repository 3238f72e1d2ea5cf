//! The addresses of the controller's memory as a host sees it.
//!
//! One step of an address is 32 bits. What stands where follows from the numbers of program, kind, array and element by a fixed law
//! with wide gaps, so an address stays valid until a `DIM` changes what it names, and nothing has to be kept for it. All
//! addresses are below 2^31, so that they are positive in a host's long integers:
//!
//! | from | what |
//! |---|---|
//! | the system pointer of the model | the address of the user parameters |
//! | `0100_0000` | system parameters, one word each, by number |
//! | `0200_0000` | user parameters: their count, then 64-bit numbers |
//! | `2000_0000` | variables of programs: 2^25 words for each program, of which each kind has 2^23 |
//! | `4000_0000` | arrays of programs: 2^26 words for each program, of which each kind has 2^24, and each array 2^17 |

use acrc_catalog::OperandClass;

use crate::flags::FIRST_WORD;

const PARAMETERS: u32 = 0x0100_0000;
const USERS: u32 = 0x0200_0000;
const VARIABLES_START: u32 = 0x2000_0000;
const VARIABLES: Area = Area { first: VARIABLES_START, window: 23, kinds: [DV, SV, LV, SD] };
const ARRAYS: Area = Area { first: 0x4000_0000, window: 24, kinds: [DA, SA, LA, TA] };

const DV: OperandClass = OperandClass::Dv;
const SV: OperandClass = OperandClass::Sv;
const LV: OperandClass = OperandClass::Lv;
const SD: OperandClass = OperandClass::StringV;
const DA: OperandClass = OperandClass::Da;
const SA: OperandClass = OperandClass::Sa;
const LA: OperandClass = OperandClass::La;
const TA: OperandClass = OperandClass::StringA;

/// Programs that have addresses.
const PROGRAMS: u32 = 16;
/// System parameters, with the numbers below that have none.
const PARAMETER_NUMBERS: u32 = 1 << 16;
/// Words of an array, as a power of two.
const ARRAY_WINDOW: u32 = 17;

/// What belongs to programs, in windows of the same size: by program, then by kind.
struct Area {
    first: u32,
    /// Words of a kind, as a power of two.
    window: u32,
    kinds: [OperandClass; 4],
}

impl Area {
    /// Where a kind begins.
    fn start(&self, program: u8, class: OperandClass) -> Option<u32> {
        let kind = self.kinds.iter().position(|kind| *kind == class)? as u32;
        let window = u32::from(program) * self.kinds.len() as u32 + kind;
        (u32::from(program) < PROGRAMS).then(|| self.first + (window << self.window))
    }

    /// The program and the kind that an address belongs to, and its place among the words of the kind.
    fn find(&self, address: u32) -> Option<(u8, OperandClass, u32)> {
        let offset = address.checked_sub(self.first)?;
        let window = offset >> self.window;
        let kinds = self.kinds.len() as u32;
        let program = u8::try_from(window / kinds).ok().filter(|program| u32::from(*program) < PROGRAMS)?;
        let class = *self.kinds.get((window % kinds) as usize)?;
        Some((program, class, offset & ((1 << self.window) - 1)))
    }
}

/// What an address names, if that exists. Every block begins with the count of what follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// A system parameter.
    Parameter(u32),
    /// A word of the user parameters.
    User(u32),
    /// A word of the variables of a program.
    Variables(Block),
    /// A word of the table of the arrays of a program.
    Table(Block),
    /// A word of an array.
    Array(u32, Block),
}

/// A word of a block of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Block {
    pub(super) program: u8,
    pub(super) class: OperandClass,
    pub(super) word: u32,
}

impl Place {
    /// What an address names by the law.
    pub(super) fn at(address: u32) -> Option<Self> {
        if let Some((program, class, word)) = ARRAYS.find(address) {
            let within = word & ((1 << ARRAY_WINDOW) - 1);
            let block = Block { program, class, word: within };
            return Some(match (word >> ARRAY_WINDOW).checked_sub(1) {
                None => Self::Table(block),
                Some(array) => Self::Array(array, block),
            });
        }
        if let Some((program, class, word)) = VARIABLES.find(address) {
            return Some(Self::Variables(Block { program, class, word }));
        }
        match address {
            USERS..VARIABLES_START => Some(Self::User(address - USERS)),
            PARAMETERS..USERS => Some(address - PARAMETERS)
                .filter(|number| (FIRST_WORD..PARAMETER_NUMBERS).contains(number))
                .map(Self::Parameter),
            _ => None,
        }
    }
}

/// Where a system parameter stands.
pub(super) fn of_parameter(number: u32) -> Option<u32> {
    (FIRST_WORD..PARAMETER_NUMBERS).contains(&number).then_some(PARAMETERS + number)
}

/// Where the count of the user parameters stands.
pub(super) const fn of_users() -> u32 {
    USERS
}

/// Where the block of a class of variables begins, or the table of a class of arrays.
pub(super) fn of_class(program: u8, class: OperandClass) -> Option<u32> {
    VARIABLES.start(program, class).or_else(|| ARRAYS.start(program, class))
}

/// Where an array begins. None behind the last one that has a window.
pub(super) fn of_array(program: u8, class: OperandClass, array: u32) -> Option<u32> {
    let last = (1 << (ARRAYS.window - ARRAY_WINDOW)) - 2;
    let start = ARRAYS.start(program, class)?;
    (array <= last).then(|| start + ((array + 1) << ARRAY_WINDOW))
}

/// How many words the block has room for that begins with a class of variables, or with one of its arrays.
pub(super) fn room(class: OperandClass) -> u32 {
    if VARIABLES.kinds.contains(&class) { 1 << VARIABLES.window } else { 1 << ARRAY_WINDOW }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CLASSES: [OperandClass; 8] = [DV, DA, SV, SA, LV, LA, SD, TA];

    #[test]
    fn every_block_is_found_at_its_address() {
        for program in 0..16 {
            for class in CLASSES {
                let start = of_class(program, class).expect("every class has an address");
                let block = Block { program, class, word: 0 };
                let first = if class.is_array() { Place::Table(block) } else { Place::Variables(block) };
                assert_eq!(Place::at(start), Some(first));
            }
            for (class, array) in [(DA, 0), (SA, 1), (LA, 126), (TA, 5)] {
                let start = of_array(program, class, array).expect("it has a window");
                let block = Block { program, class, word: 7 };
                assert_eq!(Place::at(start + 7), Some(Place::Array(array, block)));
            }
        }
        assert_eq!(of_array(0, LA, 127), None);
        assert_eq!(of_class(16, LV), None);
    }

    #[test]
    fn the_areas_do_not_meet() {
        let last = of_class(15, SD).expect("it exists") + room(SD) - 1;
        assert_eq!(last, ARRAYS.first - 1);
        let last = of_array(15, TA, 126).expect("it has a window") + room(TA) - 1;
        assert_eq!(last, i32::MAX.cast_unsigned());
        assert_eq!(Place::at(last + 1), None);
    }
}
