//! Connections that are guarded (Ethernet specification, "Watchdog Function").

use std::collections::BTreeMap;
use std::net::{IpAddr, SocketAddr};
use std::sync::Arc;

use acrc_wire::ethernet::Watchdog;
use parking_lot::Mutex;
use tokio::sync::Notify;
use tokio::time::{Instant, sleep_until};

use crate::event::Reason;
use crate::shared::Shared;

/// What clients have asked to be guarded.
#[derive(Debug, Default)]
pub(crate) struct Guards {
    /// By the number of the management connection. A guard outlives it: a client that has died is what it is there for.
    list: Mutex<BTreeMap<u64, Guard>>,
    changed: Notify,
}

#[derive(Clone, Debug)]
struct Guard {
    guarded: Guarded,
    /// When the connections are closed.
    ends: Instant,
}

/// Connections of a client, by their ports at its end. Port 0 stands for none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Guarded {
    command: Option<SocketAddr>,
    fast_status: Option<SocketAddr>,
}

impl Guarded {
    fn of(watchdog: &Watchdog) -> Self {
        let address = |port: u32| {
            let port = u16::try_from(port).ok().filter(|port| *port != 0);
            port.map(|port| SocketAddr::new(IpAddr::V4(watchdog.address), port))
        };
        Self { command: address(watchdog.command_port), fast_status: address(watchdog.fast_status_port) }
    }

    fn live(&self, shared: &Shared) -> bool {
        self.command.is_none_or(|peer| shared.registry.has_command(peer))
            && self.fast_status.is_none_or(|peer| shared.subscribers.has(peer))
    }

    fn close(&self, shared: &Shared) {
        if let Some(peer) = self.command {
            shared.registry.dismiss_command(peer, Reason::Watchdog);
        }
        if let Some(peer) = self.fast_status {
            shared.end_subscription(peer, Reason::Watchdog);
        }
    }
}

impl Guards {
    /// Takes a packet of a management connection. Tells whether it is to be sent back: while the connections live.
    pub(crate) fn hear(&self, connection: u64, watchdog: &Watchdog, shared: &Shared) -> bool {
        let guarded = Guarded::of(watchdog);
        let mut list = self.list.lock();
        // The latest packet counts, whichever connection it came by.
        list.retain(|number, guard| *number != connection && guard.guarded != guarded);
        let ends =
            watchdog.patience(shared.wire.watchdog_unit).and_then(|patience| Instant::now().checked_add(patience));
        if let Some(ends) = ends {
            list.insert(connection, Guard { guarded, ends });
        }
        drop(list);
        self.changed.notify_one();
        guarded.live(shared)
    }

    /// Forgets all guards.
    pub(crate) fn clear(&self) {
        self.list.lock().clear();
    }

    /// Closes what is guarded when its time is over, for ever.
    pub(crate) async fn watch(self: Arc<Self>, shared: Arc<Shared>) {
        loop {
            let next = self.list.lock().values().map(|guard| guard.ends).min();
            tokio::select! {
                () = self.changed.notified() => {}
                () = async { if let Some(next) = next { sleep_until(next).await } else { std::future::pending().await } } => {
                    self.close_overdue(&shared);
                }
            }
        }
    }

    fn close_overdue(&self, shared: &Shared) {
        let now = Instant::now();
        let mut overdue = Vec::new();
        self.list.lock().retain(|_, guard| {
            let stays = guard.ends > now;
            if !stays {
                overdue.push(guard.guarded);
            }
            stays
        });
        for guarded in overdue {
            guarded.close(shared);
        }
    }
}
