//! What an image asks for that this controller does not do; known before a run begins.

use acrc_catalog::{CommandId, command};
use acrc_image::{Image, Node, Unit, UnitName};
use thiserror::Error;

use super::Controller;
use crate::command::supported;

/// A command in the image that the dry run does not execute.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{} is not simulated", .command.info().name)]
pub struct Unsupported {
    /// The command.
    pub command: CommandId,
    /// The unit.
    pub unit: UnitName,
    /// Source file, when known.
    pub file: Option<String>,
    /// Line, from 1, when known.
    pub line: Option<u32>,
}

impl Controller {
    /// The commands of setup code, of the given programs, and of the PLC programs that start by themselves, that this controller does not execute.
    pub fn unsupported(image: &Image, programs: &[u8]) -> Vec<Unsupported> {
        let wanted = |unit: &&Unit| match unit.name {
            UnitName::Program(number) => programs.contains(&number),
            UnitName::Plc(_) => Self::boots_as_plc(unit),
            UnitName::Boot => false,
        };
        let mut found = Vec::new();
        for unit in std::iter::once(&image.boot).chain(image.programs.iter().filter(wanted)) {
            for instruction in unit.decode().unwrap_or_default() {
                let parts = instruction.items.iter().filter_map(|item| match item.node {
                    Node::Interpolation(command) => Some(command),
                    _ => None,
                });
                let Some(command) = std::iter::once(instruction.command).chain(parts).find(|part| !executed(*part))
                else {
                    continue;
                };
                let place = unit.debug.as_ref().and_then(|debug| debug.locate(instruction.address));
                found.push(Unsupported {
                    command,
                    unit: unit.name,
                    file: place.and_then(|place| image.files.get(place.file as usize).cloned()),
                    line: place.map(|place| place.line),
                });
            }
        }
        found
    }

    /// Whether a text is a PLC program that starts at power-up.
    pub fn boots_as_plc(unit: &Unit) -> bool {
        matches!(unit.name, UnitName::Plc(_)) && boots(unit)
    }

    /// Programs whose first statement is `PBOOT`.
    pub fn boot_programs(image: &Image) -> Vec<u8> {
        let numbers = image.programs.iter().filter(|unit| boots(unit)).filter_map(|unit| match unit.name {
            UnitName::Program(number) => Some(number),
            UnitName::Boot | UnitName::Plc(_) => None,
        });
        numbers.collect()
    }
}

/// Whether a text begins with `PBOOT`.
pub(crate) fn boots(unit: &Unit) -> bool {
    let instructions = unit.decode().unwrap_or_default();
    let passed = |command: CommandId| matches!(command, command::REM | command::LINE_NUMBER);
    let first = instructions.iter().find(|instruction| !passed(instruction.command));
    first.is_some_and(|instruction| instruction.command == command::PBOOT)
}

/// Whether the controller or the VM executes a command.
fn executed(command: CommandId) -> bool {
    supported(command) || acrc_vm::executes(command)
}
