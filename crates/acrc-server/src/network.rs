//! The thread that serves all sockets, and the phases of its life: serving, halted by a download, rebooting, stopping.

use std::io;
use std::net::{IpAddr, SocketAddr};
use std::sync::Arc;
use std::time::Duration;

use acrc_wire::ethernet::{MANAGEMENT_CLIENTS, Subscription};
use tokio::net::{TcpStream, UdpSocket};
use tokio::sync::{Notify, Semaphore, oneshot};
use tokio::time::sleep;

use crate::event::{Event, Reason, Service};
use crate::listeners::{Bound, Listeners, prepare};
use crate::management::watchdog::Guards;
use crate::registry::Registry;
use crate::shared::{Phase, Shared};
use crate::statistics::Counters;
use crate::status::Outcome;
use crate::{Ports, command, farewell, management};

/// Clients that are turned away at the same time; more are cut off.
const TURNED_AWAY: usize = 32;
/// Time between two attempts to listen again, and how many there are.
const RETRY: Duration = Duration::from_millis(50);
const RETRIES: u32 = 100;
/// Room for a request of fast status; what is longer is cut, and means the same.
const REQUEST: usize = 64;

/// The network of a server.
pub(crate) struct Network {
    pub(crate) shared: Arc<Shared>,
    pub(crate) address: IpAddr,
    pub(crate) ports: Ports,
    turned_away: Arc<Semaphore>,
    guards: Arc<Guards>,
}

impl Network {
    pub(crate) fn new(shared: Arc<Shared>, address: IpAddr, ports: Ports) -> Self {
        Self { shared, address, ports, turned_away: Arc::new(Semaphore::new(TURNED_AWAY)), guards: Arc::default() }
    }

    /// Serves until the server stops.
    pub(crate) async fn run(self, bound: Bound) -> io::Result<()> {
        let guarding = tokio::spawn(Arc::clone(&self.guards).watch(Arc::clone(&self.shared)));
        let result = self.live(bound.listen()?).await;
        guarding.abort();
        result
    }

    async fn live(&self, mut listeners: Listeners) -> io::Result<()> {
        let mut phases = self.shared.phase.subscribe();
        loop {
            let mut phase = self.serve(&listeners).await;
            // First the servers, so that nobody comes in again (Ethernet specification, "Download Preparation").
            drop(listeners);
            self.close_down(phase).await;
            if matches!(phase, Phase::Halted { .. }) {
                self.shared.core().halt(&self.shared.streams);
                let further = phases.wait_for(|phase| *phase > Phase::Halted { by: u64::MAX }).await;
                phase = further.map_or(Phase::Stopping, |phase| *phase);
                self.close_down(phase).await;
            }
            match phase {
                Phase::Stopping => return Ok(()),
                Phase::Rebooting => {
                    let mut core = self.shared.core();
                    core.reboot();
                    self.shared.release(core);
                }
                Phase::Serving | Phase::Halted { .. } | Phase::Restarted => {}
            }
            listeners = self.listen_again().await?;
            self.shared.serve_again();
            self.shared.log(&Event::Rebooted);
        }
    }

    /// Takes clients in until the phase changes.
    async fn serve(&self, listeners: &Listeners) -> Phase {
        let mut phases = self.shared.phase.subscribe();
        let mut request = [0; REQUEST];
        loop {
            tokio::select! {
                phase = phases.wait_for(|phase| *phase != Phase::Serving) => {
                    return phase.map_or(Phase::Stopping, |phase| *phase);
                }
                client = listeners.ascii.accept() => self.accept(Service::Ascii, client).await,
                client = listeners.mixed.accept() => self.accept(Service::Mixed, client).await,
                client = listeners.management.accept() => self.accept(Service::Management, client).await,
                received = listeners.fast_status.recv_from(&mut request) => match received {
                    Ok((count, peer)) => self.subscribe(listeners, request.get(..count).unwrap_or_default(), peer),
                    Err(problem) => self.trouble(Service::FastStatus, &problem).await,
                },
            }
        }
    }

    async fn accept(&self, service: Service, client: io::Result<(TcpStream, SocketAddr)>) {
        match client {
            Ok((socket, peer)) => {
                let peer = SocketAddr::new(peer.ip().to_canonical(), peer.port());
                // A socket that cannot be set up is broken already, as reading from it will show.
                let _ = prepare(&socket);
                self.take_in(service, socket, peer);
            }
            Err(problem) => self.trouble(service, &problem).await,
        }
    }

    /// An error of a listening socket: without descriptors, for one, it comes back until somebody leaves.
    async fn trouble(&self, service: Service, problem: &io::Error) {
        self.shared.log(&Event::Trouble { service, problem: problem.to_string() });
        sleep(RETRY).await;
    }

