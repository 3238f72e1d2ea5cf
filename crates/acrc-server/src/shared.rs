//! What the two threads share.

use std::net::SocketAddr;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use acrc_controller::StreamName;
use acrc_wire::WireOptions;
use parking_lot::{Condvar, Mutex, MutexGuard};
use tokio::sync::{broadcast, watch};

use crate::Statistics;
use crate::alarms::{Alarm, WAITING};
use crate::core::Core;
use crate::event::{Event, Reason, Service};
use crate::registry::Registry;
use crate::statistics::Counters;
use crate::status::Subscribers;

/// What the two threads share.
pub(crate) struct Shared {
    core: Mutex<Core>,
    pub(crate) bell: Bell,
    pub(crate) registry: Registry,
    pub(crate) subscribers: Subscribers,
    pub(crate) phase: watch::Sender<Phase>,
    pub(crate) counters: Counters,
    pub(crate) alarms: broadcast::Sender<Alarm>,
    pub(crate) wire: WireOptions,
    pub(crate) patience: Duration,
    pub(crate) streams: Vec<StreamName>,
    log: Box<dyn Fn(&Event) + Send + Sync>,
}

/// What the network goes by.
pub(crate) struct Settings {
    pub(crate) wire: WireOptions,
    pub(crate) patience: Duration,
    pub(crate) log: Box<dyn Fn(&Event) + Send + Sync>,
}

/// What the network is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Phase {
    /// Clients are served.
    Serving,
    /// One client sends an operating system, all others are closed.
    Halted {
        /// The number of that client.
        by: u64,
    },
    /// The controller has restarted by itself: all clients are closed.
    Restarted,
    /// All clients are closed, then the controller restarts.
    Rebooting,
    /// All clients are closed, then the server ends.
    Stopping,
}

impl Shared {
    pub(crate) fn new(core: Core, streams: Vec<StreamName>, settings: Settings) -> Arc<Self> {
        let Settings { wire, patience, log } = settings;
        Arc::new(Self {
            core: Mutex::new(core),
            bell: Bell::default(),
            registry: Registry::default(),
            subscribers: Subscribers::default(),
            phase: watch::Sender::new(Phase::Serving),
            counters: Counters::default(),
            alarms: broadcast::Sender::new(WAITING),
            wire,
            patience,
            streams,
            log,
        })
    }

    /// The controller.
    pub(crate) fn core(&self) -> MutexGuard<'_, Core> {
        self.core.lock()
    }

    /// Lets go of the controller after something was changed: the pace has to look at it now if it sleeps.
    pub(crate) fn release(&self, core: MutexGuard<'_, Core>) {
        let asleep = core.asleep;
        drop(core);
        if asleep {
            self.bell.ring();
        }
    }

    /// The next instant at which the pace looks at the controller: datagrams that are sent then cost it no waking of their own.
    pub(crate) fn next_beat(&self) -> Instant {
        self.core().beat_after(Instant::now())
    }

    pub(crate) fn log(&self, event: &Event) {
        (self.log)(event);
    }

    /// Enters a phase, unless one that outranks it has been entered. Tells whether it has.
    pub(crate) fn enter(&self, phase: Phase) -> bool {
        enter(&self.phase, phase)
    }

    /// The controller has restarted: clients are served again, unless the server stops.
    pub(crate) fn serve_again(&self) {
        self.phase.send_if_modified(|phase| {
            let serves = *phase != Phase::Stopping;
            if serves {
                *phase = Phase::Serving;
            }
            serves
        });
    }

    /// Ends a subscription to fast status, if there is one.
    pub(crate) fn end_subscription(&self, peer: SocketAddr, reason: Reason) {
        if self.subscribers.remove(peer) {
            self.log(&Event::Disconnected { service: Service::FastStatus, peer, reason });
        }
    }

    /// What has been counted so far.
    pub(crate) fn statistics(&self) -> Statistics {
        let measured = self.subscribers.measured();
        let lost = self.core().lost;
        Statistics { lost, lateness: measured.lateness, left_out: measured.left_out, ..self.counters.report() }
    }

    /// Takes the core out, when the threads are gone.
    pub(crate) fn into_core(self: Arc<Self>) -> Option<Core> {
        Arc::into_inner(self).map(|shared| shared.core.into_inner())
    }
}

/// Enters a phase, unless one that outranks it has been entered. Tells whether it has.
pub(crate) fn enter(phases: &watch::Sender<Phase>, phase: Phase) -> bool {
    phases.send_if_modified(|current| {
        let enters = std::mem::discriminant(current) != std::mem::discriminant(&phase) && *current < phase;
        if enters {
            *current = phase;
        }
        enters
    })
}

/// Wakes the thread that owns the pace.
#[derive(Default)]
pub(crate) struct Bell {
    rung: Mutex<bool>,
    condition: Condvar,
    ended: AtomicBool,
}

impl Bell {
    pub(crate) fn ring(&self) {
        *self.rung.lock() = true;
        self.condition.notify_one();
    }

    /// Sleeps until an instant, or until it rings.
    pub(crate) fn sleep_until(&self, instant: Option<Instant>) {
        let mut rung = self.rung.lock();
        while !*rung {
            match instant {
                Some(instant) if self.condition.wait_until(&mut rung, instant).timed_out() => break,
                Some(_) => {}
                None => self.condition.wait(&mut rung),
            }
        }
        *rung = false;
    }

    /// The thread of the pace is to end.
    pub(crate) fn end(&self) {
        self.ended.store(true, Ordering::Relaxed);
        self.ring();
    }

    pub(crate) fn has_ended(&self) -> bool {
        self.ended.load(Ordering::Relaxed)
    }
}
