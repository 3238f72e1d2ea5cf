//! Parameters and flags by number: one memory, whichever way it is reached (guide, "Parameters and Bits").

mod bits;
mod live;
pub(crate) mod map;
mod parameters;
mod store;
mod stream;

pub(crate) use map::{is_of_unknown_form, is_outside_flag, is_plain_parameter};
pub(crate) use store::Registers;
