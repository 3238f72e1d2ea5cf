//! Memory: what the setup and the programs of a project allocate, what their texts take, and where that does not fit
//! (guide, "Memory Allocations").
//!
//! ```text
//! text ── memory_index ─┬─ places of DIM, CLEAR, NEW ─────────────────────────┐
//!                       └─ memory_events ─┬─ project_memory ── memory_view ───┴─ diagnostics
//!                          text_bytes ────┘   only where a bound of the bytes is not below the space
//! ```
//!
//! `memory_events` and `memory_view` hold no places, and the bounds of texts are rounded up, so that an edit inside
//! a program that has room enough ends in its own file. [`report()`] is the whole account, for `acrc mem`; it counts from the
//! compiled image.

mod calls;
mod events;
mod exact;
mod grouped;
mod issue;
mod locals;
mod play;
mod query;
mod report;
mod state;
mod text;
mod view;

pub use acrc_catalog::memory::{LocalBlock, Stream, SystemBlock};
pub use calls::Calls;
pub use events::{Block, Event, EventKind, MemoryEvents, MemorySites, Size, local_class, space_of};
pub use exact::Exact;
pub use grouped::grouped;
pub use issue::{Issue, IssueKind, Site, Space, Spare};
pub use locals::{Extent, LocalDims};
pub use play::ProjectMemory;
pub(crate) use query::memory_sites;
pub use query::{memory_view, project_memory, text_bytes};
pub use report::{Allocation, Parameters, Part, ProgramReport, Report, SystemLine, report};
pub use text::{SectionBytes, TextBound};
pub use view::MemoryView;
