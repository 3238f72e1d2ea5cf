//! A look at the controller between two ticks.

use acrc_image::UnitName;

use crate::machine::Machine;
use crate::plc::Plc;
use crate::program::{Program, State};
use crate::world::World;

/// A look at the controller between two ticks.
pub struct View<'a> {
    pub(super) machine: &'a Machine,
    pub(super) programs: &'a [Program],
    pub(super) plcs: &'a [Plc],
}

/// Where a program stands: at the statement that waits, else at the one that comes next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Standing {
    /// Which program it is.
    pub unit: UnitName,
    /// Where it is in its life.
    pub state: State,
    /// Index of the source file among the files of the image, when that is known.
    pub file: Option<u32>,
    /// Line of the file, else of the stored text; from 1.
    pub line: u32,
    /// Statement of the line, from 1.
    pub statement: u32,
}

impl View<'_> {
    /// Virtual time in seconds.
    pub fn seconds(&self) -> f64 {
        self.machine.clock.seconds()
    }

    /// Ticks since power-up.
    pub fn ticks(&self) -> u64 {
        self.machine.clock.ticks()
    }

    /// Servo period in seconds.
    pub fn period(&self) -> f64 {
        self.machine.clock.period()
    }

    /// The axes that are slaves of some master, ascending.
    pub fn axes(&self) -> Vec<u8> {
        (0..self.machine.model.axes).filter(|axis| self.machine.axes[usize::from(*axis)].slave.is_some()).collect()
    }

    /// The name that a program gives an axis.
    pub fn axis_name(&self, axis: u8) -> Option<String> {
        self.machine.axis_name(axis).map(|name| name.to_string())
    }

    /// Actual position of an axis in units; 0 for an axis that the model does not have.
    pub fn position(&self, axis: u8) -> f64 {
        if axis < self.machine.model.axes { self.machine.registers_of(axis).actual } else { 0.0 }
    }

    /// Velocity (units/s) and acceleration (units/s^2) of an axis; 0 for an axis that the model does not have.
    pub fn motion(&self, axis: u8) -> (f64, f64) {
        if axis < self.machine.model.axes { self.machine.motion(axis) } else { (0.0, 0.0) }
    }

    /// The value of a parameter as a program would read it; `None` for one that does not exist, or not yet, or holds text.
    pub fn parameter(&self, number: u32) -> Option<f64> {
        self.machine.read_parameter(i64::from(number)).ok()?.to_f64().ok()
    }

    /// Where the programs and PLC programs stand that have text.
    pub fn standings(&self) -> impl Iterator<Item = Standing> {
        let programs = (0..).zip(self.programs).map(|(number, program)| (UnitName::Program(number), program));
        let plcs = self.plcs.iter().map(|plc| (UnitName::Plc(plc.ladder.number()), &plc.program));
        programs.chain(plcs).filter(|(_, program)| program.code.is_some()).map(|(unit, program)| {
            let location = program.location();
            Standing {
                unit,
                state: program.state,
                file: location.source.map(|source| source.file),
                line: location.source_line(),
                statement: location.statement,
            }
        })
    }

    /// State of a flag; flags that do not exist are clear.
    pub fn bit(&self, bit: u32) -> bool {
        self.machine.flags.get(bit)
    }

    /// The scripted world.
    pub fn world(&self) -> &World {
        self.machine.world()
    }
}
