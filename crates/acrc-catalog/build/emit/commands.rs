//! The command table and its constants.

use std::collections::BTreeMap;

use super::{confidence, index, line, table};
use crate::catalogue::rows::{ArgumentRow, CommandRow};
use crate::vocabulary::{Levels, ObjectKind, Shape};

pub fn tables(rows: &[CommandRow], out: &mut String) {
    let mut rows: Vec<&CommandRow> = rows.iter().collect();
    rows.sort_by_key(|row| row.opcode);
    let opcodes = rows.iter().map(|row| (row.name.as_str(), row.opcode)).collect::<BTreeMap<_, _>>();
    table(out, "COMMANDS", "Command", rows.iter().map(|row| command(row, &rows, &opcodes)));
    index(out, "COMMAND_BY_OPCODE", rows.iter().map(|row| row.opcode));
}

pub fn constants(rows: &[CommandRow]) -> String {
    let mut out = String::new();
    for row in rows {
        line(&mut out, format_args!("/// `{}`: {}.", row.name, row.summary));
        line(&mut out, format_args!("pub const {}: CommandId = CommandId({});", row.constant(), row.opcode));
    }
    out
}

fn command(row: &CommandRow, rows: &[&CommandRow], opcodes: &BTreeMap<&str, u16>) -> String {
    let id = |name: &Option<String>| match name {
        Some(name) => format!("Some(CommandId({}))", opcodes[name.as_str()]),
        None => "None".to_owned(),
    };
    let ids = |related: fn(&CommandRow) -> &Option<String>| {
        let related = rows.iter().filter(|other| related(other).as_deref() == Some(row.name.as_str()));
        related.map(|row| format!("CommandId({})", row.opcode)).collect::<Vec<_>>().join(", ")
    };
    let prefixes =
        row.prefixes.iter().map(|name| format!("ObjectKind::{:?}", ObjectKind::from_name(name).expect("checked")));
    let arguments = row.arguments.iter().map(argument).collect::<Vec<_>>().join(", ");
    format!(
        "Command {{ id: CommandId({}), name: {:?}, word: {:?}, parent: {}, belongs_to: {}, clause: {}, group: {:?}, summary: {:?}, note: {:?}, \
         signature: {:?}, arguments: &[{arguments}], shape: Shape::{:?}, min_args: {}, max_args: {}, tuple_min: {}, tuple_max: {}, \
         bare_axis: {}, setting: {}, levels: Levels::from_bits({}), report: {:?}, prefixes: &[{}], takes_axes: {}, daughter_required: {}, models: {:?}, \
         source: {:?}, confidence: {}, daughters: &[{}], parts: &[{}] }}",
        row.opcode,
        row.name,
        row.last_word(),
        id(&row.parent),
        id(&row.belongs_to),
        row.clause,
        row.group,
        row.summary,
        row.note,
        row.signature,
        Shape::from_name(&row.shape).expect("checked"),
        row.min_args,
        row.max_args(),
        row.tuple[0],
        row.tuple[1],
        row.bare_axis,
        row.setting,
        levels(&row.levels),
        row.report,
        prefixes.collect::<Vec<_>>().join(", "),
        row.takes_axes,
        row.daughter_required,
        row.models,
        row.source,
        confidence(&row.confidence),
        ids(|row| &row.parent),
        ids(|row| &row.belongs_to),
    )
}

fn levels(names: &[String]) -> u8 {
    let bits = Levels::NAMES.iter().enumerate().filter(|(_, name)| names.iter().any(|level| level == *name));
    bits.map(|(bit, _)| 1 << bit).sum()
}

fn argument(row: &ArgumentRow) -> String {
    format!(
        "Argument {{ name: {:?}, kind: {:?}, unit: {:?}, range: {:?}, default: {:?}, default_value: {:?}, opposite: {} }}",
        row.name,
        row.kind,
        row.unit,
        row.range,
        row.default,
        row.default_value(),
        row.is_opposite()
    )
}
