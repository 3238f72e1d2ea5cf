//! The move buffer of a program: `DIM MBUF` gives it memory, `MBUF ON` lets the program's master use it (guide, "How Much Memory?" and
//! "Velocity Profile").

use acrc_catalog::command;
use acrc_vm::{Call, Outcome};

use super::{Action, Context, Entry};
use crate::error::ControllerError;
use crate::machine::Machine;

pub(super) const COMMANDS: &[Entry] = &[
    (command::MBUF, Action::Run(report)),
    (command::MBUF_ON, Action::Run(switch)),
    (command::MBUF_OFF, Action::Run(switch)),
];

/// Moves that may wait behind the running one without a move buffer.
pub(crate) const UNBUFFERED: u32 = 1;

/// `MBUF`: the command that makes what it reports. How many moves the buffer holds `DIM MBUF` tells.
fn report(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let master = context.master(call)?;
    let switched = if context.machine.masters[master].buffered { command::MBUF_ON } else { command::MBUF_OFF };
    context.report_text(switched.info().name);
    Ok(Outcome::Done)
}

/// `MBUF ON`, `MBUF OFF`. Moves that wait already are executed whatever is switched.
fn switch(context: &mut Context, call: &Call) -> Result<Outcome, ControllerError> {
    let master = context.master(call)?;
    context.machine.masters[master].buffered = call.command == command::MBUF_ON;
    Ok(Outcome::Done)
}

impl Context<'_> {
    /// Whether the master of the program takes another move now.
    pub(super) fn takes_move(&mut self, master: usize) -> bool {
        self.machine.takes_move(master, self.moves)
    }
}

impl Machine {
    /// Whether a master takes another move now, with a move buffer of its program that holds so many.
    pub(crate) fn takes_move(&mut self, master: usize, buffered: u32) -> bool {
        let master = &mut self.masters[master];
        let depth = if master.buffered { buffered.max(UNBUFFERED) } else { UNBUFFERED };
        if depth > master.places {
            master.profiler.set_queue_capacity(depth as usize);
            master.places = depth;
        }
        let room = master.profiler.can_accept() && master.profiler.waiting() < depth as usize;
        // A search for marks ends with what other moves count from.
        room && master.ahead.seek.is_none()
    }
}
