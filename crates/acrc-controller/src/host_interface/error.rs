//! What the controller refuses a host.

use thiserror::Error;

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
}
