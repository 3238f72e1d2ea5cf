//! What bends, shifts, turns and slows down the paths of moves that follow (guide, groups "Transformation", "Feedback Control",
//! "Interpolation" and "Velocity Profile" of the command list).

use acrc_catalog::command;
use acrc_motion::{Lookahead, SettingError, Tangent};
use acrc_vm::{Arg, Call, Outcome};

use super::arguments::{AxisArgument, AxisValue, real, scalar};
use super::master_settings::number;
use super::{Action, Context, Entry, settings};
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::master::SLOTS;

pub(super) const COMMANDS: &[Entry] = &[
    (command::ROTARY, Action::Run(of_axis)),
    (command::MAXVEL, Action::Run(of_axis)),
    (command::FLZ, Action::Run(shift)),
    (command::OFFSET, Action::Run(shift)),
    (command::SCALE, Action::Run(scale)),
    (command::ROTATE, Action::Run(rotate)),
    (command::TANG_ON, Action::Run(tangent_on)),
    (command::TANG_OFF, Action::Run(tangent_off)),
    (command::LOOK_ON, Action::Run(look_on)),
    (command::LOOK_OFF, Action::Run(look_off)),
    (command::LOOK_ANG, Action::Run(look_angles)),
    (command::LOOK_MODE, Action::Run(look_mode)),
];

/// A turn of an axis that is no rotary axis, in units: degrees.
const TURN: f64 = 360.0;

/// `ROTARY X360`, `MAXVEL X20`: settings of the axis, which its master looks at when it lays a path.
fn of_axis(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    for argument in context.axes(call)? {
        if let Some(value) = argument.value.numbers(command)?.into_iter().find(|value| *value < 0.0) {
            return Err(ControllerError::BadValue { command, problem: format!("{value} is negative") });
        }
    }
    settings::keep(context, call)
}

impl Machine {
    /// Tells the profiler of a master what its axes are like.
    pub(super) fn take_axes(&mut self, master: usize) -> Result<(), ControllerError> {
        for slot in 0..SLOTS {
            let Some(axis) = self.masters[master].slots[slot] else { continue };
            let [turn, ceiling] =
                [command::ROTARY, command::MAXVEL].map(|command| self.first_setting(command, u16::from(axis)));
            let profiler = &mut self.masters[master].profiler;
            profiler.set_rotary(slot, turn).map_err(refused)?;
            profiler.set_ceiling(slot, ceiling).map_err(refused)?;
        }
        Ok(())
    }
}

/// `FLZ` and `OFFSET`: shifts of axes, or what they are.
fn shift(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let floats = call.command == command::FLZ;
    context.each_slot(call, |context, master, slot, values| {
        let profiler = &mut context.machine.masters[master].profiler;
        match values {
            [] => {
                let value = if floats { profiler.float(slot) } else { profiler.offset(slot) };
                context.report(value);
                Ok(())
            }
            [value] if floats => profiler.float_zero(slot, *value).map_err(refused),
            [value] => profiler.set_offset(slot, *value).map_err(refused),
            _ => Err(ControllerError::Expected { command: call.command.info().name, expected: "one shift an axis" }),
        }
    })
}

/// `SCALE X2`, `SCALE X(2, centre)`
fn scale(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    context.each_slot(call, |context, master, slot, values| {
        let profiler = &mut context.machine.masters[master].profiler;
        let (factor, center) = match values {
            [] => {
                let factor = profiler.scale(slot);
                context.report(factor);
                return Ok(());
            }
            [factor] => (*factor, 0.0),
            [factor, center] => (*factor, *center),
            _ => {
                let command = call.command.info().name;
                return Err(ControllerError::Expected { command, expected: "a factor and a centre an axis" });
            }
        };
        profiler.set_scale(slot, factor, center).map_err(refused)
    })
}

/// `ROTATE 30 X5 Y5`: two axes about a centre; without axes the first two slots about zero.
fn rotate(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    let master = context.master(call)?;
    let Some((angle, axes)) = call.arguments.split_first() else {
        let degrees = context.machine.masters[master].profiler.rotation();
        context.report(degrees);
        return Ok(Outcome::Done);
    };
    let expected = ControllerError::Expected { command, expected: "an angle, and no axis or two with their centres" };
    let Arg::Value(angle, _) = angle else { return Err(expected) };
    let degrees = real(command, angle)?;
    let (mut slots, mut center) = ([0, 1], [0.0; 2]);
    match axes {
        [] => {}
        [first, second] => {
            for (place, argument) in [first, second].into_iter().enumerate() {
                let axis = context.axis_argument(command, argument, call)?;
                slots[place] = context.slot(call, master, axis.axis)?;
                center[place] = match axis.value.numbers(command)?[..] {
                    [] => 0.0,
                    [center] => center,
                    _ => return Err(expected),
                };
            }
        }
        _ => return Err(expected),
    }
    context.machine.masters[master].profiler.set_rotation(slots, degrees, center).map_err(refused)?;
    Ok(Outcome::Done)
}

