//! What a controller keeps without power (guide, "Memory Allocations", "Resetting the Controller", "Return to Factory Default").
//!
//! Three memories outlast a reset:
//!
//! - battery-backed memory: all that `DIM` gave out, programs, aliases and user parameters ([`Memory`]);
//! - the saved system parameters: attachments, gains, settings of axes and masters ([`SystemParameters`]);
//! - the user image in flash memory, which takes the place of battery-backed memory at power-up ([`FlashImage`]).
//!
//! The table of rules says which command does what to which of them. Everything here is plain data; nobody but `acrc-store` knows files.

mod parameters;
mod power;
mod prom;
mod restart;
mod saved;

use acrc_catalog::{CommandId, command};

pub use power::RestoreError;
pub use saved::{
    AxisParameters, FlashImage, MasterParameters, Memory, Saved, Setting, SettingValue, Slave, SystemParameters,
    TypedLine, TypedText,
};

/// What a command does to the memories.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operation {
    /// Copies the system parameters to their memory.
    SaveParameters,
    /// Copies them back.
    LoadParameters,
    /// Forgets the saved system parameters; those in use stay.
    EraseParameters,
    /// Copies programs, with their memory and the aliases that they refer to, to flash memory.
    FlashPrograms,
    /// The same, with user parameters and all that `DIM` gave out.
    FlashEverything,
    /// Copies the image in flash memory back.
    LoadFlash,
    /// No longer copies it back at power-up.
    RetireFlash,
    /// Forgets it.
    EraseFlash,
    /// Disconnects the battery until power comes back.
    DisconnectBattery,
    /// Restarts the controller.
    Reboot,
    /// Sends the stored programs in the form that EPROM programmers read.
    DumpPrograms,
}

/// One command on the memories.
pub(crate) struct Rule {
    pub(crate) command: CommandId,
    pub(crate) operation: Operation,
    /// Models that do not have what it is about.
    pub(crate) missing: fn(&str) -> bool,
    /// It changes attachments or programs under a motion, so nothing may move.
    pub(crate) at_rest: bool,
    /// It is about an image that must be there.
    pub(crate) needs_image: bool,
}

const fn rule(command: CommandId, operation: Operation) -> Rule {
    Rule { command, operation, missing: has_everything, at_rest: false, needs_image: false }
}

/// Every command on the memories. Sources: the guide's table of non-volatile commands, "Velocity Profile Setup" (what `ESAVE`
/// saves and that a reset undoes the rest), "Return to Factory Default" (`FLASH` is not for ACR8000), the caution of "Memory
/// Allocations" (`BRESET`), and the catalogue's rows of these commands.
pub(crate) const RULES: &[Rule] = &[
    rule(command::ESAVE, Operation::SaveParameters),
    Rule { at_rest: true, ..rule(command::ELOAD, Operation::LoadParameters) },
    rule(command::ERASE, Operation::EraseParameters),
    Rule { missing: has_no_flash, ..rule(command::FLASH_SAVE, Operation::FlashPrograms) },
    Rule { missing: has_no_flash, ..rule(command::FLASH_IMAGE, Operation::FlashEverything) },
    Rule { missing: has_no_flash, at_rest: true, needs_image: true, ..rule(command::FLASH_LOAD, Operation::LoadFlash) },
    Rule { missing: has_no_flash, ..rule(command::FLASH_RES, Operation::RetireFlash) },
    Rule { missing: has_no_flash, ..rule(command::FLASH_ERASE, Operation::EraseFlash) },
    rule(command::BRESET, Operation::DisconnectBattery),
    rule(command::REBOOT, Operation::Reboot),
    Rule { missing: has_no_eprom, ..rule(command::PROM, Operation::DumpPrograms) },
];

fn has_everything(_: &str) -> bool {
    false
}

fn has_no_flash(model: &str) -> bool {
    model == "ACR8000"
}

fn has_no_eprom(model: &str) -> bool {
    !["ACR2000", "ACR8000", "ACR8010", "ACR8020"].contains(&model)
}

/// What keeps the memory without power.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Battery {
    /// It has none: a reset loses the memory.
    Absent,
    /// The memory outlasts a reset.
    #[default]
    Connected,
    /// `BRESET` disconnected it: a reset loses the memory, and connects it again only when power was off.
    Disconnected,
}

/// The memories that outlast a reset beside battery-backed memory, which is the working memory itself.
#[derive(Clone, Debug, Default)]
pub(crate) struct NonVolatile {
    pub(crate) battery: Battery,
    pub(crate) parameters: Option<SystemParameters>,
    pub(crate) image: Option<FlashImage>,
}

impl Operation {
    /// It changes what outlasts a reset.
    pub(crate) fn saves(self) -> bool {
        !matches!(self, Self::LoadParameters | Self::LoadFlash | Self::Reboot | Self::DumpPrograms)
    }
}
