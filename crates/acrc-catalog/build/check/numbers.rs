//! Checks of parameters, flags and the ranges they lie in.

use std::collections::BTreeMap;

use super::Faults;
use crate::catalogue::rows::{BlockRow, Catalogue, NumberRow, WordRow};
use crate::vocabulary::{Access, BitKind, Space, ValueType};

/// The word that holds flags 0-31.
const FIRST_FLAG_WORD: u32 = 4096;

pub fn check(catalogue: &Catalogue, faults: &mut Faults) {
    rows("parameter", &catalogue.parameters, faults);
    rows("bit", &catalogue.bits, faults);
    fields(catalogue, faults);
    blocks(&catalogue.blocks, faults);
    words(&catalogue.words, faults);
    for row in catalogue.parameters.iter().filter(|row| row.count > 0) {
        inside_block(row, &catalogue.blocks, faults);
    }
    for row in &catalogue.bits {
        let homeless =
            row.numbers().map(|bit| FIRST_FLAG_WORD + bit / 32).find(|word| holder(&catalogue.words, *word).is_none());
        if let Some(word) = homeless {
            faults.add(label("bit", row), format_args!("no flag word row holds P{word}"));
        }
        if row.kind.is_none() {
            faults.add(label("bit", row), "the kind is missing");
        }
    }
}

fn label(what: &str, row: &NumberRow) -> String {
    format!("{what} {} ({} of {})", row.first, row.field, row.object)
}

fn rows(what: &str, rows: &[NumberRow], faults: &mut Faults) {
    for row in rows {
        faults.known(label(what, row), "object", &row.object, Space::from_name(&row.object).is_some());
        if let Some(access) = &row.access {
            faults.known(label(what, row), "access", access, Access::from_name(access).is_some());
        }
        if let Some(value_type) = &row.value_type {
            faults.known(label(what, row), "type", value_type, ValueType::from_name(value_type).is_some());
        }
        if let Some(kind) = &row.kind {
            faults.known(label(what, row), "kind", kind, BitKind::from_name(kind).is_some());
        }
        if row.range.is_some_and(|[least, most]| least > most) {
            faults.add(label(what, row), "its range ends before it begins");
        }
        if row.count == 0 || (row.stride == 0) != (row.count == 1) {
            faults.add(label(what, row), format_args!("stride {} does not go with count {}", row.stride, row.count));
        }
        faults.origin(label(what, row), &row.source, &row.confidence);
    }
    overlaps(what, rows, faults);
}

/// Rows of different count may overlap: the smaller one wins. With the same count nothing decides.
fn overlaps(what: &str, rows: &[NumberRow], faults: &mut Faults) {
    let mut owners: BTreeMap<(u32, u32), &NumberRow> = BTreeMap::new();
    for row in rows {
        let clash =
            row.numbers().find_map(|number| owners.insert((row.count, number), row).map(|other| (number, other)));
        if let Some((number, other)) = clash {
            faults.add(
                label(what, row),
                format_args!("its law meets that of {} at {number}, and neither is the more specific", other.field),
            );
        }
    }
}

/// A field name stands for one law, in one run or in two (masters 0-7 and 8-15).
fn fields(catalogue: &Catalogue, faults: &mut Faults) {
    let mut known: BTreeMap<&str, (&str, &NumberRow, u32)> = BTreeMap::new();
    let parameters = catalogue.parameters.iter().map(|row| ("parameter", row));
    let bits = catalogue.bits.iter().map(|row| ("bit", row));
    for (what, row) in parameters.chain(bits) {
        let runs = match known.get(row.field.as_str()) {
            None => 1,
            Some((kind, first, 1)) if *kind == what && continues(first, row) => 2,
            Some((kind, other, _)) => {
                let owner = format!("{kind} {} of {}", other.first, other.object);
                faults.add(label(what, row), format_args!("the field name is taken by the {owner}"));
                continue;
            }
        };
        known.insert(&row.field, (what, row, runs));
    }
}

fn continues(first: &NumberRow, second: &NumberRow) -> bool {
    first.object == second.object
        && first.stride == second.stride
        && second.first_index == first.first_index + first.count
}

fn blocks(rows: &[BlockRow], faults: &mut Faults) {
    let label = |row: &BlockRow| format!("block P{}-P{}", row.first, row.last);
    for row in rows {
        faults.known(label(row), "object", &row.object, Space::from_name(&row.object).is_some());
        faults.origin(label(row), &row.source, &row.confidence);
        if row.last < row.first {
            faults.add(label(row), "it ends before it begins");
        }
    }
    for (index, row) in rows.iter().enumerate() {
        if let Some(other) = rows[..index].iter().find(|other| other.first <= row.last && row.first <= other.last) {
            faults.add(label(row), format_args!("it overlaps the {}", label(other)));
        }
    }
}

fn words(rows: &[WordRow], faults: &mut Faults) {
    let label = |row: &WordRow| format!("flag words from P{} ({})", row.first, row.group);
    for (index, row) in rows.iter().enumerate() {
        faults.known(label(row), "object", &row.object, Space::from_name(&row.object).is_some());
        faults.origin(label(row), &row.source, &row.confidence);
        let end = row.first + row.count;
        if let Some(other) =
            rows[..index].iter().find(|other| other.first < end && row.first < other.first + other.count)
        {
            faults.add(label(row), format_args!("they overlap the {}", label(other)));
        }
    }
}

fn holder(words: &[WordRow], number: u32) -> Option<&WordRow> {
    words.iter().find(|word| (word.first..word.first + word.count).contains(&number))
}

fn inside_block(row: &NumberRow, blocks: &[BlockRow], faults: &mut Faults) {
    let outside = row.numbers().find(|number| {
        !blocks.iter().any(|block| (block.first..=block.last).contains(number) && owns(&block.object, &row.object))
    });
    if let Some(number) = outside {
        faults.add(label("parameter", row), format_args!("P{number} lies in no block of {}", row.object));
    }
}

fn owns(block: &str, row: &str) -> bool {
    block == row || (block == Space::DacAdc.name() && [Space::Dac.name(), Space::Adc.name()].contains(&row))
}
