//! What the controller refuses, with the texts of the controller where they are known (`docs/fidelity.md`, error texts).

use acrc_catalog::{AliasNameError, CommandId, MessageId, command};
use acrc_image::UnitName;
use acrc_vm::FaultKind;
use thiserror::Error;

use crate::streams::DeviceError;
use crate::terminal::StreamName;

/// Why a statement could not be executed.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ControllerError {
    /// A text of the catalogue, with nothing to add.
    #[error("{}", .0.text())]
    Said(MessageId),
    /// The controller's text for a block that has memory already.
    #[error("Re-dimensioned block: {block} has {bytes} bytes already; CLEAR frees them")]
    Redimensioned {
        /// What has memory.
        block: String,
        /// How much.
        bytes: u32,
    },
    /// A size that no block can have.
    #[error("the size must be between 1 and {limit}")]
    DimensionRange {
        /// Largest size.
        limit: i64,
    },
    /// The memory is used up.
    #[error("out of memory: {needed} bytes are needed and {free} are free")]
    OutOfMemory {
        /// Bytes asked for.
        needed: u32,
        /// Bytes left.
        free: u32,
    },
    /// Space that `CLEAR` cannot free yet.
    #[error("{block} has a program: NEW erases it before CLEAR can free its space")]
    Stored {
        /// The program.
        block: String,
    },
    /// A rung of a PLC program that does not fit together.
    #[error("{command} needs {needed} in front of it on its rung")]
    Rung {
        /// The command.
        command: &'static str,
        /// What it works on.
        needed: &'static str,
    },
    /// A flag that PLC programs cannot use.
    #[error("BIT{number} is out of reach: PLC programs of this controller use BIT0 to BIT{last}")]
    PlcFlag {
        /// Its number.
        number: i64,
        /// The last one that they reach.
        last: u32,
    },
    /// A program does not fit its space.
    #[error("{unit} needs {needed} bytes but DIM {unit} gives {available}")]
    ProgramTooLarge {
        /// The program.
        unit: UnitName,
        /// Bytes of its text.
        needed: u64,
        /// Bytes of its space.
        available: u64,
    },
    /// An alias that cannot be called so.
    #[error("the alias {name} {problem}")]
    AliasName {
        /// The name.
        name: String,
        /// What is wrong with it.
        problem: AliasNameError,
    },
    /// An alias without room in the table.
    #[error("there is no room for the alias {name}: DIM DEF({room}) gives {room}")]
    AliasTableFull {
        /// Its name.
        name: String,
        /// How many the table holds.
        room: u32,
    },
    /// A text that was entered does not fit its space.
    #[error("{program} needs {needed} bytes but DIM {program} gives {available}")]
    TextTooLarge {
        /// `PROG0`, `PLC1`.
        program: String,
        /// Bytes of the text.
        needed: u64,
        /// Bytes of the space.
        available: u64,
    },
    /// A user parameter without memory.
    #[error("P{number} is outside DIM P({count})")]
    UserParameter {
        /// Its number.
        number: i64,
        /// How many there are.
        count: usize,
    },
    /// A number that is no parameter of this controller.
    #[error("P{0} is no parameter of this controller")]
    UnknownParameter(i64),
    /// A value that a parameter has no room for.
    #[error("P{number} cannot hold {value}")]
    ParameterRange {
        /// The parameter.
        number: i64,
        /// The value as it is printed.
        value: String,
    },
    /// A number that is no flag of this controller.
    #[error("BIT{0} is no flag of this controller")]
    UnknownBit(i64),
    /// A parameter or flag that programs can only read.
    #[error("{name} ({title}) is read-only")]
    ReadOnly {
        /// `P12291` or `BIT516`.
        name: String,
        /// What it is.
        title: &'static str,
    },
    /// A number outside the objects of the model.
    #[error("{object}{index} does not exist: this controller has {object}0 to {object}{last}")]
    NoSuchObject {
        /// `AXIS`, `MASTER`, ...
        object: &'static str,
        /// The number.
        index: i64,
        /// Highest number.
        last: u8,
    },
    /// A motion statement in a program that has no master.
    #[error("program {0} has no master: ATTACH MASTER comes first")]
    NoMaster(u8),
    /// `DETACH` of a master that the program does not have.
    #[error("program {program} is not attached to MASTER{master}")]
    NotAttached {
        /// The program.
        program: u8,
        /// The master.
        master: u16,
    },
    /// An axis name that the program has not attached.
    #[error("program {program} has no axis named {name}")]
    UnknownAxis {
        /// The program.
        program: u8,
        /// The name.
        name: String,
    },
    /// Attachments that contradict those that exist.
    #[error("{what} is attached already, to {owner}")]
    AlreadyAttached {
        /// `MASTER0`, `AXIS1`, `SLAVE0`.
        what: String,
        /// By whom.
        owner: String,
    },
    /// A statement for another prompt level.
    #[error("{command} is not possible at the {level} level")]
    WrongLevel {
        /// The command.
        command: &'static str,
        /// The level.
        level: String,
    },
    /// A value outside what the command takes.
    #[error("{command}: {problem}")]
    BadValue {
        /// The command.
        command: &'static str,
        /// What is wrong with the value, which is named.
        problem: String,
    },
    /// An argument that is missing or of the wrong form.
    #[error("{command} expects {expected}")]
    Expected {
        /// The command.
        command: &'static str,
        /// What it expects.
        expected: &'static str,
    },
    /// The attached axes may not be touched now; the controller's text.
    #[error("Not valid while in motion")]
    InMotion,
    /// A move while the master's Kill All Moves flag is set.
    #[error("master {master} has its Kill All Moves flag set (BIT{bit}): it must be cleared before a move")]
    Killed {
        /// The master.
        master: u8,
        /// The flag.
        bit: u32,
    },
    /// A move that the profiler refuses.
    #[error("{0}")]
    Move(String),
    /// Reading from a device that has no stream.
    #[error("#{device} is not open: OPEN \"COM1:9600,n,8,1\" AS #{device} or the like comes first")]
    NotOpen {
        /// The device.
        device: i32,
    },
    /// A typed statement reads what is typed.
    #[error(
        "#0 is this terminal, which takes commands: characters come from #1 to #3, once OPEN has given them a stream"
    )]
    OwnTerminal,
    /// `OPEN` of a device that has another stream.
    #[error("#{device} is open already, as {stream}: CLOSE #{device} comes first")]
    DeviceOpen {
        /// The device.
        device: u8,
        /// What it is.
        stream: StreamName,
    },
    /// `OPEN` of a stream that another device has.
    #[error("{stream} is open already, as #{device}: CLOSE #{device} comes first")]
    StreamOpen {
        /// The stream.
        stream: StreamName,
        /// The device that has it.
        device: u8,
    },
    /// `OPEN` of, or `TALK TO` something that is no device.
    #[error(transparent)]
    Device(#[from] DeviceError),
    /// A command that this dry run does not execute.
    #[error("{}", not_simulated(*.0))]
    NotSimulated(CommandId),
    /// A statement that the VM refuses.
    #[error(transparent)]
    Program(FaultKind),
}

/// What is said of a command that the dry run does not execute.
pub(crate) fn not_simulated(command: CommandId) -> String {
    let name = command.info().name;
    match command {
        command::DTALK => format!("{name} is not simulated: a dry run has no drive that could answer"),
        _ => format!("{name} is not simulated"),
    }
}

impl From<ControllerError> for FaultKind {
    fn from(error: ControllerError) -> Self {
        match error {
            ControllerError::Program(kind) => kind,
            other => Self::Controller(other.to_string().into()),
        }
    }
}
