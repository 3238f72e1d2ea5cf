//! Tables of parameters and flags, and the laws of their fields.

use std::collections::BTreeMap;

use super::{confidence, constant, line, table};
use crate::address::AddressLaw;
use crate::catalogue::rows::{ArgumentRow, Catalogue, CommandRow, NumberRow};
use crate::vocabulary::{Access, BitKind, Space, ValueType};

/// Numbers that share one entry of the look-up index; a group of the binary interface is as large.
const GROUP: u32 = 256;

pub fn tables(catalogue: &Catalogue, out: &mut String) {
    let parameters = sorted(&catalogue.parameters);
    table(out, "PARAMETERS", "ParameterRow", parameters.iter().map(|row| parameter(row, &catalogue.commands)));
    groups(out, "PARAMETERS_BY_GROUP", &parameters);
    fields(out, "PARAMETER_FIELDS", &catalogue.parameters);
    let bits = sorted(&catalogue.bits);
    table(out, "BITS", "BitRow", bits.iter().map(|row| bit(row, &catalogue.commands)));
    groups(out, "BITS_BY_GROUP", &bits);
    fields(out, "BIT_FIELDS", &catalogue.bits);
    let blocks = catalogue.blocks.iter().map(|row| {
        format!(
            "ParameterBlock {{ first: {}, last: {}, stride: {}, object: {}, first_index: {}, group_code: {:?}, note: {:?}, source: {:?}, confidence: {} }}",
            row.first,
            row.last,
            row.stride,
            space(&row.object),
            row.first_index,
            row.group_code,
            row.note,
            row.source,
            confidence(&row.confidence)
        )
    });
    table(out, "BLOCKS", "ParameterBlock", blocks);
    let words = catalogue.words.iter().map(|row| {
        format!(
            "FlagWords {{ law: {}, object: {}, group: {:?}, note: {:?}, source: {:?}, confidence: {} }}",
            law(row.law()),
            space(&row.object),
            row.group,
            row.note,
            row.source,
            confidence(&row.confidence)
        )
    });
    table(out, "FLAG_WORDS", "FlagWords", words);
}

/// A constant for each field: the law that gives its number for an object.
pub fn laws(catalogue: &Catalogue) -> String {
    let mut out = String::new();
    for (letter, rows) in [("P", &catalogue.parameters), ("BIT", &catalogue.bits)] {
        for (field, runs) in by_field(rows) {
            let row = runs[0];
            line(&mut out, format_args!("/// {letter}{}: {}.", row.first, row.title));
            line(&mut out, format_args!("pub const {}: Law = {};", constant(field), field_law(&runs)));
        }
    }
    out
}

fn sorted(rows: &[NumberRow]) -> Vec<&NumberRow> {
    let mut rows: Vec<_> = rows.iter().collect();
    rows.sort_by_key(|row| (row.first, std::cmp::Reverse(row.count)));
    rows
}

/// For each group of numbers the rows that hold some of them, the most specific first.
fn groups(out: &mut String, name: &str, rows: &[&NumberRow]) {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for (index, row) in rows.iter().enumerate() {
        for number in row.numbers() {
            let group = (number / GROUP) as usize;
            if groups.len() <= group {
                groups.resize(group + 1, Vec::new());
            }
            if groups[group].last() != Some(&index) {
                groups[group].push(index);
            }
        }
    }
    for group in &mut groups {
        group.sort_by_key(|index| rows[*index].count);
    }
    table(out, name, "&[u16]", groups.iter().map(|group| format!("&{group:?}")));
}

fn by_field(rows: &[NumberRow]) -> BTreeMap<&str, Vec<&NumberRow>> {
    let mut fields: BTreeMap<&str, Vec<&NumberRow>> = BTreeMap::new();
    for row in rows {
        fields.entry(&row.field).or_default().push(row);
    }
    fields
}

fn fields(out: &mut String, name: &str, rows: &[NumberRow]) {
    let rows = by_field(rows).into_iter().map(|(field, runs)| format!("({field:?}, {})", field_law(&runs)));
    table(out, name, "(&str, Law)", rows);
}

fn field_law(runs: &[&NumberRow]) -> String {
    let first = runs[0];
    let second = runs.get(1).map_or((first.first, 0), |row| (row.first, row.count));
    format!("Law::new({}, {}, {}, {}, {})", first.first, first.stride, first.count, second.0, second.1)
}

fn law(law: AddressLaw) -> String {
    format!("{law:?}")
}

fn space(name: &str) -> String {
    format!("Space::{:?}", Space::from_name(name).expect("checked"))
}

fn access(name: Option<&str>) -> String {
    format!("Access::{:?}", name.and_then(Access::from_name).unwrap_or(Access::Unknown))
}

/// The command that sets a row.
fn setter<'a>(row: &NumberRow, commands: &'a [CommandRow]) -> Option<&'a CommandRow> {
    commands.iter().find(|command| Some(&command.name) == row.command.as_ref())
}

fn set_by(row: &NumberRow, commands: &[CommandRow]) -> String {
    setter(row, commands).map_or("None".to_owned(), |command| {
        format!("Some(SetBy {{ command: CommandId({}), part: {} }})", command.opcode, row.part.unwrap_or(0))
    })
}

/// The values at power-up: those of the row, or that of the command that sets it. The second of a pair is the first with its sign turned.
fn defaults(row: &NumberRow, commands: &[CommandRow]) -> Vec<f64> {
    let Some(command) = setter(row, commands) else { return row.default.values().to_vec() };
    let Some(argument) = command.arguments.get(usize::from(row.part.unwrap_or(0))) else { return Vec::new() };
    let value = if argument.is_opposite() {
        command
            .arguments
            .first()
            .and_then(ArgumentRow::default_value)
            .map(|value| if value == 0.0 { 0.0 } else { -value })
    } else {
        argument.default_value()
    };
    value.into_iter().collect()
}

fn parameter(row: &NumberRow, commands: &[CommandRow]) -> String {
    let value_type = row.value_type.as_deref().and_then(ValueType::from_name);
    let range = row.range.map(|[least, most]| (least, most));
    let value_type = value_type.map_or("None".to_owned(), |value_type| format!("Some(ValueType::{value_type:?})"));
    format!(
        "ParameterRow {{ law: {}, object: {}, field: {:?}, title: {:?}, also: &{:?}, ty: {value_type}, access: {}, range: {range:?}, set_by: {}, \
         defaults: &{:?}, unit: {:?}, note: {:?}, source: {:?}, confidence: {} }}",
        law(row.law()),
        space(&row.object),
        row.field,
        row.title,
        row.also,
        access(row.access.as_deref()),
        set_by(row, commands),
        defaults(row, commands),
        row.unit,
        row.note,
        row.source,
        confidence(&row.confidence)
    )
}

fn bit(row: &NumberRow, commands: &[CommandRow]) -> String {
    let kind = row.kind.as_deref().and_then(BitKind::from_name).expect("checked");
    format!(
        "BitRow {{ law: {}, object: {}, field: {:?}, title: {:?}, also: &{:?}, kind: BitKind::{kind:?}, access: {}, set_by: {}, note: {:?}, \
         source: {:?}, confidence: {} }}",
        law(row.law()),
        space(&row.object),
        row.field,
        row.title,
        row.also,
        access(row.access.as_deref()),
        set_by(row, commands),
        row.note,
        row.source,
        confidence(&row.confidence)
    )
}
