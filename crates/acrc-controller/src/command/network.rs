//! The Ethernet Powerlink network, of which a dry run has the flags only (guide, "Ethernet Powerlink").

use acrc_catalog::command;

use super::{Action, Context, Entry};

pub(super) const COMMANDS: &[Entry] =
    &[(command::EPLC_ON, Action::Answer(start_or_stop)), (command::EPLC_OFF, Action::Answer(start_or_stop))];

/// The network does what it does: the world changes its flags.
fn start_or_stop(context: &mut Context) {
    let note = "EPLC ON and EPLC OFF: there is no network in a dry run; its state comes from the world";
    context.machine.notes.insert(note.to_owned());
}
