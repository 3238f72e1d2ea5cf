//! Moves that wait for something, and moves that something ends or redirects (guide, command list: `TRG`, `INT`, `TRJ`,
//! `HSINT`, `SYNC`).

use acrc_catalog::{ObjectKind, command, law};
use acrc_vm::{Arg, Call, Outcome};

use super::captures::mode;
use super::moves::refused;
use super::{Action, Context, Entry};
use crate::coordination::{Condition, Redirection};
use crate::error::ControllerError;
use crate::flags::Flags;
use crate::machine::Machine;

pub(super) const COMMANDS: &[Entry] = &[
    (command::TRG, Action::Run(trigger)),
    (command::INT, Action::Run(interruptible)),
    (command::TRJ, Action::Run(new_trajectory)),
    (command::HSINT, Action::Run(redirected)),
    (command::SYNC_ON, Action::Run(join)),
    (command::SYNC_OFF, Action::Run(leave)),
];

/// `TRG 32`, `TRG -32`: the next move waits for the flag.
fn trigger(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let master = usize::from(context.machine.master_of(context.program(call)?)?);
    let [argument] = call.arguments else {
        return Err(ControllerError::Expected { command: call.command.info().name, expected: "one flag" });
    };
    context.machine.masters[master].ahead.gate = Some(condition(call, argument)?);
    Ok(Outcome::Done)
}

/// `INT -32 X10`: the move ends early when the flag is clear.
fn interruptible(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let master = context.movable(call)?;
    let Some((flag, moves)) = call.arguments.split_first() else {
        return Err(ControllerError::Expected { command: call.command.info().name, expected: "a flag and a move" });
    };
    let condition = condition(call, flag)?;
    if !context.takes_move(master) {
        return Ok(Outcome::Again);
    }
    let next = context.statement(call, moves)?.interruptible(condition.code());
    context.queue(call, master, &next)
}

/// `TRJ X10`: takes the place of the move that runs and of those that wait.
fn new_trajectory(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let master = context.movable(call)?;
    let next = context.statement(call, call.arguments)?;
    let machine = &mut *context.machine;
    machine.prepare_master(master)?;
    machine.masters[master].forget();
    machine.masters[master].profiler.replace(&next).map_err(|error| refused(call.command, error))?;
    machine.begin_moves(master);
    Ok(Outcome::Done)
}

/// `HSINT X(mode, target, width, access, window, wraps, abort)`: a move that ends `width` behind where the axis is captured.
fn redirected(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    let master = context.movable(call)?;
    // A capture belongs to one move: that of another one is not to be taken for it.
    if !context.machine.stands(master) {
        return Ok(Outcome::Again);
    }
    let [argument] = &context.axes(call)?[..] else {
        return Err(ControllerError::Expected { command, expected: "one axis" });
    };
    let values = argument.value.numbers(command)?;
    let [number, target, width, ref rest @ ..] = values[..] else {
        return Err(ControllerError::Expected { command, expected: "mode, target and width at least" });
    };
    let slot = context.slot(call, master, argument.axis)?;
    let from = context.machine.masters[master].profiler.target(slot);
    let mode = mode(command, number)?;
    let abort = rest.get(3).map(|flag| flag_state(*flag)).transpose()?;
    let redirection = Redirection { axis: argument.axis, slot, mode, width, window: window(from, target, rest), abort };
    let axis = u32::from(argument.axis);
    let captured = Condition { flag: law::CAPTURE_COMPLETE.at(axis), state: true };
    let mut next = context.statement(call, &[])?.interruptible(captured.code());
    next.targets[slot] = Some(acrc_motion::Target::Absolute(target));
    for flag in [law::HSINT_REGISTERED, law::HSINT_ABORTED] {
        context.machine.flags.set_law(flag, axis, false);
    }
    context.machine.arm_capture(argument.axis, mode, argument.axis);
    let outcome = context.queue(call, master, &next)?;
    let state = &mut context.machine.masters[master];
    state.ahead.redirection = state.profiler.in_motion().then_some(redirection);
    Ok(outcome)
}

/// Where captures count: from `access` on the way, over `window`; zero is no limit.
fn window(from: f64, target: f64, rest: &[f64]) -> (f64, f64) {
    let [access, window] = [0, 1].map(|place| rest.get(place).copied().unwrap_or(0.0).abs());
    let way = if target < from { -1.0 } else { 1.0 };
    let begin = if access > 0.0 { from + way * access } else { -way * f64::INFINITY };
    let end = if window > 0.0 { from + way * (access + window) } else { way * f64::INFINITY };
    (begin.min(end), begin.max(end))
}

/// `SYNC ON MASTER0 MASTER1`: the moves of these masters begin together. Without masters the one of the program joins
/// those that do so already.
fn join(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let mut group = context.listed_masters(call)?;
    let masters = &mut context.machine.masters;
    if call.arguments.is_empty() {
        group = masters.iter().fold(group, |all, master| all | master.group);
    }
    let joined =
        masters.iter().filter(|master| master.group & group != 0).fold(group, |all, master| all | master.group);
    for (_, master) in masters.iter_mut().enumerate().filter(|(index, _)| joined >> index & 1 == 1) {
        master.group = joined;
        master.profiler.set_synchronised(true);
    }
    context.machine.start_groups();
    Ok(Outcome::Done)
}

/// `SYNC OFF MASTER1`: these masters go on alone.
fn leave(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let leaving = context.listed_masters(call)?;
    context.machine.leave_groups(leaving);
    Ok(Outcome::Done)
}

impl Machine {
    /// Lets masters, as bits, go on alone.
    pub(super) fn leave_groups(&mut self, leaving: u32) {
        for index in 0..self.masters.len() {
            let master = &mut self.masters[index];
            let leaves = leaving >> index & 1 == 1;
            master.group = if leaves { 0 } else { master.group & !leaving };
            if leaves {
                master.profiler.set_synchronised(false);
                self.update_master_flags(index);
            }
        }
        self.start_groups();
    }
}

impl Context<'_> {
    /// The masters that a call lists, or the one of the program, as bits.
    fn listed_masters(&self, call: &Call) -> Result<u32, ControllerError> {
        if call.arguments.is_empty() {
            return Ok(1 << self.master(call)?);
        }
        call.arguments.iter().try_fold(0, |all, argument| match argument {
            Arg::Object { kind: ObjectKind::Master, index: Some(index), .. } => {
                let index = Machine::object("MASTER", i64::from(*index), self.machine.model.masters)?;
                Ok(all | 1 << index)
            }
            _ => Err(ControllerError::Expected { command: call.command.info().name, expected: "masters" }),
        })
    }
}

/// A flag that is set, or clear behind a minus.
fn condition(call: &Call, argument: &Arg) -> Result<Condition, ControllerError> {
    match argument {
        Arg::Bit { index, negative } => flag(*index, !negative),
        _ => Err(ControllerError::Expected { command: call.command.info().name, expected: "a flag" }),
    }
}

/// The same as a number.
fn flag_state(number: f64) -> Result<Condition, ControllerError> {
    flag(number.abs() as i64, number.is_sign_positive())
}

fn flag(index: i64, state: bool) -> Result<Condition, ControllerError> {
    let flag = u32::try_from(index).ok().filter(|flag| Flags::contains(*flag));
    flag.map(|flag| Condition { flag, state }).ok_or(ControllerError::UnknownBit(index))
}
