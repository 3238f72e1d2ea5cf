//! Gear, hand wheel, cam, ballscrew, gantry lock, ratchets and limiters (guide, "Gear Profiler", "Cam Profiler", "Setpoint Control Commands").

use acrc_catalog::{CommandId, ObjectKind, command};
use acrc_vm::{ArgValue, Call, Outcome, Reference, Value};

use super::arguments::{real, scalar};
use super::{Action, Context, Entry, settings};
use crate::error::ControllerError;
use crate::motion::{ArrayPlace, Preload, TableKind};

pub(super) const COMMANDS: &[Entry] = &[
    (command::GEAR_ON, Action::Run(switch)),
    (command::GEAR_OFF, Action::Run(switch)),
    (command::GEAR_RES, Action::Run(preload)),
    (command::HDW_ON, Action::Run(switch)),
    (command::HDW_OFF, Action::Run(switch)),
    (command::CAM_ON, Action::Run(switch)),
    (command::CAM_OFF, Action::Run(switch)),
    (command::CAM_RES, Action::Run(preload)),
    (command::CAM_DIM, Action::Run(dimension)),
    (command::CAM_SEG, Action::Run(segment)),
    (command::CAM_CLEAR, Action::Run(clear)),
    (command::CAM_SHIFT, Action::Run(shift)),
    (command::CAM_CYCLE, Action::Run(cycles)),
    (command::BSC_ON, Action::Run(switch)),
    (command::BSC_OFF, Action::Run(switch)),
    (command::BSC_RES, Action::Run(preload)),
    (command::BSC_DIM, Action::Run(dimension)),
    (command::BSC_SEG, Action::Run(segment)),
    (command::BSC_CLEAR, Action::Run(clear)),
    (command::BSC_SHIFT, Action::Run(shift)),
    (command::LOCK, Action::Run(lock)),
    (command::UNLOCK, Action::Run(unlock)),
    (command::NORM, Action::Run(normalize)),
    (command::RATCH_RES, Action::Run(reset_gate)),
    (command::LIMIT_RES, Action::Run(reset_gate)),
];

fn table(id: CommandId) -> TableKind {
    if id.info().name.starts_with("CAM") { TableKind::Cam } else { TableKind::Ballscrew }
}

/// `GEAR ON X Y`: each axis by itself; the program goes on at once.
fn switch(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let axes = context.axes(call)?;
    // All of them or none.
    if !call.command.info().name.ends_with("OFF") {
        axes.iter().try_for_each(|argument| context.machine.may_move(argument.axis))?;
    }
    for argument in axes {
        let axis = argument.axis;
        match call.command {
            command::GEAR_ON => context.machine.switch_gear(axis, true)?,
            command::GEAR_OFF => context.machine.switch_gear(axis, false)?,
            command::HDW_ON => context.machine.switch_hand_wheel(axis, true)?,
            command::HDW_OFF => context.machine.switch_hand_wheel(axis, false)?,
            command::CAM_ON | command::BSC_ON => context.machine.switch_table(axis, table(call.command), true)?,
            _ => context.machine.switch_table(axis, table(call.command), false)?,
        }
    }
    Ok(Outcome::Done)
}

/// `GEAR RES`, `CAM RES` and `BSC RES` clear or preload an offset.
fn preload(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    for argument in context.axes(call)? {
        let offset = match argument.value.numbers(command)?[..] {
            [] => 0.0,
            [offset] => offset,
            _ => return Err(ControllerError::Expected { command, expected: "one offset an axis" }),
        };
        let preload = match call.command {
            command::GEAR_RES => Preload::Gear(offset),
            command::CAM_RES => Preload::CamIntoCoordinated(offset),
            _ => Preload::BallscrewIntoCoordinated(offset),
        };
        context.machine.preload(argument.axis, preload)?;
    }
    Ok(Outcome::Done)
}

fn dimension(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    for argument in context.axes(call)? {
        if let [count] = argument.value.numbers(command)?[..] {
            if count < 1.0 {
                return Err(ControllerError::BadValue {
                    command,
                    problem: format!("{count} is no number of segments"),
                });
            }
            context.machine.dim_table(argument.axis, table(call.command), count as usize)?;
        }
    }
    settings::keep(context, call)
}

