//! What is known of each operator: rank, operands, result.

use crate::generated::{OPERATORS, UNARY_OPERATORS};
use crate::{Confidence, Operator, UnaryOperator};

/// What is known of an operator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OperatorInfo {
    /// Its canonical spelling.
    pub symbol: &'static str,
    /// A second spelling that is accepted; empty for none.
    pub alternative: &'static str,
    /// Its rank, 1 to 8; the lower rank binds tighter.
    pub precedence: u8,
    /// What it does, in one line.
    pub summary: &'static str,
    /// What it takes.
    pub operands: &'static str,
    /// What it gives.
    pub result: &'static str,
    /// What else is known or not known.
    pub note: &'static str,
    /// Where the row comes from (`data/README.md`).
    pub source: &'static str,
    /// How well it is attested.
    pub confidence: Confidence,
}

// The build script emits one row for each variant, in the order of the ids.
const _: () = assert!(OPERATORS.len() == Operator::ALL.len() && UNARY_OPERATORS.len() == UnaryOperator::ALL.len());

impl Operator {
    /// Its row.
    pub fn info(self) -> &'static OperatorInfo {
        &OPERATORS[usize::from(self.id())]
    }

    /// The canonical spelling.
    pub const fn symbol(self) -> &'static str {
        self.name()
    }

    /// The operator with this spelling, canonical or not, in any case.
    pub fn from_symbol(symbol: &str) -> Option<Self> {
        let alternative =
            || Self::ALL.iter().copied().find(|operator| !symbol.is_empty() && operator.info().alternative == symbol);
        Self::from_name(symbol).or_else(alternative)
    }

    /// The rank, 2 to 8; the lower rank binds tighter and equal ranks go from left to right.
    pub fn precedence(self) -> u8 {
        self.info().precedence
    }

    /// How well operator and rank are attested.
    pub fn confidence(self) -> Confidence {
        self.info().confidence
    }
}

impl UnaryOperator {
    /// Its row.
    pub fn info(self) -> &'static OperatorInfo {
        &UNARY_OPERATORS[usize::from(self.id())]
    }

    /// The spelling.
    pub const fn symbol(self) -> &'static str {
        self.name()
    }

    /// The rank; the lower rank binds tighter.
    pub fn precedence(self) -> u8 {
        self.info().precedence
    }

    /// How well operator and rank are attested.
    pub fn confidence(self) -> Confidence {
        self.info().confidence
    }
}

/// Every operator with two operands, in the order of the ids.
pub fn all_operators() -> impl ExactSizeIterator<Item = Operator> {
    Operator::ALL.iter().copied()
}

/// Every operator with one operand, in the order of the ids.
pub fn all_unary_operators() -> impl ExactSizeIterator<Item = UnaryOperator> {
    UnaryOperator::ALL.iter().copied()
}
