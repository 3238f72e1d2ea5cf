//! Settings of masters that outlast a reset with those of `ESAVE` (guide, "Saving to and Erasing from Flash Memory").
//!
//! A master acts by what its profiler has been told. That is kept with the other settings as well, and told again when
//! they are loaded.

use acrc_catalog::{CommandId, Keyword, command};
use acrc_motion::Lookahead;
use acrc_vm::{Call, Outcome, Source, Value};

use super::Context;
use crate::error::ControllerError;
use crate::machine::Machine;
use crate::master::Look;
use crate::settings::Item;

/// A number as a setting.
pub(super) fn number(value: f64) -> Item {
    Item::Number(Value::Double(value))
}

impl Context<'_> {
    /// Keeps what a command has set for a master.
    pub(super) fn keep_for_master(
        &mut self,
        call: &Call,
        master: usize,
        items: Vec<Item>,
    ) -> Result<Outcome, ControllerError> {
        self.machine.set_setting(call.command, master as u16, items)?;
        Ok(Outcome::Done)
    }
}

impl Machine {
    /// Tells a master what settings that were loaded say of it.
    pub(crate) fn restore_master(&mut self, index: usize) -> Result<(), ControllerError> {
        let refused = |error: acrc_motion::SettingError| ControllerError::Move(error.to_string());
        let one = |command| self.numbers_of(command, index).first().copied();
        let (rapid, stretch) = (one(command::ROV).unwrap_or(1.0), one(command::TOV).unwrap_or(1.0));
        let mode = one(command::LOOK_MODE).unwrap_or(0.0);
        let angles = match self.numbers_of(command::LOOK_ANG, index)[..] {
            [full, stop] => Lookahead { full, stop },
            _ => Look::default().angles,
        };
        let source = match self.settings.of(command::SRC, index as u16)[..] {
            [Item::Source(source)] => source,
            _ => Source::Word(Keyword::Clock, None),
        };
        let master = &mut self.masters[index];
        master.profiler.set_rapid_override(rapid).map_err(refused)?;
        master.time.factor = stretch;
        master.look = Look { angles, mode, ..master.look };
        self.set_source(index, source)
    }

    /// The numbers that a command has set for a master; none at power-up.
    fn numbers_of(&self, command: CommandId, master: usize) -> Vec<f64> {
        let items = self.settings.of(command, master as u16);
        let number = |item: &Item| if let Item::Number(value) = item { value.to_f64().ok() } else { None };
        items.iter().filter_map(number).collect()
    }
}
