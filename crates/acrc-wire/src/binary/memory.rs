//! Memory by address (guide, "Binary Peek Command" to "Binary Mask Command", "Binary Global Parameter Access").
//!
//! One step of an address is 32 bits. Where variables stand is asked for with [`Address`], where a parameter stands with
//! [`Request::ParameterAddress`](super::Request::ParameterAddress), and where the user parameters stand is found at the
//! system pointer of the model.

use crate::reader::Reader;
use crate::{Field, Fields, Malformed, PacketKind};

/// What stands in the controller's memory, and what it is converted to for the line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Conversion {
    /// Long integers, which stay what they are.
    Long,
    /// 64-bit numbers, which go over the line as IEEE singles.
    Double,
    /// 32-bit numbers, which go over the line as IEEE singles.
    Single,
}

impl Conversion {
    /// By how many addresses two numbers that follow each other are apart.
    pub const fn stride(self) -> u32 {
        match self {
            Self::Long | Self::Single => 1,
            Self::Double => 2,
        }
    }

    const fn code(self) -> u8 {
        match self {
            Self::Long => 0,
            Self::Double => 1,
            Self::Single => 2,
        }
    }

    const fn from_code(code: u8) -> Result<Self, Malformed> {
        match code {
            0 => Ok(Self::Long),
            1 => Ok(Self::Double),
            2 => Ok(Self::Single),
            _ => Err(Malformed::Conversion(code)),
        }
    }
}

/// Where a user parameter stands, given what is found at the system pointer: the address of their count. None when
/// nothing is dimensioned or the address space ends before it.
pub fn global_variable_address(base: u32, index: u32) -> Option<u32> {
    let base = Some(base).filter(|base| *base != 0)?;
    base.checked_add(1)?.checked_add(index.checked_mul(Conversion::Double.stride())?)
}

/// Reads numbers from memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Peek {
    /// What stands there.
    pub conversion: Conversion,
    /// How many.
    pub count: u8,
    /// Where the first one stands.
    pub address: u32,
}

impl Peek {
    pub(super) fn put(self, kind: PacketKind, out: &mut impl Extend<u8>) {
        out.extend(kind.start());
        out.extend([self.conversion.code(), self.count]);
        out.extend(self.address.to_le_bytes());
    }

    pub(super) fn read(rest: &mut Reader<'_>) -> Result<Self, Malformed> {
        let [_, _, code, count] = *rest.bytes()?;
        Ok(Self { conversion: Conversion::from_code(code)?, count, address: rest.long()? })
    }
}

/// What stands in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PeekReply<'a> {
    request: Peek,
    fields: Fields<'a>,
}

impl<'a> PeekReply<'a> {
    /// The answer to a request. None when there are not as many fields as were asked for.
    pub fn new(request: Peek, fields: impl Into<Fields<'a>>) -> Option<Self> {
        let fields = fields.into();
        (fields.len() == usize::from(request.count)).then_some(Self { request, fields })
    }

    /// What was asked for.
    pub const fn request(&self) -> Peek {
        self.request
    }

    /// The numbers: long integers or singles, as the conversion says.
    pub const fn fields(&self) -> Fields<'a> {
        self.fields
    }

    pub(super) fn put(&self, out: &mut impl Extend<u8>) {
        self.request.put(PacketKind::Peek, out);
        self.fields.put(out);
    }

    pub(super) fn read(rest: &mut Reader<'a>) -> Result<Self, Malformed> {
        let request = Peek::read(rest)?;
        Ok(Self { request, fields: rest.fields(usize::from(request.count))? })
    }
}

/// Writes numbers to memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Poke<'a> {
    to: Peek,
    fields: Fields<'a>,
}

impl<'a> Poke<'a> {
    /// The most numbers that one packet takes.
    pub const MOST: usize = 255;

    /// Writes numbers one after another. None when there are more than [`Poke::MOST`].
    pub fn new(conversion: Conversion, address: u32, fields: impl Into<Fields<'a>>) -> Option<Self> {
        let fields = fields.into();
        let count = u8::try_from(fields.len()).ok()?;
        Some(Self { to: Peek { conversion, count, address }, fields })
    }

    /// What they become in memory.
    pub const fn conversion(&self) -> Conversion {
        self.to.conversion
    }

    /// Where the first one goes.
    pub const fn address(&self) -> u32 {
        self.to.address
    }

    /// The numbers: long integers or singles, as the conversion says.
    pub const fn fields(&self) -> Fields<'a> {
        self.fields
    }

    pub(super) fn put(&self, out: &mut impl Extend<u8>) {
        self.to.put(PacketKind::Poke, out);
        self.fields.put(out);
    }

    pub(super) fn read(rest: &mut Reader<'a>) -> Result<Self, Malformed> {
        let to = Peek::read(rest)?;
        Ok(Self { to, fields: rest.fields(usize::from(to.count))? })
    }
}

/// A kind of local variables. At the address of one of them stands how many there are; then the variables follow, or the
/// addresses of the arrays, each of which begins with its count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VariableKind {
    /// `DV`.
    DoubleVariables,
    /// `DA`.
    DoubleArrays,
    /// `SV`.
    SingleVariables,
    /// `SA`.
    SingleArrays,
    /// `LV`.
    LongVariables,
    /// `LA`.
    LongArrays,
    /// `$V`.
    StringVariables,
    /// `$A`.
    StringArrays,
}

impl VariableKind {
    /// Every kind, in the order of their codes.
    pub const ALL: [Self; 8] = [
        Self::DoubleVariables,
        Self::DoubleArrays,
        Self::SingleVariables,
        Self::SingleArrays,
        Self::LongVariables,
        Self::LongArrays,
        Self::StringVariables,
        Self::StringArrays,
    ];
}

/// Asks for the address of the variables of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Address {
    /// The number of the program.
    pub program: u8,
    /// Which variables.
    pub kind: VariableKind,
}

impl Address {
    pub(super) fn bytes(self) -> [u8; 4] {
        let [header, id] = PacketKind::Address.start();
        [header, id, self.program, self.kind as u8]
    }

    pub(super) fn read(rest: &mut Reader<'_>) -> Result<Self, Malformed> {
        let [_, _, program, code] = *rest.bytes()?;
        let kind = VariableKind::ALL.get(usize::from(code)).ok_or(Malformed::VariableKind(code))?;
        Ok(Self { program, kind: *kind })
    }
}

/// Clears bits, then sets bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BitMask {
    /// The bits to be cleared: the guide's NAND mask.
    pub clear: u32,
    /// The bits to be set: the guide's OR mask. They are set even if they are to be cleared too.
    pub set: u32,
}

impl BitMask {
    /// What becomes of a value.
    pub const fn apply(self, value: u32) -> u32 {
        (value & !self.clear) | self.set
    }

    pub(super) fn fields(self) -> [Field; 2] {
        [Field(self.clear), Field(self.set)]
    }

    /// Writes the packet that changes what stands at an address.
    pub(super) fn put(self, address: u32, out: &mut impl Extend<u8>) {
        out.extend(PacketKind::Mask.start());
        out.extend([0, 0]);
        Fields::from(&[Field(address), Field(self.clear), Field(self.set)]).put(out);
    }

    pub(super) fn read(rest: &mut Reader<'_>) -> Result<Self, Malformed> {
        Ok(Self { clear: rest.long()?, set: rest.long()? })
    }
}
