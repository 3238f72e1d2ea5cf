//! What an expression is made of: variables, parameters, flags, aliases and constants.

use crate::generated::OPERANDS;
use crate::{Confidence, OperandClass};

/// A kind of operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Operand {
    /// How it is written, `n` standing for its number and `i` for an element.
    pub name: &'static str,
    /// Its class, for those that have one; further rows of a class follow its first.
    pub class: Option<OperandClass>,
    /// What it is, in one line.
    pub summary: &'static str,
    /// Accepted numbers.
    pub index: &'static str,
    /// What it occupies.
    pub storage: &'static str,
    /// What else is known or not known.
    pub note: &'static str,
    /// Where the row comes from (`data/README.md`).
    pub source: &'static str,
    /// How well it is attested.
    pub confidence: Confidence,
}

impl OperandClass {
    /// The row that describes the class.
    pub fn info(self) -> &'static Operand {
        all_operands()
            .find(|operand| operand.class == Some(self))
            .expect("the build script checks that every class has a row")
    }
}

/// Every kind of operand, in the order of the data file.
pub fn all_operands() -> impl ExactSizeIterator<Item = &'static Operand> {
    OPERANDS.iter()
}
