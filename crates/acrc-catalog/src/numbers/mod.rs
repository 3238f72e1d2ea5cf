//! What a parameter or flag number stands for (guide, "Parameters and Bits").

mod bits;
mod parameters;

pub use bits::{BitInfo, BitRow, FlagWords, all_bits, all_flag_words, bit, bit_number, flag_words};
pub use parameters::{
    ParameterBlock, ParameterInfo, ParameterRow, all_parameter_blocks, all_parameters, parameter, parameter_number,
};

/// How precisely a number is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Known {
    /// A row names it.
    Row,
    /// Only the range is known: the block of the parameter, or the word of the flag.
    Range,
    /// It lies in the space of parameters or flags, and no source says what it is.
    Unknown,
    /// No controller has it.
    OutOfSpace,
}

/// Numbers that share one entry of the look-up index.
const GROUP: u32 = 256;

/// The rows that may hold a number, the most specific first.
fn candidates(groups: &'static [&'static [u16]], number: u32) -> impl Iterator<Item = usize> {
    let group = usize::try_from(number / GROUP).ok().and_then(|group| groups.get(group));
    group.into_iter().flat_map(|rows| rows.iter()).map(|row| usize::from(*row))
}
