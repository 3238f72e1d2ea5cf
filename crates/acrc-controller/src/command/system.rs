//! Levels, memory and program control (guide, "Operating System", "Memory Control", "Program Control").

use acrc_catalog::{CommandId, Keyword, Model, ObjectKind, command};
use acrc_syntax::units::Level;
use acrc_vm::{Arg, Call, Outcome};

use super::arguments::{real, scalar};
use super::{Action, Context, Entry};
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::memory::Block;
use crate::request::{Query, Request};
use crate::terminal::StreamName;

pub(super) const COMMANDS: &[Entry] = &[
    (command::SYS, Action::Run(level)),
    (command::PROG, Action::Run(level)),
    (command::PLC, Action::Run(level)),
    (command::PROGRAM, Action::Run(install)),
    // At a prompt these end nothing.
    (command::END, Action::Nothing),
    (command::ENDP, Action::Nothing),
    (command::RUN, Action::Run(control)),
    (command::LRUN, Action::Run(listen)),
    (command::LISTEN, Action::Run(listen)),
    (command::HALT, Action::Run(control)),
    (command::PAUSE, Action::Run(control)),
    (command::RESUME, Action::Run(control)),
    (command::NEW, Action::Run(control)),
    (command::CLEAR, Action::Run(clear)),
    (command::DIM_PROG, Action::Run(dimension)),
    (command::DIM_PLC, Action::Run(dimension)),
    (command::DIM_P, Action::Run(dimension)),
    (command::DIM_DEF, Action::Run(dimension)),
    (command::DIM_STREAM, Action::Run(dimension)),
    (command::DIM_COM1, Action::Run(dimension)),
    (command::DIM_COM2, Action::Run(dimension)),
    (command::DIM_FIFO, Action::Run(dimension)),
    (command::DIM_DPCB, Action::Run(dimension)),
    (command::CLEAR_COM1, Action::Run(clear_stream)),
    (command::CLEAR_COM2, Action::Run(clear_stream)),
    (command::CLEAR_FIFO, Action::Run(clear_stream)),
    (command::CLEAR_DPCB, Action::Run(clear_stream)),
    (command::CLEAR_STREAM, Action::Run(clear_stream)),
    (command::PERIOD, Action::Run(period)),
    (command::PBOOT, Action::Nothing),
    (command::REM, Action::Nothing),
];

/// `SYS`, `PROG n`, `PLC n` at a prompt. In a running program there is no prompt to switch.
fn level(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let name = call.command.info().name;
    if !context.immediate {
        return Err(ControllerError::WrongLevel { command: name, level: "program".to_owned() });
    }
    let index = scalar(call)?.unwrap_or(-1.0) as i64;
    let model = context.machine.model;
    context.machine.level = match call.command {
        command::PROG => Level::Program(Machine::object("PROG", index, model.programs)?),
        command::PLC => Level::Plc(Machine::object("PLC", index, model.plcs)?),
        _ => Level::System,
    };
    Ok(Outcome::Done)
}

/// `PROGRAM` in setup code: the image has the text that follows it as a unit of its own.
fn install(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    match scalar(call)? {
        Some(index) if context.immediate => context.machine.requests.push(Request::Install(index as usize)),
        _ => return Err(ControllerError::WrongLevel { command: "PROGRAM", level: "program".to_owned() }),
    }
    Ok(Outcome::Done)
}

/// `RUN`, `HALT`, ... of the named programs, of all, or of the one at the prompt.
fn control(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let request = match call.command {
        command::HALT => Request::Halt,
        command::PAUSE => Request::Pause,
        command::RESUME => Request::Resume,
        command::NEW => Request::New,
        _ => Request::Run,
    };
    let programs = context.programs(call)?;
    let itself = !context.immediate && context.program.is_some_and(|program| programs.contains(&program));
    if itself && call.command == command::PAUSE && !call.first {
        // It was paused here, and goes on.
        return Ok(Outcome::Done);
    }
    context.machine.requests.extend(programs.into_iter().map(request));
    Ok(match call.command {
        command::HALT | command::NEW if itself => Outcome::End,
        command::PAUSE if itself => Outcome::Again,
        _ => Outcome::Done,
    })
}

/// `LRUN` and `LISTEN` show the output of a program at the channel that typed them. In a program and in setup code nobody listens.
fn listen(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let &[program] = &context.programs(call)?[..] else {
        return Err(ControllerError::Expected { command: call.command.info().name, expected: "one program" });
    };
    let channel = context.channel.and_then(|id| context.machine.terminal.get_mut(id));
    if let Some(channel) = channel {
        channel.listening = Some(program);
    }
    if call.command == command::LRUN { control(context, call) } else { Ok(Outcome::Done) }
}

/// `CLEAR` at the system prompt frees all system memory, at a program prompt the program's variables.
fn clear(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    match (context.program, context.machine.level) {
        (None, Level::System) => {
            context.machine.memory.clear();
            if context.channel.is_some() {
                context.machine.requests.push(Request::ForgetAliases);
            }
            context.machine.requests.push(Request::ClearAllLocals);
        }
        // The VM clears the variables of the program.
        (Some(_), _) => {}
        (None, level) => {
            return Err(ControllerError::WrongLevel { command: call.command.info().name, level: level.to_string() });
        }
    }
    Ok(Outcome::Done)
}

