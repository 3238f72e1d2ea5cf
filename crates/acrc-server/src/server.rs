//! A server from its start to its end.

use std::io;
use std::net::SocketAddr;
use std::sync::Arc;
use std::thread::{Builder, JoinHandle};

use acrc_controller::{Controller, Observer, StreamName};

use crate::core::Core;
use crate::error::command_streams;
use crate::listeners::Bound;
use crate::network::Network;
use crate::pace::{self, Pace};
use crate::shared::{Phase, Settings, Shared, enter};
use crate::{BindError, Config, Ports, Service, Statistics};

/// A virtual controller on the network. It serves until it is told to stop.
pub struct Server {
    handle: Handle,
    address: std::net::IpAddr,
    ports: Ports,
    network: JoinHandle<io::Result<()>>,
    pace: JoinHandle<Pace>,
}

/// Speaks to a server from any thread.
#[derive(Clone)]
pub struct Handle {
    shared: Arc<Shared>,
}

/// What is left of a server.
pub struct Finished {
    /// The controller, as it was in the end. None if somebody keeps a [`Handle`].
    pub controller: Option<Controller>,
    /// Who watched it.
    pub observer: Option<Box<dyn Observer + Send>>,
    /// What the server has done.
    pub statistics: Statistics,
}

impl Server {
    /// Listens at the ports and powers the controller up.
    ///
    /// # Errors
    /// When a port cannot be had, or the model has no streams for clients.
    pub fn bind(controller: Controller, config: Config) -> Result<Self, BindError> {
        let Config { address, ports, speed, wire, patience, observer, log } = config;
        let streams = command_streams(controller.model())?;
        let bound = Bound::bind(address, ports)?;
        let ports = bound.ports()?;
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
        let mut core = Core::new(controller, observer, speed);
        core.power_up();
        let shared = Shared::new(core, streams, Settings { wire, patience, log });
        let paced = Arc::clone(&shared);
        let pace = Builder::new().name("acrc pace".to_owned()).spawn(move || pace::run(&paced))?;
        let network = Network::new(Arc::clone(&shared), address, ports);
        let network = Builder::new().name("acrc network".to_owned()).spawn(move || {
            let result = runtime.block_on(network.run(bound));
            // Tasks that are left hold the controller.
            drop(runtime);
            result
        });
        let handle = Handle { shared };
        match network {
            Ok(network) => Ok(Self { handle, address, ports, network, pace }),
            Err(problem) => {
                handle.shared.bell.end();
                Err(problem.into())
            }
        }
    }

    /// Where a service listens.
    pub fn address(&self, service: Service) -> SocketAddr {
        let port = match service {
            Service::Ascii => self.ports.ascii,
            Service::FastStatus => self.ports.fast_status,
            Service::Management => self.ports.management,
            Service::Mixed => self.ports.mixed,
        };
        SocketAddr::new(self.address, port)
    }

    /// The streams that clients of the command ports get.
    pub fn streams(&self) -> &[StreamName] {
        &self.handle.shared.streams
    }

    /// Speaks to the server from other threads.
    pub fn handle(&self) -> Handle {
        self.handle.clone()
    }

    /// Waits until the server has stopped: every client has been told, and no time passes any more.
    ///
    /// # Errors
    /// When the sockets could not be had again after a restart of the controller.
    pub fn wait(self) -> io::Result<Finished> {
        let Self { handle: Handle { shared }, network, pace, .. } = self;
        let served = network.join().map_err(|_| io::Error::other("the network's thread has failed"));
        shared.bell.end();
        let pace = pace.join().map_err(|_| io::Error::other("the thread of the pace has failed"))?;
        served??;
        let mut statistics = shared.statistics();
        statistics.slip = pace.slip;
        let core = shared.into_core();
        let (controller, observer) = core.map(|core| (core.controller, core.observer)).unzip();
        Ok(Finished { controller, observer, statistics })
    }
}

impl Handle {
    /// Tells the server to stop.
    pub fn shutdown(&self) {
        self.shared.enter(Phase::Stopping);
    }

    /// The same by who needs the handle no more. It is let go of first: the controller comes back from [`Server::wait`] only
    /// when nobody else holds it by then.
    pub fn end(self) {
        let phase = self.shared.phase.clone();
        drop(self);
        enter(&phase, Phase::Stopping);
    }

    /// Looks at the controller, which stands still meanwhile.
    pub fn look<T>(&self, look: impl FnOnce(&Controller) -> T) -> T {
        look(&self.shared.core().controller)
    }

    /// What the server has done so far, but for the slip of its time.
    pub fn statistics(&self) -> Statistics {
        self.shared.statistics()
    }
}
