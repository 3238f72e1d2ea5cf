//! The sockets that listen.

use std::io;
use std::net::{IpAddr, SocketAddr, TcpListener as StdListener, UdpSocket as StdUdp};
use std::time::Duration;

use socket2::{Domain, Protocol, SockAddr, SockRef, Socket, TcpKeepalive, Type};
use tokio::net::{TcpListener, TcpStream, UdpSocket};

use crate::{BindError, Ports, Service};

/// Silence after which the system asks whether a client is still there.
const SILENCE: Duration = Duration::from_secs(10);
/// Time between two such questions.
const QUESTIONS: Duration = Duration::from_secs(5);

/// The sockets, before they belong to a runtime.
#[derive(Debug)]
pub(crate) struct Bound {
    ascii: StdListener,
    mixed: StdListener,
    management: StdListener,
    fast_status: StdUdp,
}

/// The sockets that listen.
#[derive(Debug)]
pub(crate) struct Listeners {
    pub(crate) ascii: TcpListener,
    pub(crate) mixed: TcpListener,
    pub(crate) management: TcpListener,
    pub(crate) fast_status: UdpSocket,
}

impl Bound {
    /// Listens at ports of an address.
    pub(crate) fn bind(address: IpAddr, ports: Ports) -> Result<Self, BindError> {
        let tcp = |service, port| {
            let address = SocketAddr::new(address, port);
            StdListener::bind(address).map_err(BindError::at(service, address))
        };
        let udp = SocketAddr::new(address, ports.fast_status);
        let bound = Self {
            ascii: tcp(Service::Ascii, ports.ascii)?,
            mixed: tcp(Service::Mixed, ports.mixed)?,
            management: tcp(Service::Management, ports.management)?,
            fast_status: StdUdp::bind(udp).map_err(BindError::at(Service::FastStatus, udp))?,
        };
        // Only now, so that two controllers cannot have the same port; the sockets of subscribers can then be bound there too.
        SockRef::from(&bound.fast_status).set_reuse_address(true)?;
        for listener in [&bound.ascii, &bound.mixed, &bound.management] {
            listener.set_nonblocking(true)?;
        }
        bound.fast_status.set_nonblocking(true)?;
        Ok(bound)
    }

    /// The ports.
    pub(crate) fn ports(&self) -> io::Result<Ports> {
        let port = |listener: &StdListener| listener.local_addr().map(|address| address.port());
        Ok(Ports {
            ascii: port(&self.ascii)?,
            fast_status: self.fast_status.local_addr()?.port(),
            management: port(&self.management)?,
            mixed: port(&self.mixed)?,
        })
    }

    /// The sockets within a runtime.
    pub(crate) fn listen(self) -> io::Result<Listeners> {
        Ok(Listeners {
            ascii: TcpListener::from_std(self.ascii)?,
            mixed: TcpListener::from_std(self.mixed)?,
            management: TcpListener::from_std(self.management)?,
            fast_status: UdpSocket::from_std(self.fast_status)?,
        })
    }
}

impl Listeners {
    /// A socket at the port of fast status that is connected to one client: one to send, one to wait for what the client sends.
    pub(crate) fn connect_status(&self, peer: SocketAddr) -> io::Result<(StdUdp, UdpSocket)> {
        let address = self.fast_status.local_addr()?;
        let socket = Socket::new(Domain::for_address(address), Type::DGRAM, Some(Protocol::UDP))?;
        socket.set_reuse_address(true)?;
        socket.bind(&SockAddr::from(address))?;
        socket.connect(&SockAddr::from(peer))?;
        socket.set_nonblocking(true)?;
        let sends: StdUdp = socket.into();
        let hears = UdpSocket::from_std(sends.try_clone()?)?;
        Ok((sends, hears))
    }
}

/// Prepares a connection: small answers leave at once, and a client that has vanished is noticed.
pub(crate) fn prepare(socket: &TcpStream) -> io::Result<()> {
    socket.set_nodelay(true)?;
    SockRef::from(socket).set_tcp_keepalive(&TcpKeepalive::new().with_time(SILENCE).with_interval(QUESTIONS))
}
