//! Character output (guide, "Character I/O").

use acrc_catalog::command;
use acrc_vm::{Call, Outcome, Value, format};

use super::{Action, Context, Entry};
use crate::error::ControllerError;

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

impl Context<'_> {
    /// Sends bytes, which are Latin-1, to a device.
    pub(super) fn output(&mut self, device: i32, bytes: &[u8]) {
        let text: String = bytes.iter().map(|byte| char::from(*byte)).collect();
        let seconds = self.machine.clock.seconds();
        self.observer.output(seconds, self.program, device, &text);
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
