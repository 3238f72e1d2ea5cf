//! Checks of what ties parameters and flags to the commands that set them, and of their values at power-up.

use std::collections::BTreeMap;

use super::Faults;
use crate::catalogue::rows::{Catalogue, CommandRow, NumberRow};
use crate::vocabulary::{ObjectKind, Space};

/// Flags that one value of a command can stand for.
const VALUE_BITS: u8 = 32;

pub fn check(catalogue: &Catalogue, faults: &mut Faults) {
    let parameters = catalogue.parameters.iter().map(|row| ("parameter", row));
    let bits = catalogue.bits.iter().map(|row| ("bit", row));
    let mut owners: BTreeMap<(&str, &str, u8), &str> = BTreeMap::new();
    for (what, row) in parameters.chain(bits) {
        let label = format!("{what} {} ({} of {})", row.first, row.field, row.object);
        defaults(&label, what, row, faults);
        let Some(name) = &row.command else {
            if row.part.is_some() {
                faults.add(&label, "a part of no command");
            }
            continue;
        };
        let command = catalogue.commands.iter().find(|command| command.name == *name);
        faults.known(&label, "command", name, command.is_some());
        if let Some(command) = command {
            link(&label, what == "bit", row, command, faults);
        }
        let part = row.part.unwrap_or(0);
        if let Some(other) = owners.insert((what, name, part), &row.field).filter(|other| *other != row.field) {
            faults.add(&label, format_args!("part {part} of {name} is taken by {other}"));
        }
    }
}

fn defaults(label: &str, what: &str, row: &NumberRow, faults: &mut Faults) {
    let values = row.default.values().len();
    if values > 0 && (what == "bit" || row.command.is_some()) {
        faults.add(label, "flags have no default, and a row with a command has that of the command");
    }
    if values > 1 && values != row.count as usize {
        faults.add(label, format_args!("{values} defaults do not go with count {}", row.count));
    }
}

fn link(label: &str, flag: bool, row: &NumberRow, command: &CommandRow, faults: &mut Faults) {
    let name = &command.name;
    if !command.setting {
        faults.add(label, format_args!("{name} is no setting"));
    }
    if !command.prefixes.iter().any(|prefix| prefix_of(&row.object).is_some_and(|kind| kind.name() == prefix)) {
        faults.add(label, format_args!("{name} does not belong to {}", row.object));
    }
    let parts = if flag { VALUE_BITS } else { command.tuple[1].max(1) };
    if row.part.is_some() != (parts > 1) || row.part.is_some_and(|part| part >= parts) {
        faults.add(label, format_args!("its part does not go with the {parts} of {name}"));
    }
}

/// The object in front of a command whose values belong to a space.
fn prefix_of(space: &str) -> Option<ObjectKind> {
    Space::from_name(space).and_then(Space::object_kind)
}
