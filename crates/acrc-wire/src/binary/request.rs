//! What a client sends.

use super::{Address, BitMask, DataRequest, FlagChange, Move, Override, OverrideKind, Peek, Poke, moves, parameter};
use crate::ids::{self, Start};
use crate::reader::Reader;
use crate::{Channel, Field, FirstByte, Framing, Length, Malformed, PacketKind, Side, Size};

/// What a client sends: a question that is answered, or an order that is not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Request<'a> {
    /// Parameters of a group. Answered.
    Data(DataRequest),
    /// A parameter as a long integer. Answered.
    GetLong {
        /// Its number.
        parameter: u16,
    },
    /// Sets a parameter to a long integer.
    SetLong {
        /// Its number.
        parameter: u16,
        /// Its new value.
        value: i32,
    },
    /// A parameter as an IEEE single. Answered.
    GetSingle {
        /// Its number.
        parameter: u16,
    },
    /// Sets a parameter to an IEEE single.
    SetSingle {
        /// Its number.
        parameter: u16,
        /// Its new value.
        value: f32,
    },
    /// Reads memory. Answered.
    Peek(Peek),
    /// Writes memory.
    Poke(Poke<'a>),
    /// The address of the variables of a program. Answered.
    Address(Address),
    /// The address of a parameter. Answered.
    ParameterAddress {
        /// Its number.
        parameter: u16,
    },
    /// Clears and sets bits of a long integer in memory.
    Mask {
        /// Its address.
        address: u32,
        /// Which bits.
        mask: BitMask,
    },
    /// Clears and sets bits of a parameter that is a long integer.
    ParameterMask {
        /// Its number.
        parameter: u16,
        /// Which bits.
        mask: BitMask,
    },
    /// A move.
    Move(Move),
    /// Feedrate or rapid override, at once.
    Override(Override),
    /// Sets or clears a flag, at once.
    Flag(FlagChange),
}

impl Request<'_> {
    pub(crate) fn put(&self, channel: &Channel, out: &mut impl Extend<u8>) {
        match self {
            Self::Data(data) => out.extend(data.bytes()),
            Self::GetLong { parameter } => parameter::put(PacketKind::GetLong, *parameter, &[], out),
            Self::GetSingle { parameter } => parameter::put(PacketKind::GetSingle, *parameter, &[], out),
            Self::ParameterAddress { parameter } => parameter::put(PacketKind::ParameterAddress, *parameter, &[], out),
            Self::SetLong { parameter, value } => {
                parameter::put(PacketKind::SetLong, *parameter, &[Field::from(*value)], out);
            }
            Self::SetSingle { parameter, value } => {
                parameter::put(PacketKind::SetSingle, *parameter, &[Field::from(*value)], out);
            }
            Self::ParameterMask { parameter, mask } => {
                parameter::put(PacketKind::ParameterMask, *parameter, &mask.fields(), out);
            }
            Self::Mask { address, mask } => mask.put(*address, out),
            Self::Peek(peek) => peek.put(PacketKind::Peek, out),
            Self::Poke(poke) => poke.put(out),
            Self::Address(address) => out.extend(address.bytes()),
            Self::Move(move_) => move_.put(channel, out),
            Self::Override(change) => change.put(&channel.options, out),
            Self::Flag(change) => change.put(channel, out),
        }
    }

    /// Whether the controller answers it.
    pub const fn is_answered(&self) -> bool {
        matches!(
            self,
            Self::Data(_)
                | Self::GetLong { .. }
                | Self::GetSingle { .. }
                | Self::Peek(_)
                | Self::Address(_)
                | Self::ParameterAddress { .. }
        )
    }

    fn read<'a>(kind: PacketKind, bytes: &'a [u8], channel: &Channel) -> Result<Request<'a>, Malformed> {
        let mut rest = Reader::new(bytes);
        Ok(match kind {
            PacketKind::Data => Request::Data(DataRequest::read(&mut rest)?),
            PacketKind::GetLong => Request::GetLong { parameter: parameter::read(&mut rest)? },
            PacketKind::GetSingle => Request::GetSingle { parameter: parameter::read(&mut rest)? },
            PacketKind::ParameterAddress => Request::ParameterAddress { parameter: parameter::read(&mut rest)? },
            PacketKind::SetLong => {
                Request::SetLong { parameter: parameter::read(&mut rest)?, value: Field(rest.long()?).long() }
            }
            PacketKind::SetSingle => {
                Request::SetSingle { parameter: parameter::read(&mut rest)?, value: Field(rest.long()?).single() }
            }
            PacketKind::ParameterMask => {
                Request::ParameterMask { parameter: parameter::read(&mut rest)?, mask: BitMask::read(&mut rest)? }
            }
            PacketKind::Mask => {
                let _reserved: &[u8; 4] = rest.bytes()?;
                Request::Mask { address: rest.long()?, mask: BitMask::read(&mut rest)? }
            }
            PacketKind::Peek => Request::Peek(Peek::read(&mut rest)?),
            PacketKind::Poke => Request::Poke(Poke::read(&mut rest)?),
            PacketKind::Address => Request::Address(Address::read(&mut rest)?),
            PacketKind::Move => Request::Move(Move::read(bytes, channel)?),
            PacketKind::FeedrateOverride => Request::Override(Override::read(OverrideKind::Feedrate, &mut rest)?),
            PacketKind::RapidOverride => Request::Override(Override::read(OverrideKind::Rapid, &mut rest)?),
            PacketKind::Flag1C | PacketKind::Flag1D => {
                Request::Flag(FlagChange::read(kind, &mut rest, channel.options.flag_headers)?)
            }
        })
    }
}

/// The direction from clients to the controller.
#[derive(Clone, Copy, Debug)]
pub enum Requests {}

impl Side for Requests {
    type Packet<'a> = Request<'a>;

    const PACKED: bool = true;

    fn size(head: &[u8], channel: &Channel) -> Size {
        let packed = channel.framing == Framing::Packed;
        if packed
            && channel.options.first_byte == FirstByte::Zero
            && head.first().is_some_and(|byte| *byte != ids::ZERO)
        {
            return Size::Text;
        }
        match ids::start(head) {
            Start::Text => Size::Text,
            Start::NeedsId => Size::AtLeast(2),
            Start::Packet(row) => match row.request {
                Length::Move => moves::size(head, channel),
                Length::Flag => Size::Exactly(if packed { 4 } else { 3 }),
                length => fixed_or_counted(length, head),
            },
        }
    }

    fn decode<'a>(bytes: &'a [u8], channel: &Channel) -> Result<Request<'a>, Malformed> {
        match ids::start(bytes) {
            Start::Packet(row) => Request::read(row.kind, bytes, channel),
            Start::Text | Start::NeedsId => Err(Malformed::Short),
        }
    }
}

/// The size of a packet whose length depends on its first four bytes at most.
pub(super) fn fixed_or_counted(length: Length, head: &[u8]) -> Size {
    match (length, head.get(3)) {
        (Length::Bytes(len), _) => Size::Exactly(len),
        (Length::PerMaskBit, Some(mask)) => Size::Exactly(4 + 4 * mask.count_ones() as usize),
        (Length::PerWord(len), Some(count)) => Size::Exactly(len + 4 * usize::from(*count)),
        // Only requests have the other two, and those measure them by themselves.
        (Length::PerMaskBit | Length::PerWord(_) | Length::Move | Length::Flag, _) => Size::AtLeast(4),
    }
}
