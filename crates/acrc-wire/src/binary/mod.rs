//! The packets of the binary host interface (guide, chapter "Binary Host Interface").
//!
//! Numbers in these packets go with the low byte first, on Ethernet too.

mod data;
mod flag;
mod memory;
mod moves;
mod overrides;
mod parameter;
mod reply;
mod request;

pub use data::{DataReply, DataRequest, Group};
pub use flag::FlagChange;
pub use memory::{Address, BitMask, Conversion, Peek, PeekReply, Poke, VariableKind, global_variable_address};
pub use moves::{
    Arc, ArcDirection, ArcPlane, Codes, Coordinate, Counter, Move, MoveBuilder, MoveField, MoveMode, Number, Path,
    RapidMoveModes, Slot, StartRule,
};
pub use overrides::{Override, OverrideKind};
pub use reply::{Replies, Reply};
pub use request::{Request, Requests};
