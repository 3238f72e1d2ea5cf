//! What the packets of a host do in the controller (guide, "Binary Host Interface"; Ethernet specification of the ACR series).
//!
//! Each family of packets has its methods of [`Controller`]. They act at once, between two ticks, past everything that waits in a
//! channel. The bytes of packets are no business of this crate: whoever owns the line decodes them and calls what is here. The
//! protocol has no way to refuse an order, so a refusal is an error for the caller to report, and the line stays silent.
//!
//! `docs/host-interface.md` describes what a host sees.

mod address;
mod alarms;
mod cell;
mod error;
mod fast_status;
mod management;
mod memory;
mod moves;
mod number;
mod overrides;
mod parameters;
mod poke;
mod strings;

pub(crate) use alarms::Alarms;
pub use alarms::{AlarmKind, HostAlarm};
pub use cell::Conversion;
pub use error::HostError;
pub(crate) use fast_status::FastUpdates;
pub use fast_status::{FAST_STATUS_GROUPS, FastStatus};
pub use management::CONFIGURATION_BYTES;
pub use moves::{Coordinate, HostArc, HostMove, HostPath, MoveExtras, MoveMode, MoveStart, Queued};
pub use overrides::Override;

use crate::controller::{Controller, Observer};

impl Controller {
    /// Lets the rest of the controller see what a host has changed.
    fn conclude_order(&mut self, observer: &mut dyn Observer) {
        self.changes.everywhere();
        if !self.machine.requests.is_empty() {
            self.apply_requests(observer);
        }
    }
}
