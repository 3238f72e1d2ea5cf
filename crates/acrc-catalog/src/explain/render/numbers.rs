//! Pages of parameters and flags.

use super::Sheet;
use crate::{
    Access, AddressLaw, BitInfo, BitRow, CommandId, Known, ParameterInfo, ParameterRow, SetBy, all_bits, all_parameters,
};

pub(super) fn parameter(info: &ParameterInfo) -> Sheet {
    let name = format!("P{}", info.number);
    let title = match info.known {
        Known::Row => info.title,
        Known::Range => "parameter of a known block, meaning unknown",
        Known::Unknown => "unknown parameter",
        Known::OutOfSpace => "no parameter of any controller",
    };
    let sheet = Sheet::new(&name, title)
        .fact("field", info.field)
        .fact("of", info.owner())
        .fact("type", info.ty.map_or("", |ty| ty.name()))
        .fact("access", access(info.access))
        .fact("range", range(info.row.and_then(|row| row.range)))
        .fact("at power-up", info.row.map(power_up).unwrap_or_default())
        .fact("unit", info.unit)
        .fact("set by", info.row.and_then(|row| row.set_by).map(value_of).unwrap_or_default())
        .fact("law", info.row.map(|row| law("P", &row.law)).unwrap_or_default());
    let sheet = match info.block {
        Some(block) => sheet.fact("block", format!("P{}-P{} ({})", block.first, block.last, block.object)),
        None => sheet,
    };
    close(sheet.fact("note", info.note), info.source, info.confidence)
}

pub(super) fn bit(info: &BitInfo) -> Sheet {
    let name = format!("BIT{}", info.number);
    let title = match info.known {
        Known::Row => info.title,
        Known::Range => "flag of a known group, meaning unknown",
        Known::Unknown => "unknown flag",
        Known::OutOfSpace => "no flag of any controller",
    };
    let word = info.word.map(|word| format!("P{word}, bit {} (mask {})", info.index, mask(info.index)));
    let sheet = Sheet::new(&name, title)
        .fact("field", info.field)
        .fact("of", info.owner())
        .fact("kind", info.kind.map_or("", |kind| kind.name()))
        .fact("access", access(info.access))
        .fact("flag word", word.unwrap_or_default())
        .fact("group", info.words.map_or("", |words| words.group))
        .fact("set by", info.row.and_then(|row| row.set_by).map(bit_of).unwrap_or_default())
        .fact("law", info.row.map(|row| law("BIT", &row.law)).unwrap_or_default());
    close(sheet.fact("note", info.note), info.source, info.confidence)
}

pub(super) fn parameter_field(row: &ParameterRow) -> Sheet {
    let laws: Vec<String> =
        all_parameters().filter(|other| other.field == row.field).map(|row| law("P", &row.law)).collect();
    Sheet::new(row.title, "parameter")
        .list("also", row.also.iter().copied())
        .fact("field", row.field)
        .fact("of", row.object.name())
        .fact("type", row.ty.map_or("", |ty| ty.name()))
        .fact("access", access(row.access))
        .fact("range", range(row.range))
        .fact("at power-up", power_up(row))
        .fact("unit", row.unit)
        .fact("set by", row.set_by.map(value_of).unwrap_or_default())
        .fact("law", laws.join("; "))
        .fact("note", row.note)
        .origin(row.source, row.confidence)
}

pub(super) fn bit_field(row: &BitRow) -> Sheet {
    let laws: Vec<String> =
        all_bits().filter(|other| other.field == row.field).map(|row| law("BIT", &row.law)).collect();
    Sheet::new(row.title, "flag")
        .list("also", row.also.iter().copied())
        .fact("field", row.field)
        .fact("of", row.object.name())
        .fact("kind", row.kind.name())
        .fact("access", access(row.access))
        .fact("set by", row.set_by.map(bit_of).unwrap_or_default())
        .fact("law", laws.join("; "))
        .fact("note", row.note)
        .origin(row.source, row.confidence)
}

/// The parameters and flags that hold the values of a command.
pub(super) fn set_by(command: CommandId) -> String {
    let sets = |set_by: Option<SetBy>| set_by.is_some_and(|set_by| set_by.command == command);
    let parameters = all_parameters().filter(|row| sets(row.set_by)).map(|row| law("P", &row.law));
    let bits = all_bits().filter(|row| sets(row.set_by)).map(|row| law("BIT", &row.law));
    parameters.chain(bits).collect::<Vec<_>>().join("; ")
}

fn value_of(set_by: SetBy) -> String {
    let command = set_by.command.info();
    match command.arguments.get(usize::from(set_by.part)) {
        Some(argument) if command.tuple_max > 1 => format!("{}, {}", command.name, argument.name),
        _ => command.name.to_owned(),
    }
}

fn bit_of(set_by: SetBy) -> String {
    format!("{}, bit {} of its value", set_by.command.info().name, set_by.part)
}

fn power_up(row: &ParameterRow) -> String {
    row.defaults.iter().map(f64::to_string).collect::<Vec<_>>().join(", ")
}

fn close(sheet: Sheet, source: &str, confidence: crate::Confidence) -> Sheet {
    if source.is_empty() { sheet } else { sheet.origin(source, confidence) }
}

fn access(access: Access) -> &'static str {
    match access {
        Access::Unknown => "",
        Access::Read | Access::ReadWrite => access.name(),
    }
}

/// `P12290 + 256 n, n = 0 to 15`
fn law(letter: &str, law: &AddressLaw) -> String {
    if law.stride == 0 {
        return format!("{letter}{}", law.first);
    }
    let offset =
        if law.first_index > 0 && law.per_object == 1 { format!("(n - {})", law.first_index) } else { "n".to_owned() };
    let from = if law.per_object == 1 { law.first_index } else { 0 };
    let step = if law.stride == 1 { offset } else { format!("{} {offset}", law.stride) };
    format!("{letter}{} + {step}, n = {from} to {}", law.first, from + law.count - 1)
}

fn mask(index: u32) -> i32 {
    // Flag words are signed: bit 31 alone is the most negative long.
    (1_u32 << (index % 32)).cast_signed()
}

fn range(range: Option<(i32, i32)>) -> String {
    range.map(|(least, most)| format!("{least} to {most}")).unwrap_or_default()
}
