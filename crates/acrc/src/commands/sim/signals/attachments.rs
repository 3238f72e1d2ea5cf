//! Which axes the text of a project attaches to masters.

use std::collections::BTreeMap;

use acrc_catalog::{ObjectKind, command};
use acrc_image::{Image, Instruction, Node, UnitName};

/// All attachments, in the order of the text.
pub(super) fn of(image: &Image) -> Vec<Attached> {
    let mut attached = Vec::new();
    for unit in image.units() {
        let mut level = unit.name;
        for instruction in unit.decode().unwrap_or_default() {
            level = prompt(&instruction).unwrap_or(level);
            attached.extend(attached_axis(&instruction, level));
        }
    }
    attached
}

/// An axis that `ATTACH SLAVEn AXISm "name"` attaches.
pub(super) struct Attached {
    /// The prompt at which it is attached: each program has a master of its own.
    level: UnitName,
    slave: i32,
    pub(super) axis: u8,
    pub(super) name: String,
}

/// The first two slaves of each program that has two.
pub(super) fn planes(attached: &[Attached]) -> Vec<(u8, u8)> {
    let mut by_level: BTreeMap<UnitName, BTreeMap<i32, u8>> = BTreeMap::new();
    for Attached { level, slave, axis, .. } in attached {
        by_level.entry(*level).or_default().insert(*slave, *axis);
    }
    let planes = by_level.values().filter_map(|slaves| {
        let mut axes = slaves.values();
        Some((*axes.next()?, *axes.next()?))
    });
    planes.collect()
}

fn attached_axis(instruction: &Instruction, level: UnitName) -> Option<Attached> {
    if instruction.command != command::ATTACH_SLAVE {
        return None;
    }
    let mut items = instruction.items.iter().map(|item| &item.node);
    let number = |node: &Node, asked: ObjectKind| match node {
        Node::Object { kind, index: Some(index), .. } if *kind == asked => Some(*index),
        _ => None,
    };
    let slave = instruction.items.iter().find_map(|item| number(&item.node, ObjectKind::Slave)).map_or(0, i32::from);
    let axis = items.find_map(|node| u8::try_from(number(node, ObjectKind::Axis)?).ok())?;
    let name = items.find_map(|node| match node {
        Node::String { bytes, .. } => Some(bytes.iter().map(|byte| char::from(byte.to_ascii_uppercase())).collect()),
        _ => None,
    })?;
    Some(Attached { level, slave, axis, name })
}

/// The program to whose prompt a statement switches.
fn prompt(instruction: &Instruction) -> Option<UnitName> {
    match (instruction.command, instruction.items.first().map(|item| &item.node)) {
        (command::PROG, Some(Node::Long(number))) => u8::try_from(*number).ok().map(UnitName::Program),
        _ => None,
    }
}
