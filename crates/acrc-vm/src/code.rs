//! A program that is ready to run.

use acrc_image::UnitName;

use crate::account::{Account, Begins, Route};
use crate::fault::FaultKind;
use crate::functions::AngleUnit;
use crate::op::Op;
use crate::plan::Plan;
use crate::value::Value;

/// A stored program, verified and decoded to the register form. Immutable; [`Code::load`] makes it.
#[derive(Clone, Debug)]
pub struct Code {
    pub(crate) name: UnitName,
    pub(crate) ops: Box<[Op]>,
    /// One for each instruction, and one for the end.
    pub(crate) accounts: Box<[Account]>,
    /// One for each instruction; those of jumps count.
    pub(crate) routes: Box<[Route]>,
    /// Strings and other constants of the value file.
    pub(crate) constants: Box<[Value]>,
    /// Real constants, with 32 bits and as the decimal that was written.
    pub(crate) reals: Box<[Real]>,
    pub(crate) plans: Box<[Plan]>,
    pub(crate) faults: Box<[FaultKind]>,
    /// Value slots that a statement needs at most.
    pub(crate) value_slots: usize,
    /// Number of `FOR` statements.
    pub(crate) loops: usize,
    pub(crate) angle: AngleUnit,
    pub(crate) statements: Box<[StatementMark]>,
    pub(crate) unconfirmed: Box<[Unconfirmed]>,
}

/// A real constant of at most seven digits.
///
/// Beside a number of 32 bits it counts with 32 bits, so that `SV0 = 0.1` makes `SV0 = 0.1` true; anywhere else it is
/// the decimal that was written, so that `P0 = 0.1` prints 0.1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Real {
    pub(crate) single: f32,
    pub(crate) decimal: f64,
}

impl Real {
    pub(crate) fn new(single: f32) -> Self {
        // The shortest digits that give the stored number back are those that were written.
        let decimal = single.to_string().parse().unwrap_or_else(|_| f64::from(single));
        Self { single, decimal }
    }
}

/// Where the instructions of a statement begin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StatementMark {
    pub(crate) pc: u32,
    pub(crate) location: Location,
    /// Where the program goes on when the statement is given up, with all that depends on it.
    pub(crate) behind: u32,
}

/// The place of a statement.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Location {
    /// Address of the statement in words from the start of the unit.
    pub address: u32,
    /// Line of the unit, from 1. Lines that vanish at compile time (blank ones, apostrophe comments) do not count.
    pub line: u32,
    /// Statement of the line, from 1.
    pub statement: u32,
    /// The number written at the start of the line.
    pub number: Option<i32>,
    /// Where it stands in the source; `None` without a debug map.
    pub source: Option<acrc_image::Location>,
}

impl Location {
    /// Line of the source file when it is known, else line of the unit; from 1.
    pub fn source_line(&self) -> u32 {
        self.source.map_or(self.line, |source| source.line)
    }
}

/// Behaviour that a program relies on and that no document at hand describes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unconfirmed {
    /// The function or operator.
    pub name: &'static str,
    /// What is not known.
    pub doubt: Doubt,
    /// The first statement that uses it.
    pub location: Location,
}

/// What is not known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Doubt {
    /// Whether it exists, or what exactly it does.
    Existence,
    /// Whether its angle is in radians.
    AngleUnit,
}

impl Code {
    /// Which unit it was made from.
    pub fn name(&self) -> UnitName {
        self.name
    }

    /// The statement that an instruction belongs to.
    pub fn location(&self, pc: u32) -> Location {
        self.statement(pc).map_or_else(Location::default, |mark| mark.location)
    }

    /// The statements in their order; what a coverage report counts against.
    pub fn locations(&self) -> impl ExactSizeIterator<Item = Location> {
        self.statements.iter().map(|mark| mark.location)
    }

    /// What the program uses although its behaviour is not documented, each once.
    pub fn unconfirmed(&self) -> &[Unconfirmed] {
        &self.unconfirmed
    }

    /// Whether an instruction is slow and begins nothing.
    pub(crate) fn continues_slowly(&self, pc: u32) -> bool {
        let begins = self.accounts.get(pc as usize).map(|account| account.begins);
        begins == Some(Begins::Nothing) && self.ops.get(pc as usize).is_some_and(Op::is_slow)
    }

    /// Where the statement of an instruction begins.
    pub(crate) fn statement_start(&self, pc: u32) -> u32 {
        self.statement(pc).map_or(pc, |mark| mark.pc)
    }

    /// Where the program goes on behind the statement of an instruction and all that depends on it.
    pub(crate) fn next_statement(&self, pc: u32) -> u32 {
        self.statement(pc).map_or(self.ops.len().saturating_sub(1) as u32, |mark| mark.behind)
    }

    fn statement(&self, pc: u32) -> Option<&StatementMark> {
        let behind = self.statements.partition_point(|mark| mark.pc <= pc);
        behind.checked_sub(1).and_then(|index| self.statements.get(index))
    }
}
