//! The configuration file: text, filled up with zeros, and its CRC.

use acrc_wire::ethernet::{FILE_LEN, seal};

use crate::shared::Shared;

/// The configuration file of the controller as it is now.
pub(super) fn file(shared: &Shared) -> [u8; FILE_LEN] {
    let contents = shared.core().controller.configuration_file();
    let mut file = [0; FILE_LEN];
    // The last four bytes are the CRC.
    for (place, byte) in file.iter_mut().zip(contents) {
        *place = byte;
    }
    seal(&mut file, shared.wire.crc, shared.wire.management_order);
    file
}
