//! A virtual controller on the network: the four ports of an ACR controller over a controller in virtual time.
//!
//! - TCP 5002 is a terminal, TCP 5006 takes text and binary packets; both give out the streams STREAM2 to STREAM5.
//! - UDP 5003 sends fast status.
//! - TCP 5004 guards connections, tells of alarms, takes an operating system and reboots (Ethernet specification).
//!
//! Two threads share the [`Controller`](acrc_controller::Controller) behind a lock. One owns the pace: it lets virtual time pass as the
//! clock on the wall does, holds the lock for the ticks that are due only, and sleeps while nothing goes on. The other one serves all
//! sockets; what is asked in binary packets it answers at once, from what the last tick has left. Neither waits for a client: what a client
//! does not read is kept up to a limit, and then the client is dropped.
//!
//! [`Server::bind`] starts both. `docs/serve.md` is for users.

mod alarms;
mod command;
mod config;
mod core;
mod error;
mod event;
mod farewell;
mod histogram;
mod listeners;
mod management;
mod network;
mod pace;
mod priority;
mod registry;
mod server;
mod shared;
mod statistics;
mod status;

pub use config::{Config, Ports, Speed};
pub use error::BindError;
pub use event::{Event, Reason, Service};
pub use histogram::Histogram;
pub use server::{Finished, Handle, Server};
pub use statistics::Statistics;
