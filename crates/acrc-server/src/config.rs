//! What a server is started with.

use std::net::{IpAddr, Ipv4Addr};
use std::time::Duration;

use acrc_controller::Observer;
use acrc_wire::WireOptions;
use acrc_wire::ethernet::{ASCII_PORT, FAST_STATUS_PORT, MANAGEMENT_PORT, MIXED_PORT};

use crate::Event;

/// How fast virtual time passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Speed {
    /// Virtual seconds in a second.
    Factor(f64),
    /// As fast as possible while something goes on; otherwise no time passes.
    Max,
}

/// The ports. Zero stands for any that is free.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ports {
    /// TCP: text.
    pub ascii: u16,
    /// UDP: fast status.
    pub fast_status: u16,
    /// TCP: connection management.
    pub management: u16,
    /// TCP: text and binary packets.
    pub mixed: u16,
}

impl Default for Ports {
    fn default() -> Self {
        Self { ascii: ASCII_PORT, fast_status: FAST_STATUS_PORT, management: MANAGEMENT_PORT, mixed: MIXED_PORT }
    }
}

impl Ports {
    /// Four ports that are free.
    pub const ANY: Self = Self { ascii: 0, fast_status: 0, management: 0, mixed: 0 };
}

/// What a server is started with.
pub struct Config {
    /// The address to listen at.
    pub address: IpAddr,
    /// The ports to listen at.
    pub ports: Ports,
    /// How fast virtual time passes.
    pub speed: Speed,
    /// How the documents are read where they contradict each other.
    pub wire: WireOptions,
    /// How long a client may not read what it is sent before it is dropped.
    pub patience: Duration,
    /// Watches the controller. It is called by the thread that owns the pace, so it must not wait.
    pub observer: Box<dyn Observer + Send>,
    /// Is told what happens on the network, by the thread that serves it: it must not wait either.
    pub log: Box<dyn Fn(&Event) + Send + Sync>,
}

impl Config {
    /// On the loopback interface, at the ports of a real controller, in real time.
    pub fn new(observer: impl Observer + Send + 'static) -> Self {
        Self {
            address: IpAddr::V4(Ipv4Addr::LOCALHOST),
            ports: Ports::default(),
            speed: Speed::Factor(1.0),
            wire: WireOptions::default(),
            patience: Duration::from_secs(10),
            observer: Box::new(observer),
            log: Box::new(|_| {}),
        }
    }
}
