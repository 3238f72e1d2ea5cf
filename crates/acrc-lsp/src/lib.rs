//! The language server: `acrc lsp`.
//!
//! What an editor asks is answered by `acrc-ide`; this crate knows the protocol. Messages are taken in the order in
//! which they arrive (`transport`) and queued for the one thread that owns the database (`writer`). It applies edits
//! itself, and gives every question a snapshot that a thread of the `pool` answers from. The next edit ends what is
//! still being asked of older snapshots.
//!
//! **Invariants.** No feature is computed here. Only the writer changes the database. Every request is answered, also
//! when a feature panics. Nothing but messages goes to standard output.

mod abilities;
mod capabilities;
mod commands;
mod diagnostics;
mod features;
mod lines;
mod outgoing;
mod pool;
mod progress;
mod queue;
mod run;
mod scratch;
mod server;
mod settings;
mod snapshot;
mod transport;
mod uri;
mod workspace;
mod writer;

pub use run::{run_stdio, run_tcp, serve};
