//! What goes over the Ethernet ports besides commands (Ethernet specification of the ACR series).
//!
//! Numbers go with the high byte first here, other than in packets of the binary host interface.

mod alarm;
mod crc;
mod fast_status;
pub mod management;
mod watchdog;

use core::ops::RangeInclusive;

pub use alarm::ControllerAlarm;
pub use crc::{Crc, FILE_LEN, is_intact, seal};
pub use fast_status::{FastStatus, Subscription};
pub use watchdog::Watchdog;

/// TCP: text only.
pub const ASCII_PORT: u16 = 5002;
/// UDP: fast status.
pub const FAST_STATUS_PORT: u16 = 5003;
/// TCP: connection management.
pub const MANAGEMENT_PORT: u16 = 5004;
/// TCP: text and binary packets.
pub const MIXED_PORT: u16 = 5006;

/// The streams that clients of [`ASCII_PORT`] and [`MIXED_PORT`] share: `STREAM2` to `STREAM5`.
pub const COMMAND_STREAMS: RangeInclusive<u8> = 2..=5;
/// How many clients may subscribe to fast status.
pub const FAST_STATUS_CLIENTS: usize = 5;
/// How many clients may manage connections.
pub const MANAGEMENT_CLIENTS: usize = 5;
