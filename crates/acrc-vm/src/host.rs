//! What a program asks of the controller around it.

use acrc_catalog::{CommandId, Keyword, ObjectKind, OperandClass};
use acrc_image::{AxisName, Mark};

use crate::fault::FaultKind;
use crate::text::Text;
use crate::value::Value;

/// The controller around a program.
///
/// The machine is generic over its host, so that these calls can be inlined. A fault that a method returns stops the
/// program at the present statement.
pub trait Host {
    /// Reads `P<number>`. User variables `P0` to `P4095`, which have 64 bits, come here when their number is computed.
    fn parameter(&mut self, number: i64) -> Result<Value, FaultKind>;

    /// Writes `P<number>`. The value is a number, never a string.
    fn set_parameter(&mut self, number: i64, value: &Value) -> Result<(), FaultKind>;

    /// Reads a user variable, `P0` to `P4095`.
    #[inline]
    fn user(&mut self, number: u16) -> Result<f64, FaultKind> {
        self.parameter(i64::from(number))?.to_f64()
    }

    /// Writes a user variable, `P0` to `P4095`.
    #[inline]
    fn set_user(&mut self, number: u16, value: f64) -> Result<(), FaultKind> {
        self.set_parameter(i64::from(number), &Value::Double(value))
    }

    /// Reads a flag.
    fn bit(&mut self, number: i64) -> Result<bool, FaultKind>;

    /// Writes a flag: `BIT 32 = 1`, and also `SET 32` and `CLR 32`, which the guide calls the same.
    fn set_bit(&mut self, number: i64, state: bool) -> Result<(), FaultKind>;

    /// Executes a command: everything but flow, assignments, `SET` and `CLR` of one flag, and `DIM` of local variables
    /// and of the move buffer.
    /// A bare `CLEAR` comes here before the local variables are cleared.
    fn command(&mut self, call: &Call) -> Result<Outcome, FaultKind>;

    /// Told how many moves the move buffer of the program holds from now on (`DIM MBUF`, `CLEAR MBUF`, `CLEAR`); 0 without memory.
    fn move_buffer(&mut self, moves: u32) {
        let _ = moves;
    }

    /// A whole number from 0 up to, not including, `below`, which is at least 1.
    fn random(&mut self, below: u32) -> u32;

    /// Takes the next character that waits at a device, if there is one (`INKEY$`, `GETCH`).
    fn take_character(&mut self, device: i32) -> Result<Option<u8>, FaultKind>;

    /// True when a character waits at a device (`KBHIT`).
    fn character_waits(&mut self, device: i32) -> Result<bool, FaultKind>;

    /// Called before the program reads or changes anything but user variables, with how much of its budget it has used:
    /// for a host that lets a program run ahead and finds out only now what time it is.
    #[inline]
    fn reached(&mut self, used: u32) {
        let _ = used;
    }

    /// Asked after the program has changed anything but user variables. True stops the run in front of the next line, as
    /// if the budget were used up: for a host that has to see to something first.
    #[inline]
    fn interrupts(&self) -> bool {
        false
    }

    /// Whether [`Host::statement`] is called, which takes time.
    const WATCHES_STATEMENTS: bool = false;

    /// Called before every statement with its place ([`crate::Code::location`]), for tracing and coverage, if
    /// [`Host::WATCHES_STATEMENTS`] says so.
    #[inline]
    fn statement(&mut self, pc: u32) {
        let _ = pc;
    }
}

/// A command with its arguments evaluated.
#[derive(Clone, Copy, Debug)]
pub struct Call<'a> {
    /// The command.
    pub command: CommandId,
    /// The object in front of it: `AXIS0 PPU 4000`.
    pub prefix: Option<(ObjectKind, Option<u16>)>,
    /// Its arguments in the order of the source.
    pub arguments: &'a [Arg],
    /// False when the call is offered again after [`Outcome::Again`].
    pub first: bool,
}

/// One argument.
#[derive(Clone, Debug, PartialEq)]
pub enum Arg {
    /// A value and what stands behind it.
    Value(Value, Mark),
    /// An axis by name.
    Axis {
        /// Its name.
        name: AxisName,
        /// A slash stands in front of the value: relative.
        slash: bool,
        /// Its value.
        value: ArgValue,
    },
    /// An object by number; also an axis by number, `AXIS3 5`.
    Object {
        /// What it is.
        kind: ObjectKind,
        /// Its number.
        index: Option<u16>,
        /// A slash stands in front of the value: relative.
        slash: bool,
        /// Its value.
        value: ArgValue,
    },
    /// Values in parentheses: `(100, 5)`.
    Tuple(Vec<Value>),
    /// A word that is only part of a statement.
    Word {
        /// Which.
        keyword: Keyword,
        /// The number glued to it.
        index: Option<u16>,
    },
    /// The kind of the moves behind it.
    Interpolation(CommandId),
    /// `#1`
    Device(i32),
    /// An operand that the command names instead of reading it.
    Reference {
        /// The operand.
        target: Reference,
        /// A minus stands in front of it: `IHPOS -P12290 (100, 5)`.
        negative: bool,
        /// What stands behind it; a semicolon behind the last variable of an `INPUT` keeps the cursor on the line.
        mark: Mark,
    },
    /// A flag that the command names.
    Bit {
        /// Its number.
        index: i64,
        /// A minus stands in front of it: `INH -516`.
        negative: bool,
    },
}

/// What stands behind an axis or an object.
#[derive(Clone, Debug, PartialEq)]
pub enum ArgValue {
    /// Nothing: the command reports, or needs no value.
    None,
    /// One value.
    Value(Value),
    /// Values in parentheses.
    Tuple(Vec<Value>),
    /// Values in parentheses and an array that the command reads: `CAM SEG X (0, 500, LA0)`.
    Table {
        /// The values.
        values: Vec<Value>,
        /// The array.
        table: Reference,
    },
    /// A source: `GEAR SRC X ENC2`.
    Source(Source),
}

/// Where a command takes a signal from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// An object by number.
    Object(ObjectKind, Option<u16>),
    /// A parameter or a variable.
    Reference(Reference),
    /// `NONE`, `CLOCK`.
    Word(Keyword, Option<u16>),
}

/// An operand as a place, with its numbers evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Reference {
    /// `P<n>`
    Parameter(i64),
    /// `BIT<n>`
    Bit(i64),
    /// `LV<n>`, `SV<n>`, `DV<n>`, `$V<n>`
    Variable {
        /// Its class.
        class: OperandClass,
        /// Its number.
        index: i64,
    },
    /// `LA<n>(i)` and its like.
    Element {
        /// Class of the array.
        class: OperandClass,
        /// Number of the array.
        array: i64,
        /// Number of the element.
        element: i64,
    },
    /// `LA<n>`: an array as a whole.
    Array {
        /// Class of the array.
        class: OperandClass,
        /// Number of the array.
        array: i64,
    },
}

/// What a command did.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// It is done.
    Done,
    /// It has to wait (`DWL`, `INH`, a full move queue). The same evaluated call is offered again when the program next
    /// gets its slice.
    Again,
    /// It ended this program (`HALT` of itself).
    End,
    /// Only for `INPUT`: the line that was typed. The machine stores it in the variables, a comma between two values.
    Input(Text),
}
