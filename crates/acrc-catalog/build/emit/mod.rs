//! The Rust source of the constant tables. Checked rows only.

mod commands;
mod expressions;
mod memory;
mod numbers;
mod perfect;
mod words;

use std::fmt::{Display, Write};

use super::rows::Catalogue;
use crate::vocabulary::Confidence;

/// The generated files: name and text.
pub fn files(catalogue: &Catalogue) -> Vec<(&'static str, String)> {
    let mut tables = String::new();
    commands::tables(&catalogue.commands, &mut tables);
    expressions::tables(catalogue, &mut tables);
    words::tables(catalogue, &mut tables);
    numbers::tables(catalogue, &mut tables);
    others(catalogue, &mut tables);
    vec![
        ("tables.rs", tables),
        ("command_ids.rs", commands::constants(&catalogue.commands)),
        ("function_ids.rs", expressions::constants(&catalogue.functions)),
        ("message_ids.rs", message_constants(catalogue)),
        ("laws.rs", numbers::laws(catalogue)),
        ("memory.rs", memory::constants(&catalogue.memory)),
    ]
}

/// A table of rows, one a line.
fn table(out: &mut String, name: &str, element: &str, rows: impl Iterator<Item = String>) {
    line(out, format_args!("pub(crate) static {name}: &[{element}] = &["));
    for row in rows {
        line(out, format_args!("    {row},"));
    }
    line(out, "];");
}

/// Positions of ids in a table, `u16::MAX` where there is none.
fn index(out: &mut String, name: &str, ids: impl Iterator<Item = u16>) {
    let mut places = Vec::new();
    for (place, id) in (0_u16..).zip(ids) {
        let id = usize::from(id);
        if places.len() <= id {
            places.resize(id + 1, u16::MAX);
        }
        places[id] = place;
    }
    line(out, format_args!("pub(crate) static {name}: &[u16] = &{places:?};"));
}

fn line(out: &mut String, text: impl Display) {
    writeln!(out, "{text}").expect("writing to a string does not fail");
}

fn confidence(name: &str) -> String {
    format!("Confidence::{:?}", Confidence::from_name(name).expect("checked"))
}

/// A word as a Rust constant.
fn constant(name: &str) -> String {
    name.to_uppercase().replace(' ', "_").replace('$', "_DOLLAR")
}

fn others(catalogue: &Catalogue, out: &mut String) {
    let models = catalogue.models.iter().map(|row| {
        format!(
            "Model {{ name: {:?}, programs: {}, plcs: {}, masters: {}, axes: {}, slaves: {}, streams: &{:?}, user_memory: {}, \
             servo_period: {:?}, plc_last_flag: {:?}, system_pointer: {:?}, note: {:?}, source: {:?}, confidence: {} }}",
            row.name,
            row.programs,
            row.plcs,
            row.masters,
            row.axes,
            row.slaves,
            row.streams,
            row.user_memory,
            row.servo_period,
            row.plc_last_flag,
            row.system_pointer,
            row.note,
            row.source,
            confidence(&row.confidence)
        )
    });
    table(out, "MODELS", "Model", models);
    let default = catalogue.models.iter().position(|row| row.default).expect("checked");
    line(out, format_args!("pub(crate) static DEFAULT_MODEL: &Model = &MODELS[{default}];"));
    let messages = catalogue.messages.iter().map(|row| {
        format!(
            "Message {{ id: MessageId({}), name: {:?}, text: {:?}, meaning: {:?}, source: {:?}, confidence: {} }}",
            row.id,
            row.name,
            row.text,
            row.meaning,
            row.source,
            confidence(&row.confidence)
        )
    });
    table(out, "MESSAGES", "Message", messages);
    index(out, "MESSAGE_BY_ID", catalogue.messages.iter().map(|row| u16::from(row.id)));
}

fn message_constants(catalogue: &Catalogue) -> String {
    let mut out = String::new();
    for row in &catalogue.messages {
        line(&mut out, format_args!("/// `{}`: {}.", row.text, row.meaning));
        line(&mut out, format_args!("pub const {}: MessageId = MessageId({});", row.name, row.id));
    }
    out
}
