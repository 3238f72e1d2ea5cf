//! Why a program cannot go on.
//!
//! The guide names two of the controller's own texts that concern a running program ("Re-dimensioned block" and
//! "Associated Slave Kill Motion Request Active"); the others are this tool's, since the controller's are not
//! documented. A message names the thing and its limit.

use acrc_catalog::{CommandId, OperandClass};
use thiserror::Error;

use crate::code::{Code, Location};
use crate::format::number;
use crate::value::Value;

/// What went wrong.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum FaultKind {
    /// `/` or `MOD` by zero.
    #[error("division by zero")]
    DivisionByZero,
    /// A result beyond the range of floating point numbers.
    #[error("the result of {operation} is beyond the range of numbers")]
    NotFinite {
        /// What was computed.
        operation: &'static str,
    },
    /// A number beyond the range of the 32-bit variable that is to hold it.
    #[error("{} is beyond the range of 32-bit floating point numbers", number(&Value::Double(*.0)))]
    NotSingle(f64),
    /// An argument that a function has no result for.
    #[error("{function} has no result for {argument}")]
    Domain {
        /// The function or operator.
        function: &'static str,
        /// Its argument.
        argument: f64,
    },
    /// A string where a number belongs.
    #[error("a number is needed here, this is a string")]
    NumberExpected,
    /// A number where a string belongs.
    #[error("a string is needed here, this is a number")]
    TextExpected,
    /// A local variable that does not exist.
    #[error("{}", outside(*class, *index, *count))]
    Undimensioned {
        /// Class of the variable.
        class: OperandClass,
        /// Its number.
        index: i64,
        /// How many there are; 0 before `DIM`.
        count: u32,
    },
    /// An array that does not exist.
    #[error("{}", outside(*class, *array, *arrays))]
    NoSuchArray {
        /// Class of the array.
        class: OperandClass,
        /// Its number.
        array: i64,
        /// How many there are; 0 before `DIM`.
        arrays: u32,
    },
    /// An array that has a number but no elements yet.
    #[error("{}{array} has no elements before DIM {}{array}(size)", class.name(), class.name())]
    EmptyArray {
        /// Class of the array.
        class: OperandClass,
        /// Its number.
        array: i64,
    },
    /// An element that does not exist.
    #[error("{}{array}({element}) is outside DIM {}{array}({size})", class.name(), class.name())]
    NoSuchElement {
        /// Class of the array.
        class: OperandClass,
        /// Its number.
        array: i64,
        /// The element.
        element: i64,
        /// How many elements there are.
        size: u32,
    },
    /// A whole array where one value belongs.
    #[error("{}{array} is a whole array, its elements are {}{array}(0) and so on", class.name(), class.name())]
    ArrayAsValue {
        /// Class of the array.
        class: OperandClass,
        /// Its number.
        array: i64,
    },
    /// A block that has memory already (the controller's own text).
    #[error("Re-dimensioned block")]
    Redimensioned,
    /// A negative size.
    #[error("DIM cannot give {size} elements")]
    NegativeSize {
        /// The size.
        size: i32,
    },
    /// More memory than the program has.
    #[error("{needed} bytes do not fit into the {free} bytes that the program has left")]
    OutOfMemory {
        /// What is asked for.
        needed: u64,
        /// What is left.
        free: u64,
    },
    /// More calls than the memory of the program allows.
    #[error("GOSUB {depth} levels deep needs 4 bytes a level, the program has no memory left")]
    GosubTooDeep {
        /// The level that does not fit.
        depth: usize,
    },
    /// `RETURN` with no call to go back to.
    #[error("RETURN without GOSUB")]
    ReturnWithoutGosub,
    /// `NEXT` of a loop that was never entered through its `FOR`, or that ended.
    #[error("NEXT without a running FOR")]
    NextWithoutFor,
    /// `BREAK` with no loop around it.
    #[error("BREAK outside of a loop")]
    BreakOutsideLoop,
    /// A loop that would never end.
    #[error("STEP {step} does not count up; FOR counts upwards only")]
    StepNotPositive {
        /// The step.
        step: f64,
    },
    /// A jump to a line that is not there.
    #[error("there is no line {line}")]
    NoSuchLine {
        /// The line number.
        line: i32,
    },
    /// A parameter that the controller does not have.
    #[error("P{0} does not exist")]
    UnknownParameter(i64),
    /// A parameter that cannot be written.
    #[error("P{0} can only be read")]
    ReadOnlyParameter(i64),
    /// A flag that the controller does not have.
    #[error("BIT{0} does not exist")]
    UnknownBit(i64),
    /// A flag that cannot be written.
    #[error("BIT{0} can only be read")]
    ReadOnlyBit(i64),
    /// A command that cannot be executed here.
    #[error("{} cannot be executed here", .0.info().name)]
    Unsupported(CommandId),
    /// A function that cannot be evaluated here.
    #[error("{0} cannot be evaluated: its behaviour is not documented")]
    UnknownFunction(&'static str),
    /// An argument that a command does not take.
    #[error("{0}")]
    Argument(Box<str>),
    /// A refusal in the controller's own words.
    #[error("{0}")]
    Controller(Box<str>),
}

fn outside(class: OperandClass, index: i64, count: u32) -> String {
    let name = class.name();
    match (class, count) {
        (_, 0) => format!("{name}{index} has no memory: no DIM {name} was executed"),
        (OperandClass::StringV, _) => format!("{name}{index} is outside DIM {name}({count}, length)"),
        _ => format!("{name}{index} is outside DIM {name}({count})"),
    }
}

/// A fault and the place of the program where it happened.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{kind}")]
pub struct Fault {
    /// What went wrong.
    pub kind: FaultKind,
    /// Where, as [`Code::location`] takes it.
    pub pc: u32,
}

impl Fault {
    /// Where it happened, for people.
    pub fn location(&self, code: &Code) -> Location {
        code.location(self.pc)
    }
}
