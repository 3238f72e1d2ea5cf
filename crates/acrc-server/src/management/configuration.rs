//! The configuration file: text, filled up with zeros, and its CRC.

use acrc_wire::ethernet::{FILE_LEN, seal};

use crate::shared::Shared;

/// The configuration file of the controller as it is now.
pub(super) fn file(shared: &Shared) -> [u8; FILE_LEN] {
    let text = format!("MODEL {}\r\n", shared.core().controller.model().name);
    let mut file = [0; FILE_LEN];
    // The last four bytes are the CRC.
    for (place, byte) in file.iter_mut().take(FILE_LEN - 4).zip(text.bytes()) {
        *place = byte;
    }
    seal(&mut file, shared.wire.crc, shared.wire.management_order);
    file
}
