//! What a parameter or flag number stands for (guide, "Parameters and Bits").

use crate::{CommandId, Space};

mod bits;
mod parameters;

pub use bits::{
    BitInfo, BitRow, FIRST_FLAG_WORD, FLAG_WORD_COUNT, FLAGS_PER_WORD, FlagWords, all_bits, all_flag_words, bit,
    bit_number, first_system_flag, flag_words, flags_in,
};
pub use parameters::{
    GROUP_FIELDS, ParameterBlock, ParameterInfo, ParameterRow, all_parameter_blocks, all_parameters, parameter,
    parameter_number,
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

/// What a number belongs to, in words: `axis 0`, `input, number 5`. Empty when no source says.
fn owner(object: Space, index: Option<u32>, element: Option<u32>) -> String {
    match (object, index, element) {
        (Space::Unknown, ..) => String::new(),
        (_, None, None) => object.name().to_owned(),
        (_, Some(index), None) => format!("{object} {index}"),
        (_, None, Some(element)) => format!("{object}, number {element}"),
        (_, Some(index), Some(element)) => format!("{object} {index}, number {element}"),
    }
}

/// A command as another way to a parameter or flag.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SetBy {
    /// The command.
    pub command: CommandId,
    /// Which of its values a parameter is, or which bit of its value a flag is.
    pub part: u8,
}

/// Numbers that share one entry of the look-up index.
const GROUP: u32 = 256;

/// The rows that may hold a number, the most specific first.
fn candidates(groups: &'static [&'static [u16]], number: u32) -> impl Iterator<Item = usize> {
    let group = usize::try_from(number / GROUP).ok().and_then(|group| groups.get(group));
    group.into_iter().flat_map(|rows| rows.iter()).map(|row| usize::from(*row))
}
