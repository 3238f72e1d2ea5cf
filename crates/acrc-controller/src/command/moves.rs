//! Coordinated moves (guide, "Making Motion").

use acrc_catalog::{ObjectKind, command, law, message};
use acrc_motion::{Move, PushError, Target};
use acrc_vm::{Arg, ArgValue, Call, Outcome};

use super::arguments::real;
use super::{Action, Context, Entry};
use crate::error::ControllerError;

pub(super) const COMMANDS: &[Entry] = &[(command::AXIS_MOVE, Action::Run(linear)), (command::MOV, Action::Run(linear))];

/// A linear move: queued when there is room, offered again when there is none.
fn linear(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let program = context.program(call)?;
    let master = usize::from(context.machine.master_of(program)?);
    let kamr = |axis| context.machine.flags.get(law::KILL_ALL_MOTION_REQUEST.at(u32::from(axis)));
    if context.machine.masters[master].attached().any(|(_, axis)| kamr(axis)) {
        return Err(ControllerError::Said(message::SLAVE_KILLED));
    }
    let killed = law::KILL_ALL_MOVES.at(master as u32);
    if context.machine.flags.get(killed) {
        return Err(ControllerError::Killed { master: master as u8, bit: killed });
    }
    if !context.machine.masters[master].profiler.can_accept() {
        return Ok(Outcome::Again);
    }
    let settings = context.machine.masters[master].settings;
    let mut next = Move::new(settings);
    for argument in call.arguments {
        let (slot, target) = context.target(program, call, argument)?;
        if next.targets[slot].replace(target).is_some() {
            let problem = format!("the axis in SLAVE{slot} is given two targets");
            return Err(ControllerError::BadValue { command: call.command.info().name, problem });
        }
    }
    if settings.velocity == 0.0 {
        let problem = format!("the velocity of master {master} is 0, so the move would never end; VEL sets it");
        return Err(ControllerError::BadValue { command: call.command.info().name, problem });
    }
    let result = context.machine.masters[master].profiler.push(&next);
    match result {
        Ok(()) => {}
        Err(PushError::Full | PushError::Stopping) => return Ok(Outcome::Again),
        Err(error) => return Err(ControllerError::Move(error.to_string())),
    }
    context.machine.update_master_flags(master);
    Ok(Outcome::Done)
}

impl Context<'_> {
    /// Slot and target of one axis of a move.
    fn target(&self, program: u8, call: &Call, argument: &Arg) -> Result<(usize, Target), ControllerError> {
        let command = call.command.info().name;
        let (name, slash, value) = match argument {
            Arg::Axis { name, slash, value } => (*name, *slash, value),
            Arg::Interpolation(interpolation) => return Err(ControllerError::NotSimulated(*interpolation)),
            Arg::Object { kind: ObjectKind::Axis, .. } => {
                return Err(ControllerError::Expected {
                    command,
                    expected: "axis names: a coordinated move takes no AXISn",
                });
            }
            _ => return Err(ControllerError::Expected { command, expected: "axis names with targets" }),
        };
        let axis = self.machine.named_axis(program, name)?;
        let ArgValue::Value(value) = value else {
            return Err(ControllerError::Expected { command, expected: "one target behind each axis" });
        };
        let slave = self.machine.axes[usize::from(axis)].slave;
        let slave = slave.ok_or(ControllerError::UnknownAxis { program, name: name.to_string() })?;
        let value = real(command, value)?;
        let target = if slash { Target::Relative(value) } else { Target::Absolute(value) };
        Ok((usize::from(slave.slot), target))
    }
}
