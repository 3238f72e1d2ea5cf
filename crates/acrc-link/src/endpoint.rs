//! Where a controller is.

use std::fmt;
use std::str::FromStr;

use acrc_wire::ethernet::{ASCII_PORT, MIXED_PORT};
use thiserror::Error;

/// What is spoken on a connection (Ethernet specification, "ASCII Command Server" and "Binary Command Server").
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Protocol {
    /// Text only, as on port 5002.
    Text,
    /// Text in packets of four bytes, mixed with binary packets, as on port 5006.
    Mixed,
}

impl Protocol {
    /// The port that speaks it.
    pub const fn port(self) -> u16 {
        match self {
            Self::Text => ASCII_PORT,
            Self::Mixed => MIXED_PORT,
        }
    }
}

/// `HOST` or `HOST:PORT`; an IPv6 address with a port stands in brackets.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Endpoint {
    /// A name or an address.
    pub host: String,
    /// The port, if it is said.
    pub port: Option<u16>,
}

impl Endpoint {
    /// The port to connect to, and what is spoken there. Where no protocol is said, port 5006 speaks [`Protocol::Mixed`],
    /// every other one [`Protocol::Text`], and without a port it is the `usual` one. A port that is not said is that of the
    /// protocol.
    pub fn resolve(&self, protocol: Option<Protocol>, usual: Protocol) -> (u16, Protocol) {
        let protocol = protocol.unwrap_or(match self.port {
            Some(MIXED_PORT) => Protocol::Mixed,
            Some(_) => Protocol::Text,
            None => usual,
        });
        (self.port.unwrap_or(protocol.port()), protocol)
    }

    /// The same host with this port.
    #[must_use]
    pub fn at(&self, port: u16) -> Self {
        Self { host: self.host.clone(), port: Some(port) }
    }
}

/// What is wrong with an endpoint.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum EndpointError {
    /// There is no host.
    #[error("there is no host: write HOST or HOST:PORT")]
    NoHost,
    /// What follows the colon is no port.
    #[error("`{0}` is no port: ports are 1 to 65535")]
    Port(String),
    /// An address with colons could be one with a port.
    #[error("`{0}` has several colons: an IPv6 address with a port is written [::1]:5002")]
    Brackets(String),
    /// A host cannot be called so.
    #[error("`{0}` is no name of a host")]
    Host(String),
}

impl FromStr for Endpoint {
    type Err = EndpointError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let text = text.trim();
        let (host, port) = match text.strip_prefix('[').and_then(|rest| rest.split_once(']')) {
            Some((host, "")) => (host, None),
            Some((host, rest)) => {
                (host, Some(rest.strip_prefix(':').ok_or_else(|| EndpointError::Host(text.to_owned()))?))
            }
            None if text.parse::<std::net::Ipv6Addr>().is_ok() => (text, None),
            None => match text.split_once(':') {
                Some((_, port)) if port.contains(':') => return Err(EndpointError::Brackets(text.to_owned())),
                Some((host, port)) => (host, Some(port)),
                None => (text, None),
            },
        };
        if host.is_empty() {
            return Err(EndpointError::NoHost);
        }
        if host.contains(|character: char| {
            character.is_whitespace() || character.is_control() || "[]/@".contains(character)
        }) {
            return Err(EndpointError::Host(host.to_owned()));
        }
        let number = |port: &str| port.parse().ok().filter(|port| *port > 0);
        let port = match port {
            Some(port) => Some(number(port).ok_or_else(|| EndpointError::Port(port.to_owned()))?),
            None => None,
        };
        Ok(Self { host: host.to_owned(), port })
    }
}

impl fmt::Display for Endpoint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.host.contains(':'), self.port) {
            (true, Some(port)) => write!(f, "[{}]:{port}", self.host),
            (false, Some(port)) => write!(f, "{}:{port}", self.host),
            (_, None) => f.write_str(&self.host),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hosts_with_and_without_ports() {
        for (text, host, port) in [
            ("192.168.10.40", "192.168.10.40", None),
            ("acr9000.local:5002", "acr9000.local", Some(5002)),
            ("[::1]:5006", "::1", Some(5006)),
            ("[::1]", "::1", None),
            ("fe80::1", "fe80::1", None),
        ] {
            assert_eq!(text.parse(), Ok(Endpoint { host: host.to_owned(), port }), "{text}");
        }
        for text in ["", ":5002", "host:", "host:0", "host:70000", "a:b:c", "[::1]5002", "tcp://host", "a b"] {
            assert!(text.parse::<Endpoint>().is_err(), "{text}");
        }
    }

    #[test]
    fn the_port_tells_what_is_spoken() {
        let resolve = |text: &str, protocol| text.parse::<Endpoint>().unwrap().resolve(protocol, Protocol::Text);
        assert_eq!(resolve("host", None), (5002, Protocol::Text));
        assert_eq!(resolve("host:5006", None), (5006, Protocol::Mixed));
        assert_eq!(resolve("host", Some(Protocol::Mixed)), (5006, Protocol::Mixed));
        assert_eq!(resolve("host:40001", None), (40001, Protocol::Text));
        assert_eq!(resolve("host:5006", Some(Protocol::Text)), (5006, Protocol::Text));
        let usual = |text: &str| text.parse::<Endpoint>().unwrap().resolve(None, Protocol::Mixed);
        assert_eq!(usual("host"), (5006, Protocol::Mixed));
        assert_eq!(usual("host:40001"), (40001, Protocol::Text));
    }
}
