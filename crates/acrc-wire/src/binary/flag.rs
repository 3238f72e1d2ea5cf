//! Setting and clearing flags at once (guide, "Binary SET and CLR").

use crate::reader::Reader;
use crate::{Channel, FlagHeaders, Framing, Malformed, PacketKind};

/// Sets or clears a flag when it is seen, past everything that waits in the channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FlagChange {
    /// The number of the flag.
    pub flag: u16,
    /// Whether it is set.
    pub set: bool,
}

impl FlagChange {
    pub(super) fn put(self, channel: &Channel, out: &mut impl Extend<u8>) {
        let is_1c = self.set == (channel.options.flag_headers == FlagHeaders::SetIs1C);
        let kind = if is_1c { PacketKind::Flag1C } else { PacketKind::Flag1D };
        let [low, high] = self.flag.to_le_bytes();
        out.extend([kind.row().header, low, high]);
        if channel.framing == Framing::Packed {
            out.extend([0]);
        }
    }

    pub(super) fn read(kind: PacketKind, rest: &mut Reader<'_>, headers: FlagHeaders) -> Result<Self, Malformed> {
        let _header: &[u8; 1] = rest.bytes()?;
        let set = (kind == PacketKind::Flag1C) == (headers == FlagHeaders::SetIs1C);
        Ok(Self { flag: rest.word()?, set })
    }
}
