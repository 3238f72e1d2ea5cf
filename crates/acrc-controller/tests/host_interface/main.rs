//! What a host does with a controller between two ticks (guide, "Binary Host Interface"; `docs/host-interface.md`).

mod alarms;
mod fast_status;
mod flags;
mod management;
mod memory;
mod moves;
mod parameters;
mod support;
