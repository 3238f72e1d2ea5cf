//! What happens on the network, for a log.

use std::fmt;
use std::net::SocketAddr;

use acrc_controller::StreamName;

/// What listens at a port.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Service {
    /// TCP 5002.
    Ascii,
    /// UDP 5003.
    FastStatus,
    /// TCP 5004.
    Management,
    /// TCP 5006.
    Mixed,
}

impl fmt::Display for Service {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Ascii => "ASCII",
            Self::FastStatus => "fast status",
            Self::Management => "connection management",
            Self::Mixed => "ASCII and binary",
        })
    }
}

/// What happens on the network.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Event {
    /// A client is served.
    Connected {
        /// Where it came in.
        service: Service,
        /// Its address.
        peer: SocketAddr,
        /// The stream that it got.
        stream: Option<StreamName>,
    },
    /// A client is no longer served.
    Disconnected {
        /// Where it came in.
        service: Service,
        /// Its address.
        peer: SocketAddr,
        /// Why.
        reason: Reason,
    },
    /// A client was turned away, since as many as there may be are served.
    Refused {
        /// Where it came in.
        service: Service,
        /// Its address.
        peer: SocketAddr,
    },
    /// A client has sent bytes that mean nothing.
    Unreadable {
        /// Where it came in.
        service: Service,
        /// Its address.
        peer: SocketAddr,
        /// What is wrong with them.
        problem: String,
    },
    /// The controller has refused a packet, which has no form to tell its client.
    Declined {
        /// Where it came in.
        service: Service,
        /// The client's address.
        peer: SocketAddr,
        /// Why.
        problem: String,
    },
    /// A client has begun to send an operating system: everything is closed down.
    Halted {
        /// Its address.
        peer: SocketAddr,
    },
    /// An operating system of so many bytes has arrived whole. A virtual controller keeps its own.
    Downloaded {
        /// How many bytes.
        bytes: usize,
    },
    /// The controller restarts.
    Rebooting,
    /// It has restarted and takes clients again.
    Rebooted,
    /// A socket gives an error that is no client's fault.
    Trouble {
        /// Where.
        service: Service,
        /// What the system says.
        problem: String,
    },
}

/// Why a client is no longer served.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// It has closed the connection, or ended its subscription.
    Left,
    /// The connection broke.
    Lost,
    /// It does not read what it is sent.
    Stuck,
    /// Its watchdog was not heard of in time.
    Watchdog,
    /// The controller closes all connections.
    ClosedDown,
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Left => "closed by the client",
            Self::Lost => "the connection broke",
            Self::Stuck => "the client does not read",
            Self::Watchdog => "its watchdog packets stayed away",
            Self::ClosedDown => "closed by the controller",
        })
    }
}

impl Event {
    /// Where it has happened.
    pub fn service(&self) -> Option<Service> {
        match self {
            Self::Connected { service, .. }
            | Self::Disconnected { service, .. }
            | Self::Refused { service, .. }
            | Self::Unreadable { service, .. }
            | Self::Declined { service, .. }
            | Self::Trouble { service, .. } => Some(*service),
            Self::Halted { .. } | Self::Downloaded { .. } | Self::Rebooting | Self::Rebooted => None,
        }
    }

    /// Which client it is about.
    pub fn peer(&self) -> Option<SocketAddr> {
        match self {
            Self::Connected { peer, .. }
            | Self::Disconnected { peer, .. }
            | Self::Refused { peer, .. }
            | Self::Unreadable { peer, .. }
            | Self::Declined { peer, .. }
            | Self::Halted { peer } => Some(*peer),
            Self::Downloaded { .. } | Self::Rebooting | Self::Rebooted | Self::Trouble { .. } => None,
        }
    }
}

impl fmt::Display for Event {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Connected { service, peer, stream: Some(stream) } => {
                write!(f, "{service}: {peer} connected, {stream}")
            }
            Self::Connected { service, peer, stream: None } => write!(f, "{service}: {peer} connected"),
            Self::Disconnected { service, peer, reason } => write!(f, "{service}: {peer} disconnected, {reason}"),
            Self::Refused { service, peer } => write!(f, "{service}: {peer} refused, all places are taken"),
            Self::Unreadable { service, peer, problem } => {
                write!(f, "{service}: {peer} sent what cannot be read: {problem}")
            }
            Self::Declined { service, peer, problem } => write!(f, "{service}: {peer} was refused a packet: {problem}"),
            Self::Halted { peer } => write!(f, "{peer} sends an operating system: programs and connections are ended"),
            Self::Downloaded { bytes } => write!(f, "an operating system of {bytes} bytes arrived; it is not executed"),
            Self::Rebooting => f.write_str("the controller restarts"),
            Self::Rebooted => f.write_str("the controller has restarted"),
            Self::Trouble { service, problem } => write!(f, "{service}: {problem}"),
        }
    }
}
