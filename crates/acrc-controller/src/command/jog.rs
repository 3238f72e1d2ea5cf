//! Jog and homing commands (guide, "Jog Profiler", "Homing").

use acrc_catalog::{CommandId, command};
use acrc_motion::axis::Side;
use acrc_vm::{Call, Outcome};

use super::arguments::AxisValue;
use super::{Action, Context, Entry};
use crate::error::ControllerError;
use crate::motion::{JogOrder, Preload};

pub(super) const COMMANDS: &[Entry] = &[
    (command::JOG_ABS, Action::Run(jog)),
    (command::JOG_INC, Action::Run(jog)),
    (command::JOG_FWD, Action::Run(jog)),
    (command::JOG_REV, Action::Run(jog)),
    (command::JOG_OFF, Action::Run(jog)),
    (command::JOG_HOME, Action::Run(home)),
    (command::JOG_REN, Action::Run(transfer)),
    (command::JOG_RES, Action::Run(transfer)),
];

/// Starts or ends a jog of each axis named. The program goes on at once.
fn jog(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let mut orders = Vec::new();
    for argument in context.axes(call)? {
        orders.push((argument.axis, order(call.command, argument.value)?));
    }
    // All of them or none.
    for (axis, _) in orders.iter().filter(|(_, order)| *order != JogOrder::Off) {
        context.machine.may_move(*axis)?;
    }
    for (axis, order) in orders {
        context.machine.jog(axis, order)?;
    }
    Ok(Outcome::Done)
}

fn order(id: CommandId, value: AxisValue) -> Result<JogOrder, ControllerError> {
    let name = id.info().name;
    let numbers = value.numbers(name)?;
    Ok(match (id, &numbers[..]) {
        (command::JOG_ABS, [target]) => JogOrder::To(*target),
        (command::JOG_INC, [distance]) => JogOrder::By(*distance),
        (command::JOG_FWD, []) => JogOrder::Run(Side::Positive),
        (command::JOG_REV, []) => JogOrder::Run(Side::Negative),
        (command::JOG_OFF, []) => JogOrder::Off,
        (command::JOG_ABS | command::JOG_INC, _) => {
            return Err(ControllerError::Expected { command: name, expected: "one value behind each axis" });
        }
        _ => return Err(ControllerError::Expected { command: name, expected: "axes without values" }),
    })
}

/// `JOG HOME X1 Y-1`: the sign is the direction of the search.
fn home(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    let mut starts = Vec::new();
    for argument in context.axes(call)? {
        let side = match argument.value.numbers(command)?[..] {
            [direction] if direction > 0.0 => Side::Positive,
            [direction] if direction < 0.0 => Side::Negative,
            _ => return Err(ControllerError::Expected { command, expected: "a direction behind each axis: 1 or -1" }),
        };
        starts.push((argument.axis, side));
    }
    for (axis, _) in &starts {
        context.machine.may_home(*axis)?;
    }
    for (axis, side) in starts {
        context.machine.home(axis, side)?;
    }
    Ok(Outcome::Done)
}

/// `JOG REN` and `JOG RES` move positions between the coordinated profiler and the jog offset. The setpoint stays.
fn transfer(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    for argument in context.axes(call)? {
        let value = match argument.value.numbers(command)?[..] {
            [] => 0.0,
            [value] => value,
            _ => return Err(ControllerError::Expected { command, expected: "one position an axis" }),
        };
        let preload = match call.command {
            command::JOG_REN => Preload::CoordinatedIntoJog(value),
            _ => Preload::JogIntoCoordinated(value),
        };
        context.machine.preload(argument.axis, preload)?;
    }
    Ok(Outcome::Done)
}
