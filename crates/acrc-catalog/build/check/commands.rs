//! Checks of the command rows.

use std::collections::BTreeMap;

use super::Faults;
use crate::catalogue::rows::CommandRow;
use crate::vocabulary::{Levels, ObjectKind, Shape};

/// Operation codes have ten bits in the stored program; 0 is no command.
const HIGHEST_OPCODE: u16 = 1023;

pub fn check(rows: &[CommandRow], faults: &mut Faults) {
    faults.unique("operation code", rows.iter().map(|row| (row.opcode, label(row))));
    faults.unique("name", rows.iter().map(|row| (row.name.to_uppercase(), label(row))));
    faults.unique("constant", rows.iter().map(|row| (row.constant(), label(row))));
    let by_name: BTreeMap<&str, &CommandRow> = rows.iter().map(|row| (row.name.as_str(), row)).collect();
    for row in rows {
        check_words(row, faults);
        check_counts(row, faults);
        check_family(row, &by_name, faults);
        faults.origin(label(row), &row.source, &row.confidence);
    }
}

fn label(row: &CommandRow) -> String {
    format!("command {} (opcode {})", row.name, row.opcode)
}

fn check_words(row: &CommandRow, faults: &mut Faults) {
    faults.known(label(row), "shape", &row.shape, Shape::from_name(&row.shape).is_some());
    for level in &row.levels {
        faults.known(label(row), "level", level, Levels::NAMES.contains(&level.as_str()));
    }
    for prefix in &row.prefixes {
        faults.known(label(row), "object prefix", prefix, ObjectKind::from_name(prefix).is_some());
    }
    for (what, text) in [("summary", &row.summary), ("signature", &row.signature)] {
        if text.trim().is_empty() || text.contains('\n') {
            faults.add(label(row), format_args!("the {what} must be one line"));
        }
    }
}

fn check_counts(row: &CommandRow, faults: &mut Faults) {
    if row.opcode == 0 || row.opcode > HIGHEST_OPCODE {
        faults.add(label(row), format_args!("operation codes are 1 to {HIGHEST_OPCODE}"));
    }
    if row.max_args() < row.min_args {
        faults.add(label(row), format_args!("max_args {} is less than min_args {}", row.max_args(), row.min_args));
    }
    let [least, most] = row.tuple;
    if most < least {
        faults.add(label(row), format_args!("tuple [{least}, {most}] is upside down"));
    }
    let needs_tuple =
        matches!(row.shape.as_str(), "AxisValues" | "AxisSources" | "Move" | "BitMove" | "ParameterTuple");
    if needs_tuple && least == 0 {
        faults.add(label(row), format_args!("shape {} needs tuple = [least, most]", row.shape));
    }
}

fn check_family(row: &CommandRow, by_name: &BTreeMap<&str, &CommandRow>, faults: &mut Faults) {
    if let Some(whole) = row.belongs_to.as_deref().filter(|whole| !by_name.contains_key(whole)) {
        faults.add(label(row), format_args!("belongs_to names no row `{whole}`"));
    }
    let Some(parent) = row.parent.as_deref() else { return };
    if !by_name.contains_key(parent) {
        faults.add(label(row), format_args!("no row of the parent `{parent}`"));
    }
    if row.name != format!("{parent} {}", row.last_word()) {
        faults.add(label(row), format_args!("the name must be that of the parent `{parent}` and one word"));
    }
    let mut ancestor = Some(parent);
    for _ in 0..by_name.len() {
        match ancestor {
            Some(name) if name == row.name => return faults.add(label(row), "it is its own ancestor"),
            Some(name) => ancestor = by_name.get(name).and_then(|row| row.parent.as_deref()),
            None => return,
        }
    }
}
