//! Coordinated moves (guide, "Move Types", "Combining Types of Motion").
//!
//! A statement has parts: what stands behind the name of a kind of move, up to the next one, is of that kind. In every
//! part an axis with a single value goes straight.

use acrc_catalog::{CommandId, ObjectKind, command, law, message};
use acrc_motion::{Move, PushError, Sine, Target};
use acrc_vm::{Arg, ArgValue, Call, Outcome};

use super::arcs;
use super::arguments::real;
use super::{Action, Context, Entry, curves};
use crate::error::ControllerError;
use crate::machine::Machine;

pub(super) const COMMANDS: &[Entry] = &[
    (command::AXIS_MOVE, Action::Run(coordinated)),
    (command::MOV, Action::Run(coordinated)),
    (command::CIRCW, Action::Run(coordinated)),
    (command::CIRCCW, Action::Run(coordinated)),
    (command::SINE, Action::Run(coordinated)),
    (command::TARC, Action::Run(coordinated)),
    (command::TARC_ON, Action::Run(arcs::open)),
    (command::TARC_OFF, Action::Run(arcs::close)),
];

/// An axis of a part that takes several values.
pub(super) struct Bent {
    pub(super) slot: usize,
    pub(super) values: Vec<f64>,
}

/// A statement of moves: queued when there is room, offered again when there is none.
fn coordinated(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let master = context.movable(call)?;
    if context.machine.masters[master].ahead.curve.is_some() {
        return context.point(call, master);
    }
    if !context.takes_move(master) {
        return Ok(Outcome::Again);
    }
    let mut next = context.statement(call, call.arguments)?;
    if !context.transform(call, master, &mut next)? {
        return Ok(Outcome::Again);
    }
    if context.machine.pair(master, &mut next)? { context.queue(call, master, &next) } else { Ok(Outcome::Done) }
}

impl Machine {
    /// Refuses moves of a master whose moves, or the motion of whose axes, are killed.
    pub(crate) fn admits_moves(&self, master: usize) -> Result<(), ControllerError> {
        let kamr = |axis| self.flags.get(law::KILL_ALL_MOTION_REQUEST.at(u32::from(axis)));
        if self.masters[master].attached().any(|(_, axis)| kamr(axis)) {
            return Err(ControllerError::Said(message::SLAVE_KILLED));
        }
        let killed = law::KILL_ALL_MOVES.at(master as u32);
        if self.flags.get(killed) {
            return Err(ControllerError::Killed { master: master as u8, bit: killed });
        }
        Ok(())
    }

    /// Queues a move of a kind. False when there is no room for it yet.
    pub(crate) fn queue_move(&mut self, kind: CommandId, master: usize, next: &Move) -> Result<bool, ControllerError> {
        if self.masters[master].ahead.curve.is_some() {
            return Err(curves::open(kind));
        }
        self.prepare_master(master)?;
        let state = &mut self.masters[master];
        let next = state.gated(next);
        match state.profiler.push(&next) {
            Ok(()) => state.ahead.gate = None,
            Err(PushError::Full | PushError::Stopping | PushError::OpenEnd) => return Ok(false),
            Err(error) => return Err(refused(kind, error)),
        }
        self.begin_moves(master);
        Ok(true)
    }

    /// Makes a master ready for a move.
    pub(super) fn prepare_master(&mut self, master: usize) -> Result<(), ControllerError> {
        if !self.moves(master) {
            self.begin_time(master);
        }
        self.take_axes(master)
    }
}

