//! The arrays of one class: `DIM LA(2)` gives two references, `DIM LA0(500)` elements to the first of them.

use acrc_catalog::OperandClass;

use super::same;
use crate::fault::FaultKind;

/// One array, or the string variables.
#[derive(Clone, Debug)]
pub(crate) struct Block<T> {
    /// Its elements.
    pub(crate) items: Vec<T>,
    /// Characters that a string may have; 0 for numbers.
    pub(crate) length: usize,
    /// Its `DIM` was executed.
    pub(crate) dimensioned: bool,
}

impl<T> Default for Block<T> {
    fn default() -> Self {
        Self { items: Vec::new(), length: 0, dimensioned: false }
    }
}

impl<T: Clone + Default> Block<T> {
    /// `count` zeros, or empty strings of at most `length` characters.
    pub(crate) fn new(count: usize, length: usize) -> Self {
        Self { items: vec![T::default(); count], length, dimensioned: true }
    }
}

impl<T> Block<T> {
    /// Whether both hold equal elements.
    pub(crate) fn equals(&self, other: &Self, equal: impl Fn(&T, &T) -> bool) -> bool {
        self.length == other.length && same(&self.items, &other.items, equal)
    }
}

/// All arrays of one class.
#[derive(Clone, Debug)]
pub(crate) struct Arrays<T> {
    class: OperandClass,
    arrays: Vec<Block<T>>,
    dimensioned: bool,
}

impl<T: Clone + Default> Arrays<T> {
    /// No references.
    pub(crate) const fn new(class: OperandClass) -> Self {
        Self { class, arrays: Vec::new(), dimensioned: false }
    }

    /// The arrays, in order.
    pub(crate) fn blocks(&self) -> &[Block<T>] {
        &self.arrays
    }

    /// Whether all arrays hold equal elements.
    pub(crate) fn equals(&self, other: &Self, equal: impl Fn(&T, &T) -> bool + Copy) -> bool {
        same(&self.arrays, &other.arrays, |left, right| left.equals(right, equal))
    }

    /// True after `DIM` gave the references.
    pub(crate) const fn is_dimensioned(&self) -> bool {
        self.dimensioned
    }

    /// `DIM LA(count)`
    pub(crate) fn dimension_references(&mut self, count: usize) {
        self.arrays.resize_with(count, Block::default);
        self.dimensioned = true;
    }

    /// References with the elements that each of them has. `None` leaves the class without memory.
    pub(crate) fn restore<I>(&mut self, arrays: Option<Vec<Option<I>>>, block: impl Fn(I) -> Block<T>) {
        self.dimensioned = arrays.is_some();
        let arrays = arrays.unwrap_or_default().into_iter();
        self.arrays = arrays.map(|array| array.map(&block).unwrap_or_default()).collect();
    }

    /// The block of an array that `DIM` may still give elements to.
    pub(crate) fn undimensioned(&mut self, array: i64) -> Result<&mut Block<T>, FaultKind> {
        let (class, arrays) = (self.class, self.arrays.len() as u32);
        match place(array).and_then(|array| self.arrays.get_mut(array)) {
            None => Err(FaultKind::NoSuchArray { class, array, arrays }),
            Some(block) if block.dimensioned => Err(FaultKind::Redimensioned),
            Some(block) => Ok(block),
        }
    }

    /// An element, with the numbers in the types in which instructions have them.
    #[inline]
    pub(crate) fn element(&mut self, array: u16, element: i32) -> Option<&mut T> {
        // A negative number becomes one beyond every array.
        self.arrays.get_mut(usize::from(array))?.items.get_mut(element as u32 as usize)
    }

    /// Why an element is not there.
    #[cold]
    pub(crate) fn missing(&self, array: u16, element: i32) -> FaultKind {
        let (array, element) = (i64::from(array), i64::from(element));
        match self.arrays.get(array as usize) {
            Some(block) => block.missing(self.class, array, element),
            None => no_such_array(self.class, array, self.arrays.len()),
        }
    }

    /// An element.
    #[inline]
    pub(crate) fn get(&self, array: i64, element: i64) -> Result<&T, FaultKind> {
        let (class, arrays) = (self.class, self.arrays.len());
        let block = place(array).and_then(|array| self.arrays.get(array));
        let block = block.ok_or_else(|| no_such_array(class, array, arrays))?;
        let item = place(element).and_then(|element| block.items.get(element));
        item.ok_or_else(|| block.missing(class, array, element))
    }

    /// An element, and the length of the strings of its array.
    #[inline]
    pub(crate) fn get_mut(&mut self, array: i64, element: i64) -> Result<(&mut T, usize), FaultKind> {
        let (class, arrays) = (self.class, self.arrays.len());
        let block = place(array).and_then(|array| self.arrays.get_mut(array));
        let block = block.ok_or_else(|| no_such_array(class, array, arrays))?;
        let length = block.length;
        match place(element).filter(|element| *element < block.items.len()) {
            Some(element) => Ok((&mut block.items[element], length)),
            None => Err(block.missing(class, array, element)),
        }
    }
}

impl<T> Block<T> {
    /// Why an element is not there.
    #[cold]
    fn missing(&self, class: OperandClass, array: i64, element: i64) -> FaultKind {
        if self.dimensioned {
            FaultKind::NoSuchElement { class, array, element, size: self.items.len() as u32 }
        } else {
            FaultKind::EmptyArray { class, array }
        }
    }
}

#[cold]
fn no_such_array(class: OperandClass, array: i64, arrays: usize) -> FaultKind {
    FaultKind::NoSuchArray { class, array, arrays: arrays as u32 }
}

/// A number of the language as a place in a table. `None` for negative numbers.
#[inline]
pub(crate) fn place(number: i64) -> Option<usize> {
    usize::try_from(number).ok()
}
