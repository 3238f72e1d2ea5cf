//! Velocity profile commands of a master (guide, "Velocity Profile Commands").

use acrc_catalog::{CommandId, command};
use acrc_motion::{MoveSettings, SettingError};
use acrc_vm::{Call, Outcome};

use super::arguments::scalar;
use super::master_settings::number;
use super::{Action, Context, Entry};
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::master::Master;

pub(super) const COMMANDS: &[Entry] = &[
    (command::ACC, Action::Run(profile_value)),
    (command::DEC, Action::Run(profile_value)),
    (command::STP, Action::Run(profile_value)),
    (command::VEL, Action::Run(profile_value)),
    (command::F, Action::Run(profile_value)),
    (command::FVEL, Action::Run(profile_value)),
    (command::IVEL, Action::Run(profile_value)),
    (command::JRK, Action::Run(profile_value)),
    (command::TMOV, Action::Run(profile_value)),
    (command::TMOV_ON, Action::Run(timed)),
    (command::TMOV_OFF, Action::Run(timed)),
    (command::FOV, Action::Run(profile_value)),
    (command::ROV, Action::Run(profile_value)),
    (command::VECTOR, Action::Run(profile_value)),
    (command::VECDEF, Action::Run(weights)),
];

/// Units per minute of `F` in the units per second of `VEL`.
const SECONDS_PER_MINUTE: f64 = 60.0;

/// `VEL 5` sets, `VEL` reports.
fn profile_value(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let index = context.master(call)?;
    let master = &mut context.machine.masters[index];
    match scalar(call)? {
        None => {
            let value = current(master, call.command);
            context.report(value);
        }
        Some(value) => context.machine.set_profile_value(index, call.command, value)?,
    }
    Ok(Outcome::Done)
}

impl Machine {
    /// Gives a master what `FOV` and its like set.
    pub(crate) fn set_profile_value(
        &mut self,
        master: usize,
        command: CommandId,
        value: f64,
    ) -> Result<(), ControllerError> {
        if value < 0.0 {
            let problem = format!("{value} is negative");
            return Err(ControllerError::BadValue { command: command.info().name, problem });
        }
        change(&mut self.masters[master], command, value).map_err(refused)?;
        if command == command::ROV {
            self.set_setting(command, master as u16, vec![number(value)])?;
        }
        Ok(())
    }
}

fn current(master: &mut Master, command: CommandId) -> f64 {
    match command {
        command::FOV => master.profiler.feedrate_override(),
        command::ROV => master.profiler.rapid_override(),
        command::VECTOR => master.vector,
        _ => *setting(&mut master.settings, command) * per_setting(command),
    }
}

fn change(master: &mut Master, command: CommandId, value: f64) -> Result<(), SettingError> {
    match command {
        command::FOV => master.profiler.set_feedrate_override(value)?,
        command::ROV => master.profiler.set_rapid_override(value)?,
        command::VECTOR => {
            master.profiler.set_vector(value)?;
            master.vector = value;
        }
        _ => *setting(&mut master.settings, command) = value / per_setting(command),
    }
    Ok(())
}

/// Units of the command for each unit of the setting.
fn per_setting(command: CommandId) -> f64 {
    if command == command::F { SECONDS_PER_MINUTE } else { 1.0 }
}

/// The setting of the next move that a command stands for.
fn setting(settings: &mut MoveSettings, command: CommandId) -> &mut f64 {
    match command {
        command::ACC => &mut settings.acceleration,
        command::DEC => &mut settings.deceleration,
        command::STP => &mut settings.stop,
        command::FVEL => &mut settings.final_velocity,
        command::IVEL => &mut settings.initial_velocity,
        command::JRK => &mut settings.jerk,
        command::TMOV => &mut settings.time,
        _ => &mut settings.velocity,
    }
}

/// `TMOV ON` and `TMOV OFF`: whether moves take the time of `TMOV`.
fn timed(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let master = context.master(call)?;
    context.machine.masters[master].timed = call.command == command::TMOV_ON;
    Ok(Outcome::Done)
}

/// `VECDEF`: the weight of each axis in the length of the path.
fn weights(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    for argument in context.axes(call)? {
        let slave = context.machine.axes[usize::from(argument.axis)].slave;
        let slave =
            slave.ok_or(ControllerError::Expected { command, expected: "axes that are attached to a master" })?;
        let [weight] = argument.value.numbers(command)?[..] else {
            return Err(ControllerError::Expected { command, expected: "one weight an axis" });
        };
        if weight < 0.0 {
            return Err(ControllerError::BadValue { command, problem: format!("{weight} is negative") });
        }
        context.machine.masters[usize::from(slave.master)]
            .profiler
            .set_weight(usize::from(slave.slot), weight)
            .map_err(refused)?;
    }
    Ok(Outcome::Done)
}

fn refused(error: SettingError) -> ControllerError {
    ControllerError::Move(error.to_string())
}
