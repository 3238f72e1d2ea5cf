//! Feedrate and rapid override at once (guide, "Binary FOV Command", "Binary ROV Command").

use acrc_catalog::{CommandId, command};

use super::{HostError, number};
use crate::controller::{Controller, Observer};
use crate::machine::Machine;

/// An override of velocities.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Override {
    /// Of moves: `FOV`.
    Feedrate,
    /// Of rapid moves: `ROV`.
    Rapid,
}

impl Override {
    const fn command(self) -> CommandId {
        match self {
            Self::Feedrate => command::FOV,
            Self::Rapid => command::ROV,
        }
    }
}

impl Controller {
    /// Gives masters an override, as `FOV` and `ROV` do. `masters` has one bit for each, the lowest for master 0; 1 is no override.
    ///
    /// # Errors
    /// When the factor is negative or no number. Masters that the model lacks are an error after those that it has are changed.
    pub fn set_override(
        &mut self,
        kind: Override,
        masters: u16,
        factor: f32,
        observer: &mut dyn Observer,
    ) -> Result<(), HostError> {
        let factor = f64::from(number::finite(factor)?);
        let mut changed = Ok(());
        for master in (0..u16::BITS).filter(|master| masters >> master & 1 == 1) {
            let exists = Machine::object("MASTER", i64::from(master), self.machine.model.masters);
            let set =
                exists.and_then(|master| self.machine.set_profile_value(usize::from(master), kind.command(), factor));
            changed = changed.and(set);
        }
        self.conclude_order(observer);
        Ok(changed?)
    }
}
