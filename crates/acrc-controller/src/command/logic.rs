//! Waiting, and bits of a parameter (guide, "Logic Function", "Other Conditional Statements").

use acrc_catalog::{command, law};
use acrc_vm::{Arg, Call, Host, Outcome, Reference, Value};

use super::arguments::{real, scalar};
use super::{Action, Context, Entry};
use crate::error::ControllerError;
use crate::program::Alarm;

pub(super) const COMMANDS: &[Entry] = &[
    (command::SET, Action::Precise(set)),
    (command::CLR, Action::Precise(set)),
    (command::INH, Action::Precise(inhibit)),
    (command::IHPOS, Action::Precise(inhibit_on_position)),
    (command::DWL, Action::Run(dwell)),
    (command::MASK, Action::Run(mask)),
];

/// Longest dwell in seconds that a run accepts, about thirty years.
const LONGEST_DWELL: f64 = 1e9;

fn bit(call: &Call) -> Result<(i64, bool), ControllerError> {
    match call.arguments {
        [Arg::Bit { index, negative }] => Ok((*index, *negative)),
        _ => Err(ControllerError::Expected { command: call.command.info().name, expected: "one flag" }),
    }
}

/// `SET` and `CLR` in the forms that the VM leaves to its host: flags whose number is computed from constants, and mistakes.
fn set(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let (index, negative) = bit(call)?;
    if negative {
        let problem = "a flag has no sign here: SET switches it on, CLR switches it off".to_owned();
        return Err(ControllerError::BadValue { command: call.command.info().name, problem });
    }
    context.write_flag(index, call.command == command::SET)?;
    Ok(Outcome::Done)
}

/// `INH n` waits for a set flag, `INH -n` for a clear one.
fn inhibit(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let (index, negative) = bit(call)?;
    let waited_for = !negative;
    Ok(if context.read_flag(index)? == waited_for { Outcome::Done } else { Outcome::Again })
}

/// `DWL`: the tick of its end is fixed when it begins.
fn dwell(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let clock = context.machine.clock;
    if call.first {
        let command = call.command.info().name;
        let seconds = scalar(call)?.ok_or(ControllerError::Expected { command, expected: "a time in seconds" })?;
        if !(0.0..=LONGEST_DWELL).contains(&seconds) {
            return Err(ControllerError::BadValue {
                command,
                problem: format!("a time of {seconds} seconds is not possible"),
            });
        }
        *context.release = Some(clock.ticks() + clock.tick_at(seconds));
    }
    match *context.release {
        Some(tick) if clock.ticks() < tick => Ok(Outcome::Again),
        _ => {
            *context.release = None;
            Ok(Outcome::Done)
        }
    }
}

/// `IHPOS P (setpoint, timeout)` waits until the parameter is above the setpoint, or with a minus below it. A timeout of 0 never ends.
fn inhibit_on_position(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    let (number, negative, values) = parameter_and_tuple(call)?;
    let [setpoint, timeout] = values else {
        return Err(ControllerError::Expected { command, expected: "a setpoint and a timeout" });
    };
    let (setpoint, timeout) = (real(command, setpoint)?, real(command, timeout)?);
    let clock = context.machine.clock;
    if call.first {
        if !(0.0..=LONGEST_DWELL).contains(&timeout) {
            let problem = format!("a timeout of {timeout} seconds is not possible");
            return Err(ControllerError::BadValue { command, problem });
        }
        context.alarm.timeout = (timeout > 0.0).then(|| clock.ticks() + clock.tick_at(timeout));
    }
    let value = real(command, &context.parameter(number).map_err(ControllerError::Program)?)?;
    let passed = if negative { value < setpoint } else { value > setpoint };
    let over = context.alarm.timeout.is_some_and(|tick| clock.ticks() >= tick);
    if passed || over {
        *context.alarm = Alarm::default();
        return Ok(Outcome::Done);
    }
    if number == i64::from(law::CLOCK_MS.at(0)) && !negative {
        // A little early at most: it looks again then.
        let wait = clock.tick_at((setpoint - value).clamp(0.0, LONGEST_DWELL * 1000.0) / 1000.0);
        context.alarm.look = Some(clock.ticks() + wait.max(1));
    }
    Ok(Outcome::Again)
}

/// `MASK P (nand, or)` clears the bits of the first mask, then sets those of the second.
fn mask(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let (number, negative, values) = parameter_and_tuple(call)?;
    let [clear, set] = values else {
        return Err(ControllerError::Expected { command: "MASK", expected: "two masks" });
    };
    if negative {
        return Err(ControllerError::Expected { command: "MASK", expected: "a parameter without a sign" });
    }
    let long = |value: &Value| value.to_long().map_err(ControllerError::Program);
    let before = long(&context.machine.read_parameter(number)?)?;
    let after = before & !long(clear)? | long(set)?;
    context.machine.write_parameter(number, &Value::Long(after))?;
    Ok(Outcome::Done)
}

/// A parameter, the sign in front of it, and the values behind it.
fn parameter_and_tuple<'c>(call: &Call<'c>) -> Result<(i64, bool, &'c [Value]), ControllerError> {
    match call.arguments {
        [Arg::Reference { target: Reference::Parameter(number), negative, .. }, Arg::Tuple(values)] => {
            Ok((*number, *negative, values))
        }
        _ => Err(ControllerError::Expected { command: call.command.info().name, expected: "a parameter and a tuple" }),
    }
}
