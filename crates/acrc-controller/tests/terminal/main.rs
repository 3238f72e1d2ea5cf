//! What is typed at a channel and what comes back, byte by byte.

mod clients;
mod control_keys;
mod corpus;
mod entry;
mod listening;
mod properties;
mod reports;
mod statements;
mod support;
