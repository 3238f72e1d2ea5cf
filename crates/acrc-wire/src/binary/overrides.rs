//! Feedrate and rapid override at once (guide, "Binary FOV Command", "Binary ROV Command").

use crate::reader::Reader;
use crate::{Field, Malformed, OverrideMasks, PacketKind, RovHeader, WireOptions};

/// Which override.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OverrideKind {
    /// `FOV`.
    Feedrate,
    /// `ROV`.
    Rapid,
}

/// Sets an override of masters when it is seen, past everything that waits in the channel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Override {
    /// Which override.
    pub kind: OverrideKind,
    /// The three masks of its header: masters 0 to 7, then masters 0 to 7 and 8 to 15 of controllers that have sixteen.
    pub masks: [u8; 3],
    /// The factor: 1.0 is no override.
    pub value: f32,
}

impl Override {
    /// An override of masters, one bit each, the lowest for master 0.
    pub const fn new(kind: OverrideKind, masters: u16, value: f32) -> Self {
        let [low, high] = masters.to_le_bytes();
        let masks = if high == 0 { [low, 0, 0] } else { [0, low, high] };
        Self { kind, masks, value }
    }

    /// The masters that it is for, one bit each, the lowest for master 0.
    pub const fn masters(self, options: &WireOptions) -> u16 {
        let [first, low, high] = self.masks;
        let others = u16::from_le_bytes([low, high]);
        match options.override_masks {
            OverrideMasks::FirstElseOthers if first != 0 => first as u16,
            OverrideMasks::FirstElseOthers | OverrideMasks::Together => others | first as u16,
        }
    }

    pub(super) fn put(self, options: &WireOptions, out: &mut impl Extend<u8>) {
        let kind = match self.kind {
            OverrideKind::Rapid if options.rov_header == RovHeader::Is1F => PacketKind::RapidOverride,
            OverrideKind::Rapid | OverrideKind::Feedrate => PacketKind::FeedrateOverride,
        };
        out.extend([kind.row().header]);
        out.extend(self.masks);
        out.extend(Field::from(self.value).0.to_le_bytes());
    }

    pub(super) fn read(kind: OverrideKind, rest: &mut Reader<'_>) -> Result<Self, Malformed> {
        let [_, first, low, high] = *rest.bytes()?;
        Ok(Self { kind, masks: [first, low, high], value: Field(rest.long()?).single() })
    }
}
