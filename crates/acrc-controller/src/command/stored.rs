//! Commands that only keep a value ([`crate::settings`]), and commands that have nothing to do in a dry run.

use acrc_catalog::{CommandId, ObjectKind, command};
use acrc_vm::{Arg, Call, Outcome};

use super::arguments::real;
use super::{Action, Context, Entry};
use crate::error::ControllerError;

const fn keep(command: CommandId) -> Entry {
    (command, Action::Run(keep_values))
}

const fn nothing(command: CommandId) -> Entry {
    (command, Action::Nothing)
}

pub(super) const COMMANDS: &[Entry] = &[
    // The servo loop: an ideal machine follows its setpoint whatever the gains are.
    keep(command::PGAIN),
    keep(command::IGAIN),
    keep(command::ILIMIT),
    keep(command::IDELAY),
    keep(command::DGAIN),
    keep(command::DWIDTH),
    keep(command::FFVEL),
    keep(command::FFACC),
    keep(command::FFVC),
    keep(command::FBVEL),
    keep(command::LOPASS),
    keep(command::NOTCH),
    keep(command::DIN),
    keep(command::DIP),
    keep(command::DZL),
    keep(command::DZU),
    keep(command::KVP),
    keep(command::KVI),
    keep(command::KVF),
    // Bands of the following error and of the output, which an ideal machine never leaves.
    keep(command::EXC),
    keep(command::IPB),
    keep(command::ITB),
    keep(command::TLM),
    // Inputs and outputs.
    keep(command::MULT),
    keep(command::ENC_MULT),
    keep(command::ENC_SRC),
    keep(command::ADC_MODE),
    keep(command::ADC_MAX),
    keep(command::ADC_GAIN),
    keep(command::ADC_OFFSET),
    keep(command::DAC_GAIN),
    keep(command::DAC_OFFSET),
    // Values that belong to limits and jogging, which only act with HLIM, SLIM and the jog commands.
    keep(command::HLBIT),
    keep(command::HLDEC),
    keep(command::SLM),
    keep(command::SLDEC),
    keep(command::JLM),
    keep(command::JOG_VEL),
    keep(command::JOG_ACC),
    keep(command::JOG_DEC),
    keep(command::JOG_JRK),
    keep(command::JOG_HOMVF),
    (command::HLIM, Action::Run(keep_limit)),
    (command::SLIM, Action::Run(keep_limit)),
    // Hardware, saving and the terminal's own settings.
    nothing(command::AXIS_ON),
    nothing(command::AXIS_OFF),
    nothing(command::CONFIG),
    nothing(command::CONFIG_CLEAR),
    nothing(command::ESAVE),
    nothing(command::ELOAD),
    nothing(command::ERASE),
    nothing(command::FLASH_ERASE),
    nothing(command::FLASH_SAVE),
    nothing(command::FLASH_IMAGE),
    nothing(command::FLASH_RES),
    nothing(command::ECHO),
    nothing(command::MODE),
];

fn keep_values(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    if call.command.info().takes_axes && !matches!(call.prefix, Some((ObjectKind::Encoder, _))) {
        for argument in context.axes(call)? {
            let values = argument.value.numbers(command)?;
            context.keep(call.command, u16::from(argument.axis), values);
        }
        return Ok(Outcome::Done);
    }
    let object = call.prefix.and_then(|(_, index)| index).unwrap_or(0);
    let mut values = Vec::new();
    for argument in call.arguments {
        match argument {
            Arg::Value(value, _) => values.push(real(command, value)?),
            Arg::Tuple(list) => {
                for value in list {
                    values.push(real(command, value)?);
                }
            }
            _ => return Err(ControllerError::Expected { command, expected: "numbers" }),
        }
    }
    context.keep(call.command, object, values);
    Ok(Outcome::Done)
}

/// Limits are kept, and the run says that it does not watch them.
fn keep_limit(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    for argument in context.axes(call)? {
        let values = argument.value.numbers(command)?;
        if values.iter().any(|value| *value != 0.0) {
            context
                .machine
                .notes
                .insert(format!("{command} was enabled: the dry run does not watch end-of-travel limits"));
        }
        context.keep(call.command, u16::from(argument.axis), values);
    }
    Ok(Outcome::Done)
}

impl Context<'_> {
    /// Keeps the values of one object, or reports them when none are given.
    fn keep(&mut self, command: CommandId, object: u16, values: Vec<f64>) {
        if !values.is_empty() {
            self.machine.settings.set(command, object, values);
            return;
        }
        let kept = self.machine.settings.get(command, object).map_or(vec![0.0], <[f64]>::to_vec);
        for value in kept {
            self.report(value);
        }
    }
}
