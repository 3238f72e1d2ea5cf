//! Values that a command sets and reports but that have no effect on an ideal machine: servo gains, error bands, output gains, jog profiles.
//!
//! They are kept so that a program can set them, ask for them and find what it wrote.

use std::collections::BTreeMap;

use acrc_catalog::CommandId;

/// Values of settings by command and object number.
#[derive(Clone, Debug, Default)]
pub(crate) struct Settings {
    values: BTreeMap<(CommandId, u16), Vec<f64>>,
}

impl Settings {
    /// Stores the values of one object.
    pub(crate) fn set(&mut self, command: CommandId, object: u16, values: Vec<f64>) {
        self.values.insert((command, object), values);
    }

    /// The values of one object; `None` while nothing has set them.
    pub(crate) fn get(&self, command: CommandId, object: u16) -> Option<&[f64]> {
        self.values.get(&(command, object)).map(Vec::as_slice)
    }
}
