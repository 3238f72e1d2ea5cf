//! The server as clients see it: through the protocol.

mod client;
mod documents;
mod features;
mod protocol;
mod session;
mod storms;
