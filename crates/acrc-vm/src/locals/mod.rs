//! Local variables of one program and the size of its move buffer, and their memory (guide, "Variable Memory Allocation" and "How Much Memory?").
//!
//! They are kept apart from the code of the program, because statements that are typed at the program's prompt use the
//! same variables.

mod access;
mod arrays;
mod dimension;
mod image;

use acrc_catalog::OperandClass;

pub(crate) use access::round_to_single;
pub(crate) use arrays::{Arrays, Block, place};
pub use dimension::Dimension;
pub(crate) use dimension::{DimBlock, Sizes};
pub use image::{LocalsImage, RestoreError, TextsImage};

use crate::op::{SCRATCH, Slot};
use crate::text::Text;

/// Local variables and arrays: `LV SV DV $V LA SA DA $A`.
///
/// The first entries of the files of longs and doubles belong to the statement that is being executed; `LV0` and
/// `DV0` follow them. So an instruction addresses a variable and an intermediate result alike, and the check that a
/// variable exists is the check of the slice.
#[derive(Clone, Debug)]
pub struct Locals {
    /// Bytes that the program has for variables and calls.
    limit: u64,
    /// Bytes in use by variables.
    used: u64,
    /// Scratch, then `LV`.
    pub(crate) longs: Vec<i32>,
    /// Scratch, then `DV`.
    pub(crate) doubles: Vec<f64>,
    /// `SV`
    pub(crate) singles: Vec<f32>,
    /// `$V`
    pub(crate) texts: Block<Text>,
    /// `LA`
    pub(crate) long_arrays: Arrays<i32>,
    /// `SA`
    pub(crate) single_arrays: Arrays<f32>,
    /// `DA`
    pub(crate) double_arrays: Arrays<f64>,
    /// `$A`
    pub(crate) text_arrays: Arrays<Text>,
    dimensioned: Dimensioned,
    /// Moves that the move buffer holds (`DIM MBUF`).
    moves: Option<u32>,
}

/// Which of the numeric variables have their memory.
#[derive(Clone, Copy, Debug, Default)]
struct Dimensioned {
    longs: bool,
    singles: bool,
    doubles: bool,
}

impl Locals {
    /// No variables, and `limit` bytes for variables and calls together: what `DIM PROG` gave the program, less its
    /// stored text.
    pub fn new(limit: u64) -> Self {
        Self {
            limit,
            used: 0,
            longs: vec![0; SCRATCH],
            doubles: vec![0.0; SCRATCH],
            singles: Vec::new(),
            texts: Block::default(),
            long_arrays: Arrays::new(OperandClass::La),
            single_arrays: Arrays::new(OperandClass::Sa),
            double_arrays: Arrays::new(OperandClass::Da),
            text_arrays: Arrays::new(OperandClass::StringA),
            dimensioned: Dimensioned::default(),
            moves: None,
        }
    }

    /// Bytes that variables and calls may use.
    pub const fn limit(&self) -> u64 {
        self.limit
    }

    /// Changes what variables and calls may use. What is in use stays, even if it is more.
    pub const fn set_limit(&mut self, limit: u64) {
        self.limit = limit;
    }

    /// Bytes in use by variables and arrays, by the guide's table.
    pub const fn used(&self) -> u64 {
        self.used
    }

    /// `CLEAR`: all variables and arrays are gone.
    pub fn clear(&mut self) {
        *self = Self::new(self.limit);
    }

    /// `CLEAR MBUF`: the move buffer is gone.
    pub(crate) fn clear_moves(&mut self) {
        if let Some(moves) = self.moves.take() {
            self.used -= DimBlock::Moves.bytes(u64::from(moves), 0);
        }
    }

    /// How many moves the move buffer holds; 0 without memory.
    pub fn moves(&self) -> u32 {
        self.moves.unwrap_or(0)
    }

    /// Whether every variable has the same value, to the bit.
    pub(crate) fn equals(&self, other: &Self) -> bool {
        // Numbers first: they tell programs that go on from those that do not.
        self.longs == other.longs
            && same(&self.doubles, &other.doubles, |left, right| left.to_bits() == right.to_bits())
            && same(&self.singles, &other.singles, |left, right| left.to_bits() == right.to_bits())
            && self.used == other.used
            && self.moves == other.moves
            && self.texts.equals(&other.texts, Text::eq)
            && self.long_arrays.equals(&other.long_arrays, i32::eq)
            && self.single_arrays.equals(&other.single_arrays, |left, right| left.to_bits() == right.to_bits())
            && self.double_arrays.equals(&other.double_arrays, |left, right| left.to_bits() == right.to_bits())
            && self.text_arrays.equals(&other.text_arrays, Text::eq)
    }

    /// How many variables there are of a class; of an array class, how many references.
    pub fn count(&self, class: OperandClass) -> u32 {
        let count = match class {
            OperandClass::Lv => self.longs.len() - SCRATCH,
            OperandClass::Dv => self.doubles.len() - SCRATCH,
            OperandClass::Sv => self.singles.len(),
            OperandClass::StringV => self.texts.items.len(),
            OperandClass::La => self.long_arrays.blocks().len(),
            OperandClass::Sa => self.single_arrays.blocks().len(),
            OperandClass::Da => self.double_arrays.blocks().len(),
            OperandClass::StringA => self.text_arrays.blocks().len(),
            OperandClass::Parameter | OperandClass::Bit => 0,
        };
        count as u32
    }
}

/// Whether two files hold equal values.
pub(crate) fn same<T>(left: &[T], right: &[T], equal: impl Fn(&T, &T) -> bool) -> bool {
    left.len() == right.len() && left.iter().zip(right).all(|(left, right)| equal(left, right))
}

/// Slot of `LV<n>` or `DV<n>`. `None` for a variable so far up that it is reached by its number instead.
pub(crate) fn variable_slot(index: i32) -> Option<Slot> {
    Slot::try_from(usize::try_from(index).ok()?.checked_add(SCRATCH)?).ok()
}
