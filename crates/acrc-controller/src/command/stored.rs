//! Commands that have nothing to do in a dry run.

use acrc_catalog::{CommandId, command};

use super::{Action, Entry};

const fn nothing(command: CommandId) -> Entry {
    (command, Action::Nothing)
}

pub(super) const COMMANDS: &[Entry] = &[
    // Conversion and commutation, neither of which the dry run shows; objects that cannot be on.
    nothing(command::ADC_ON),
    nothing(command::ADC_OFF),
    nothing(command::CMT_ON),
    nothing(command::CMT_OFF),
    nothing(command::PLS_RES),
    // Hardware.
    nothing(command::AXIS_ON),
    nothing(command::AXIS_OFF),
];
