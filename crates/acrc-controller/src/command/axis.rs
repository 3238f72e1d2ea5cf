//! Axis commands that change its registers, scaling or drive (guide, "Feedback Control Commands").

use acrc_catalog::{ObjectKind, command, law};
use acrc_vm::{Call, Outcome};

use super::arguments::{AxisArgument, AxisValue, scalar};
use super::{Action, Context, Entry};
use crate::error::ControllerError;
use crate::motion::Preload;

pub(super) const COMMANDS: &[Entry] = &[
    (command::DRIVE, Action::Run(drive_report)),
    (command::DRIVE_ON, Action::Run(drive_on)),
    (command::DRIVE_OFF, Action::Run(drive_off)),
    (command::PPU, Action::Run(pulses_per_unit)),
    (command::RES, Action::Run(reset)),
    (command::REN, Action::Run(renew)),
    (command::ENC_RES, Action::Run(reset_encoder)),
];

fn drive_report(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    for argument in context.axes(call)? {
        let on = context.machine.flags.get(law::DRIVE_ENABLE.at(u32::from(argument.axis)));
        context.report_text(&format!("DRIVE {} AXIS{}", if on { "ON" } else { "OFF" }, argument.axis));
    }
    Ok(Outcome::Done)
}

/// `DRIVE ON` also clears Kill All Moves of the master when the drive was off, and the faults of the axis.
fn drive_on(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    for argument in context.resting_axes(call)? {
        let axis = argument.axis;
        let machine = &mut *context.machine;
        if !machine.flags.get(law::DRIVE_ENABLE.at(u32::from(axis))) {
            machine.flags.set_law(law::KILL_ALL_MOTION_REQUEST, u32::from(axis), false);
            if let Some(slave) = machine.axes[usize::from(axis)].slave {
                machine.flags.set_law(law::KILL_ALL_MOVES, u32::from(slave.master), false);
            }
        }
        machine.update_kills();
        for law in [law::DRIVE_FAULT_LATCHED, law::EXC_FAULT_LATCHED] {
            machine.flags.set_law(law, u32::from(axis), false);
        }
        machine.set_drive(axis, true);
    }
    Ok(Outcome::Done)
}

fn drive_off(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    for argument in context.resting_axes(call)? {
        context.machine.set_drive(argument.axis, false);
    }
    Ok(Outcome::Done)
}

fn pulses_per_unit(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    for argument in context.axes(call)? {
        match argument.value.numbers(command)?[..] {
            [] => {
                let ratio = context.machine.axes[usize::from(argument.axis)].pulses_per_unit;
                context.report(ratio);
            }
            [ratio] => context.machine.set_pulses_per_unit(argument.axis, ratio)?,
            _ => return Err(ControllerError::Expected { command, expected: "one ratio an axis" }),
        }
    }
    Ok(Outcome::Done)
}

/// `RES` sets every position register to the preload; without axes it does so for all axes of the program.
fn reset(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    let mut axes = context.axes(call)?;
    if axes.is_empty() {
        let master = context.master(call)?;
        let attached =
            context.machine.masters[master].attached().map(|(_, axis)| AxisArgument { axis, value: AxisValue::None });
        axes = attached.collect();
    }
    for argument in axes {
        let preload = match argument.value.numbers(command)?[..] {
            [] => 0.0,
            [preload] => preload,
            _ => return Err(ControllerError::Expected { command, expected: "one preload an axis" }),
        };
        context.machine.preload(argument.axis, Preload::All(preload))?;
    }
    Ok(Outcome::Done)
}

/// `REN` takes the actual position over as setpoint.
fn renew(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    for argument in context.resting_axes(call)? {
        context.machine.preload(argument.axis, Preload::Match)?;
    }
    Ok(Outcome::Done)
}

fn reset_encoder(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    let Some((ObjectKind::Encoder, Some(index))) = call.prefix else {
        return Err(ControllerError::Expected { command, expected: "an encoder: ENC0 RES" });
    };
    let preload = scalar(call)?.unwrap_or(0.0) as i32;
    if let Ok(axis) = context.axis(i64::from(index)) {
        context.machine.set_encoder(axis, preload);
        context.machine.reset_encoder_faults(axis);
    }
    Ok(Outcome::Done)
}

impl Context<'_> {
    /// The axes of a call, none of which may move.
    fn resting_axes<'c>(&self, call: &Call<'c>) -> Result<Vec<AxisArgument<'c>>, ControllerError> {
        let axes = self.axes(call)?;
        if axes.iter().any(|argument| self.machine.axis_in_motion(argument.axis)) {
            return Err(ControllerError::InMotion);
        }
        Ok(axes)
    }
}
