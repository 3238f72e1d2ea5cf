//! The communication streams by name (guide, "Stream Allocation"; the catalogue's models).

use std::fmt;
use std::str::FromStr;

use acrc_catalog::{Model, memory};
use thiserror::Error;

/// A communication stream of a controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum StreamName {
    /// The FIFO of the bus of a computer.
    Fifo,
    /// Dual-port memory.
    DualPort,
    /// A serial port.
    Com(u8),
    /// `STREAM1` is USB, the others are handed to Ethernet clients.
    Stream(u8),
}

/// Why a channel cannot be opened.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum StreamError {
    /// A name that no controller has.
    #[error("`{0}` is no stream: there are FIFO, DPCB, COM1, COM2 and STREAM1 to STREAM5")]
    Unknown(String),
    /// The model lacks it.
    #[error("{model} has no {stream}: its streams are {}", streams.join(", "))]
    Missing {
        /// The stream.
        stream: StreamName,
        /// The model.
        model: &'static str,
        /// What it has.
        streams: &'static [&'static str],
    },
    /// Another channel uses it.
    #[error("{0} is in use")]
    InUse(StreamName),
}

impl fmt::Display for StreamName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fifo => f.write_str("FIFO"),
            Self::DualPort => f.write_str("DPCB"),
            Self::Com(number) => write!(f, "COM{number}"),
            Self::Stream(number) => write!(f, "STREAM{number}"),
        }
    }
}

impl StreamName {
    /// Whether a model has it.
    ///
    /// # Errors
    /// When it has not.
    pub fn check(self, model: &'static Model) -> Result<(), StreamError> {
        if model.streams.contains(&self.to_string().as_str()) {
            return Ok(());
        }
        Err(StreamError::Missing { stream: self, model: model.name, streams: model.streams })
    }
}

impl FromStr for StreamName {
    type Err = StreamError;

    fn from_str(text: &str) -> Result<Self, StreamError> {
        let upper = text.trim().to_ascii_uppercase();
        let number = |digits: &str, last: u8| digits.parse().ok().filter(|number| (1..=last).contains(number));
        let stream = match (upper.strip_prefix("COM"), upper.strip_prefix("STREAM")) {
            _ if upper == "FIFO" => Some(Self::Fifo),
            _ if upper == "DPCB" => Some(Self::DualPort),
            (Some(digits), _) => number(digits, 2).map(Self::Com),
            (_, Some(digits)) => number(digits, 5).map(Self::Stream),
            (None, None) => None,
        };
        stream.ok_or_else(|| StreamError::Unknown(text.to_owned()))
    }
}

/// The buffer of a stream.
impl From<StreamName> for memory::Stream {
    fn from(name: StreamName) -> Self {
        match name {
            StreamName::Stream(number) => Self::Numbered(number),
            StreamName::Fifo => Self::Fifo,
            StreamName::DualPort => Self::Dpcb,
            StreamName::Com(number) => Self::Com(number),
        }
    }
}
