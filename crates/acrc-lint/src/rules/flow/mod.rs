//! Labels, blocks, and the way through a program (guide, "Program Labels" and "Program Flow").

pub(crate) mod break_outside_loop;
pub(crate) mod crossed_blocks;
pub(crate) mod duplicate_label;
pub(crate) mod endp_without_program;
pub(crate) mod goto_out_of_block;
pub(crate) mod missing_return;
pub(crate) mod no_program;
pub(crate) mod program_not_closed;
pub(crate) mod unclosed_block;
pub(crate) mod undefined_label;
pub(crate) mod unopened_block_end;
pub(crate) mod unused_label;
