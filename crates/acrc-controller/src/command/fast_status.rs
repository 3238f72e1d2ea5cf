//! Status for a host (`FSTAT`): whether it is brought up to date ([`crate::host_interface`] has what it holds).

use acrc_catalog::command;

use super::{Action, Context, Entry};

pub(super) const COMMANDS: &[Entry] =
    &[(command::FSTAT_ON, Action::Answer(on)), (command::FSTAT_OFF, Action::Answer(off))];

fn on(context: &mut Context) {
    context.machine.fast_status.stopped = false;
}

fn off(context: &mut Context) {
    context.machine.fast_status.stopped = true;
}