impl Context<'_> {
    /// The master of the program, if its axes may move.
    pub(super) fn movable(&self, call: &Call) -> Result<usize, ControllerError> {
        let master = usize::from(self.machine.master_of(self.program(call)?)?);
        self.machine.admits_moves(master)?;
        moving_velocity(call.command, master, self.machine.masters[master].settings.velocity)?;
        self.transformable(call, master)?;
        Ok(master)
    }

    /// The move of a statement, with the settings of now.
    pub(super) fn statement(&self, call: &Call, arguments: &[Arg]) -> Result<Move, ControllerError> {
        let program = self.program(call)?;
        let master = usize::from(self.machine.master_of(program)?);
        let mut next = Move::new(self.machine.masters[master].move_settings());
        let mut kind = call.command;
        let mut bent: Vec<Bent> = Vec::new();
        for argument in arguments {
            if let Arg::Interpolation(other) = argument {
                part(&mut next, kind, &bent)?;
                bent.clear();
                kind = *other;
                continue;
            }
            if let Arg::Axis { slash: false, value: ArgValue::Tuple(values), .. } = argument {
                let (slot, ..) = self.axis_of_move(kind, program, argument)?;
                let values = values.iter().map(|value| real(kind.info().name, value)).collect::<Result<_, _>>()?;
                bent.push(Bent { slot, values });
            } else {
                let (slot, target) = self.straight_target(kind, program, argument)?;
                to(&mut next, kind, slot, target)?;
            }
        }
        part(&mut next, kind, &bent)?;
        Ok(next)
    }

    /// Slot and target of an axis that goes straight.
    pub(super) fn straight_target(
        &self,
        kind: CommandId,
        program: u8,
        argument: &Arg,
    ) -> Result<(usize, Target), ControllerError> {
        let (slot, slash, value) = self.axis_of_move(kind, program, argument)?;
        let ArgValue::Value(value) = value else {
            let expected = "a target behind each axis, relative ones for straight moves only";
            return Err(ControllerError::Expected { command: kind.info().name, expected });
        };
        let value = real(kind.info().name, value)?;
        Ok((slot, if slash { Target::Relative(value) } else { Target::Absolute(value) }))
    }

    /// Slot, slash and value of one axis of a move.
    fn axis_of_move<'c>(
        &self,
        kind: CommandId,
        program: u8,
        argument: &'c Arg,
    ) -> Result<(usize, bool, &'c ArgValue), ControllerError> {
        let command = kind.info().name;
        let (name, slash, value) = match argument {
            Arg::Axis { name, slash, value } => (*name, *slash, value),
            Arg::Object { kind: ObjectKind::Axis, .. } => {
                return Err(ControllerError::Expected {
                    command,
                    expected: "axis names: a coordinated move takes no AXISn",
                });
            }
            _ => return Err(ControllerError::Expected { command, expected: "axis names with targets" }),
        };
        let axis = self.machine.named_axis(program, name)?;
        let slave = self.machine.axes[usize::from(axis)].slave;
        let slave = slave.ok_or(ControllerError::UnknownAxis { program, name: name.to_string() })?;
        Ok((usize::from(slave.slot), slash, value))
    }

    /// Queues a move, or asks to be offered it again where there is no room yet.
    pub(super) fn queue(&mut self, call: &Call, master: usize, next: &Move) -> Result<Outcome, ControllerError> {
        let queued = self.machine.queue_move(call.command, master, next)?;
        Ok(if queued { Outcome::Done } else { Outcome::Again })
    }
}

/// Refuses a move without velocity, which would never end.
pub(crate) fn moving_velocity(kind: CommandId, master: usize, velocity: f64) -> Result<(), ControllerError> {
    if velocity > 0.0 {
        return Ok(());
    }
    let problem = format!("the velocity of master {master} is 0, so the move would never end; VEL sets it");
    Err(ControllerError::BadValue { command: kind.info().name, problem })
}

/// Adds what the axes with several values make of a part.
fn part(next: &mut Move, kind: CommandId, bent: &[Bent]) -> Result<(), ControllerError> {
    match kind {
        command::CIRCW | command::CIRCCW => arcs::planar(next, kind, bent),
        command::TARC => arcs::in_space(next, bent),
        command::SINE => bent.iter().try_for_each(|bent| {
            let [target, phase, sweep, amplitude] = bent.values[..] else {
                let expected = "target, phase, sweep and amplitude of each axis";
                return Err(ControllerError::Expected { command: kind.info().name, expected });
            };
            to(next, kind, bent.slot, Target::Sine(Sine { target, phase, sweep, amplitude }))
        }),
        _ if bent.is_empty() => Ok(()),
        _ => Err(ControllerError::Expected { command: kind.info().name, expected: "one target behind each axis" }),
    }
}

/// Gives an axis its only target.
fn to(next: &mut Move, kind: CommandId, slot: usize, target: Target) -> Result<(), ControllerError> {
    if next.targets[slot].replace(target).is_some() { Err(twice(kind, slot)) } else { Ok(()) }
}

fn twice(kind: CommandId, slot: usize) -> ControllerError {
    let problem = format!("the axis in SLAVE{slot} is given two targets");
    ControllerError::BadValue { command: kind.info().name, problem }
}

/// What a master does not do, as the program hears of it.
pub(super) fn refused(kind: CommandId, error: PushError) -> ControllerError {
    match error {
        PushError::SlotTwice(slot) => twice(kind, slot),
        error => ControllerError::Move(error.to_string()),
    }
}
