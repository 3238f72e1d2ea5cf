//! Data packets: up to eight parameters of a group at once (guide, "Binary Data Packets").

use acrc_catalog::{Confidence, GROUP_FIELDS, ParameterBlock, all_parameter_blocks};

use crate::ids::ZERO;
use crate::reader::Reader;
use crate::{Fields, Malformed};

/// Parameters of one kind, one for each of eight objects, or eight that follow each other
/// ([`ParameterBlock::of_group`]).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Group {
    code: u8,
    block: &'static ParameterBlock,
}

impl Group {
    /// The group with a code, if it lies in a block of parameters.
    pub fn of(code: u8) -> Option<Self> {
        ParameterBlock::of_group(code).map(|block| Self { code, block })
    }

    /// Its code.
    pub const fn code(&self) -> u8 {
        self.code
    }

    /// Whether the catalogue has the code, and not only parameters that it would be for.
    pub fn is_listed(&self) -> bool {
        self.block.group_code == Some(self.code)
    }

    /// How well the block of its parameters is attested.
    pub const fn confidence(&self) -> Confidence {
        self.block.confidence
    }

    /// The number of the parameter that a bit of the isolation mask isolates, by group index and bit. None for an object
    /// or a parameter behind the last one.
    pub fn parameter(&self, index: u8, bit: u8) -> Option<u16> {
        self.block.group_field(self.code, index, bit).and_then(|number| u16::try_from(number).ok())
    }
}

/// Asks for parameters of a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DataRequest {
    /// The group code. The identifiers of other packets (88 to 8B, 90 to 95) cannot be asked for.
    pub group: u8,
    /// The group index: which parameter of each object, or the first of eight.
    pub index: u8,
    /// The isolation mask: one bit a field, the lowest for the first.
    pub mask: u8,
}

impl DataRequest {
    /// The request for one parameter, by a code that the catalogue has.
    pub fn of(parameter: u16) -> Option<Self> {
        let number = u32::from(parameter);
        let block = all_parameter_blocks().find(|block| (block.first..=block.last).contains(&number))?;
        let offset = number - block.first;
        let bit = offset.saturating_sub(0xFF).div_ceil(block.stride.max(1));
        let index = u8::try_from(offset.checked_sub(bit * block.stride.max(1))?).ok()?;
        let mask = 1_u8.checked_shl(bit).filter(|_| bit < u32::from(GROUP_FIELDS))?;
        Some(Self { group: block.group_code?, index, mask })
    }

    /// How many fields the answer has.
    pub const fn count(&self) -> usize {
        self.mask.count_ones() as usize
    }

    /// The parameters that are asked for, in the order of the answer. None for one that does not exist.
    pub fn parameters(self) -> impl Iterator<Item = Option<u16>> {
        let group = Group::of(self.group);
        (0..GROUP_FIELDS)
            .filter(move |bit| self.mask & (1 << bit) != 0)
            .map(move |bit| group.and_then(|group| group.parameter(self.index, bit)))
    }

    pub(super) const fn bytes(self) -> [u8; 4] {
        [ZERO, self.group, self.index, self.mask]
    }

    pub(super) fn read(rest: &mut Reader<'_>) -> Result<Self, Malformed> {
        let [_, group, index, mask] = *rest.bytes()?;
        Ok(Self { group, index, mask })
    }
}

/// Parameters of a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DataReply<'a> {
    request: DataRequest,
    fields: Fields<'a>,
}

impl<'a> DataReply<'a> {
    /// The answer to a request. None when there are not as many fields as were asked for.
    pub fn new(request: DataRequest, fields: impl Into<Fields<'a>>) -> Option<Self> {
        let fields = fields.into();
        (fields.len() == request.count()).then_some(Self { request, fields })
    }

    /// What was asked for.
    pub const fn request(&self) -> DataRequest {
        self.request
    }

    /// The values, in the order of the bits of the mask: long integers or singles, as the parameters are.
    pub const fn fields(&self) -> Fields<'a> {
        self.fields
    }

    pub(super) fn put(&self, out: &mut impl Extend<u8>) {
        out.extend(self.request.bytes());
        self.fields.put(out);
    }

    pub(super) fn read(rest: &mut Reader<'a>) -> Result<Self, Malformed> {
        let request = DataRequest::read(rest)?;
        Ok(Self { request, fields: rest.fields(request.count())? })
    }
}
