//! The signals that are recorded when nobody chooses: every axis that the image attaches, the inputs that the world drives, and the flags that
//! programs switch.

use std::collections::BTreeSet;

use acrc_catalog::{command, law};
use acrc_controller::world::World;
use acrc_image::{Image, Instruction, Node};

use super::names::{Names, bit_of};
use super::{Column, quantities};

/// Reads them off an image and its world.
pub(super) fn columns(names: &Names, image: &Image, world: &World) -> Vec<Column> {
    let mut bits: BTreeSet<u32> = world.driven_inputs().into_iter().collect();
    for unit in image.units() {
        let instructions = unit.decode().unwrap_or_default();
        bits.extend(
            instructions.iter().filter_map(|instruction| switched_bit(instruction, image)).filter(|bit| is_shown(*bit)),
        );
    }
    let axes = names.axes().flat_map(|(axis, owner)| quantities::main_columns(axis, owner));
    let bits = bits.into_iter().map(|bit| {
        let label = names.of_bit(bit).map(|name| format!("BIT{bit} {name}"));
        Column { label, ..Column::bit(bit, &format!("BIT{bit}")) }
    });
    axes.chain(bits).collect()
}

/// The flag that `SET`, `CLR` or an assignment switches, when its number is written down.
fn switched_bit(instruction: &Instruction, image: &Image) -> Option<u32> {
    let target = &instruction.items.first()?.node;
    let target = match target {
        Node::Alias { index, .. } => &image.aliases.get(usize::from(*index))?.target,
        _ => target,
    };
    match (instruction.command, target) {
        (command::SET | command::CLR, Node::Long(number)) => u32::try_from(*number).ok(),
        (command::SET | command::CLR | command::ASSIGNMENT, _) => bit_of(target),
        _ => None,
    }
}

/// Outputs and user flags; settings such as limit levels are not worth a lane.
fn is_shown(bit: u32) -> bool {
    let laws = [law::ONBOARD_INPUT, law::ONBOARD_OUTPUT, law::USER_FLAG_1_4, law::USER_FLAG_5];
    laws.iter().any(|law| law.index_of(bit).is_some())
}
