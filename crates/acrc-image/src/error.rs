//! Why an image is refused, and why something cannot be put into one.

use thiserror::Error;

use crate::unit::UnitName;

/// Why an image is refused.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum ImageError {
    /// The magic is missing.
    #[error("not an acrc image: the file does not begin with `ACRX`")]
    NotAnImage,
    /// Written by a later version.
    #[error("the image has format version {found}, this program reads versions up to {newest}")]
    NewerVersion {
        /// Version of the file.
        found: u16,
        /// Newest version that can be read.
        newest: u16,
    },
    /// Version 0 or a flag that the version does not have.
    #[error("the image header has {what} {value}, which no version defines")]
    UnknownHeader {
        /// The field.
        what: &'static str,
        /// Its value.
        value: u16,
    },
    /// The end is missing.
    #[error("the image is truncated: {expected} bytes expected, {found} found")]
    Truncated {
        /// Length by the header.
        expected: u64,
        /// Length of the file.
        found: u64,
    },
    /// Something follows the end.
    #[error("{extra} bytes follow the end of the image")]
    TrailingBytes {
        /// How many.
        extra: u64,
    },
    /// The checksum differs.
    #[error("the image was altered: checksum {computed:08X} instead of {stored:08X}")]
    Altered {
        /// Checksum in the header.
        stored: u32,
        /// Checksum of the bytes.
        computed: u32,
    },
    /// A section contradicts the header or itself.
    #[error("the image is malformed: {0}")]
    Malformed(&'static str),
    /// The words of a unit are no program.
    #[error("{unit}, word {address}: {problem}")]
    Word {
        /// The unit.
        unit: UnitName,
        /// The word, from the start of the unit.
        address: u32,
        /// What is wrong with it.
        problem: Problem,
    },
    /// The operand of an alias is none.
    #[error("alias {name}: {problem}")]
    AliasTarget {
        /// The alias.
        name: String,
        /// What is wrong with its operand.
        problem: Problem,
    },
}

/// What is wrong with a word.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Problem {
    /// The stream ends too early.
    #[error("the words end inside a statement")]
    EndOfWords,
    /// The pool ends too early.
    #[error("a text of {needed} bytes is missing, the pool holds {left} more")]
    EndOfText {
        /// Length of the text.
        needed: usize,
        /// Bytes left.
        left: usize,
    },
    /// Bytes of the pool belong to no text.
    #[error("{0} bytes of the pool belong to no text")]
    UnusedText(usize),
    /// The code is not in the catalogue.
    #[error("{what} {code} is unknown")]
    Unknown {
        /// What it should be.
        what: &'static str,
        /// The code.
        code: u32,
    },
    /// A bit that must be zero is not, or a form was chosen that the encoder does not write.
    #[error("the word {0:08X} is not in its one valid form")]
    NotCanonical(u32),
    /// A constant that no program text gives.
    #[error("a constant is not a finite number")]
    NotFinite,
    /// Too many nodes within each other.
    #[error("more than {} nodes lie within each other", crate::MAX_DEPTH)]
    TooDeep,
    /// A node where such a node cannot stand.
    #[error("{0} cannot stand here")]
    Misplaced(&'static str),
    /// A reference to a label that is not defined.
    #[error("label {ordinal} is referred to, the unit defines {labels}")]
    NoSuchLabel {
        /// Number of the label.
        ordinal: u16,
        /// Labels of the unit.
        labels: usize,
    },
    /// A reference to an alias that is not in the table.
    #[error("alias {index} is referred to, the image defines {aliases}")]
    NoSuchAlias {
        /// Place in the table.
        index: u16,
        /// Length of the table.
        aliases: usize,
    },
    /// A reference to a program that is not in the image.
    #[error("program text {index} is referred to, the image holds {programs}")]
    NoSuchProgram {
        /// Index into the programs.
        index: i32,
        /// How many there are.
        programs: usize,
    },
    /// The operands of a command are not its operands.
    #[error("{0}")]
    Operands(&'static str),
}

/// Why something cannot be encoded.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum EncodeError {
    /// A field of a word is too narrow.
    #[error("{what} is {value}, the stored form holds at most {limit}")]
    TooLarge {
        /// What does not fit.
        what: &'static str,
        /// Its size.
        value: u64,
        /// The limit.
        limit: u64,
    },
    /// It would be refused when decoded.
    #[error(transparent)]
    Invalid(#[from] Problem),
}
