//! What holds for commands that are typed at a terminal and not for those of programs: the prompt level, and the words of a refusal.

use acrc_catalog::{Confidence, command, message};
use acrc_syntax::units::Level;
use acrc_vm::{Arg, Call};

use crate::error::ControllerError;

/// Whether a prompt takes a command: an object before it or behind it, or axis names, say what it acts on at any prompt, and a program prompt
/// takes the commands of the system too. Only what is well attested is refused; the rest is left to the command itself.
pub(super) fn admit(call: &Call, level: Level) -> Result<(), ControllerError> {
    let row = call.command.info();
    let names = |argument: &Arg| matches!(argument, Arg::Axis { .. } | Arg::Object { .. });
    let elsewhere = match level {
        Level::System => !row.levels.sys(),
        Level::Program(_) => false,
        Level::Plc(_) => !row.levels.plc(),
    };
    let bare = call.prefix.is_none() && !call.arguments.iter().any(names);
    if elsewhere && bare && row.confidence == Confidence::High {
        return Err(ControllerError::Said(message::UNKNOWN_COMMAND));
    }
    Ok(())
}

/// What a refused command is answered with: a command of another level is unknown, and so is a word that is no axis of the program, wherever it
/// stands (guide, "Slaves and Axis Names": other programs do not recognize it).
pub(super) fn refusal(call: &Call, error: ControllerError) -> ControllerError {
    let is_move = call.command == command::AXIS_MOVE;
    match error {
        ControllerError::WrongLevel { .. } | ControllerError::UnknownAxis { .. } => {
            ControllerError::Said(message::UNKNOWN_COMMAND)
        }
        ControllerError::NoMaster(_) if is_move => ControllerError::Said(message::UNKNOWN_COMMAND),
        other => other,
    }
}
