//! Reading and writing parameters and flags by name.
//!
//! A connection with packets reads system parameters and flags by packets, many under way at a time. User parameters
//! (`P0` to `P4095`) go as text everywhere: packets carry 32 bits and they have 64.

mod name;
mod read;
mod risk;
mod write;

pub use name::{NameError, Named, Names, Register};
pub use read::{Value, read};
pub use risk::{Risk, risk};
pub use write::{WriteError, parse_value, write};
