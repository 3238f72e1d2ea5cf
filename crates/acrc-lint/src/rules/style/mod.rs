//! What works, and could be clearer or cheaper.

mod branches;
pub(crate) mod constant_condition;
pub(crate) mod duplicate_branch;
pub(crate) mod duplicate_condition;
pub(crate) mod float_equality;
pub(crate) mod goto_loop;
pub(crate) mod identical_operands;
pub(crate) mod keyword_case;
pub(crate) mod magic_bit_number;
pub(crate) mod mixed_and_or;
pub(crate) mod remark_costs_memory;
pub(crate) mod self_assignment;
pub(crate) mod unused_variable;
