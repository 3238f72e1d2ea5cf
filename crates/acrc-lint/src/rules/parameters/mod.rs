//! Parameters and bits by number (guide, "Parameters and Bits").

pub(crate) mod actual_position_written;
pub(crate) mod alias_exists;
pub(crate) mod bit_as_number;
pub(crate) mod contradictory_bit_test;
pub(crate) mod duplicate_node;
pub(crate) mod inhibit_without_motion;
pub(crate) mod never_set_flag;
pub(crate) mod number_as_bit;
pub(crate) mod object_not_attached;
pub(crate) mod plc_beyond_flags;
pub(crate) mod read_only;
pub(crate) mod request_bit_awaited;
pub(crate) mod unknown_number;
pub(crate) mod value_out_of_range;
pub(crate) mod wizard_number;
