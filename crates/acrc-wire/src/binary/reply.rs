//! What a controller answers: the first four bytes of the request, and what was asked for.

use super::request::fixed_or_counted;
use super::{Address, DataReply, PeekReply, parameter};
use crate::ids::{self, Start};
use crate::reader::Reader;
use crate::{Channel, Field, Malformed, PacketKind, Side, Size};

/// What a controller answers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reply<'a> {
    /// Parameters of a group.
    Data(DataReply<'a>),
    /// A parameter as a long integer.
    Long {
        /// Its number.
        parameter: u16,
        /// Its value.
        value: i32,
    },
    /// A parameter as an IEEE single.
    Single {
        /// Its number.
        parameter: u16,
        /// Its value.
        value: f32,
    },
    /// What stands in memory.
    Peek(PeekReply<'a>),
    /// Where the variables of a program stand; 0 when it has none of the kind.
    Address {
        /// What was asked for.
        request: Address,
        /// Their address.
        address: u32,
    },
    /// Where a parameter stands; 0 when there is no such parameter.
    ParameterAddress {
        /// Its number.
        parameter: u16,
        /// Its address.
        address: u32,
    },
}

impl Reply<'_> {
    pub(crate) fn put(&self, out: &mut impl Extend<u8>) {
        match self {
            Self::Data(data) => data.put(out),
            Self::Long { parameter, value } => {
                parameter::put(PacketKind::GetLong, *parameter, &[Field::from(*value)], out);
            }
            Self::Single { parameter, value } => {
                parameter::put(PacketKind::GetSingle, *parameter, &[Field::from(*value)], out);
            }
            Self::Peek(peek) => peek.put(out),
            Self::Address { request, address } => {
                out.extend(request.bytes());
                out.extend(address.to_le_bytes());
            }
            Self::ParameterAddress { parameter, address } => {
                parameter::put(PacketKind::ParameterAddress, *parameter, &[Field(*address)], out);
            }
        }
    }
}

/// The direction from the controller to a client.
#[derive(Clone, Copy, Debug)]
pub enum Replies {}

impl Side for Replies {
    type Packet<'a> = Reply<'a>;

    const PACKED: bool = false;

    fn size(head: &[u8], _: &Channel) -> Size {
        match (head.first(), ids::start(head)) {
            // Nothing but zero begins an answer; the other headers are characters like any.
            (Some(&byte), _) if byte != ids::ZERO => Size::Text,
            (_, Start::Packet(row)) => row.reply.map_or(Size::Exactly(4), |reply| fixed_or_counted(reply, head)),
            (_, Start::Text | Start::NeedsId) => Size::AtLeast(2),
        }
    }

    fn decode<'a>(bytes: &'a [u8], _: &Channel) -> Result<Reply<'a>, Malformed> {
        let Start::Packet(row) = ids::start(bytes) else { return Err(Malformed::Short) };
        let mut rest = Reader::new(bytes);
        Ok(match row.kind {
            PacketKind::Data => Reply::Data(DataReply::read(&mut rest)?),
            PacketKind::GetLong => {
                Reply::Long { parameter: parameter::read(&mut rest)?, value: Field(rest.long()?).long() }
            }
            PacketKind::GetSingle => {
                Reply::Single { parameter: parameter::read(&mut rest)?, value: Field(rest.long()?).single() }
            }
            PacketKind::Peek => Reply::Peek(PeekReply::read(&mut rest)?),
            PacketKind::Address => Reply::Address { request: Address::read(&mut rest)?, address: rest.long()? },
            PacketKind::ParameterAddress => {
                Reply::ParameterAddress { parameter: parameter::read(&mut rest)?, address: rest.long()? }
            }
            _ => return Err(Malformed::NotAReply(row.id.unwrap_or(row.header))),
        })
    }
}
