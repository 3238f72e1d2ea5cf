//! An operating system that a client sends (Ethernet specification, "Operating System Download"). It goes into a scratch area and is never
//! executed.

use acrc_wire::WireOptions;
use acrc_wire::ethernet::management::DownloadResult;
use acrc_wire::ethernet::{FILE_LEN, is_intact};

/// Bytes of a block.
pub(super) const BLOCK: usize = FILE_LEN;

/// The blocks that have arrived. The decoder lets no index pass that is too high, so this is a mebibyte at most.
#[derive(Debug, Default)]
pub(super) struct Download {
    file: Vec<u8>,
}

impl Download {
    /// Stores a block at its place. What is between it and the others is zero until it comes.
    pub(super) fn store(&mut self, index: u16, data: &[u8; BLOCK]) {
        let start = usize::from(index) * BLOCK;
        let end = start + BLOCK;
        if self.file.len() < end {
            self.file.resize(end, 0);
        }
        if let Some(place) = self.file.get_mut(start..end) {
            place.copy_from_slice(data);
        }
    }

    /// What the client is told at the end.
    pub(super) fn finish(&self, wire: &WireOptions) -> DownloadResult {
        if is_intact(&self.file, wire.crc, wire.management_order) {
            DownloadResult::Success
        } else {
            DownloadResult::CrcFailure
        }
    }

    /// Its bytes.
    pub(super) fn len(&self) -> usize {
        self.file.len()
    }
}
