//! Parameters and bits by number (guide, "Parameters and Bits").

pub(crate) mod read_only;
pub(crate) mod unknown_number;
