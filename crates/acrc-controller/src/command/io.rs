//! Character output (guide, "Character I/O").

use acrc_catalog::command;
use acrc_syntax::units::Level;
use acrc_vm::{Call, Outcome, Value, format};

use super::{Action, Context, Entry};
use crate::controller::Observer;
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::request::Origin;

pub(super) const COMMANDS: &[Entry] = &[
    (command::PRINT, Action::Run(print)),
    // A dry run shows what is sent to any device, so opening one changes nothing.
    (command::OPEN, Action::Nothing),
    (command::CLOSE, Action::Nothing),
];

fn print(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let printed = format::print_line(call.arguments).map_err(ControllerError::Program)?;
    context.output(printed.device, &printed.bytes);
    Ok(Outcome::Done)
}

/// Sends bytes, which are Latin-1, to a device. What belongs to device 0 goes to the channel that typed the command, or to those who listen to
/// the program; whoever watches the run sees what no channel asked for.
pub(crate) fn deliver(machine: &mut Machine, observer: &mut dyn Observer, origin: Origin, device: i32, bytes: &[u8]) {
    if device == 0
        && let Some(channel) = origin.channel
    {
        machine.terminal.send(channel, bytes);
        return;
    }
    let program = match origin.level {
        Level::Program(number) => Some(number),
        Level::System | Level::Plc(_) => None,
    };
    if let (0, false, Some(program)) = (device, origin.immediate, program) {
        machine.terminal.tell_listeners(program, bytes);
    }
    let text: String = bytes.iter().map(|byte| char::from(*byte)).collect();
    observer.output(machine.clock.seconds(), program, device, &text);
}

impl Context<'_> {
    /// Sends bytes, which are Latin-1, to a device.
    pub(super) fn output(&mut self, device: i32, bytes: &[u8]) {
        let origin = self.origin();
        deliver(self.machine, self.observer, origin, device, bytes);
    }

    /// The answer of a command that was given without its value.
    pub(super) fn report(&mut self, value: f64) {
        self.report_text(&format::number(&Value::Double(value)));
    }

    /// A line that answers a command.
    pub(super) fn report_text(&mut self, text: &str) {
        self.output(0, format!("{text}\r\n").as_bytes());
    }
}
