//! What has memory at one time: blocks of the system, and variables of a program.

use std::collections::BTreeMap;

use acrc_catalog::memory::SystemBlock;
use acrc_catalog::{Model, memory};

use super::events::{Block, Size};
use super::issue::Space;

/// System memory of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Slot {
    /// `None` when it is not known.
    pub(super) bytes: Option<u64>,
    /// What the `DIM` counts, when it is known.
    pub(super) count: Option<u64>,
    /// The file and the event of the `DIM`; `None` for the factory settings.
    pub(super) by: Option<(u32, u32)>,
}

/// Local variables and move buffer of a program at one time.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct LocalState {
    pub(super) blocks: BTreeMap<Block, Size>,
    /// What may have happened makes every answer unsure.
    pub(super) unknown: bool,
}

impl Slot {
    /// The memory of a block that may have none. `None` when it is not known.
    pub(super) fn space(slot: Option<&Self>) -> Option<Space> {
        match slot {
            None => Some(Space::None),
            Some(slot) if slot.by.is_none() => slot.bytes.map(Space::Factory),
            Some(slot) => slot.bytes.map(Space::Dim),
        }
    }
}

impl LocalState {
    /// Bytes of what is known.
    pub(super) fn bytes(&self) -> u64 {
        self.blocks.iter().filter_map(|(block, size)| local_bytes(*block, *size)).sum()
    }
}

impl LocalState {
    /// Bytes of everything; `None` when something of it is not known.
    pub(super) fn known_bytes(&self) -> Option<u64> {
        let all = self.blocks.iter().map(|(block, size)| local_bytes(*block, *size));
        all.sum::<Option<u64>>().filter(|_| !self.unknown)
    }
}

/// Bytes of a block of a program. `None` when a number of it is computed, or for a block of the system.
pub(super) fn local_bytes(block: Block, size: Size) -> Option<u64> {
    match block {
        Block::Local(local, _) => Some(local.bytes(size.count?, size.length?)),
        Block::System(_) => None,
    }
}

/// `CLEAR` and `NEW` of a program.
pub(super) fn forget(state: &mut LocalState, certain: bool) {
    if certain {
        *state = LocalState::default();
    } else {
        state.unknown = true;
    }
}

/// `CLEAR MBUF` of a program.
pub(super) fn forget_moves(state: &mut LocalState, certain: bool) {
    if certain {
        state.blocks.remove(&Block::MOVES);
    } else {
        state.unknown = true;
    }
}

/// Factory settings: the first programs share the program memory equally.
pub(super) fn factory(model: &Model) -> BTreeMap<SystemBlock, Slot> {
    let share = u64::from(memory::FACTORY_SHARE);
    let slot = Slot { bytes: Some(share), count: Some(share), by: None };
    (0..memory::FACTORY_PROGRAMS.min(model.programs)).map(|program| (SystemBlock::Program(program), slot)).collect()
}
