//! Arguments of commands and functions, by their rows in the catalogue (guide, "Command Syntax").

pub(crate) mod argument_count;
pub(crate) mod argument_kind;
pub(crate) mod argument_range;
mod groups;
pub(crate) mod missing_parentheses;
pub(crate) mod number_too_large;
mod range;
pub(crate) mod report_before_move;
pub(crate) mod unstorable_character;
mod value_kind;
