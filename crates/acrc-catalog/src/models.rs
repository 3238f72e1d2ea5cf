//! Controller models (guide, "Masters", "Slaves", "Memory Allocations").

use crate::Confidence;
use crate::generated::{DEFAULT_MODEL, MODELS};
use crate::memory::FACTORY_PROGRAM_BYTES;

/// A controller model. What no document states is assumed, and [`Model::note`] says so.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Model {
    /// Its name: `ACR9000`.
    pub name: &'static str,
    /// Number of programs.
    pub programs: u8,
    /// Number of PLC programs.
    pub plcs: u8,
    /// Number of masters.
    pub masters: u8,
    /// Number of axes that the firmware has.
    pub axes: u8,
    /// Number of slave slots of each master.
    pub slaves: u8,
    /// Its communication streams.
    pub streams: &'static [&'static str],
    /// Memory for programs, variables and buffers, in bytes.
    pub user_memory: u32,
    /// Servo period with factory settings, in seconds.
    pub servo_period: f64,
    /// The last flag that its PLC programs reach, where that is not all of them.
    pub plc_last_flag: Option<u32>,
    /// Where the binary host interface finds the address of the user parameters, where a document states it.
    pub system_pointer: Option<u32>,
    /// What is stated and what is assumed.
    pub note: &'static str,
    /// Where the row comes from (`data/README.md`).
    pub source: &'static str,
    /// How well it is attested.
    pub confidence: Confidence,
}

impl Model {
    /// Memory that its system level shares out to programs, PLC programs, user parameters, aliases and stream buffers, in
    /// bytes. Never less than what the factory settings give to the programs.
    pub const fn system_memory(&self) -> u32 {
        if self.user_memory > FACTORY_PROGRAM_BYTES { self.user_memory } else { FACTORY_PROGRAM_BYTES }
    }
}

/// Every model.
pub fn models() -> &'static [Model] {
    MODELS
}

/// The model with this name, in any case.
pub fn model(name: &str) -> Option<&'static Model> {
    MODELS.iter().find(|model| model.name.eq_ignore_ascii_case(name))
}

/// The model of a project that names none.
pub fn default_model() -> &'static Model {
    DEFAULT_MODEL
}
