//! Packets that name a parameter by its number (guide, "Binary Parameter Access", "Binary Parameter Address Command",
//! "Binary Parameter Mask Command"): header, identifier, the number as a word, then fields.

use crate::reader::Reader;
use crate::{Field, Malformed, PacketKind};

pub(super) fn put(kind: PacketKind, parameter: u16, fields: &[Field], out: &mut impl Extend<u8>) {
    out.extend(kind.start());
    out.extend(parameter.to_le_bytes());
    out.extend(fields.iter().flat_map(|field| field.0.to_le_bytes()));
}

/// Reads up to the number.
pub(super) fn read(rest: &mut Reader<'_>) -> Result<u16, Malformed> {
    let _start: &[u8; 2] = rest.bytes()?;
    rest.word()
}
