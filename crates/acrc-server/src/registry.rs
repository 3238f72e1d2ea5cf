//! Who is connected, and who is to go.

use std::collections::BTreeMap;
use std::net::SocketAddr;
use std::sync::Arc;

use parking_lot::Mutex;
use tokio::sync::{Notify, watch};

use crate::event::{Reason, Service};
use crate::shared::Shared;

/// The TCP clients that are connected.
#[derive(Debug, Default)]
pub(crate) struct Registry {
    members: Mutex<Members>,
    /// Somebody has gone.
    gone: Notify,
}

#[derive(Debug, Default)]
struct Members {
    named: u64,
    list: BTreeMap<u64, Member>,
}

#[derive(Debug)]
struct Member {
    service: Service,
    peer: SocketAddr,
    /// It is served, and not only given time to read its last bytes.
    served: bool,
    dismiss: watch::Sender<Option<Reason>>,
}

/// One client's place. It is free again when this goes.
pub(crate) struct Membership {
    pub(crate) number: u64,
    pub(crate) peer: SocketAddr,
    pub(crate) service: Service,
    dismissed: watch::Receiver<Option<Reason>>,
    shared: Arc<Shared>,
}

impl Registry {
    /// Takes a client in.
    pub(crate) fn join(shared: &Arc<Shared>, service: Service, peer: SocketAddr) -> Membership {
        let (dismiss, dismissed) = watch::channel(None);
        let mut members = shared.registry.members.lock();
        members.named += 1;
        let number = members.named;
        members.list.insert(number, Member { service, peer, served: true, dismiss });
        Membership { number, peer, service, dismissed, shared: Arc::clone(shared) }
    }

    /// How many clients a service has.
    pub(crate) fn count(&self, service: Service) -> usize {
        self.members.lock().list.values().filter(|member| member.served && member.service == service).count()
    }

    /// Whether a command connection comes from an address.
    pub(crate) fn has_command(&self, peer: SocketAddr) -> bool {
        self.members.lock().list.values().any(|member| member.is_command_of(peer))
    }

    /// Closes the command connections that come from an address.
    pub(crate) fn dismiss_command(&self, peer: SocketAddr, reason: Reason) {
        for member in self.members.lock().list.values().filter(|member| member.is_command_of(peer)) {
            member.dismiss.send_replace(Some(reason));
        }
    }

    /// Closes all connections but one.
    pub(crate) fn dismiss_all(&self, but: Option<u64>, reason: Reason) {
        for (_, member) in self.members.lock().list.iter().filter(|(number, _)| Some(**number) != but) {
            member.dismiss.send_replace(Some(reason));
        }
    }

    /// Waits until nobody is left but one.
    pub(crate) async fn empty(&self, but: Option<u64>) {
        loop {
            let gone = self.gone.notified();
            if self.members.lock().list.keys().all(|number| Some(*number) == but) {
                return;
            }
            gone.await;
        }
    }
}

impl Member {
    fn is_command_of(&self, peer: SocketAddr) -> bool {
        self.served && matches!(self.service, Service::Ascii | Service::Mixed) && self.peer == peer
    }
}

impl Membership {
    /// Waits until the client is to go, and says why.
    pub(crate) async fn dismissed(&mut self) -> Reason {
        // The sender lives as long as this does.
        let reason = self.dismissed.wait_for(Option::is_some).await.ok().and_then(|reason| *reason);
        reason.unwrap_or(Reason::ClosedDown)
    }

    /// The client is no longer served, but may read what was sent.
    pub(crate) fn leave(&self) {
        if let Some(member) = self.shared.registry.members.lock().list.get_mut(&self.number) {
            member.served = false;
        }
    }
}

impl Drop for Membership {
    fn drop(&mut self) {
        self.shared.registry.members.lock().list.remove(&self.number);
        self.shared.registry.gone.notify_waiters();
    }
}