/// `TANG ON X Y Z`: the last axis points along the path of the others. Alone, it follows the first two slots. A value
/// behind it is where it is while the path leads up the first axis.
fn tangent_on(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    let master = context.master(call)?;
    let axes = context.axes(call)?;
    let expected = ControllerError::Expected { command, expected: "two axes of a path and the axis that turns" };
    let (plane, turned) = match &axes[..] {
        [turned] => ([0, 1], turned),
        [first, second, turned] => {
            ([context.slot(call, master, first.axis)?, context.slot(call, master, second.axis)?], turned)
        }
        _ => return Err(expected),
    };
    let offset = match turned.value.numbers(command)?[..] {
        [] => 0.0,
        [offset] => offset,
        _ => return Err(expected),
    };
    let axis = context.slot(call, master, turned.axis)?;
    let length = context.machine.first_setting(command::ROTARY, u16::from(turned.axis));
    let turn = if length > 0.0 { length } else { TURN };
    let tangent = Tangent { plane, axis, turn, offset };
    context.machine.masters[master].profiler.set_tangent(Some(tangent)).map_err(refused)?;
    Ok(Outcome::Done)
}

fn tangent_off(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let master = context.master(call)?;
    context.machine.masters[master].profiler.set_tangent(None).map_err(refused)?;
    Ok(Outcome::Done)
}

fn look_on(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    context.look_ahead(call, true)
}

fn look_off(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    context.look_ahead(call, false)
}

/// `LOOK ANG 10 90`: up to the first angle full speed, from the second on a stop.
fn look_angles(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    let master = context.master(call)?;
    let angles: Vec<f64> = call
        .arguments
        .iter()
        .map(|argument| match argument {
            Arg::Value(value, _) => real(command, value),
            _ => Err(ControllerError::Expected { command, expected: "one or two angles" }),
        })
        .collect::<Result<_, _>>()?;
    let look = &mut context.machine.masters[master].look;
    let angles = match angles[..] {
        [] => {
            let Lookahead { full, stop } = look.angles;
            context.report(full);
            context.report(stop);
            return Ok(Outcome::Done);
        }
        [full] => Lookahead { full, ..look.angles },
        [full, stop] => Lookahead { full, stop },
        _ => return Err(ControllerError::Expected { command, expected: "one or two angles" }),
    };
    if !(0.0..=180.0).contains(&angles.full) || !(angles.full..=180.0).contains(&angles.stop) {
        let problem = format!("{} and {} are no angles that rise from 0 to 180", angles.full, angles.stop);
        return Err(ControllerError::BadValue { command, problem });
    }
    look.angles = angles;
    let on = look.on;
    context.look_ahead(call, on)?;
    context.keep_for_master(call, master, vec![number(angles.full), number(angles.stop)])
}

/// `LOOK MODE`: kept; corners are taken by their angles in any mode.
fn look_mode(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let master = context.master(call)?;
    match scalar(call)? {
        None => {
            let mode = context.machine.masters[master].look.mode;
            context.report(mode);
        }
        Some(mode) => {
            context.machine.masters[master].look.mode = mode;
            let note = "LOOK MODE was set: the dry run takes corners by LOOK ANG in any mode";
            context.machine.notes.insert(note.to_owned());
            return context.keep_for_master(call, master, vec![number(mode)]);
        }
    }
    Ok(Outcome::Done)
}

impl Context<'_> {
    /// Does something to the slot of each axis of a call, with the values behind it; without axes to all of the master.
    fn each_slot(
        &mut self,
        call: &Call,
        mut action: impl FnMut(&mut Self, usize, usize, &[f64]) -> Result<(), ControllerError>,
    ) -> Result<Outcome, ControllerError> {
        let master = self.master(call)?;
        let mut axes = self.axes(call)?;
        if axes.is_empty() {
            let all = self.machine.masters[master].attached();
            axes = all.map(|(_, axis)| AxisArgument { axis, value: AxisValue::None }).collect();
        }
        for argument in axes {
            let slot = self.slot(call, master, argument.axis)?;
            action(self, master, slot, &argument.value.numbers(call.command.info().name)?)?;
        }
        Ok(Outcome::Done)
    }

    fn look_ahead(&mut self, call: &Call, on: bool) -> Result<Outcome, ControllerError> {
        let index = self.master(call)?;
        let master = &mut self.machine.masters[index];
        master.look.on = on;
        let angles = on.then_some(master.look.angles);
        master.profiler.set_lookahead(angles).map_err(refused)?;
        Ok(Outcome::Done)
    }
}

fn refused(error: SettingError) -> ControllerError {
    ControllerError::Move(error.to_string())
}
