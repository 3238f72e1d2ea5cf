//! The table of packets: headers, identifiers and lengths, written once for encoders and decoders of both sides.

/// The first byte of packets with an identifier, and of their replies.
pub(crate) const ZERO: u8 = 0x00;

/// A packet of the binary host interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PacketKind {
    /// Eight parameters of a group, chosen by a mask.
    Data,
    /// A parameter as a long integer.
    GetLong,
    /// Sets a parameter to a long integer.
    SetLong,
    /// A parameter as an IEEE single.
    GetSingle,
    /// Sets a parameter to an IEEE single.
    SetSingle,
    /// Reads memory.
    Peek,
    /// Writes memory.
    Poke,
    /// The address of the variables of a program.
    Address,
    /// The address of a parameter.
    ParameterAddress,
    /// Clears and sets bits in memory.
    Mask,
    /// Clears and sets bits of a parameter.
    ParameterMask,
    /// A move of a master.
    Move,
    /// Feedrate override of masters.
    FeedrateOverride,
    /// Rapid override of masters.
    RapidOverride,
    /// Sets or clears a flag, header 1C.
    Flag1C,
    /// Sets or clears a flag, header 1D.
    Flag1D,
}

/// How long a packet is, in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Length {
    /// Always this many.
    Bytes(usize),
    /// Four, and four more for each bit of byte 3.
    PerMaskBit,
    /// This many, and four more for each of the count in byte 3.
    PerWord(usize),
    /// What the header of a move announces.
    Move,
    /// Three; four where everything comes in packets of four.
    Flag,
}

/// A row of the table of packets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PacketRow {
    /// Which packet it is.
    pub kind: PacketKind,
    /// Its first byte.
    pub header: u8,
    /// Its second byte. Data packets have any byte there that is no identifier of another packet: a group code.
    pub id: Option<u8>,
    /// What the guide calls it.
    pub title: &'static str,
    /// How long the request is.
    pub request: Length,
    /// How long the answer is, if there is one.
    pub reply: Option<Length>,
}

const fn row(
    kind: PacketKind,
    header: u8,
    id: Option<u8>,
    title: &'static str,
    request: Length,
    reply: Option<Length>,
) -> PacketRow {
    PacketRow { kind, header, id, title, request, reply }
}

/// Every packet of the binary host interface (guide, "Binary Data Packets" to "Binary ROV Command").
pub const PACKETS: [PacketRow; 16] = {
    use Length::{Bytes, Flag, Move, PerMaskBit, PerWord};
    use PacketKind as Kind;
    [
        row(Kind::Data, ZERO, None, "Binary Data Packet", Bytes(4), Some(PerMaskBit)),
        row(Kind::GetLong, ZERO, Some(0x88), "Binary Get Long", Bytes(4), Some(Bytes(8))),
        row(Kind::SetLong, ZERO, Some(0x89), "Binary Set Long", Bytes(8), None),
        row(Kind::GetSingle, ZERO, Some(0x8A), "Binary Get IEEE", Bytes(4), Some(Bytes(8))),
        row(Kind::SetSingle, ZERO, Some(0x8B), "Binary Set IEEE", Bytes(8), None),
        row(Kind::Peek, ZERO, Some(0x90), "Binary Peek", Bytes(8), Some(PerWord(8))),
        row(Kind::Poke, ZERO, Some(0x91), "Binary Poke", PerWord(8), None),
        row(Kind::Address, ZERO, Some(0x92), "Binary Address", Bytes(4), Some(Bytes(8))),
        row(Kind::ParameterAddress, ZERO, Some(0x93), "Binary Parameter Address", Bytes(4), Some(Bytes(8))),
        row(Kind::Mask, ZERO, Some(0x94), "Binary Mask", Bytes(16), None),
        row(Kind::ParameterMask, ZERO, Some(0x95), "Binary Parameter Mask", Bytes(12), None),
        row(Kind::Move, 0x04, None, "Binary Move", Move, None),
        row(Kind::FeedrateOverride, 0x07, None, "Binary FOV", Bytes(8), None),
        row(Kind::RapidOverride, 0x1F, None, "Binary ROV", Bytes(8), None),
        row(Kind::Flag1C, 0x1C, None, "Binary SET", Flag, None),
        row(Kind::Flag1D, 0x1D, None, "Binary CLR", Flag, None),
    ]
};

impl PacketKind {
    /// Its row of the table.
    pub const fn row(self) -> &'static PacketRow {
        // The rows stand in the order of the kinds; a test holds them to it.
        const ROWS: &[PacketRow; PACKETS.len()] = &PACKETS;
        &ROWS[self as usize]
    }

    /// The first two bytes of a packet that has an identifier.
    pub(crate) const fn start(self) -> [u8; 2] {
        let row = self.row();
        match row.id {
            Some(id) => [row.header, id],
            None => [row.header, 0],
        }
    }
}

/// What the first bytes of a packet say.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Start {
    /// No packet begins with them.
    Text,
    /// The second byte decides.
    NeedsId,
    Packet(&'static PacketRow),
}

/// Which packet begins with these bytes.
pub(crate) fn start(head: &[u8]) -> Start {
    match *head {
        [] | [ZERO] => Start::NeedsId,
        [ZERO, id, ..] => {
            let known = PACKETS.iter().find(|row| row.id == Some(id));
            Start::Packet(known.unwrap_or(PacketKind::Data.row()))
        }
        [header, ..] => PACKETS.iter().find(|row| row.header == header).map_or(Start::Text, Start::Packet),
    }
}

/// A row of the table of management packets (Ethernet specification, "Connection Management").
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ManagementRow {
    /// Its first four bytes.
    pub id: u32,
    /// What it is.
    pub title: &'static str,
    /// Length of the packet of the client, in bytes.
    pub request: usize,
    /// Length of what the controller sends with this identifier, if it does.
    pub reply: Option<usize>,
}

/// Every packet of port 5004.
pub const MANAGEMENT_PACKETS: [ManagementRow; 7] = [
    ManagementRow { id: 1, title: "watchdog", request: 24, reply: Some(24) },
    ManagementRow { id: 2, title: "user alarms", request: 8, reply: Some(8) },
    ManagementRow { id: 3, title: "controller alarms", request: 8, reply: Some(16) },
    ManagementRow { id: 4, title: "configuration file", request: 4, reply: Some(1028) },
    ManagementRow { id: 5, title: "block of an operating system", request: 1032, reply: None },
    ManagementRow { id: 6, title: "end of a download", request: 4, reply: Some(8) },
    ManagementRow { id: 7, title: "reboot", request: 4, reply: None },
];
