//! Levels, memory and program control (guide, "Operating System", "Memory Control", "Program Control").

use acrc_catalog::memory::SystemBlock;
use acrc_catalog::{CommandId, Keyword, ObjectKind, command};
use acrc_syntax::units::Level;
use acrc_vm::{Arg, Call, Outcome};

use super::arguments::{real, scalar};
use super::{Action, Context, Entry};
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::request::{Query, Request};
use crate::task::Task;
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
    (command::BLK, Action::Run(control)),
    (command::AUT, Action::Run(control)),
    (command::STEP, Action::Run(control)),
    (command::TRON, Action::Run(control)),
    (command::TROFF, Action::Run(control)),
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
    // With a size these are executed by the VM.
    (command::DIM_LV, Action::Run(dimension)),
    (command::DIM_SV, Action::Run(dimension)),
    (command::DIM_DV, Action::Run(dimension)),
    (command::DIM_STRING_V, Action::Run(dimension)),
    (command::DIM_LA, Action::Run(dimension)),
    (command::DIM_SA, Action::Run(dimension)),
    (command::DIM_DA, Action::Run(dimension)),
    (command::DIM_STRING_A, Action::Run(dimension)),
    (command::DIM_MBUF, Action::Run(dimension)),
    (command::CLEAR_COM1, Action::Run(clear_stream)),
    (command::CLEAR_COM2, Action::Run(clear_stream)),
    (command::CLEAR_FIFO, Action::Run(clear_stream)),
    (command::CLEAR_DPCB, Action::Run(clear_stream)),
    (command::CLEAR_STREAM, Action::Run(clear_stream)),
    (command::PERIOD, Action::Run(period)),
    (command::PBOOT, Action::Run(control)),
    (command::REM, Action::Nothing),
];

