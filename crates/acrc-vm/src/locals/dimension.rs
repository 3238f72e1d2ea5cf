//! `DIM` of local variables and of the move buffer, and the bytes it takes (guide, "How Much Memory?").

use acrc_catalog::OperandClass;
/// What a `DIM` statement allocates.
pub(crate) use acrc_catalog::memory::LocalBlock as DimBlock;

use super::{Block, Locals};
use crate::fault::FaultKind;
use crate::op::SCRATCH;

/// The numbers of a `DIM` statement.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sizes {
    /// Number of the array.
    pub(crate) array: i32,
    /// How many variables, references, elements or moves.
    pub(crate) count: i32,
    /// Characters of each string.
    pub(crate) length: i32,
}

/// One allocation, as the report of `DIM` shows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension {
    /// What it is.
    pub block: DimBlock,
    /// Number of the array; `None` for everything else.
    pub array: Option<u32>,
    /// How many variables, references, elements or moves.
    pub count: u32,
    /// Characters of each string; 0 for numbers.
    pub length: u32,
    /// Bytes by the guide's table.
    pub bytes: u64,
}

impl Locals {
    /// Executes a `DIM`. `reserved` bytes are in use by calls.
    pub(crate) fn dimension(&mut self, block: DimBlock, sizes: Sizes, reserved: u64) -> Result<(), FaultKind> {
        let negative = [sizes.count, sizes.length].into_iter().find(|size| *size < 0);
        if let Some(size) = negative {
            return Err(FaultKind::NegativeSize { size });
        }
        let (count, length) = (sizes.count.unsigned_abs(), sizes.length.unsigned_abs());
        self.check_free(block, i64::from(sizes.array))?;
        let needed = block.bytes(u64::from(count), u64::from(length));
        let free = self.limit.saturating_sub(self.used + reserved);
        if needed > free {
            return Err(FaultKind::OutOfMemory { needed, free });
        }
        self.allocate(block, i64::from(sizes.array), count as usize, length as usize)?;
        self.used += needed;
        Ok(())
    }

    /// Refuses a block that has its memory already.
    fn check_free(&mut self, block: DimBlock, array: i64) -> Result<(), FaultKind> {
        let taken = match block {
            DimBlock::Moves => self.moves.is_some(),
            DimBlock::Variables(OperandClass::Lv) => self.dimensioned.longs,
            DimBlock::Variables(OperandClass::Sv) => self.dimensioned.singles,
            DimBlock::Variables(OperandClass::Dv) => self.dimensioned.doubles,
            DimBlock::Variables(_) => self.texts.dimensioned,
            DimBlock::References(OperandClass::La) => self.long_arrays.is_dimensioned(),
            DimBlock::References(OperandClass::Sa) => self.single_arrays.is_dimensioned(),
            DimBlock::References(OperandClass::Da) => self.double_arrays.is_dimensioned(),
            DimBlock::References(_) => self.text_arrays.is_dimensioned(),
            DimBlock::Array(OperandClass::La) => self.long_arrays.undimensioned(array).map(|_| false)?,
            DimBlock::Array(OperandClass::Sa) => self.single_arrays.undimensioned(array).map(|_| false)?,
            DimBlock::Array(OperandClass::Da) => self.double_arrays.undimensioned(array).map(|_| false)?,
            DimBlock::Array(_) => self.text_arrays.undimensioned(array).map(|_| false)?,
        };
        if taken { Err(FaultKind::Redimensioned) } else { Ok(()) }
    }

    fn allocate(&mut self, block: DimBlock, array: i64, count: usize, length: usize) -> Result<(), FaultKind> {
        match block {
            DimBlock::Moves => self.moves = Some(count as u32),
            DimBlock::Variables(OperandClass::Lv) => {
                self.longs.resize(SCRATCH + count, 0);
                self.dimensioned.longs = true;
            }
            DimBlock::Variables(OperandClass::Dv) => {
                self.doubles.resize(SCRATCH + count, 0.0);
                self.dimensioned.doubles = true;
            }
            DimBlock::Variables(OperandClass::Sv) => {
                self.singles.resize(count, 0.0);
                self.dimensioned.singles = true;
            }
            DimBlock::Variables(_) => self.texts = Block::new(count, length),
            DimBlock::References(OperandClass::La) => self.long_arrays.dimension_references(count),
            DimBlock::References(OperandClass::Sa) => self.single_arrays.dimension_references(count),
            DimBlock::References(OperandClass::Da) => self.double_arrays.dimension_references(count),
            DimBlock::References(_) => self.text_arrays.dimension_references(count),
            DimBlock::Array(OperandClass::La) => *self.long_arrays.undimensioned(array)? = Block::new(count, 0),
            DimBlock::Array(OperandClass::Sa) => *self.single_arrays.undimensioned(array)? = Block::new(count, 0),
            DimBlock::Array(OperandClass::Da) => *self.double_arrays.undimensioned(array)? = Block::new(count, 0),
            DimBlock::Array(_) => *self.text_arrays.undimensioned(array)? = Block::new(count, length),
        }
        Ok(())
    }

    /// Every allocation, in the order `LV SV DV $V LA SA DA $A MBUF`, each class of arrays followed by its arrays.
    pub fn dimensions(&self) -> Vec<Dimension> {
        let mut all = Vec::new();
        let scalars = [
            (OperandClass::Lv, self.dimensioned.longs, 0),
            (OperandClass::Sv, self.dimensioned.singles, 0),
            (OperandClass::Dv, self.dimensioned.doubles, 0),
            (OperandClass::StringV, self.texts.dimensioned, self.texts.length),
        ];
        for (class, dimensioned, length) in scalars {
            if dimensioned {
                all.push(Dimension::new(DimBlock::Variables(class), None, self.count(class), length));
            }
        }
        list_arrays(&mut all, OperandClass::La, &self.long_arrays);
        list_arrays(&mut all, OperandClass::Sa, &self.single_arrays);
        list_arrays(&mut all, OperandClass::Da, &self.double_arrays);
        list_arrays(&mut all, OperandClass::StringA, &self.text_arrays);
        all.extend(self.moves.map(|moves| Dimension::new(DimBlock::Moves, None, moves, 0)));
        all
    }
}

impl Dimension {
    fn new(block: DimBlock, array: Option<u32>, count: u32, length: usize) -> Self {
        let bytes = block.bytes(u64::from(count), length as u64);
        Self { block, array, count, length: length as u32, bytes }
    }
}

fn list_arrays<T: Clone + Default>(all: &mut Vec<Dimension>, class: OperandClass, arrays: &super::Arrays<T>) {
    if !arrays.is_dimensioned() {
        return;
    }
    all.push(Dimension::new(DimBlock::References(class), None, arrays.blocks().len() as u32, 0));
    for (number, block) in (0..).zip(arrays.blocks()) {
        if block.dimensioned {
            all.push(Dimension::new(DimBlock::Array(class), Some(number), block.items.len() as u32, block.length));
        }
    }
}
