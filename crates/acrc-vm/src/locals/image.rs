//! The variables of a program as plain data, for whoever keeps them beyond a run.

use acrc_catalog::OperandClass;
use thiserror::Error;

use super::{Arrays, Block, Locals};
use crate::op::SCRATCH;
use crate::text::Text;

/// Everything that [`Locals`] holds besides its limit. `None` stands for what no `DIM` has given its memory.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LocalsImage {
    /// `LV`
    pub longs: Option<Vec<i32>>,
    /// `SV`
    pub singles: Option<Vec<f32>>,
    /// `DV`
    pub doubles: Option<Vec<f64>>,
    /// `$V`
    pub texts: Option<TextsImage>,
    /// `LA`: the references, each with its elements.
    pub long_arrays: Option<Vec<Option<Vec<i32>>>>,
    /// `SA`
    pub single_arrays: Option<Vec<Option<Vec<f32>>>>,
    /// `DA`
    pub double_arrays: Option<Vec<Option<Vec<f64>>>>,
    /// `$A`
    pub text_arrays: Option<Vec<Option<TextsImage>>>,
    /// Moves that the move buffer holds.
    pub moves: Option<u32>,
}

/// Strings of one dimensioned length.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TextsImage {
    /// Characters that each may have.
    pub length: u32,
    /// The strings.
    pub items: Vec<Text>,
}

/// Why variables cannot be taken back.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum RestoreError {
    /// More memory than the program has.
    #[error("the variables need {needed} bytes, the program has {limit}")]
    OutOfMemory {
        /// What they need.
        needed: u64,
        /// What there is.
        limit: u64,
    },
    /// A number that no program can have stored.
    #[error("{} holds a value that is no finite number", class.name())]
    NotFinite {
        /// Class of the variables.
        class: OperandClass,
    },
    /// A string beyond its dimensioned length.
    #[error("{} holds a string of {found} characters where {length} fit", class.name())]
    TooLong {
        /// Class of the variables.
        class: OperandClass,
        /// Characters of the string.
        found: usize,
        /// Characters that fit.
        length: u32,
    },
}

impl Locals {
    /// The variables as plain data. Numbers are those of the program to the bit.
    pub fn image(&self) -> LocalsImage {
        let texts = |block: &Block<Text>| TextsImage { length: block.length as u32, items: block.items.clone() };
        LocalsImage {
            longs: self.dimensioned.longs.then(|| self.longs.iter().skip(SCRATCH).copied().collect()),
            singles: self.dimensioned.singles.then(|| self.singles.clone()),
            doubles: self.dimensioned.doubles.then(|| self.doubles.iter().skip(SCRATCH).copied().collect()),
            texts: self.texts.dimensioned.then(|| texts(&self.texts)),
            long_arrays: references(&self.long_arrays, |block| block.items.clone()),
            single_arrays: references(&self.single_arrays, |block| block.items.clone()),
            double_arrays: references(&self.double_arrays, |block| block.items.clone()),
            text_arrays: references(&self.text_arrays, texts),
            moves: self.moves,
        }
    }

    /// Variables from plain data, in a program that has `limit` bytes for variables and calls.
    ///
    /// # Errors
    /// When no program could have left such variables behind.
    pub fn restore(limit: u64, image: LocalsImage) -> Result<Self, RestoreError> {
        image.check()?;
        let mut locals = Self::new(limit);
        locals.dimensioned = super::Dimensioned {
            longs: image.longs.is_some(),
            singles: image.singles.is_some(),
            doubles: image.doubles.is_some(),
        };
        locals.longs.extend(image.longs.unwrap_or_default());
        locals.doubles.extend(image.doubles.unwrap_or_default());
        locals.singles = image.singles.unwrap_or_default();
        locals.texts = image.texts.map(texts_block).unwrap_or_default();
        locals.long_arrays.restore(image.long_arrays, numbers_block);
        locals.single_arrays.restore(image.single_arrays, numbers_block);
        locals.double_arrays.restore(image.double_arrays, numbers_block);
        locals.text_arrays.restore(image.text_arrays, texts_block);
        locals.moves = image.moves;
        locals.used = locals.dimensions().iter().map(|dimension| dimension.bytes).sum();
        if locals.used > limit {
            return Err(RestoreError::OutOfMemory { needed: locals.used, limit });
        }
        Ok(locals)
    }
}

impl LocalsImage {
    fn check(&self) -> Result<(), RestoreError> {
        let singles = self.single_arrays.iter().flatten().flatten().map(|items| (OperandClass::Sa, items));
        for (class, items) in singles.chain(self.singles.iter().map(|items| (OperandClass::Sv, items))) {
            if !items.iter().all(|value| value.is_finite()) {
                return Err(RestoreError::NotFinite { class });
            }
        }
        let doubles = self.double_arrays.iter().flatten().flatten().map(|items| (OperandClass::Da, items));
        for (class, items) in doubles.chain(self.doubles.iter().map(|items| (OperandClass::Dv, items))) {
            if !items.iter().all(|value| value.is_finite()) {
                return Err(RestoreError::NotFinite { class });
            }
        }
        let texts = self.text_arrays.iter().flatten().flatten().map(|texts| (OperandClass::StringA, texts));
        for (class, texts) in texts.chain(self.texts.iter().map(|texts| (OperandClass::StringV, texts))) {
            let length = texts.length;
            if let Some(text) = texts.items.iter().find(|text| text.len() > length as usize) {
                return Err(RestoreError::TooLong { class, found: text.len(), length });
            }
        }
        Ok(())
    }
}

/// The references of a class, if there are any, each with what it holds.
fn references<T: Clone + Default, I>(arrays: &Arrays<T>, image: impl Fn(&Block<T>) -> I) -> Option<Vec<Option<I>>> {
    let one = |block: &Block<T>| block.dimensioned.then(|| image(block));
    arrays.is_dimensioned().then(|| arrays.blocks().iter().map(one).collect())
}

fn numbers_block<T>(items: Vec<T>) -> Block<T> {
    Block { items, length: 0, dimensioned: true }
}

fn texts_block(texts: TextsImage) -> Block<Text> {
    Block { items: texts.items, length: texts.length as usize, dimensioned: true }
}
