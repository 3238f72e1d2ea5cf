//! A look at the controller between two ticks.

use crate::machine::Machine;
use crate::world::World;

/// A look at the controller between two ticks.
pub struct View<'a> {
    pub(super) machine: &'a Machine,
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

    /// State of a flag; flags that do not exist are clear.
    pub fn bit(&self, bit: u32) -> bool {
        self.machine.flags.get(bit)
    }

    /// The scripted world.
    pub fn world(&self) -> &World {
        self.machine.world()
    }
}
