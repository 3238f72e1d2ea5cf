//! Commands about the channel at which they are typed, and about what it may show (guide, "Operating System").

use acrc_catalog::{Keyword, command, message};
use acrc_syntax::units::Level;
use acrc_vm::{Arg, Call, Outcome, Text, Value};

use super::arguments::{real, scalar};
use super::{Action, Context, Entry};
use crate::error::ControllerError;
use crate::request::Query;
use crate::terminal::Channel;

pub(super) const COMMANDS: &[Entry] = &[
    (command::ECHO, Action::Run(echo)),
    (command::MODE, Action::Run(mode)),
    (command::STREAM, Action::Answer(stream)),
    (command::TALK_TO, Action::Run(talk)),
    (command::LIST, Action::Run(list)),
    (command::PASSWORD, Action::Run(password)),
];

/// Highest value of `ECHO`: three flags.
const ECHO_VALUES: u8 = 7;
/// Highest value of `MODE`.
const MODE_VALUES: u8 = 3;

/// `ECHO n`: echo characters (1), no prompt (4).
fn echo(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let outcome = channel_setting(context, call, ECHO_VALUES, |channel| &mut channel.echo)?;
    if let Some(channel) = context.channel {
        context.machine.flag_echo(channel);
    }
    Ok(outcome)
}

/// `MODE n`: how the bytes of binary packets are written on this channel.
fn mode(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    channel_setting(context, call, MODE_VALUES, |channel| &mut channel.mode)
}

/// Sets or reports a setting of the channel. In a program and in setup code there is none.
fn channel_setting(
    context: &mut Context,
    call: &Call,
    last: u8,
    place: fn(&mut Channel) -> &mut u8,
) -> Result<Outcome, ControllerError> {
    let value = setting(call, last)?;
    let channel = context.channel.and_then(|id| context.machine.terminal.get_mut(id));
    match (channel.map(place), value) {
        (Some(place), Some(value)) => *place = value,
        (Some(place), None) => {
            let present = f64::from(*place);
            context.report(present);
        }
        (None, _) => {}
    }
    Ok(Outcome::Done)
}

fn setting(call: &Call, last: u8) -> Result<Option<u8>, ControllerError> {
    let Some(value) = scalar(call)? else { return Ok(None) };
    let valid = (0..=last).find(|number| f64::from(*number) == value);
    valid.map(Some).ok_or_else(|| ControllerError::BadValue {
        command: call.command.info().name,
        problem: format!("{value} is not a whole number from 0 to {last}"),
    })
}

fn stream(context: &mut Context) {
    let name =
        context.channel.and_then(|id| context.machine.terminal.get(id)).map(|channel| channel.stream.to_string());
    if let Some(name) = name {
        context.report_text(&name);
    }
}

/// `TALK TO "COM1:"`: what is typed at the channel goes out at another stream and what comes in there is shown, until ESC.
fn talk(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    let [Arg::Value(Value::Text(text), _)] = call.arguments else {
        return Err(ControllerError::Expected { command, expected: "a device string" });
    };
    let stream = context.machine.stream_of(text)?;
    if let Some(device) = context.machine.streams.device(stream) {
        return Err(ControllerError::StreamOpen { stream, device: device.number() });
    }
    let level = if context.immediate { context.machine.level.to_string() } else { "program".to_owned() };
    let channel = context.channel.and_then(|id| context.machine.terminal.get_mut(id));
    let channel = channel.ok_or(ControllerError::WrongLevel { command, level })?;
    if channel.stream == stream {
        let problem = format!("{stream} is the stream at which this was typed");
        return Err(ControllerError::BadValue { command, problem });
    }
    channel.talking = Some(stream);
    Ok(Outcome::Done)
}

/// `LIST`, `LIST line`, `LIST first, last`
fn list(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    if context.origin().level == Level::System {
        return Err(ControllerError::WrongLevel { command, level: context.machine.level.to_string() });
    }
    if context.machine.password.is_some() {
        return Err(ControllerError::Said(message::PROTECTED));
    }
    let line = |argument: &Arg| match argument {
        Arg::Value(value, _) => real(command, value).map(|number| number as u32),
        _ => Err(ControllerError::Expected { command, expected: "line numbers" }),
    };
    let (first, last) = match call.arguments {
        [] => (0, u32::MAX),
        [only] => (line(only)?, line(only)?),
        [first, last, ..] => (line(first)?, line(last)?),
    };
    context.ask(Query::List { first, last });
    Ok(Outcome::Done)
}

/// `PASSWORD ON "text"` protects the programs, `PASSWORD OFF "text"` lifts the protection.
fn password(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let off = call.arguments.iter().any(|argument| matches!(argument, Arg::Word { keyword: Keyword::Off, .. }));
    let text = call.arguments.iter().find_map(|argument| match argument {
        Arg::Value(Value::Text(text), _) => Some(text.clone()),
        _ => None,
    });
    let expected =
        ControllerError::Expected { command: call.command.info().name, expected: "ON or OFF and a text in quotes" };
    let text: Text = text.ok_or(expected)?;
    match (&context.machine.password, off) {
        (Some(present), _) if *present != text => return Err(ControllerError::Said(message::WRONG_PASSWORD)),
        (_, true) => context.machine.password = None,
        (_, false) => context.machine.password = Some(text),
    }
    Ok(Outcome::Done)
}
