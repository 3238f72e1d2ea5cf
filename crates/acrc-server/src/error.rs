//! Why a server does not start.

use std::io;
use std::net::SocketAddr;

use acrc_controller::StreamName;
use thiserror::Error;

use crate::Service;

/// Why a server does not start.
#[derive(Debug, Error)]
pub enum BindError {
    /// Somebody else listens there.
    #[error("{service} cannot listen at {address}: the port is in use, perhaps by another controller")]
    InUse {
        /// What was to listen.
        service: Service,
        /// Where.
        address: SocketAddr,
    },
    /// The system refuses it for another reason.
    #[error("{service} cannot listen at {address}")]
    Refused {
        /// What was to listen.
        service: Service,
        /// Where.
        address: SocketAddr,
        /// Why.
        #[source]
        problem: io::Error,
    },
    /// The model has none of the streams that clients get.
    #[error("{model} has no Ethernet: its streams are {}", streams.join(", "))]
    NoStreams {
        /// The model.
        model: &'static str,
        /// What it has.
        streams: &'static [&'static str],
    },
    /// The system gives no thread or no socket.
    #[error("the server cannot be started")]
    System(#[from] io::Error),
}

impl BindError {
    pub(crate) fn at(service: Service, address: SocketAddr) -> impl FnOnce(io::Error) -> Self {
        move |problem| match problem.kind() {
            io::ErrorKind::AddrInUse => Self::InUse { service, address },
            _ => Self::Refused { service, address, problem },
        }
    }
}

/// The streams that clients of the command ports get, of those that a model has.
pub(crate) fn command_streams(model: &'static acrc_catalog::Model) -> Result<Vec<StreamName>, BindError> {
    let all = acrc_wire::ethernet::COMMAND_STREAMS.map(StreamName::Stream);
    let streams: Vec<StreamName> = all.filter(|stream| stream.check(model).is_ok()).collect();
    if streams.is_empty() {
        return Err(BindError::NoStreams { model: model.name, streams: model.streams });
    }
    Ok(streams)
}
