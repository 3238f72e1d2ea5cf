//! Parameters: values by number, `P0` and up.

use super::{Known, SetBy, candidates, owner};
use crate::generated::{BLOCKS, PARAMETER_FIELDS, PARAMETERS, PARAMETERS_BY_GROUP};
use crate::numbers::flag_words;
use crate::{Access, AddressLaw, Confidence, Space, ValueType};

/// A run of parameters with one meaning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterRow {
    /// Its numbers.
    pub law: AddressLaw,
    /// What it belongs to.
    pub object: Space,
    /// Its name in reports and look-ups: `actual_position`.
    pub field: &'static str,
    /// What it is.
    pub title: &'static str,
    /// Acronyms.
    pub also: &'static [&'static str],
    /// The type of its value, where known.
    pub ty: Option<ValueType>,
    /// What programs may do with it.
    pub access: Access,
    /// The least and the largest value that a document allows.
    pub range: Option<(i32, i32)>,
    /// The command that sets the same value.
    pub set_by: Option<SetBy>,
    /// Values at power-up where a document states them: none, one for every object, or one for each.
    pub defaults: &'static [f64],
    /// Unit of its value; empty for none or unknown.
    pub unit: &'static str,
    /// What else is known or not known.
    pub note: &'static str,
    /// Where the row comes from (`data/README.md`).
    pub source: &'static str,
    /// How well it is attested.
    pub confidence: Confidence,
}

impl ParameterRow {
    /// The value at power-up of the parameter at a place of the row, where a document states it.
    pub fn default(&self, place: u32) -> Option<f64> {
        match self.defaults {
            [value] => Some(*value),
            values => values.get(place as usize).copied(),
        }
    }
}

/// A range of parameter numbers that belongs to one kind of object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ParameterBlock {
    /// The first number.
    pub first: u32,
    /// The last number.
    pub last: u32,
    /// Numbers of one object; 0 where objects are not numbered.
    pub stride: u32,
    /// What it belongs to.
    pub object: Space,
    /// Index of the first object.
    pub first_index: u32,
    /// Group code of the binary interface, where one is stated.
    pub group_code: Option<u8>,
    /// What else is known or not known.
    pub note: &'static str,
    /// Where the row comes from (`data/README.md`).
    pub source: &'static str,
    /// How well it is attested.
    pub confidence: Confidence,
}

/// A parameter number, decoded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterInfo {
    /// The number.
    pub number: u32,
    /// How precisely it is known. Only for [`Known::Row`] is there a field.
    pub known: Known,
    /// What it belongs to.
    pub object: Space,
    /// Which axis, master, ... it belongs to, where these are numbered.
    pub object_index: Option<u32>,
    /// Which of several it is, where an object has several: user variable 5.
    pub element: Option<u32>,
    /// Its name in reports and look-ups; empty when unknown.
    pub field: &'static str,
    /// What it is; empty when unknown.
    pub title: &'static str,
    /// The type of its value, where known.
    pub ty: Option<ValueType>,
    /// What programs may do with it.
    pub access: Access,
    /// Unit of its value; empty for none or unknown.
    pub unit: &'static str,
    /// What else is known or not known.
    pub note: &'static str,
    /// Where the row comes from (`data/README.md`).
    pub source: &'static str,
    /// How well it is attested.
    pub confidence: Confidence,
    /// The row, for its law.
    pub row: Option<&'static ParameterRow>,
    /// The block that it lies in.
    pub block: Option<&'static ParameterBlock>,
}

impl ParameterInfo {
    /// What it belongs to, in words: `axis 0`; for a flag word, what the flags in it belong to. Empty when unknown.
    pub fn owner(&self) -> String {
        match flag_words(self.number) {
            Some(words) if self.object == Space::Flags => {
                let object = owner(words.object, self.object_index, None);
                if object.is_empty() { words.group.to_owned() } else { format!("{object}: {}", words.group) }
            }
            _ => owner(self.object, self.object_index, self.element),
        }
    }

    fn unnamed(number: u32, known: Known) -> Self {
        Self {
            number,
            known,
            object: Space::Unknown,
            object_index: None,
            element: None,
            field: "",
            title: "",
            ty: None,
            access: Access::Unknown,
            unit: "",
            note: "",
            source: "",
            confidence: Confidence::Low,
            row: None,
            block: None,
        }
    }

