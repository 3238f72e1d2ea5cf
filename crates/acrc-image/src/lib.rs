//! The stored-program form of an `AcroBASIC` program.
//!
//! A controller keeps a program as words, not as text, and counts its memory by them (guide, "How Much Memory?"). This crate is that form:
//! a stream of little-endian 32-bit words and a pool of bytes for the texts, whose size is exactly what the guide's table charges. It holds
//!
//! - [`Node`], [`Instruction`]: the decoded form, which the virtual machine and the lister read;
//! - [`Unit`] with [`Unit::decode`], the verifier, and [`encode`], its inverse;
//! - [`Image`]: a whole project (immediate statements, stored programs, aliases) and its file format `.acrx`;
//! - [`mod@list`]: the controller's `LIST` form of a unit;
//! - [`dump`]: the words themselves with their fields named.
//!
//! The layout is specified in `docs/image-format.md`. The table in [`layout`] is its only definition in code: encoder, decoder, dump and the
//! table of that page all come from it.

mod constant;
mod cost;
mod debug;
mod decode;
pub mod dump;
mod encode;
mod error;
mod field;
mod file;
mod image;
mod instruction;
pub mod layout;
pub mod list;
mod name;
mod node;
mod protect;
mod renumber;
pub mod text;
mod unit;
mod verify;

pub use constant::{SINGLE_DIGITS, format_double, format_single, integer, negate, real};
pub use cost::TextCost;
pub use debug::{DebugEntry, DebugMap, Location, Span};
pub use encode::{UnitBuilder, encode};
pub use error::{EncodeError, ImageError, Problem};
pub use file::MAGIC;
pub use image::{Alias, Image, VERSION};
pub use instruction::{Instruction, Item, Mark, Separator};
pub use name::{AxisName, InvalidAxisName};
pub use node::Node;
pub use unit::{LabelDefinition, Unit, UnitName};

/// Nodes that may lie within each other in one item. Bounds the recursion of everything that walks a decoded item.
pub const MAX_DEPTH: usize = 200;
