//! Memory: what is given to programs and variables, and what they need (guide, "Memory Allocations").

pub(crate) mod array_reference_count;
pub(crate) mod dim_in_wrong_level;
pub(crate) mod dim_without_clear;
pub(crate) mod index_may_leave_dim;
pub(crate) mod index_outside_dim;
mod interval;
mod operands;
pub(crate) mod oversized_dim;
pub(crate) mod program_too_large;
pub(crate) mod redimensioned_block;
mod sites;
pub(crate) mod string_too_long;
pub(crate) mod system_memory_exceeded;
pub(crate) mod too_many_aliases;
pub(crate) mod undimensioned_move_buffer;
pub(crate) mod undimensioned_parameters;
pub(crate) mod undimensioned_variable;
pub(crate) mod unused_local_memory;
