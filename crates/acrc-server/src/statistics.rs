//! What a server has done.

use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use crate::Histogram;

/// What a server has done.
#[derive(Clone, Debug, Default)]
pub struct Statistics {
    /// Clients of the three TCP ports and of fast status that were served.
    pub clients: u64,
    /// Clients that were turned away.
    pub refused: u64,
    /// Binary packets that were taken.
    pub packets: u64,
    /// By how much virtual time was behind the clock on the wall, once a millisecond while something went on.
    pub slip: Histogram,
    /// Wall time that was given up, since the computer could not keep up or was suspended.
    pub lost: Duration,
    /// How late the datagrams of fast status were sent.
    pub lateness: Histogram,
    /// Datagrams of fast status that were left out, since the next one was due already.
    pub left_out: u64,
}

/// What is counted by the network's thread.
#[derive(Debug, Default)]
pub(crate) struct Counters {
    pub(crate) clients: AtomicU64,
    pub(crate) refused: AtomicU64,
    pub(crate) packets: AtomicU64,
}

impl Counters {
    pub(crate) fn add(counter: &AtomicU64, count: u64) {
        counter.fetch_add(count, Ordering::Relaxed);
    }

    pub(crate) fn report(&self) -> Statistics {
        let [clients, refused, packets] =
            [&self.clients, &self.refused, &self.packets].map(|counter| counter.load(Ordering::Relaxed));
        Statistics { clients, refused, packets, ..Statistics::default() }
    }
}
