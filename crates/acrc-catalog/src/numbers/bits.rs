//! Flags: single bits by number. Flag `b` is bit `b mod 32` of parameter `4096 + b div 32`.

use super::{Known, SetBy, candidates, owner};
use crate::generated::{BIT_FIELDS, BITS, BITS_BY_GROUP, FLAG_WORDS};
use crate::{Access, AddressLaw, BitKind, Confidence, Space};

/// The parameter that holds flags 0-31. Below are user parameters, which do nothing.
pub const FIRST_FLAG_WORD: u32 = 4096;
/// Flags in one word.
pub const FLAGS_PER_WORD: u32 = 32;
/// Flag words, from [`FIRST_FLAG_WORD`] on: parameters 4096-6143.
pub const FLAG_WORD_COUNT: u32 = 2048;

/// A run of flags with one meaning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BitRow {
    /// Its numbers.
    pub law: AddressLaw,
    /// What it belongs to.
    pub object: Space,
    /// Its name in reports and look-ups: `kill_all_motion_request`.
    pub field: &'static str,
    /// What it is.
    pub title: &'static str,
    /// Acronyms.
    pub also: &'static [&'static str],
    /// What it is for.
    pub kind: BitKind,
    /// What programs may do with it.
    pub access: Access,
    /// The command that sets it together with others, and which bit of its value it is.
    pub set_by: Option<SetBy>,
    /// What else is known or not known.
    pub note: &'static str,
    /// Where the row comes from (`data/README.md`).
    pub source: &'static str,
    /// How well it is attested.
    pub confidence: Confidence,
}

/// A run of flag words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FlagWords {
    /// The parameters that hold them.
    pub law: AddressLaw,
    /// What their flags belong to.
    pub object: Space,
    /// The name of the group of flags.
    pub group: &'static str,
    /// What ties words and flags together.
    pub note: &'static str,
    /// Where the row comes from (`data/README.md`).
    pub source: &'static str,
    /// How well it is attested.
    pub confidence: Confidence,
}

impl FlagWords {
    /// Which axis, master, ... the flags of a word belong to, where these are numbered.
    pub const fn object_index(&self, parameter: u32) -> Option<u32> {
        match self.law.place(parameter) {
            Some(place) => self.law.object_index(place),
            None => None,
        }
    }
}

/// A flag number, decoded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BitInfo {
    /// The number.
    pub number: u32,
    /// How precisely it is known. Only for [`Known::Row`] is there a field.
    pub known: Known,
    /// What it belongs to.
    pub object: Space,
    /// Which axis, master, ... it belongs to, where these are numbered.
    pub object_index: Option<u32>,
    /// Which of several it is, where an object has several: input 24.
    pub element: Option<u32>,
    /// Its name in reports and look-ups; empty when unknown.
    pub field: &'static str,
    /// What it is; empty when unknown.
    pub title: &'static str,
    /// What it is for, where known.
    pub kind: Option<BitKind>,
    /// What programs may do with it.
    pub access: Access,
    /// What else is known or not known.
    pub note: &'static str,
    /// Where the row comes from (`data/README.md`).
    pub source: &'static str,
    /// How well it is attested.
    pub confidence: Confidence,
    /// The parameter that holds it; `None` beyond the flag space.
    pub word: Option<u32>,
    /// Its index in that parameter, 0 to 31.
    pub index: u32,
    /// The row, for its law.
    pub row: Option<&'static BitRow>,
    /// The run of flag words that it lies in.
    pub words: Option<&'static FlagWords>,
}

impl BitInfo {
    /// What it belongs to, in words: `axis 0`. Empty when unknown.
    pub fn owner(&self) -> String {
        owner(self.object, self.object_index, self.element)
    }
}

/// What a flag number stands for. Where two rows hold it, the one with fewer numbers wins.
pub fn bit(number: u32) -> BitInfo {
    let word = (number / FLAGS_PER_WORD < FLAG_WORD_COUNT).then_some(FIRST_FLAG_WORD + number / FLAGS_PER_WORD);
    let words = word.and_then(flag_words);
    let group = words.filter(|words| words.object != Space::Unknown);
    let mut info = BitInfo {
        number,
        known: if word.is_none() { Known::OutOfSpace } else { Known::Unknown },
        object: Space::Unknown,
        object_index: None,
        element: None,
        field: "",
        title: "",
        kind: None,
        access: Access::Unknown,
        note: words.map_or("", |words| words.note),
        source: words.map_or("", |words| words.source),
        confidence: words.map_or(Confidence::Low, |words| words.confidence),
        word,
        index: number % FLAGS_PER_WORD,
        row: None,
        words,
    };
    let rows = candidates(BITS_BY_GROUP, number).filter_map(|row| BITS.get(row));
    if let Some((row, place)) = rows.into_iter().find_map(|row| Some((row, row.law.place(number)?))) {
        info = BitInfo {
            known: Known::Row,
            object: row.object,
            object_index: row.law.object_index(place),
            element: row.law.element(place),
            field: row.field,
            title: row.title,
            kind: Some(row.kind),
            access: row.access,
            note: row.note,
            source: row.source,
            confidence: row.confidence,
            row: Some(row),
            ..info
        };
    } else if let (Some(group), Some(word)) = (group, word) {
        info = BitInfo { known: Known::Range, object: group.object, object_index: group.object_index(word), ..info };
    }
    info
}

/// The run of flag words that holds a parameter.
pub fn flag_words(parameter: u32) -> Option<&'static FlagWords> {
    FLAG_WORDS.iter().find(|words| words.law.place(parameter).is_some())
}

/// The first flag that means something to the controller by itself: below are inputs, outputs and flags of programs.
pub fn first_system_flag() -> u32 {
    let plain = [Space::Input, Space::Output, Space::User, Space::Xio];
    let system = FLAG_WORDS.iter().find(|words| !plain.contains(&words.object));
    system.map_or(0, |words| flags_in(words.law.first).start)
}

/// The flags that a parameter holds; none for one that is no flag word.
pub fn flags_in(parameter: u32) -> std::ops::Range<u32> {
    let word = parameter.checked_sub(FIRST_FLAG_WORD).filter(|word| *word < FLAG_WORD_COUNT);
    word.map_or(0..0, |word| word * FLAGS_PER_WORD..(word + 1) * FLAGS_PER_WORD)
}

/// The number of a flag for an object, across the rows of the field: `bit_number("kill_all_motion_request", 1)` is 8499.
pub fn bit_number(field: &str, object_index: u32) -> Option<u32> {
    let place = BIT_FIELDS.binary_search_by_key(&field, |(name, _)| *name).ok()?;
    BIT_FIELDS.get(place)?.1.get(object_index)
}

/// Every row of flags, by number.
pub fn all_bits() -> impl ExactSizeIterator<Item = &'static BitRow> {
    BITS.iter()
}

/// Every run of flag words, by number.
pub fn all_flag_words() -> impl ExactSizeIterator<Item = &'static FlagWords> {
    FLAG_WORDS.iter()
}
