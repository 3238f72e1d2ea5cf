//! The state of a virtual controller in a folder: what it keeps without power ([`acrc_controller::nonvolatile::Saved`]).
//!
//! A state is one file, and each save writes a new one beside the old: written under another name, flushed, renamed, and the
//! folder flushed. Whoever is killed at any instant leaves the old state or the new one, never a mixture. The file carries its
//! version, length and checksum; one that is damaged or not ours is refused with the reason, never taken in part. A lock keeps
//! other processes out.
//!
//! `docs/nonvolatile.md` describes the folder.

mod error;
mod files;
mod form;
mod store;
mod wire;

pub use error::{ReadError, StoreError};
pub use files::{Disk, Files};
pub use form::{decode, encode};
pub use store::{Store, VERSION};