/// `SYS`, `PROG n`, `PLC n` at a prompt. In a running program there is no prompt to switch.
fn level(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let name = call.command.info().name;
    if !context.immediate {
        return Err(ControllerError::WrongLevel { command: name, level: "program".to_owned() });
    }
    let index = scalar(call)?.map(|index| index as i64);
    let number = || index.ok_or(ControllerError::Expected { command: name, expected: "a number" });
    let model = context.machine.model;
    context.machine.level = match call.command {
        command::PROG => Level::Program(Machine::object("PROG", number()?, model.programs)?),
        command::PLC => Level::Plc(Machine::object("PLC", number()?, model.plcs)?),
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

/// `RUN`, `HALT`, ... of the named programs, of all, or of the one at the prompt; `PBOOT` typed at a prompt starts all that begin with it.
fn control(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    if call.command == command::PBOOT {
        context.machine.requests.push(Request::Boot);
        return Ok(Outcome::Done);
    }
    let tasks = context.tasks(call)?;
    let itself = !context.immediate && context.task().is_some_and(|task| tasks.contains(&task));
    if itself && call.command == command::PAUSE && !call.first {
        // It was paused here, and goes on.
        return Ok(Outcome::Done);
    }
    for task in tasks {
        let request = match (call.command, task) {
            (command::RUN | command::LRUN, _) => Request::Run(task),
            (command::HALT, _) => Request::Halt(task),
            (command::NEW, _) => Request::New(task),
            (_, Task::Plc(_)) => return Err(only_programs(call.command)),
            (command::PAUSE, Task::Program(program)) => Request::Pause(program),
            (command::RESUME, Task::Program(program)) => Request::Resume(program),
            (command::BLK | command::AUT, Task::Program(program)) => {
                Request::Block(program, call.command == command::BLK)
            }
            (command::STEP, Task::Program(program)) => Request::Step(program),
            (_, Task::Program(program)) => Request::Trace(program, call.command == command::TRON),
        };
        context.machine.requests.push(request);
    }
    Ok(match call.command {
        command::HALT | command::NEW if itself => Outcome::End,
        command::PAUSE if itself => Outcome::Again,
        _ => Outcome::Done,
    })
}

/// `LRUN` and `LISTEN` show the output of a program at the channel that typed them. In a program and in setup code nobody listens.
fn listen(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let &[task] = &context.tasks(call)?[..] else {
        let expected = "one program or PLC program";
        return Err(ControllerError::Expected { command: call.command.info().name, expected });
    };
    if let Some(channel) = context.channel.and_then(|id| context.machine.terminal.get_mut(id)) {
        channel.listening = Some(task);
    }
    if call.command == command::LRUN { control(context, call) } else { Ok(Outcome::Done) }
}

/// `CLEAR` at the system prompt frees all system memory, at a program prompt the program's variables.
fn clear(context: &mut Context, _: &Call) -> Result<Outcome, ControllerError> {
    if context.task().is_none() {
        context.machine.memory.clear()?;
        if context.channel.is_some() {
            context.machine.requests.push(Request::ForgetAliases);
        }
        context.machine.requests.push(Request::ClearAllLocals);
    }
    // The VM clears the variables of the program.
    Ok(Outcome::Done)
}

fn dimension(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let command = call.command.info().name;
    if call.arguments.is_empty() {
        context.ask(Query::Dimensions(call.command));
        return Ok(Outcome::Done);
    }
    context.system_level(call)?;
    let mut numbers = Vec::new();
    for argument in call.arguments {
        match argument {
            Arg::Value(value, _) => numbers.push(real(command, value)? as i64),
            _ => return Err(ControllerError::Expected { command, expected: "sizes" }),
        }
    }
    let model = context.machine.model;
    let (block, size) = match (call.command, &numbers[..]) {
        (command::DIM_P, [count]) => (SystemBlock::Parameters, *count),
        (command::DIM_DEF, [count]) => (SystemBlock::Aliases, *count),
        (command::DIM_PROG, [index, size]) => {
            (SystemBlock::Program(Machine::object("PROG", *index, model.programs)?), *size)
        }
        (command::DIM_PLC, [index, size]) => (SystemBlock::Plc(Machine::object("PLC", *index, model.plcs)?), *size),
        (_, [size]) => (stream_block(context.machine, call.command, 0)?, *size),
        (_, [index, size]) => (stream_block(context.machine, call.command, *index)?, *size),
        _ => return Err(ControllerError::Expected { command, expected: "a size" }),
    };
    context.machine.memory.dimension(block, size)?;
    Ok(Outcome::Done)
}

/// `CLEAR COM1` and its like: the buffer has its 256 bytes of the factory again, which count for nothing.
fn clear_stream(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    context.system_level(call)?;
    let index = scalar(call)?.unwrap_or(0.0) as i64;
    let block = stream_block(context.machine, call.command, index)?;
    context.machine.memory.free_block(block);
    Ok(Outcome::Done)
}

/// The buffer of the stream that a `DIM` or `CLEAR` is about.
fn stream_block(machine: &Machine, command: CommandId, index: i64) -> Result<SystemBlock, ControllerError> {
    let stream = match command {
        command::DIM_COM1 | command::CLEAR_COM1 => StreamName::Com(1),
        command::DIM_COM2 | command::CLEAR_COM2 => StreamName::Com(2),
        command::DIM_FIFO | command::CLEAR_FIFO => StreamName::Fifo,
        command::DIM_DPCB | command::CLEAR_DPCB => StreamName::DualPort,
        _ => StreamName::Stream(u8::try_from(index).unwrap_or(u8::MAX)),
    };
    stream.check(machine.model).map_err(|error| ControllerError::Device(error.into()))?;
    Ok(SystemBlock::Stream(stream.into()))
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
        // A download sets what the one before it has set.
        Some(seconds) if seconds.to_bits() == context.machine.clock.period().to_bits() => {}
        Some(seconds) if context.machine.clock.ticks() == 0 => context.machine.clock.set_period(seconds),
        Some(_) => {
            let problem = "the servo period can only be set before time begins".to_owned();
            return Err(ControllerError::BadValue { command, problem });
        }
    }
    Ok(Outcome::Done)
}

impl Context<'_> {
    /// What executes the command; at a prompt, what the prompt belongs to.
    pub(super) fn task(&self) -> Option<Task> {
        match (&self.ladder, self.program, self.machine.level) {
            (Some(ladder), ..) => Some(Task::Plc(ladder.number())),
            (None, Some(program), _) => Some(Task::Program(program)),
            (None, None, Level::Plc(number)) if self.immediate => Some(Task::Plc(number)),
            (None, None, _) => None,
        }
    }

    /// Refuses a command that belongs to the system prompt anywhere else.
    fn system_level(&self, call: &Call) -> Result<(), ControllerError> {
        let level = match self.task() {
            None => return Ok(()),
            Some(Task::Program(_)) => "program",
            Some(Task::Plc(_)) => "PLC",
        };
        Err(ControllerError::WrongLevel { command: call.command.info().name, level: level.to_owned() })
    }

    /// The programs that a control command means.
    fn tasks(&self, call: &Call) -> Result<Vec<Task>, ControllerError> {
        let command = call.command.info().name;
        let model = self.machine.model;
        if call.arguments.is_empty() {
            let level = || self.machine.level.to_string();
            return self
                .task()
                .map(|task| vec![task])
                .ok_or_else(|| ControllerError::WrongLevel { command, level: level() });
        }
        let mut tasks = Vec::new();
        for argument in call.arguments {
            match argument {
                Arg::Word { keyword: Keyword::All, .. } => {
                    tasks.extend((0..model.programs).map(Task::Program));
                    if takes_plcs(call.command) {
                        tasks.extend((0..model.plcs).map(Task::Plc));
                    }
                }
                Arg::Object { kind: ObjectKind::Prog, index: Some(index), .. } => {
                    tasks.push(Task::Program(Machine::object("PROG", i64::from(*index), model.programs)?));
                }
                Arg::Object { kind: ObjectKind::Plc, index: Some(index), .. } if takes_plcs(call.command) => {
                    tasks.push(Task::Plc(Machine::object("PLC", i64::from(*index), model.plcs)?));
                }
                Arg::Object { kind: ObjectKind::Plc, .. } => return Err(only_programs(call.command)),
                _ => return Err(ControllerError::Expected { command, expected: "PROGn, PLCn or ALL" }),
            }
        }
        Ok(tasks)
    }
}

/// The commands that also act on PLC programs (guide, "Starting, Pausing, and Halting Programs").
fn takes_plcs(command: CommandId) -> bool {
    matches!(command, command::RUN | command::LRUN | command::LISTEN | command::HALT | command::NEW)
}

fn only_programs(command: CommandId) -> ControllerError {
    ControllerError::Expected { command: command.info().name, expected: "PROGn or ALL" }
}
