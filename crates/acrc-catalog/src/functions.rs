//! Functions of expressions (guide, "Parametric Evaluation").

use crate::generated::{FUNCTION_BY_ID, FUNCTIONS};
use crate::{Confidence, TypeClass};

/// A row of the function table; its number is stable and stored in images.
///
/// Values come from [`crate::function`], from look-ups, or from [`FunctionId::from_id`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FunctionId(pub u8);

impl FunctionId {
    /// The row.
    pub fn info(self) -> &'static Function {
        self.find().expect("a function id is an id of the catalogue")
    }

    /// The number that images store.
    pub const fn id(self) -> u8 {
        self.0
    }

    /// The function with this id, if there is one.
    pub fn from_id(id: u8) -> Option<Self> {
        Self(id).find().map(|function| function.id)
    }

    fn find(self) -> Option<&'static Function> {
        let place = FUNCTION_BY_ID.get(usize::from(self.0))?;
        FUNCTIONS.get(usize::from(*place))
    }
}

/// A function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Function {
    /// Its identifier.
    pub id: FunctionId,
    /// Its name: `CHR$`.
    pub name: &'static str,
    /// Fewest arguments.
    pub min_args: u8,
    /// Most arguments.
    pub max_args: u8,
    /// What each argument must be, [`Function::max_args`] of them.
    pub argument_types: &'static [TypeClass],
    /// What it gives.
    pub result: TypeClass,
    /// Accepted arguments and their meaning; empty for no restriction.
    pub domain: &'static str,
    /// What it does, in one line.
    pub summary: &'static str,
    /// What else is known or not known; empty for nothing.
    pub note: &'static str,
    /// Where the row comes from (`data/README.md`).
    pub source: &'static str,
    /// How well it is attested.
    pub confidence: Confidence,
}

/// Every function, in the order of the data file.
pub fn all_functions() -> impl ExactSizeIterator<Item = &'static Function> {
    FUNCTIONS.iter()
}
