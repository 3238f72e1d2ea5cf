//! The PLC ladder commands (`plc_ladder.toml`; `docs/fidelity.md`, "PLC programs").

use acrc_catalog::{CommandId, command};
use acrc_vm::{Arg, Call, Outcome};

use super::{Action, Context, Entry};
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::plc::{Join, Ladder};

pub(super) const COMMANDS: &[Entry] = &[
    (command::LD, Action::Precise(contact)),
    (command::LD_NOT, Action::Precise(contact)),
    (command::AND, Action::Precise(contact)),
    (command::AND_NOT, Action::Precise(contact)),
    (command::OR, Action::Precise(contact)),
    (command::OR_NOT, Action::Precise(contact)),
    (command::AND_LD, Action::Precise(join)),
    (command::OR_LD, Action::Precise(join)),
    (command::OUT, Action::Precise(output)),
    (command::OUT_NOT, Action::Precise(output)),
    (command::KR, Action::Precise(latch)),
    (command::TIM, Action::Precise(timer)),
    (command::CNT, Action::Precise(counter)),
];

/// `LD n`, `AND n`, `OR n` and their inverses.
fn contact(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let (join, inverted) = match call.command {
        command::LD => (Join::Load, false),
        command::LD_NOT => (Join::Load, true),
        command::AND => (Join::And, false),
        command::AND_NOT => (Join::And, true),
        command::OR => (Join::Or, false),
        _ => (Join::Or, true),
    };
    let state = context.read_flag(flag(call)?)? != inverted;
    let joined = context.ladder(call)?.contact(join, state);
    done(call, joined, "LD")
}

/// `AND LD`, `OR LD`
fn join(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let join = if call.command == command::AND_LD { Join::And } else { Join::Or };
    let joined = context.ladder(call)?.join(join);
    done(call, joined, TWO_BLOCKS)
}

/// `OUT n`, `OUT NOT n`
fn output(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let number = flag(call)?;
    let state = context.ladder(call)?.drive().ok_or_else(|| incomplete(call.command, "LD"))?;
    context.drive_flag(number, state != (call.command == command::OUT_NOT))?;
    Ok(Outcome::Done)
}

/// `KR n`: the first rung sets the flag, the second one clears it and prevails.
fn latch(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let number = flag(call)?;
    let (set, reset) = context.ladder(call)?.pair().ok_or_else(|| incomplete(call.command, TWO_BLOCKS))?;
    let state = !reset && (set || context.read_flag(number)?);
    context.ladder(call)?.leave(state);
    context.drive_flag(number, state)?;
    Ok(Outcome::Done)
}

/// `TIM n preset`, in milliseconds.
fn timer(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let (index, preset) = numbers(call)?;
    let clock = context.machine.clock;
    let preset = clock.tick_at(f64::from(preset) / 1000.0);
    let timed = context.ladder(call)?.timer(index, preset, clock.ticks());
    done(call, timed, "LD")
}

/// `CNT n preset`
fn counter(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let (index, preset) = numbers(call)?;
    let counted = context.ladder(call)?.counter(index, preset);
    done(call, counted, TWO_BLOCKS)
}

const TWO_BLOCKS: &str = "two blocks that begin with LD";

fn done(call: &Call, fits: Option<()>, needed: &'static str) -> Result<Outcome, ControllerError> {
    fits.map(|()| Outcome::Done).ok_or_else(|| incomplete(call.command, needed))
}

fn incomplete(command: CommandId, needed: &'static str) -> ControllerError {
    ControllerError::Rung { command: command.info().name, needed }
}

fn flag(call: &Call) -> Result<i64, ControllerError> {
    match call.arguments {
        [Arg::Bit { index, negative: false }] => Ok(*index),
        _ => Err(ControllerError::Expected { command: call.command.info().name, expected: "one flag" }),
    }
}

/// The number of a timer or counter, and its preset, which is not negative.
fn numbers(call: &Call) -> Result<(i32, i32), ControllerError> {
    let command = call.command.info().name;
    let expected = ControllerError::Expected { command, expected: "a number and a preset" };
    let [Arg::Value(index, _), Arg::Value(preset, _)] = call.arguments else { return Err(expected) };
    let (Ok(index), Ok(preset)) = (index.to_long(), preset.to_long()) else { return Err(expected) };
    if preset < 0 {
        return Err(ControllerError::BadValue { command, problem: format!("a preset of {preset} is not possible") });
    }
    Ok((index, preset))
}

impl Context<'_> {
    /// The ladder of the PLC program that executes a command.
    fn ladder(&mut self, call: &Call) -> Result<&mut Ladder, ControllerError> {
        let level = if self.program.is_some() { "program".to_owned() } else { self.machine.level.to_string() };
        let command = call.command.info().name;
        self.ladder.as_deref_mut().ok_or(ControllerError::WrongLevel { command, level })
    }

    /// Gives a flag the state of a rung. A flag that has it already is left alone, which is the same and wakes nobody; one that cannot be driven
    /// is a mistake whatever its state.
    fn drive_flag(&mut self, number: i64, state: bool) -> Result<(), ControllerError> {
        let settled = self.read_flag(number)? == state && !Machine::is_read_only(number);
        if settled { Ok(()) } else { self.write_flag(number, state) }
    }
}