fn dimension(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    if call.arguments.is_empty() {
        context.ask(Query::Dimensions);
        return Ok(Outcome::Done);
    }
    if context.program.is_some() {
        return Err(ControllerError::WrongLevel { command, level: "program".to_owned() });
    }
    let numbers = whole_numbers(call)?;
    let model = context.machine.model;
    let (block, size) = match (call.command, &numbers[..]) {
        (command::DIM_P, [count]) => (Block::Parameters, *count),
        (command::DIM_DEF, [count]) => (Block::Aliases, *count),
        (command::DIM_PROG, [index, size]) => (Block::Program(Machine::object("PROG", *index, model.programs)?), *size),
        (command::DIM_PLC, [index, size]) => (Block::Plc(Machine::object("PLC", *index, model.plcs)?), *size),
        (_, [.., size]) if let Some(stream) = stream(model, call.command, &numbers)? => (Block::Stream(stream), *size),
        _ => return Err(ControllerError::Expected { command, expected: "a size" }),
    };
    context.machine.memory.dimension(block, size)?;
    Ok(Outcome::Done)
}

/// `CLEAR COM1` and the like: the buffer of a stream is what the factory makes it.
fn clear_stream(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    if context.program.is_some() {
        return Err(ControllerError::WrongLevel { command, level: "program".to_owned() });
    }
    if let Some(stream) = stream(context.machine.model, call.command, &whole_numbers(call)?)? {
        context.machine.memory.clear_stream(stream);
    }
    Ok(Outcome::Done)
}

/// The stream that a command is about, if it is about one; the model must have it.
fn stream(model: &'static Model, command: CommandId, numbers: &[i64]) -> Result<Option<StreamName>, ControllerError> {
    let stream = match command {
        command::DIM_COM1 | command::CLEAR_COM1 => StreamName::Com(1),
        command::DIM_COM2 | command::CLEAR_COM2 => StreamName::Com(2),
        command::DIM_FIFO | command::CLEAR_FIFO => StreamName::Fifo,
        command::DIM_DPCB | command::CLEAR_DPCB => StreamName::DualPort,
        command::DIM_STREAM | command::CLEAR_STREAM => {
            let index = numbers.first().copied().unwrap_or(-1);
            StreamName::Stream(u8::try_from(index).unwrap_or(u8::MAX))
        }
        _ => return Ok(None),
    };
    stream.check(model).map_err(|error| ControllerError::Device(error.into()))?;
    Ok(Some(stream))
}

/// The numbers behind a command.
fn whole_numbers(call: &Call) -> Result<Vec<i64>, ControllerError> {
    let command = call.command.info().name;
    let number = |argument: &Arg| match argument {
        Arg::Value(value, _) => Ok(real(command, value)? as i64),
        _ => Err(ControllerError::Expected { command, expected: "sizes" }),
    };
    call.arguments.iter().map(number).collect()
}

/// `PERIOD` sets the servo period; a run keeps the one it started with.
fn period(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    match scalar(call)? {
        None => {
            let period = context.machine.clock.period();
            context.report(period);
        }
        Some(seconds) if !(1e-5..=0.1).contains(&seconds) => {
            return Err(ControllerError::BadValue {
                command,
                problem: format!("a servo period of {seconds} seconds is not possible"),
            });
        }
        Some(seconds) if context.machine.clock.ticks() == 0 => context.machine.clock.set_period(seconds),
        Some(_) => {
            let problem = "the servo period can only be set before time begins".to_owned();
            return Err(ControllerError::BadValue { command, problem });
        }
    }
    Ok(Outcome::Done)
}

impl Context<'_> {
    /// The programs that a control command means.
    fn programs(&self, call: &Call) -> Result<Vec<u8>, ControllerError> {
        let count = self.machine.model.programs;
        if call.arguments.is_empty() {
            return Ok(vec![self.program(call)?]);
        }
        let mut programs = Vec::new();
        for argument in call.arguments {
            match argument {
                Arg::Word { keyword: Keyword::All, .. } => programs.extend(0..count),
                Arg::Object { kind: ObjectKind::Prog, index: Some(index), .. } => {
                    programs.push(Machine::object("PROG", i64::from(*index), count)?);
                }
                // PLC programs are not part of a dry run; erasing or stopping one is no loss.
                Arg::Object { kind: ObjectKind::Plc, .. } if !starts(call.command) => {}
                Arg::Object { kind: ObjectKind::Plc, .. } => return Err(ControllerError::NotSimulated(command::PLC)),
                _ => {
                    return Err(ControllerError::Expected {
                        command: call.command.info().name,
                        expected: "PROGn, PLCn or ALL",
                    });
                }
            }
        }
        Ok(programs)
    }
}

fn starts(command: CommandId) -> bool {
    matches!(command, command::RUN | command::LRUN)
}
