//! What is typed at a channel and what comes back, byte by byte.

mod clients;
mod control_keys;
mod entry;
mod listening;
mod reports;
mod statements;
mod support;
