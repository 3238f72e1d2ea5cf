//! Arcs: of two axes by end and centre, of three by end and a point on the way (guide, "Move Types").

use acrc_catalog::{CommandId, command};
use acrc_motion::{Arc, Move, SpaceArc, Target, Turn};
use acrc_vm::{Call, Outcome};

use super::Context;
use super::moves::Bent;
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::master::OpenArc;

/// `CIRCW X(end, centre) Y(end, centre)`: each pair of axes makes an arc, the first one of a pair is its primary axis.
pub(super) fn planar(next: &mut Move, kind: CommandId, bent: &[Bent]) -> Result<(), ControllerError> {
    let turn = if kind == command::CIRCW { Turn::Clockwise } else { Turn::CounterClockwise };
    bent.chunks(2).try_for_each(|pair| match pair {
        [first, second] => {
            let [(x, center_x), (y, center_y)] = [two(kind, first)?, two(kind, second)?];
            *next = next.arc(Arc {
                slots: [first.slot, second.slot],
                target: [x, y],
                center: [center_x, center_y],
                relative_target: false,
                relative_center: false,
                turn,
            });
            Ok(())
        }
        _ => Err(expected(kind, "two axes for an arc, each with its end and its centre")),
    })
}

/// `TARC X(end, via) Y(end, via) Z(end, via)`
pub(super) fn in_space(next: &mut Move, bent: &[Bent]) -> Result<(), ControllerError> {
    let kind = command::TARC;
    match bent {
        [] => Ok(()),
        [x, y, z] => {
            let [x_values, y_values, z_values] = [two(kind, x)?, two(kind, y)?, two(kind, z)?];
            *next = next.space_arc(SpaceArc {
                slots: [x.slot, y.slot, z.slot],
                target: [x_values.0, y_values.0, z_values.0],
                via: [x_values.1, y_values.1, z_values.1],
            });
            Ok(())
        }
        _ => Err(expected(kind, "three axes, each with its end and a point on the way")),
    }
}

/// `TARC ON X Y Z`: of every two moves of these axes the first is a point on the way, the second the end of an arc.
pub(super) fn open(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let master = usize::from(context.machine.master_of(context.program(call)?)?);
    let [first, second, third] = context.slots(call, master)?[..] else {
        return Err(expected(call.command, "the three axes of the arcs"));
    };
    end_pair(context, call, master)?;
    context.machine.masters[master].ahead.arc = Some(OpenArc { slots: [first, second, third], via: None });
    Ok(Outcome::Done)
}

/// `TARC OFF X Y Z`: moves are straight again.
pub(super) fn close(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let master = usize::from(context.machine.master_of(context.program(call)?)?);
    end_pair(context, call, master)?;
    Ok(Outcome::Done)
}

/// Ends arcs of pairs between two pairs.
fn end_pair(context: &mut Context, call: &Call, master: usize) -> Result<(), ControllerError> {
    let arc = context.machine.masters[master].ahead.arc.take();
    if arc.is_some_and(|arc| arc.via.is_some()) {
        let problem = "the arc has a point on its way but no end: a second move gives it".to_owned();
        return Err(ControllerError::BadValue { command: call.command.info().name, problem });
    }
    Ok(())
}

impl Machine {
    /// Makes a move what it is between `TARC ON` and `TARC OFF`. False for the first one of a pair, which is none.
    pub(crate) fn pair(&mut self, master: usize, next: &mut Move) -> Result<bool, ControllerError> {
        let master = &mut self.masters[master];
        let Some(arc) = &mut master.ahead.arc else { return Ok(true) };
        let targets = arc.slots.map(|slot| next.targets[slot].take());
        if targets.iter().all(Option::is_none) {
            return Ok(true);
        }
        let from = arc.via.unwrap_or(arc.slots.map(|slot| master.profiler.programmed_target(slot)));
        let mut point = from;
        for (place, target) in point.iter_mut().zip(targets) {
            match target {
                None => {}
                Some(Target::Absolute(position)) => *place = position,
                Some(Target::Relative(distance)) => *place += distance,
                Some(Target::Sine(_)) => {
                    return Err(expected(command::TARC_ON, "straight moves of its axes"));
                }
            }
        }
        match arc.via.take() {
            None => {
                arc.via = Some(point);
                Ok(false)
            }
            Some(via) => {
                *next = next.space_arc(SpaceArc { slots: arc.slots, via, target: point });
                Ok(true)
            }
        }
    }
}

fn two(kind: CommandId, bent: &Bent) -> Result<(f64, f64), ControllerError> {
    match bent.values[..] {
        [end, other] => Ok((end, other)),
        _ => Err(expected(kind, "two values behind each axis of the arc")),
    }
}

fn expected(kind: CommandId, expected: &'static str) -> ControllerError {
    ControllerError::Expected { command: kind.info().name, expected }
}
