//! The watchdog of connections (Ethernet specification, "Watchdog Function").

use core::net::Ipv4Addr;
use core::time::Duration;

use crate::reader::Reader;
use crate::{ByteOrder, Malformed, WatchdogUnit};

/// Asks the controller to guard connections of a client. The controller sends the same packet back while they live, and
/// closes them when no more come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Watchdog {
    /// The interval in which the client expects an answer. Zero ends the guard.
    pub timer: u32,
    /// How many intervals may pass without a packet.
    pub ticker: u32,
    /// Address of the client whose connections are guarded.
    pub address: Ipv4Addr,
    /// The client's own port of its command connection.
    pub command_port: u32,
    /// The client's own port of its fast status connection.
    pub fast_status_port: u32,
}

impl Watchdog {
    /// After how long without a packet the connections are closed. None when the guard ends.
    pub fn patience(&self, unit: WatchdogUnit) -> Option<Duration> {
        let time = u64::from(self.timer) * u64::from(self.ticker);
        (self.timer != 0).then(|| match unit {
            WatchdogUnit::Milliseconds => Duration::from_millis(time),
            WatchdogUnit::Seconds => Duration::from_secs(time),
        })
    }

    pub(super) fn values(&self) -> [u32; 5] {
        [self.timer, self.ticker, self.address.to_bits(), self.command_port, self.fast_status_port]
    }

    pub(super) fn read(rest: &mut Reader<'_>, order: ByteOrder) -> Result<Self, Malformed> {
        Ok(Self {
            timer: rest.long_in(order)?,
            ticker: rest.long_in(order)?,
            address: Ipv4Addr::from_bits(rest.long_in(order)?),
            command_port: rest.long_in(order)?,
            fast_status_port: rest.long_in(order)?,
        })
    }
}
