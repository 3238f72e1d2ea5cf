//! Why a program cannot be loaded.

use acrc_catalog::CommandId;
use acrc_image::{ImageError, UnitName};
use thiserror::Error;

use crate::code::Location;

/// A program that cannot be loaded, and the statement at fault.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{}{kind}", place(*unit, location))]
pub struct LoadError {
    /// What is wrong.
    pub kind: LoadErrorKind,
    /// In which unit.
    pub unit: UnitName,
    /// Where; line 0 when the words could not be read at all.
    pub location: Location,
}

fn place(unit: UnitName, location: &Location) -> String {
    match location.source_line() {
        0 => String::new(),
        line => format!("{unit}, line {line}: "),
    }
}

/// What is wrong with a program.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum LoadErrorKind {
    /// The words are no program.
    #[error(transparent)]
    Image(#[from] ImageError),
    /// A statement that closes or divides a block that is not open.
    #[error("{} without {opener}", closer.info().name)]
    NotOpen {
        /// The statement.
        closer: CommandId,
        /// What should stand before it.
        opener: &'static str,
    },
    /// A block that is never closed.
    #[error("{} without {closer}", opener.info().name)]
    NotClosed {
        /// The statement that opens it.
        opener: CommandId,
        /// What should stand behind it.
        closer: &'static str,
    },
    /// A block that crosses the end of another: `FOR`, `WHILE`, `NEXT`.
    #[error("{} closes a {} block that stands inside it", closer.info().name, inner.info().name)]
    Crossed {
        /// The closing statement.
        closer: CommandId,
        /// What opened the inner block.
        inner: CommandId,
    },
    /// A block that is only half inside a line that depends on `THEN`.
    #[error("{} behind THEN belongs to a block that is not on the same line", .0.info().name)]
    BlockAcrossThen(CommandId),
    /// A second `ELSE`, or `ELSEIF` behind `ELSE`.
    #[error("{} behind ELSE", .0.info().name)]
    BehindElse(CommandId),
    /// `GOTO` and `GOSUB` with nothing behind them.
    #[error("{} needs a label or a line number", .0.info().name)]
    NoTarget(CommandId),
    /// The target of an assignment is no operand.
    #[error("only parameters, flags and variables can be assigned to")]
    NotAssignable,
    /// Something stands where a value belongs.
    #[error("this is no value")]
    NotAValue,
    /// The alias table is too short.
    #[error("alias {0} is not defined")]
    UnknownAlias(u16),
    /// A statement with too many intermediate results.
    #[error(
        "the statement is too long to be executed at once: it needs more than {} intermediate results",
        crate::op::SCRATCH
    )]
    TooComplex,
    /// A program with more loops than can be numbered.
    #[error("the program has more than {} FOR statements", u16::MAX)]
    TooManyLoops,
}
