//! What an image asks for that this controller does not do; known before a run begins.

use acrc_catalog::{CommandId, command};
use acrc_image::{Image, Node, Unit, UnitName};
use thiserror::Error;

use super::Controller;
use super::starts::reached;
use crate::command::supported;
use crate::error::not_simulated;

/// A command in the image that the dry run does not execute.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{}", not_simulated(*.command))]
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
    /// The commands that this controller does not execute: of setup code, of the given programs and PLC programs, of the PLC programs that start by
    /// themselves, and of whatever one of these starts.
    pub fn unsupported(image: &Image, programs: &[u8], plcs: &[u8]) -> Vec<Unsupported> {
        let booting = image.programs.iter().filter(|unit| Self::boots_as_plc(unit)).map(|unit| unit.name);
        let programs = programs.iter().copied().map(UnitName::Program);
        let first = programs.chain(plcs.iter().copied().map(UnitName::Plc)).chain(booting);
        let mut found = Vec::new();
        for unit in std::iter::once(&image.boot).chain(reached(image, first)) {
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
