//! What a run recorded: signals over time, as numbers for other tools and as a picture for a person.
//!
//! - [`Trace`] holds the samples in memory, one column a signal;
//! - [`csv`] writes them as plain CSV, also row by row while a run goes on;
//! - [`parquet`] writes them as Parquet, in the same way;
//! - [`plot`] draws them as one self-contained SVG picture;
//! - [`Envelope`] and [`StatementLog`] keep what a long run did in bounded memory, and [`report`] makes one page of it
//!   in which a person can look around.
//!
//! **Invariants.** The crate knows neither the controller nor the language: a signal is a name, a unit and numbers. It
//! touches no file. The same samples always give the same bytes, on every machine: nothing here uses a function whose
//! last digit depends on the platform's mathematics library.

pub mod csv;
mod envelope;
pub mod parquet;
pub mod plot;
pub mod report;
mod signal;
mod statements;
mod trace;

pub use envelope::{Band, Envelope};
pub use signal::{Kind, Signal};
pub use statements::{Entry, Place, ProgramLog, StatementLog};
pub use trace::{Trace, TraceError};