    fn named(number: u32, row: &'static ParameterRow, place: u32) -> Self {
        // A flag word belongs to the object whose flags it holds.
        let holder = flag_words(number).filter(|_| row.object == Space::Flags);
        Self {
            known: Known::Row,
            object: row.object,
            object_index: holder.map_or_else(|| row.law.object_index(place), |words| words.object_index(number)),
            element: if holder.is_some() { None } else { row.law.element(place) },
            field: row.field,
            title: row.title,
            ty: row.ty,
            access: row.access,
            unit: row.unit,
            note: row.note,
            source: row.source,
            confidence: row.confidence,
            row: Some(row),
            ..Self::unnamed(number, Known::Row)
        }
    }
}

/// What a parameter number stands for. Where two rows hold it, the one with fewer numbers wins.
pub fn parameter(number: u32) -> ParameterInfo {
    let block = BLOCKS.iter().find(|block| (block.first..=block.last).contains(&number));
    let rows = candidates(PARAMETERS_BY_GROUP, number).filter_map(|row| PARAMETERS.get(row));
    if let Some((row, place)) = rows.into_iter().find_map(|row| Some((row, row.law.place(number)?))) {
        return ParameterInfo { block, ..ParameterInfo::named(number, row, place) };
    }
    match block {
        Some(block) if block.object == Space::Flags => flag_word(number, block),
        Some(block) => ParameterInfo {
            object: block.object,
            object_index: (number - block.first).checked_div(block.stride).map(|index| block.first_index + index),
            note: block.note,
            source: block.source,
            confidence: block.confidence,
            block: Some(block),
            ..ParameterInfo::unnamed(number, Known::Range)
        },
        None if BLOCKS.iter().any(|block| number <= block.last) => ParameterInfo::unnamed(number, Known::Unknown),
        None => ParameterInfo::unnamed(number, Known::OutOfSpace),
    }
}

/// A flag word that no row names: its flags may still be known to lie there, or nothing is.
fn flag_word(number: u32, block: &'static ParameterBlock) -> ParameterInfo {
    let words = flag_words(number);
    let known = if words.is_some_and(|words| words.object != Space::Unknown) { Known::Range } else { Known::Unknown };
    ParameterInfo {
        object: Space::Flags,
        ty: Some(ValueType::Long),
        note: words.map_or("", |words| words.note),
        source: words.map_or(block.source, |words| words.source),
        block: Some(block),
        ..ParameterInfo::unnamed(number, known)
    }
}

/// The number of a field for an object, across the rows of the field.
pub fn parameter_number(field: &str, object_index: u32) -> Option<u32> {
    let place = PARAMETER_FIELDS.binary_search_by_key(&field, |(name, _)| *name).ok()?;
    PARAMETER_FIELDS.get(place)?.1.get(object_index)
}

/// Every row of parameters, by number.
pub fn all_parameters() -> impl ExactSizeIterator<Item = &'static ParameterRow> {
    PARAMETERS.iter()
}

/// Fields of a group of the binary interface.
pub const GROUP_FIELDS: u8 = 8;

impl ParameterBlock {
    /// The block that a group code of the binary interface chooses from: the code is the high byte of the number of the first
    /// parameter. Every row of the guide's table agrees with that, so codes that the table lacks are read in the same way.
    pub fn of_group(code: u8) -> Option<&'static Self> {
        let first = u32::from(code) << 8;
        all_parameter_blocks().find(|block| (block.first..=block.last).contains(&first))
    }

    /// The number of a field of a group, by the index of the group and the bit of the isolation mask: a parameter of one of eight
    /// objects, or one of eight that follow each other. None for what lies behind the last object or parameter.
    pub fn group_field(&self, code: u8, index: u8, bit: u8) -> Option<u32> {
        let number = (u32::from(code) << 8) + u32::from(index) + u32::from(bit) * self.stride.max(1);
        (bit < GROUP_FIELDS && number <= self.last).then_some(number)
    }
}

/// Every range of parameter numbers.
pub fn all_parameter_blocks() -> impl ExactSizeIterator<Item = &'static ParameterBlock> {
    BLOCKS.iter()
}