    /// Gives a client its place, or turns it away.
    fn take_in(&self, service: Service, socket: TcpStream, peer: SocketAddr) {
        let shared = Arc::clone(&self.shared);
        if service == Service::Management {
            if shared.registry.count(service) >= MANAGEMENT_CLIENTS {
                return self.turn_away(service, socket, peer);
            }
            let membership = Registry::join(&shared, service, peer);
            self.welcome(service, peer, None);
            tokio::spawn(management::serve(socket, shared, membership, Arc::clone(&self.guards)));
            return;
        }
        let news = Arc::new(Notify::new());
        let opened = shared.core().open(&shared.streams, &news);
        let Some((channel, stream)) = opened else { return self.turn_away(service, socket, peer) };
        let membership = Registry::join(&shared, service, peer);
        self.welcome(service, peer, Some(stream));
        tokio::spawn(command::serve(socket, shared, membership, (channel, news), service == Service::Mixed));
    }

    fn welcome(&self, service: Service, peer: SocketAddr, stream: Option<acrc_controller::StreamName>) {
        Counters::add(&self.shared.counters.clients, 1);
        self.shared.log(&Event::Connected { service, peer, stream });
    }

    /// Ends a connection at once, without a byte that a client could take for an answer.
    fn turn_away(&self, service: Service, socket: TcpStream, peer: SocketAddr) {
        Counters::add(&self.shared.counters.refused, 1);
        self.shared.log(&Event::Refused { service, peer });
        if let Ok(place) = Arc::clone(&self.turned_away).try_acquire_owned() {
            tokio::spawn(async move {
                farewell::part(socket, &[]).await;
                drop(place);
            });
        }
    }

    /// A request for fast status.
    fn subscribe(&self, listeners: &Listeners, request: &[u8], sender: SocketAddr) {
        let peer = SocketAddr::new(sender.ip().to_canonical(), sender.port());
        let service = Service::FastStatus;
        let subscription = match Subscription::decode(request) {
            Ok(subscription) => subscription,
            Err(problem) => {
                return self.shared.log(&Event::Unreadable { service, peer, problem: problem.to_string() });
            }
        };
        let due = self.shared.next_beat();
        match self.shared.subscribers.request(peer, subscription, due) {
            Outcome::New => match listeners.connect_status(sender) {
                Ok((sends, hears)) => {
                    let subscribed = self.shared.subscribers.add(peer, subscription, due, sends);
                    self.welcome(service, peer, None);
                    tokio::spawn(hear_subscriber(Arc::clone(&self.shared), peer, hears, subscribed));
                }
                Err(problem) => self.shared.log(&Event::Trouble { service, problem: problem.to_string() }),
            },
            Outcome::Full => {
                Counters::add(&self.shared.counters.refused, 1);
                self.shared.log(&Event::Refused { service, peer });
            }
            Outcome::Ended { known: true } => {
                self.shared.log(&Event::Disconnected { service, peer, reason: Reason::Left });
            }
            Outcome::Ended { known: false } | Outcome::Changed => {}
        }
        self.shared.bell.ring();
    }

    /// Ends all connections, but for the one that sends an operating system.
    async fn close_down(&self, phase: Phase) {
        let but = match phase {
            Phase::Halted { by } => Some(by),
            _ => None,
        };
        for peer in self.shared.subscribers.clear() {
            let reason = Reason::ClosedDown;
            self.shared.log(&Event::Disconnected { service: Service::FastStatus, peer, reason });
        }
        self.guards.clear();
        self.shared.registry.dismiss_all(but, Reason::ClosedDown);
        self.shared.registry.empty(but).await;
    }

    /// Listens at the same ports as before.
    async fn listen_again(&self) -> io::Result<Listeners> {
        let mut tries = 0;
        loop {
            match Bound::bind(self.address, self.ports) {
                Ok(bound) => return bound.listen(),
                Err(error) if tries >= RETRIES => return Err(io::Error::other(error)),
                Err(_) => sleep(RETRY).await,
            }
            tries += 1;
        }
    }
}

/// Waits for what a subscriber sends, or for news that nobody is there any more, until its subscription is over.
async fn hear_subscriber(
    shared: Arc<Shared>,
    peer: SocketAddr,
    socket: UdpSocket,
    mut subscribed: oneshot::Receiver<()>,
) {
    let mut request = [0; REQUEST];
    loop {
        let received = tokio::select! {
            _ = &mut subscribed => return,
            received = socket.recv(&mut request) => received,
        };
        let ended = match received.map(|count| Subscription::decode(request.get(..count).unwrap_or_default())) {
            Ok(Ok(subscription)) if subscription.is_end() => Reason::Left,
            Ok(Ok(subscription)) => {
                shared.subscribers.request(peer, subscription, shared.next_beat());
                shared.bell.ring();
                continue;
            }
            Ok(Err(_)) => continue,
            Err(_) => Reason::Lost,
        };
        shared.end_subscription(peer, ended);
    }
}
