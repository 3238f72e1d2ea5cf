//! One stored text: a program, a PLC program, or the immediate statements of a project.

use std::fmt;

use acrc_catalog::command;

use crate::debug::DebugMap;
use crate::error::ImageError;
use crate::node::Node;
use crate::text;

/// Which text of a controller a unit is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum UnitName {
    /// The immediate statements of all files in their order. Where the text of a program stood, `PROGRAM` carries its index in
    /// [`crate::Image::programs`].
    Boot,
    /// `PROG0` to `PROG15`
    Program(u8),
    /// `PLC0` to `PLC7`
    Plc(u8),
}

impl fmt::Display for UnitName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Boot => f.write_str("boot"),
            Self::Program(number) => write!(f, "PROG{number}"),
            Self::Plc(number) => write!(f, "PLC{number}"),
        }
    }
}

/// A text in its stored form.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unit {
    /// Which text it is.
    pub name: UnitName,
    /// The words.
    pub words: Vec<u32>,
    /// The pool: the bytes of all texts in the order of the stream.
    pub strings: Vec<u8>,
    /// Where the words come from; `None` when stripped or never known.
    pub debug: Option<DebugMap>,
}

/// A label and where its definition stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LabelDefinition {
    /// The name without the underscore.
    pub name: String,
    /// Address of the definition.
    pub address: u32,
}

impl Unit {
    /// The memory that the text takes in a controller, in bytes: 4 a word and 1 a character, which is the guide's table ("How Much Memory?").
    pub fn memory(&self) -> u32 {
        memory(&self.words, &self.strings)
    }

    /// The labels, in the order of their numbers.
    ///
    /// # Errors
    /// As [`Unit::decode`].
    pub fn labels(&self) -> Result<Vec<LabelDefinition>, ImageError> {
        let instructions = self.decode()?;
        let definitions = instructions.iter().filter(|instruction| instruction.command == command::LABEL);
        let named = definitions.filter_map(|instruction| match instruction.items.first().map(|item| &item.node) {
            Some(Node::String { bytes, .. }) => {
                Some(LabelDefinition { name: text::decode(bytes), address: instruction.address })
            }
            _ => None,
        });
        Ok(named.collect())
    }
}

/// The memory that words and the characters of texts take.
pub(crate) fn memory(words: &[u32], strings: &[u8]) -> u32 {
    let bytes = 4 * words.len() as u64 + strings.len() as u64;
    u32::try_from(bytes).unwrap_or(u32::MAX)
}
