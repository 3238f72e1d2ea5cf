//! The bytes that a controller and its clients exchange.
//!
//! This crate turns bytes into packets and packets into bytes, for the controller's side and the client's side alike. It
//! opens no connection and keeps no time: the caller reads and writes, and says when a transfer has taken too long. It
//! implements the guide's chapter "Binary Host Interface" and the Ethernet specification of the ACR series.
//!
//! - [`Channel`] is one line between a client and a controller: how bytes are packed there and how they are read. It
//!   encodes [`Request`]s, [`Reply`]s and text, and gives the [`Decoder`]s for both directions.
//! - [`binary`] has the packets of the binary host interface: what a client asks for and what is answered.
//! - [`PACKETS`] is the table of their identifiers and lengths.
//! - [`ethernet`] has the other ports: fast status (UDP 5003) and connection management (TCP 5004).
//! - [`WireOptions`] chooses between readings where the documents contradict each other.
//!
//! # Bytes from anywhere
//!
//! Whatever bytes arrive, in whatever pieces, a decoder gives the same packets and never panics. What cannot be read is
//! reported as [`Item::Unreadable`] and costs the bytes of that packet only. The crate's own code is `no_std` and does
//! not know how to allocate: packets borrow what they carry from the input or from the buffer of the decoder, which is as
//! long as the longest packet.
//!
//! # Example
//!
//! ```
//! use acrc_wire::{Channel, Item, Reply, Request};
//!
//! let channel = Channel::ethernet();
//! let mut sent = Vec::new();
//! channel.text(b"VEL22\r", &mut sent);
//! channel.request(&Request::GetLong { parameter: 12288 }, &mut sent);
//! assert_eq!(sent, *b"VEL22\r\0\0\x00\x88\x00\x30");
//!
//! // The controller reads the same, and answers.
//! let mut decoder = channel.requests();
//! let mut input = sent.as_slice();
//! assert_eq!(decoder.next_item(&mut input), Some(Item::Text(b"VEL2")));
//! assert_eq!(decoder.next_item(&mut input), Some(Item::Text(b"2\r")));
//! assert_eq!(decoder.next_item(&mut input), Some(Item::Packet(Request::GetLong { parameter: 12288 })));
//! assert_eq!(decoder.next_item(&mut input), None);
//!
//! let mut answer = Vec::new();
//! channel.reply(&Reply::Long { parameter: 12288, value: -1 }, &mut answer);
//! assert_eq!(answer, [0x00, 0x88, 0x00, 0x30, 0xFF, 0xFF, 0xFF, 0xFF]);
//! ```
#![no_std]

pub mod binary;
mod channel;
mod decoder;
mod error;
pub mod ethernet;
mod field;
mod ids;
mod modes;
mod options;
mod reader;

use core::time::Duration;

pub use binary::{Reply, Request};
pub use channel::{Channel, Framing};
pub use decoder::{Decoder, Item, Side, Size, Waiting};
pub use error::Malformed;
pub use field::{Field, Fields};
pub use ids::{Length, MANAGEMENT_PACKETS, ManagementRow, PACKETS, PacketKind, PacketRow};
pub use modes::{Escaped, Mode, Unescape};
pub use options::{
    ByteOrder, CrcRule, CurveFields, FirstByte, FlagHeaders, MovePadding, OverrideMasks, RovHeader, SplineFields,
    WatchdogUnit, WireOptions,
};

/// The longest pause between two bytes of a binary transfer before a controller gives it up, unless the channel is set
/// otherwise (guide, "Binary Data Transfer").
pub const TRANSFER_TIMEOUT: Duration = Duration::from_millis(50);

/// The longest packet in bytes: a block of an operating system with its header.
pub const LONGEST_PACKET: usize = 1032;
