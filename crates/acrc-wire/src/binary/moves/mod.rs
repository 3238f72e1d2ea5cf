//! Moves of a master (guide, "Binary Move Command").
//!
//! The bits of a header of 4, 5 or 9 bytes say which of 23 fields follow and what they mean. [`Move`] keeps header and
//! fields as they are on the line, so that nothing is lost; [`Move::path`], [`Move::rule`] and the like say what they
//! mean, and [`MoveBuilder`] sets the bits that go with the fields.

mod builder;
mod codes;
mod meaning;

use crate::channel::padding;
use crate::reader::Reader;
use crate::{Channel, CurveFields, Field, Framing, Malformed, MovePadding, PacketKind, Size, WireOptions};

pub use builder::{Coordinate, MoveBuilder};
pub use codes::Codes;
pub use meaning::{Arc, ArcDirection, ArcPlane, Counter, MoveMode, Number, Path, RapidMoveModes, StartRule};

/// Number of fields that a move can have.
const FIELDS: usize = 23;

/// The place of a master or of a slave of a master: 0 to 15.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Slot(u8);

impl Slot {
    /// Number of places.
    pub const COUNT: u8 = 16;

    /// A place, if there is one with this number.
    pub const fn new(number: u8) -> Option<Self> {
        if number < Self::COUNT { Some(Self(number)) } else { None }
    }

    /// Its number.
    pub const fn number(self) -> u8 {
        self.0
    }

    /// Every place.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..Self::COUNT).map(Self)
    }
}

/// A field of a move, by what it carries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MoveField {
    /// Data 00: velocity of the master.
    Velocity,
    /// Data 01: final velocity of the master.
    FinalVelocity,
    /// Data 02: acceleration and deceleration of the master.
    Acceleration,
    /// Data 03 to 18: target of a slave, or the coordinate of a control point.
    Target(Slot),
    /// Data 19: center of an arc on its primary axis.
    PrimaryCenter,
    /// Data 20: center of an arc on its secondary axis.
    SecondaryCenter,
    /// Data 21: scaling of an arc on its primary axis, or the knot of a curve.
    PrimaryScalingOrKnot,
    /// Data 22: scaling of an arc on its secondary axis, or the weight of a NURB.
    SecondaryScalingOrWeight,
}

impl MoveField {
    /// Its number in the guide's table.
    pub const fn number(self) -> u8 {
        match self {
            Self::Velocity => 0,
            Self::FinalVelocity => 1,
            Self::Acceleration => 2,
            Self::Target(slave) => 3 + slave.0,
            Self::PrimaryCenter => 19,
            Self::SecondaryCenter => 20,
            Self::PrimaryScalingOrKnot => 21,
            Self::SecondaryScalingOrWeight => 22,
        }
    }
}

/// A move of a master, as it is on the line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Move {
    codes: Codes,
    /// Which fields there are, one bit each by number.
    present: u32,
    /// The fields by number; zero where there is none.
    fields: [Field; FIELDS],
}

impl Move {
    /// The header.
    pub const fn codes(&self) -> Codes {
        self.codes
    }

    /// What a field carries, if the move has it.
    pub fn field(&self, field: MoveField) -> Option<Field> {
        let number = field.number();
        if self.present & (1 << number) == 0 { None } else { self.fields.get(usize::from(number)).copied() }
    }

    pub(super) fn put(&self, channel: &Channel, out: &mut impl Extend<u8>) {
        let header = self.codes.header_len();
        out.extend([PacketKind::Move.row().header]);
        out.extend(self.codes.bytes().into_iter().take(header - 1));
        out.extend(core::iter::repeat_n(0, filling(header, channel, MovePadding::BehindHeader)));
        for number in order(channel.options) {
            if self.present & (1 << number) != 0
                && let Some(field) = self.fields.get(usize::from(number))
            {
                out.extend(field.0.to_le_bytes());
            }
        }
        out.extend(core::iter::repeat_n(0, filling(header, channel, MovePadding::AtEnd)));
    }

    pub(super) fn read(bytes: &[u8], channel: &Channel) -> Result<Self, Malformed> {
        let codes = Codes::read(bytes).ok_or(Malformed::Short)?;
        let header = codes.header_len();
        let start = header + filling(header, channel, MovePadding::BehindHeader);
        let mut rest = Reader::new(bytes.get(start..).ok_or(Malformed::Short)?);
        let mut read = Self { codes, present: codes.fields(&channel.options), fields: [Field::default(); FIELDS] };
        for number in order(channel.options) {
            if read.present & (1 << number) != 0
                && let Some(field) = read.fields.get_mut(usize::from(number))
            {
                *field = Field(rest.long()?);
            }
        }
        Ok(read)
    }
}

/// How long a move is, by the bytes of its header that have come.
pub(super) fn size(head: &[u8], channel: &Channel) -> Size {
    if head.len() < 4 {
        return Size::AtLeast(4);
    }
    let Some(codes) = Codes::read(head) else { return Size::AtLeast(Codes::header_wanted(head)) };
    let header = codes.header_len();
    let fields = 4 * codes.fields(&channel.options).count_ones() as usize;
    Size::Exactly(header + fields + filling(header, channel, channel.options.move_padding))
}

/// How many zeros stand at a place: all that is needed to come to a multiple of four, or none.
fn filling(header: usize, channel: &Channel, place: MovePadding) -> usize {
    let here = channel.framing == Framing::Packed && channel.options.move_padding == place;
    if here { padding(header) } else { 0 }
}

/// The numbers of the fields, in the order of the line.
fn order(options: WireOptions) -> impl Iterator<Item = u8> {
    let slave_10 = 13;
    let curve = 21..23;
    let split = match options.curve_fields {
        CurveFields::Last => 21,
        CurveFields::BeforeSlave10 => slave_10,
    };
    (0..split).chain(curve).chain(split..21)
}