/// `CAM SEG X(0, 250, LA0)`: length in counts of the source, and the array of the program that says so.
fn segment(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    let level = || ControllerError::WrongLevel { command, level: context.machine.level.to_string() };
    let task = context.task().ok_or_else(level)?;
    for argument in call.arguments {
        let (axis, value) = context.axis_and_value(call, argument)?;
        let ArgValue::Table { values, table: Reference::Array { class, array } } = value else {
            if *value == ArgValue::None {
                continue;
            }
            return Err(ControllerError::Expected { command, expected: "a segment, its length and an array" });
        };
        let [segment, length] = &values[..] else {
            return Err(ControllerError::Expected { command, expected: "a segment, its length and an array" });
        };
        let segment = index(command, segment)?;
        let place = ArrayPlace { task, class: *class, array: *array };
        context.machine.set_segment(axis, table(call.command), (segment, real(command, length)?), place)?;
    }
    settings::keep(context, call)
}

fn index(command: &'static str, value: &Value) -> Result<usize, ControllerError> {
    let number = real(command, value)?;
    if number < 0.0 {
        return Err(ControllerError::BadValue { command, problem: format!("there is no segment {number}") });
    }
    Ok(number as usize)
}

fn clear(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    for argument in context.axes(call)? {
        context.machine.dim_table(argument.axis, table(call.command), 0)?;
    }
    settings::forget(context, call)
}

/// The shift that an incremental table has built up: set, or reported as it is.
fn shift(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    for argument in context.axes(call)? {
        match argument.value.numbers(command)?[..] {
            [] => {
                let shift = context.machine.table_shift(argument.axis, table(call.command));
                context.report(shift);
            }
            [shift] => context.machine.set_table_shift(argument.axis, table(call.command), shift)?,
            _ => return Err(ControllerError::Expected { command, expected: "one shift an axis" }),
        }
    }
    Ok(Outcome::Done)
}

/// `CAM CYCLE X5` ends the cam after five passes; `CAM CYCLE X` reports those since `CAM ON`.
fn cycles(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    for argument in context.axes(call)? {
        match argument.value.numbers(command)?[..] {
            [] => {
                let cycles = context.machine.axes[usize::from(argument.axis)].profilers.cam.cycles();
                context.report(cycles as f64);
            }
            [count] if (0.0..=f64::from(u32::MAX)).contains(&count) => {
                context.machine.set_cam_cycles(argument.axis, count as u32);
            }
            [count] => {
                return Err(ControllerError::BadValue { command, problem: format!("{count} is no number of passes") });
            }
            _ => return Err(ControllerError::Expected { command, expected: "one count an axis" }),
        }
    }
    Ok(Outcome::Done)
}

/// `LOCK Y X`: Y follows X.
fn lock(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let axes = context.axes(call)?;
    if axes.is_empty() || axes.len() % 2 != 0 {
        return Err(ControllerError::Expected {
            command: "LOCK",
            expected: "pairs of axes: the follower and its leader",
        });
    }
    for pair in axes.chunks_exact(2) {
        context.machine.lock(pair[0].axis, pair[1].axis)?;
    }
    Ok(Outcome::Done)
}

fn unlock(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    for argument in context.axes(call)? {
        context.machine.unlock(argument.axis)?;
    }
    Ok(Outcome::Done)
}

/// `NORM X360` folds the position of a rotary axis; without a length that of `ROTARY` counts.
fn normalize(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    for argument in context.axes(call)? {
        let length = match argument.value.numbers(command)?[..] {
            [] => context.machine.first_setting(command::ROTARY, u16::from(argument.axis)),
            [length] => length,
            _ => return Err(ControllerError::Expected { command, expected: "one length an axis" }),
        };
        if length <= 0.0 {
            let problem = format!("AXIS{} has no rotary length to be folded to", argument.axis);
            return Err(ControllerError::BadValue { command, problem });
        }
        context.machine.preload(argument.axis, Preload::Fold(length))?;
    }
    Ok(Outcome::Done)
}

fn reset_gate(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    let Some((kind, Some(index))) = call.prefix else {
        return Err(ControllerError::Expected { command, expected: "an object: RATCH0 RES" });
    };
    if scalar(call)?.is_some_and(|value| value != 0.0) {
        let problem = "what a value other than 0 does is not known".to_owned();
        return Err(ControllerError::BadValue { command, problem });
    }
    context.machine.reset_gate(kind == ObjectKind::Ratch, usize::from(index));
    Ok(Outcome::Done)
}
