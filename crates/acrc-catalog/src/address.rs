//! Address laws: which numbers a row of parameters or flags stands for.

/// The numbers `first`, `first + stride`, ... of one row, and what they count.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct AddressLaw {
    /// The first number.
    pub first: u32,
    /// Distance between numbers; 0 when there is only one.
    pub stride: u32,
    /// How many numbers.
    pub count: u32,
    /// Index of the object that the first number belongs to (8 for the flags of masters 8-15).
    pub first_index: u32,
    /// How many numbers each object has: 1 for a law over objects, more where a row lists the elements of each object, 0 where the numbers are
    /// elements of something that is not numbered (input 24).
    pub per_object: u32,
}

impl AddressLaw {
    /// The number at a place of the row, from 0.
    pub const fn number(&self, place: u32) -> Option<u32> {
        if place < self.count { Some(self.first + place * self.stride) } else { None }
    }

    /// The last number of the row.
    pub const fn last(&self) -> u32 {
        self.first + self.count.saturating_sub(1) * self.stride
    }

    /// The place of a number in the row, from 0.
    pub const fn place(&self, number: u32) -> Option<u32> {
        if number < self.first || number > self.last() {
            return None;
        }
        let distance = number - self.first;
        match distance.checked_rem(self.stride) {
            None => Some(0),
            Some(0) => Some(distance / self.stride),
            Some(_) => None,
        }
    }

    /// Index of the object that a place belongs to, if objects are numbered.
    pub const fn object_index(&self, place: u32) -> Option<u32> {
        match place.checked_div(self.per_object) {
            Some(object) if self.stride > 0 => Some(self.first_index + object),
            _ => None,
        }
    }

    /// Index among the numbers of its object, if an object has several.
    pub const fn element(&self, place: u32) -> Option<u32> {
        match (self.stride, self.per_object) {
            (0, _) | (_, 1) => None,
            (_, 0) => Some(place),
            (_, size) => Some(place % size),
        }
    }
}
