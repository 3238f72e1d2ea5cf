//! What the `AcroBASIC` language knows: commands, expressions, parameters, flags and controller models.
//!
//! Every fact is a row of a file in `data/`; the build script checks the rows and turns them into constant tables, so that nothing is parsed or
//! allocated at start-up. Parser, argument checker, stored program, editor features and reference pages read the same rows. Each row says where it
//! comes from and how well it is attested ([`Confidence`]).
//!
//! - commands: [`command`], [`Command`], [`word`] and [`daughter`] for the reader of program text
//! - expressions: [`Operator`], [`UnaryOperator`], [`function`], [`OperandClass`]
//! - numbers: [`parameter`], [`bit`], [`law`]
//! - controllers: [`Model`], [`message`], [`memory`]
//! - a person's questions: [`explain`]
//!
//! ```
//! use acrc_catalog::{Shape, bit, command, daughter, law, word};
//!
//! assert_eq!(word("jog").and_then(|word| word.command), Some(command::JOG));
//! assert_eq!(daughter(command::JOG, "HOME"), Some(command::JOG_HOME));
//! assert_eq!(command::DWL.info().shape, Shape::Value);
//! assert_eq!(law::IN_MOTION.at(1), 548);
//! assert_eq!(bit(8499).title, "Kill All Motion Request (KAMR)");
//! ```

#[macro_use]
mod named;

mod address;
mod alias_name;
mod axis_name;
mod commands;
mod explain;
mod fields;
mod functions;
mod generated;
mod hash;
pub mod memory;
mod messages;
mod models;
mod numbers;
mod operands;
mod operators;
mod vocabulary;
mod words;

pub use address::AddressLaw;
pub use alias_name::{AliasNameError, check_alias_name};
pub use axis_name::{AxisNameError, check_axis_name};
pub use commands::{Argument, Command, CommandId, all_commands};
pub use explain::{Entry, Explanation, explain, nearest_command};
pub use fields::Law;
pub use functions::{Function, FunctionId, all_functions};
pub use messages::{Message, MessageId, all_messages};
pub use models::{Model, default_model, model, models};
pub use numbers::{
    BitInfo, BitRow, FIRST_FLAG_WORD, FLAG_WORD_COUNT, FLAGS_PER_WORD, FlagWords, GROUP_FIELDS, Known, ParameterBlock,
    ParameterInfo, ParameterRow, SetBy, all_bits, all_flag_words, all_parameter_blocks, all_parameters, bit,
    bit_number, first_system_flag, flag_words, flags_in, parameter, parameter_number,
};
pub use operands::{Operand, all_operands};
pub use operators::{OperatorInfo, all_operators, all_unary_operators};
pub use vocabulary::{
    Access, BitKind, Confidence, Keyword, Levels, ObjectKind, OperandClass, Operator, Shape, Space, TypeClass,
    UnaryOperator, ValueType,
};
pub use words::{Word, daughter, word};

/// The identifiers of the commands, one constant a row: [`command::JOG_HOME`], [`command::DIM_STRING_V`].
#[allow(clippy::doc_markdown, reason = "generated from one-line summaries")]
pub mod command {
    use crate::CommandId;

    include!(concat!(env!("OUT_DIR"), "/command_ids.rs"));
}

/// The identifiers of the functions; a dollar sign is spelled out: [`function::CHR_DOLLAR`].
#[allow(clippy::doc_markdown, reason = "generated from one-line summaries")]
pub mod function {
    use crate::FunctionId;

    include!(concat!(env!("OUT_DIR"), "/function_ids.rs"));
}

/// The texts that a controller is known to send.
pub mod message {
    use crate::MessageId;

    include!(concat!(env!("OUT_DIR"), "/message_ids.rs"));
}

/// The numbers of parameters and flags by object: `law::CURRENT_POSITION.at(axis)`, `law::IN_MOTION.at(master)`.
#[allow(
    clippy::doc_markdown,
    clippy::unreadable_literal,
    reason = "generated from titles and numbers as the guide writes them"
)]
pub mod law {
    use crate::Law;

    include!(concat!(env!("OUT_DIR"), "/laws.rs"));
}
