//! One file a rule, in groups.

pub(crate) mod arguments;
pub(crate) mod compile;
pub(crate) mod flow;
pub(crate) mod memory;
pub(crate) mod motion;
pub(crate) mod names;
pub(crate) mod parameters;
pub(crate) mod style;
pub(crate) mod suppressions;
pub(crate) mod syntax;
