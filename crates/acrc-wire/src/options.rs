//! Where the documents contradict each other: what is read by default, and the other reading.
//!
//! `docs/fidelity.md` has the reasons, in its section "Wire". What is a plain misprint (a number beside bytes that say
//! otherwise) has no setting.

/// How the documents are read where they contradict each other or leave a choice. The default is what this project
/// takes to be true.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WireOptions {
    /// Which bytes begin a binary packet on port 5006.
    pub first_byte: FirstByte,
    /// Which of the headers 1C and 1D sets a flag.
    pub flag_headers: FlagHeaders,
    /// The header of a rapid override.
    pub rov_header: RovHeader,
    /// How the three masks of an override act together.
    pub override_masks: OverrideMasks,
    /// What a spline move carries besides its control points.
    pub spline_fields: SplineFields,
    /// Where knot and weight stand in a move.
    pub curve_fields: CurveFields,
    /// How a move is padded on port 5006.
    pub move_padding: MovePadding,
    /// The unit of a watchdog's timer.
    pub watchdog_unit: WatchdogUnit,
    /// The order of bytes on port 5004.
    pub management_order: ByteOrder,
    /// How the CRC of a file is computed.
    pub crc: CrcRule,
}

/// Which bytes begin a binary packet on port 5006.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FirstByte {
    /// Every header of the guide: 00, 04, 07, 1C, 1D, 1F.
    #[default]
    AnyHeader,
    /// Zero only, as the Ethernet specification says.
    Zero,
}

/// Which of the headers 1C and 1D sets a flag.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FlagHeaders {
    /// 1C sets, 1D clears: the guide, and the examples of both documents.
    #[default]
    SetIs1C,
    /// 1D sets, 1C clears: the headings of two tables of the ACR7000 note.
    SetIs1D,
}

/// The header with which a rapid override is sent. A packet that comes in with 1F is one, and with 07 none, in both
/// readings.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RovHeader {
    /// 1F, as the guide's table says.
    #[default]
    Is1F,
    /// 07, as the guide's examples print it; such a packet sets the feedrate override.
    Is07,
}

/// How the three masks of an override act together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum OverrideMasks {
    /// The first one alone, unless it is zero: then the two others.
    #[default]
    FirstElseOthers,
    /// All of them together.
    Together,
}

/// What a spline move carries besides its control points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SplineFields {
    /// Its knot, when bit 5 of header code 1 says so; a weight belongs to NURBS only.
    #[default]
    KnotByCode1,
    /// Both fields that bit 3 of header code 3 announces, as NURBS do; bit 5 of header code 1 says that the knot is used.
    BothByCode3,
}

/// Where knot and weight stand in a move. Without slaves 8 to 15 it makes no difference.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CurveFields {
    /// Behind all targets and centers, as data 21 and 22 of the guide's table.
    #[default]
    Last,
    /// As data 13 and 14 of the guide's text: in front of the target of slave 10.
    BeforeSlave10,
}

/// How a move is padded on port 5006, where everything comes in packets of four bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MovePadding {
    /// The data follow the header of 4, 5 or 9 bytes at once; zeros fill up the end.
    #[default]
    AtEnd,
    /// Zeros fill up the header to 4, 8 or 12 bytes.
    BehindHeader,
}

/// The unit of a watchdog's timer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum WatchdogUnit {
    /// As the table of the packet says.
    #[default]
    Milliseconds,
    /// As the text in front of it says.
    Seconds,
}

/// The order of the bytes of a number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ByteOrder {
    /// The high byte comes first.
    #[default]
    BigEndian,
    /// The low byte comes first, as in packets of the binary host interface.
    LittleEndian,
}

impl ByteOrder {
    pub(crate) const fn read(self, bytes: [u8; 4]) -> u32 {
        match self {
            Self::BigEndian => u32::from_be_bytes(bytes),
            Self::LittleEndian => u32::from_le_bytes(bytes),
        }
    }

    pub(crate) const fn write(self, value: u32) -> [u8; 4] {
        match self {
            Self::BigEndian => value.to_be_bytes(),
            Self::LittleEndian => value.to_le_bytes(),
        }
    }
}

/// How the CRC of a configuration file or an operating system is computed from its polynomial.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CrcRule {
    /// As Ethernet does it: low bits first, inverted at the end.
    #[default]
    Ethernet,
    /// With the polynomial and the first remainder alone, which is all that the specification names: high bits first,
    /// not inverted.
    HighBitFirst,
}
