//! The pages of the entries.

mod commands;
mod numbers;

use super::Entry;
use super::sheet::Sheet;
use crate::{Function, Message, Model, Operand, OperatorInfo, TypeClass};

/// The page of an entry.
pub(super) fn entry(entry: &Entry) -> Sheet {
    match entry {
        Entry::Command(command) => commands::command(command),
        Entry::Function(function) => self::function(function),
        Entry::Operator(info) => operator(info),
        Entry::Operand(operand) => self::operand(operand),
        Entry::Keyword(keyword) => commands::keyword(*keyword),
        Entry::Object(kind) => commands::object(*kind),
        Entry::Parameter(info) => numbers::parameter(info),
        Entry::Bit(info) => numbers::bit(info),
        Entry::ParameterField(row) => numbers::parameter_field(row),
        Entry::BitField(row) => numbers::bit_field(row),
        Entry::Model(model) => self::model(model),
        Entry::Message(message) => self::message(message),
    }
}

fn function(function: &Function) -> Sheet {
    Sheet::new(function.name, "function")
        .summary(function.summary)
        .code("form", call(function))
        .fact("result", function.result.name())
        .fact("domain", function.domain)
        .fact("note", function.note)
        .origin(function.source, function.confidence)
}

/// `MID$(string, long {, long})`
fn call(function: &Function) -> String {
    let required = usize::from(function.min_args);
    let (needed, optional) = function.argument_types.split_at(required.min(function.argument_types.len()));
    let names = |types: &[TypeClass]| types.iter().map(|class| class.name()).collect::<Vec<_>>();
    let form = match (names(needed).join(", "), names(optional).join(" {, ")) {
        (needed, _) if needed.is_empty() => return function.name.to_owned(),
        (needed, optional) if optional.is_empty() => needed,
        (needed, rest) => format!("{needed} {{, {rest}{}", "}".repeat(optional.len())),
    };
    format!("{}({form})", function.name)
}

fn operator(info: &OperatorInfo) -> Sheet {
    Sheet::new(info.symbol, "operator")
        .summary(info.summary)
        .fact("operands", info.operands)
        .fact("result", info.result)
        .fact("rank", format!("{} of 8, 1 binds tightest", info.precedence))
        .fact("also", info.alternative)
        .fact("note", info.note)
        .origin(info.source, info.confidence)
}

fn operand(operand: &Operand) -> Sheet {
    Sheet::new(operand.name, "operand")
        .summary(operand.summary)
        .fact("numbers", operand.index)
        .fact("storage", operand.storage)
        .fact("note", operand.note)
        .origin(operand.source, operand.confidence)
}

fn model(model: &Model) -> Sheet {
    Sheet::new(model.name, "controller model")
        .fact("programs", model.programs.to_string())
        .fact("PLC programs", model.plcs.to_string())
        .fact("masters", model.masters.to_string())
        .fact("axes", model.axes.to_string())
        .fact("slaves", model.slaves.to_string())
        .list("streams", model.streams.iter().copied())
        .fact("memory", format!("{} bytes", model.user_memory))
        .fact("servo period", format!("{} s", model.servo_period))
        .fact("system pointer", model.system_pointer.map_or_else(String::new, |address| format!("0x{address:06X}")))
        .fact("note", model.note)
        .origin(model.source, model.confidence)
}

fn message(message: &Message) -> Sheet {
    Sheet::new(message.text, "message of the controller")
        .summary(message.meaning)
        .origin(message.source, message.confidence)
}
