//! What the controller refuses a host.

use thiserror::Error;

use super::cell::Conversion;
use crate::error::ControllerError;

/// Why an order of a host is not carried out.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum HostError {
    /// As a statement of a program would be refused.
    #[error(transparent)]
    Controller(#[from] ControllerError),
    /// A bit mask for something that is no long integer.
    #[error("P{0} is no long integer, so it has no bits to mask")]
    NotLong(u32),
    /// A value that is no number.
    #[error("{0} is no finite number")]
    NotFinite(f32),
    /// An address at which nothing stands.
    #[error("nothing stands at address 0x{0:08X}")]
    NoAddress(u32),
    /// A count or an address.
    #[error("address 0x{0:08X} holds a count or an address, which only DIM changes")]
    Fixed(u32),
    /// A conversion code for something of another type.
    #[error("address 0x{address:08X} does not hold {}", .conversion.expects())]
    Conversion {
        /// The address.
        address: u32,
        /// What the packet takes it for.
        conversion: Conversion,
    },
    /// A bit mask for something in memory that is no long integer.
    #[error("address 0x{0:08X} holds no long integer, so there are no bits to mask")]
    NotLongAt(u32),
    /// A length that a string cannot have.
    #[error("a string of {length} characters does not fit: DIM gives it {most}")]
    TextLength {
        /// The length.
        length: u32,
        /// The longest one.
        most: u32,
    },
    /// A move of a slave that a master does not have.
    #[error("SLAVE{slave} of MASTER{master} has no axis")]
    NoSlave {
        /// The master.
        master: u8,
        /// The slave.
        slave: usize,
    },
    /// A move whose targets would have to be transformed.
    #[error("INVK is on for MASTER{0}, which transforms the targets of statements only")]
    Kinematics(u8),
    /// An arc whose radius is scaled.
    #[error("scaling of the radius of an arc is not simulated")]
    RadiusScaling,
}
