//! The server as clients see it: through the protocol.

mod client;
mod documents;
mod protocol;
mod session;
