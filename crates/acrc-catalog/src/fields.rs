//! The number of a field for an object.

/// The numbers of one field of parameters or flags, by object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Law {
    first: u32,
    stride: u32,
    count: u32,
    second: u32,
    second_count: u32,
}

impl Law {
    pub(crate) const fn new(first: u32, stride: u32, count: u32, second: u32, second_count: u32) -> Self {
        Self { first, stride, count, second, second_count }
    }

    /// The number for an object. Beyond [`Law::count`] the last run is continued, which gives a number that means something else.
    pub const fn at(self, index: u32) -> u32 {
        if index < self.count || self.second_count == 0 {
            self.first.saturating_add(index.saturating_mul(self.stride))
        } else {
            self.second.saturating_add((index - self.count).saturating_mul(self.stride))
        }
    }

    /// The number for an object, if it has one.
    pub const fn get(self, index: u32) -> Option<u32> {
        if index < self.count() { Some(self.at(index)) } else { None }
    }

    /// How many objects have the field.
    pub const fn count(self) -> u32 {
        self.count + self.second_count
    }

    /// The object that a number of this field belongs to.
    pub const fn index_of(self, number: u32) -> Option<u32> {
        match place(self.first, self.stride, self.count, number) {
            Some(index) => Some(index),
            None => match place(self.second, self.stride, self.second_count, number) {
                Some(index) => Some(self.count + index),
                None => None,
            },
        }
    }
}

const fn place(first: u32, stride: u32, count: u32, number: u32) -> Option<u32> {
    let Some(distance) = number.checked_sub(first) else { return None };
    let index = match distance.checked_div(stride) {
        Some(index) => index,
        None => distance,
    };
    if index < count && index * stride == distance { Some(index) } else { None }
}
