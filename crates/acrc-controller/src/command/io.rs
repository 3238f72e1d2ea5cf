//! Character input and output (guide, "Character I/O").

use acrc_catalog::command;
use acrc_image::{Mark, UnitName};
use acrc_syntax::units::Level;
use acrc_vm::{Arg, Call, Outcome, Text, Value, format, input_fits};

use super::{Action, Context, Entry};
use crate::controller::{Observer, Sent};
use crate::error::ControllerError;
use crate::footprint::Places;
use crate::machine::Machine;
use crate::request::Origin;
use crate::streams::{Device, DeviceError, Port, device_stream};
use crate::task::Task;
use crate::terminal::StreamName;

pub(super) const COMMANDS: &[Entry] = &[
    (command::PRINT, Action::Run(print)),
    (command::INPUT, Action::Run(input)),
    (command::OPEN, Action::Run(open)),
    (command::OPEN_DTALK, Action::Run(open_drive_talk)),
    (command::CLOSE, Action::Run(close)),
];

/// What an `INPUT` without a prompt asks with.
const DEFAULT_PROMPT: &[u8] = b"? ";

const NEW_LINE: &[u8] = b"\r\n";

fn print(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let printed = format::print_line(call.arguments).map_err(ControllerError::Program)?;
    if !(0..=3).contains(&printed.device) {
        return Err(no_device(call, printed.device));
    }
    context.output(printed.device, &printed.bytes);
    Ok(Outcome::Done)
}

/// `INPUT; #1, "prompt"; variables`: asks until a line fits the variables.
fn input(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let number = device_number(call).unwrap_or(0);
    let port = context.input_port(number)?;
    let prompt = call.arguments.iter().find_map(|argument| match argument {
        Arg::Value(Value::Text(text), _) => Some(text.as_bytes()),
        _ => None,
    });
    let prompt = prompt.unwrap_or(DEFAULT_PROMPT);
    let stays = matches!(call.arguments.last(), Some(Arg::Reference { mark: Mark::Semicolon, .. }));
    if call.first {
        context.output(number, prompt);
    }
    loop {
        let reading = context.machine.streams.read(port);
        context.output(number, &reading.echo);
        let Some(line) = reading.line else {
            context.machine.streams.awaited = Some(port);
            return Ok(Outcome::Again);
        };
        let fits = input_fits(&line, call.arguments);
        if !(fits && stays) {
            context.output(number, NEW_LINE);
        }
        // The line is gone for whoever else reads there.
        context.footprint.write(Places::ALL);
        if fits {
            return Ok(Outcome::Input(Text::from(line)));
        }
        context.output(number, prompt);
    }
}

/// `OPEN "COM1:9600,n,8,1" AS #1`. Opening a device again as what it is changes nothing.
fn open(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let [Arg::Value(Value::Text(text), _), Arg::Device(number)] = call.arguments else {
        return Err(ControllerError::Expected { command: call.command.info().name, expected: "a device string" });
    };
    let device = context.device(call, *number)?;
    let stream = context.machine.stream_of(text)?;
    let streams = &mut context.machine.streams;
    match (streams.stream(device), streams.device(stream)) {
        (Some(present), _) if present == stream => {}
        (Some(present), _) => {
            return Err(ControllerError::DeviceOpen { device: device.number(), stream: present });
        }
        (None, Some(other)) => return Err(ControllerError::StreamOpen { stream, device: other.number() }),
        (None, None) => streams.open(device, stream),
    }
    Ok(Outcome::Done)
}

/// `OPEN DTALK "COM2:9600,N,8,1" AS #1`: the port belongs to the drives from now on.
fn open_drive_talk(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let note = "OPEN DTALK: no drive answers in a dry run; what drives report comes from the world";
    context.machine.notes.insert(note.to_owned());
    open(context, call)
}

