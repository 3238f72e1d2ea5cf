//! What is wrong with a packet that cannot be read.

use core::fmt;

/// A packet whose length is known but whose contents mean nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Malformed {
    /// It ends before its header says so.
    Short,
    /// Peek or poke with a conversion code that the guide does not list.
    Conversion(u8),
    /// A request for an address with a parameter code that the guide does not list.
    VariableKind(u8),
    /// A reply with the identifier of a request that is not answered.
    NotAReply(u8),
    /// A management packet with an identifier that the Ethernet specification does not list.
    ManagementId(u32),
    /// A block behind the last one of an operating system.
    BlockIndex(u32),
    /// A result of a download that the Ethernet specification does not list.
    DownloadResult(u32),
}

impl fmt::Display for Malformed {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Short => write!(formatter, "the packet ends before its header says so"),
            Self::Conversion(code) => write!(formatter, "conversion code {code:#04X} is not 0, 1 or 2"),
            Self::VariableKind(code) => write!(formatter, "parameter code {code:#04X} is not one of 0 to 7"),
            Self::NotAReply(id) => write!(formatter, "packets with the ID {id:#04X} are not answered"),
            Self::ManagementId(id) => write!(formatter, "management packet ID {id:#X} is not one of 1 to 7"),
            Self::BlockIndex(index) => write!(formatter, "block index {index} is beyond 1023"),
            Self::DownloadResult(result) => write!(formatter, "download result {result} is not 0, 1 or 2"),
        }
    }
}

impl core::error::Error for Malformed {}
