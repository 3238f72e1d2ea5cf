//! What a run reports.

use std::fmt;

use acrc_image::UnitName;

use crate::axis::AxisStatistics;
use crate::master::MasterStatistics;
use crate::program::State;
use crate::streams::Port;

/// A run-time error.
#[derive(Clone, Debug, PartialEq)]
pub struct FaultReport {
    /// Virtual time in seconds.
    pub seconds: f64,
    /// Which text it happened in.
    pub unit: UnitName,
    /// Source file, when the image knows it.
    pub file: Option<String>,
    /// Line of the file, or of the stored program when the image has no debug section; from 1.
    pub line: Option<u32>,
    /// Statement within the line, from 1.
    pub statement: u32,
    /// What is wrong.
    pub message: String,
    /// Whoever listens to the program at a terminal has been told.
    pub heard: bool,
}

impl fmt::Display for FaultReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.unit {
            UnitName::Boot => f.write_str("setup")?,
            unit => write!(f, "{unit}")?,
        }
        if let Some(file) = &self.file {
            write!(f, " {file}")?;
        }
        if let Some(line) = self.line {
            write!(f, " line {line}")?;
        }
        write!(f, " statement {}: {}", self.statement, self.message)
    }
}

/// State of a program or PLC program.
#[derive(Clone, Debug, PartialEq)]
pub struct ProgramReport {
    /// Which it is.
    pub unit: UnitName,
    /// Where it is in its life.
    pub state: State,
    /// Line of its next statement, from 1; the last one when it has ended.
    pub line: Option<u32>,
    /// Where it waits for characters (`INPUT`, `GETCH`).
    pub awaits: Option<Port>,
    /// Statements executed.
    pub statements: u64,
}

/// What an axis did.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisReport {
    /// Its number.
    pub axis: u8,
    /// Its name in the program that has it as a slave.
    pub name: Option<String>,
    /// Position in units.
    pub position: f64,
    /// Travel and peaks.
    pub statistics: AxisStatistics,
    /// It moved although its drive was never enabled.
    pub moved_disabled: bool,
}

/// What a master did.
#[derive(Clone, Debug, PartialEq)]
pub struct MasterReport {
    /// Its number.
    pub master: u8,
    /// Moves completed and ticks in motion.
    pub statistics: MasterStatistics,
    /// Time in motion in seconds.
    pub motion_seconds: f64,
}
