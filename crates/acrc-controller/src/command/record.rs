//! Limit switches and data sampling, which work with arrays of programs (guide, command list: `PLS`, `SAMP`).

use acrc_catalog::{CommandId, ObjectKind, command};
use acrc_vm::{Arg, Call, Outcome, Reference};

use super::{Action, Context, Entry, settings};
use crate::error::ControllerError;
use crate::motion::ArrayPlace;

pub(super) const COMMANDS: &[Entry] = &[
    (command::PLS_BASE, Action::Run(array)),
    (command::PLS_ON, Action::Run(switch)),
    (command::PLS_OFF, Action::Run(switch)),
    (command::SAMP_BASE, Action::Run(array)),
    (command::SAMP_CLEAR, Action::Run(clear)),
];

/// The object that a command is for.
fn object(call: &Call, kind: ObjectKind) -> Result<usize, ControllerError> {
    match call.prefix {
        Some((prefix, Some(index))) if prefix == kind => Ok(usize::from(index)),
        _ => Err(ControllerError::Expected {
            command: call.command.info().name,
            expected: "a number behind its first word",
        }),
    }
}

fn kind(id: CommandId) -> ObjectKind {
    if id == command::SAMP_BASE { ObjectKind::Samp } else { ObjectKind::Pls }
}

/// `PLS0 BASE LA0`, `SAMP0 BASE LA1`: an array of the program that says so.
fn array(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    if let [argument] = call.arguments {
        let number = object(call, kind(call.command))?;
        let Arg::Reference { target: Reference::Array { class, array }, negative: false, .. } = argument else {
            return Err(ControllerError::Expected { command, expected: "an array" });
        };
        let level = || ControllerError::WrongLevel { command, level: context.machine.level.to_string() };
        let place = ArrayPlace { task: context.task().ok_or_else(level)?, class: *class, array: *array };
        match kind(call.command) {
            ObjectKind::Samp => context.machine.set_sample_array(number, place),
            _ => context.machine.set_limit_switch_table(number, place),
        }
    }
    settings::keep(context, call)
}

fn switch(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let number = object(call, ObjectKind::Pls)?;
    context.machine.set_limit_switch(number, call.command == command::PLS_ON);
    Ok(Outcome::Done)
}

fn clear(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    context.machine.clear_sampling();
    settings::forget(context, call)
}
