//! Waiting (guide, "Logic Function").

use acrc_catalog::command;
use acrc_vm::{Arg, Call, Outcome};

use super::arguments::scalar;
use super::{Action, Context, Entry};
use crate::error::ControllerError;

pub(super) const COMMANDS: &[Entry] = &[(command::INH, Action::Run(inhibit)), (command::DWL, Action::Run(dwell))];

/// Longest dwell in seconds that a run accepts, about thirty years.
const LONGEST_DWELL: f64 = 1e9;

fn bit(call: &Call) -> Result<(i64, bool), ControllerError> {
    match call.arguments {
        [Arg::Bit { index, negative }] => Ok((*index, *negative)),
        _ => Err(ControllerError::Expected { command: call.command.info().name, expected: "one flag" }),
    }
}

/// `INH n` waits for a set flag, `INH -n` for a clear one.
fn inhibit(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let (index, negative) = bit(call)?;
    let waited_for = !negative;
    Ok(if context.machine.read_bit(index)? == waited_for { Outcome::Done } else { Outcome::Again })
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