/// `CLOSE #1`. Closing a device that is not open changes nothing.
fn close(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let Some(number) = device_number(call) else {
        return Err(ControllerError::Expected { command: call.command.info().name, expected: "a device" });
    };
    let device = context.device(call, number)?;
    if let Some((stream, lost @ 1..)) = context.machine.streams.close(device) {
        let note = format!("{stream} was closed with {lost} characters that no program had read: they are lost");
        context.machine.notes.insert(note);
    }
    Ok(Outcome::Done)
}

/// The number behind `#`.
fn device_number(call: &Call) -> Option<i32> {
    call.arguments.iter().find_map(|argument| match argument {
        Arg::Device(number) => Some(*number),
        _ => None,
    })
}

fn no_device(call: &Call, number: i32) -> ControllerError {
    let problem = format!("there is no device #{number} here: programs have #0 to #3, the system prompt #1 to #3");
    ControllerError::BadValue { command: call.command.info().name, problem }
}

/// Sends bytes, which are Latin-1, to a device. What belongs to device 0 goes to the channel that typed the command, or to those who listen to
/// the program; whoever watches the run sees what no channel asked for.
pub(crate) fn deliver(machine: &mut Machine, observer: &mut dyn Observer, origin: Origin, device: i32, bytes: &[u8]) {
    if bytes.is_empty() {
        return;
    }
    if device == 0
        && let Some(channel) = origin.channel
    {
        machine.terminal.send(channel, bytes);
        return;
    }
    let (unit, program) = match origin.level {
        Level::Program(number) => (UnitName::Program(number), Some(number)),
        Level::Plc(number) => (UnitName::Plc(number), None),
        Level::System => (UnitName::Boot, None),
    };
    let owner = program.filter(|_| !origin.immediate);
    let task = Task::at(origin.level).filter(|_| !origin.immediate);
    let stream = Device::of(device, owner).and_then(|device| machine.streams.stream(device));
    match (device, stream, task) {
        (_, Some(stream), _) => machine.terminal.send_to(stream, bytes),
        (0, None, Some(task)) => machine.terminal.tell_listeners(task, bytes),
        (0, None, None) => {}
        (_, None, _) => {
            machine.notes.insert(format!("#{device} was not open when something was printed to it: that text is lost"));
            return;
        }
    }
    let text: String = bytes.iter().map(|byte| char::from(*byte)).collect();
    observer.output(&Sent { seconds: machine.clock.seconds(), unit, device, stream, text: &text });
}

impl Machine {
    /// The stream of this model that a device string names.
    pub(super) fn stream_of(&self, device: &Text) -> Result<StreamName, DeviceError> {
        let stream = device_stream(&device.to_string())?;
        stream.check(self.model)?;
        Ok(stream)
    }
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

    /// The device that a number means here.
    fn device(&self, call: &Call, number: i32) -> Result<Device, ControllerError> {
        Device::of(number, self.program).ok_or_else(|| no_device(call, number))
    }

    /// Where the characters of a device come from. Device 0 of a prompt is the terminal itself, which reads commands, unless it was opened.
    /// Whoever listens to the program hands over what was typed: what no program asks for stays a line for the terminal.
    pub(crate) fn input_port(&mut self, number: i32) -> Result<Port, ControllerError> {
        let port = Device::of(number, self.program).and_then(|device| self.machine.streams.port(device));
        let of_a_program = port.is_some_and(|port| !(self.immediate && matches!(port, Port::Listener(_))));
        if number == 0 && self.immediate && !of_a_program {
            return Err(ControllerError::OwnTerminal);
        }
        let port = port.ok_or(ControllerError::NotOpen { device: number })?;
        if let Port::Listener(program) = port {
            while self.machine.streams.lacks_line(port) {
                let typed = self.machine.terminal.take_typed(program);
                if typed.is_empty() {
                    break;
                }
                self.machine.streams.arrive(port, &typed);
            }
        }
        Ok(port)
    }
}
