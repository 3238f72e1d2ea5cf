//! Fast status on UDP port 5003 (Ethernet specification, "Fast Status").
//!
//! Datagrams are sent by the thread that owns the pace, at fixed instants. Each subscriber has a socket of its own, connected to it at the same
//! port, so that the system tells when nobody listens there any more.

use std::net::{SocketAddr, UdpSocket};
use std::time::{Duration, Instant};

use acrc_controller::Controller;
use acrc_wire::Field;
use acrc_wire::ethernet::{FAST_STATUS_CLIENTS, FastStatus, Subscription};
use parking_lot::Mutex;
use tokio::sync::oneshot;

use crate::Histogram;

/// Who has subscribed.
#[derive(Debug, Default)]
pub(crate) struct Subscribers(Mutex<Inner>);

#[derive(Debug, Default)]
struct Inner {
    list: Vec<Subscriber>,
    measured: Measured,
}

#[derive(Debug)]
struct Subscriber {
    peer: SocketAddr,
    socket: UdpSocket,
    interval: Duration,
    due: Instant,
    /// Goes with the subscription, so that whoever reads from its socket ends.
    _subscribed: oneshot::Sender<()>,
}

/// How late datagrams were sent, and how many were left out.
#[derive(Clone, Debug, Default)]
pub(crate) struct Measured {
    pub(crate) lateness: Histogram,
    pub(crate) left_out: u64,
}

/// What became of a request.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// The client is known, and gets status at another interval.
    Changed,
    /// The client is new: a socket is to be connected to it.
    New,
    /// The client gets no more, if it ever did.
    Ended {
        /// It did.
        known: bool,
    },
    /// There are as many as there may be.
    Full,
}

impl Subscribers {
    /// Takes a request of a client that may be known, and that gets its next datagram at `due`.
    pub(crate) fn request(&self, peer: SocketAddr, subscription: Subscription, due: Instant) -> Outcome {
        let mut inner = self.0.lock();
        if subscription.is_end() {
            let before = inner.list.len();
            inner.list.retain(|subscriber| subscriber.peer != peer);
            return Outcome::Ended { known: inner.list.len() < before };
        }
        let full = inner.list.len() >= FAST_STATUS_CLIENTS;
        match inner.list.iter_mut().find(|subscriber| subscriber.peer == peer) {
            Some(subscriber) => {
                subscriber.interval = interval(subscription);
                subscriber.due = due;
                Outcome::Changed
            }
            None if full => Outcome::Full,
            None => Outcome::New,
        }
    }

    /// Takes a client in that is new. What is given ends with the subscription.
    pub(crate) fn add(
        &self,
        peer: SocketAddr,
        subscription: Subscription,
        due: Instant,
        socket: UdpSocket,
    ) -> oneshot::Receiver<()> {
        let (sender, receiver) = oneshot::channel();
        let interval = interval(subscription);
        self.0.lock().list.push(Subscriber { peer, socket, interval, due, _subscribed: sender });
        receiver
    }

    /// Whether a client gets status.
    pub(crate) fn has(&self, peer: SocketAddr) -> bool {
        self.0.lock().list.iter().any(|subscriber| subscriber.peer == peer)
    }

    /// Takes a client out. False when it was not in.
    pub(crate) fn remove(&self, peer: SocketAddr) -> bool {
        self.request(peer, Subscription::end(), Instant::now()) == Outcome::Ended { known: true }
    }

    /// Takes all clients out, and gives their addresses.
    pub(crate) fn clear(&self) -> Vec<SocketAddr> {
        std::mem::take(&mut self.0.lock().list).into_iter().map(|subscriber| subscriber.peer).collect()
    }

    /// When the next datagram is due.
    pub(crate) fn next_due(&self) -> Option<Instant> {
        self.0.lock().list.iter().map(|subscriber| subscriber.due).min()
    }

    pub(crate) fn is_due(&self, now: Instant) -> bool {
        self.next_due().is_some_and(|due| due <= now)
    }

    /// Sends status to those for whom it is due.
    pub(crate) fn send(&self, status: &FastStatus) {
        let datagram = status.encode();
        let Inner { list, measured, .. } = &mut *self.0.lock();
        for subscriber in list {
            let late = Instant::now().checked_duration_since(subscriber.due);
            let Some(late) = late else { continue };
            // What goes wrong is seen by whoever reads from this socket; a full buffer loses this datagram, as any network may.
            let _ = subscriber.socket.send(&datagram);
            measured.lateness.record(late);
            let missed = u32::try_from(late.as_nanos() / subscriber.interval.as_nanos()).unwrap_or(u32::MAX);
            measured.left_out += u64::from(missed);
            subscriber.due += subscriber.interval * missed.saturating_add(1);
        }
    }

    pub(crate) fn measured(&self) -> Measured {
        self.0.lock().measured.clone()
    }
}

/// An interval of zero is the shortest one.
fn interval(subscription: Subscription) -> Duration {
    Duration::from_millis(u64::from(subscription.interval_milliseconds.max(1)))
}

/// What is sent now.
pub(crate) fn contents(controller: &mut Controller) -> FastStatus {
    FastStatus(controller.fast_status().map(|group| group.map(Field)))
}
