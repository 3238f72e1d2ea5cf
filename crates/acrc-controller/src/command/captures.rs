//! Captures of positions, and the search for the marks of encoders (guide, "Homing"; `INTCAP`, `MSEEK`).

use acrc_catalog::{ObjectKind, command};
use acrc_motion::{Move, Target};
use acrc_vm::{Arg, Call, Outcome};

use super::arguments::{AxisValue, real};
use super::{Action, Context, Entry};
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::mechanics::{Seek, sought};

pub(super) const COMMANDS: &[Entry] = &[(command::INTCAP, Action::Run(capture)), (command::MSEEK, Action::Run(seek))];

/// What one axis captures.
struct Order {
    axis: u8,
    mode: u8,
    encoder: u8,
}

/// `INTCAP X0`, `INTCAP X 0 ENC1 Y 4`, `AXIS0 INTCAP 0`: the next mark or input captures the position.
fn capture(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    let prefixed = match call.prefix {
        Some((ObjectKind::Axis, Some(index))) => Some(context.axis(i64::from(index))?),
        _ => None,
    };
    let mut orders: Vec<Order> = Vec::new();
    for argument in call.arguments {
        let (axis, value) = match (argument, prefixed) {
            (Arg::Object { kind: ObjectKind::Encoder, index: Some(index), .. }, _) => {
                let order =
                    orders.last_mut().ok_or(ControllerError::Expected { command, expected: "an axis first" })?;
                order.encoder = Machine::object("ENC", i64::from(*index), context.machine.model.axes)?;
                continue;
            }
            (Arg::Value(value, _), Some(axis)) => (axis, value),
            _ => match context.axis_argument(command, argument, call)? {
                argument if let AxisValue::One(value) = argument.value => (argument.axis, value),
                _ => return Err(ControllerError::Expected { command, expected: "a mode behind each axis" }),
            },
        };
        orders.push(Order { axis, mode: mode(command, real(command, value)?)?, encoder: axis });
    }
    for Order { axis, mode, encoder } in orders {
        context.machine.arm_capture(axis, mode, encoder);
    }
    Ok(Outcome::Done)
}

/// `MSEEK X(1,0)`: an incremental move that looks for the mark and returns to it; there is zero then. Moves behind it wait for its end.
fn seek(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    let master = context.movable(call)?;
    if !context.machine.stands(master) {
        return Ok(Outcome::Again);
    }
    let mut axes = Vec::new();
    let settings = context.machine.masters[master].move_settings();
    let mut next = Move::new(settings);
    for argument in context.axes(call)? {
        let [distance, number] = argument.value.numbers(command)?[..] else {
            return Err(ControllerError::Expected { command, expected: "distance and mode of each axis" });
        };
        let slot = context.slot(call, master, argument.axis)?;
        next.targets[slot] = Some(Target::Relative(distance));
        axes.push((argument.axis, slot, mode(command, number)?));
    }
    let Some((first, ..)) = axes.first() else {
        return Err(ControllerError::Expected { command, expected: "distance and mode of an axis" });
    };
    let next = next.interruptible(sought(*first).code());
    // Before the move begins, which what was captured earlier would end.
    for (axis, _, mode) in &axes {
        context.machine.arm_capture(*axis, *mode, *axis);
    }
    let outcome = context.queue(call, master, &next)?;
    if outcome == Outcome::Done {
        let seek = Seek::new(axes.iter().map(|(axis, slot, _)| (*axis, *slot)), settings);
        context.machine.begin_seek(master, seek);
    }
    Ok(outcome)
}

/// A capture mode.
pub(super) fn mode(command: &'static str, number: f64) -> Result<u8, ControllerError> {
    if number.trunc() == number && (0.0..16.0).contains(&number) {
        return Ok(number as u8);
    }
    let problem = format!("{number} is no capture mode: they are numbered 0 to 15");
    Err(ControllerError::BadValue { command, problem })
}
