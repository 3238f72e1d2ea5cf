//! The tables that the build script makes of `data/`.

#![allow(clippy::unreadable_literal, reason = "numbers are written as the guide writes them")]

use crate::{
    Access, AddressLaw, Argument, BitKind, BitRow, Command, CommandId, Confidence, FlagWords, Function, FunctionId,
    Keyword, Law, Levels, Message, MessageId, Model, ObjectKind, Operand, OperandClass, Operator, OperatorInfo,
    ParameterBlock, ParameterRow, SetBy, Shape, Space, TypeClass, UnaryOperator, ValueType, Word, hash::PerfectHash,
};

include!(concat!(env!("OUT_DIR"), "/tables.rs"));
