//! The local variables that a program may have, put together from every `DIM` of it.

use std::collections::BTreeMap;

use acrc_catalog::OperandClass;
use acrc_catalog::memory::LocalBlock;

use super::events::{Block, Event, EventKind, Size};

/// How large something is at most, over all its `DIM`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// How many; `None` when some `DIM` computes it.
    pub count: Option<u64>,
    /// Characters of each string; `None` when some `DIM` computes it.
    pub length: Option<u64>,
}

impl Extent {
    pub(super) fn of(size: Size) -> Self {
        Self { count: size.count, length: size.length }
    }

    /// The larger of both, where both are known.
    pub(super) fn join(self, other: Self) -> Self {
        let larger = |a: Option<u64>, b: Option<u64>| Some(a?.max(b?));
        Self { count: larger(self.count, other.count), length: larger(self.length, other.length) }
    }
}

/// What a program dimensions somewhere, at its prompt or in its text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LocalDims {
    blocks: BTreeMap<(LocalBlock, u32), Extent>,
}

impl LocalDims {
    /// How large a block is at most; `None` when nothing dimensions it. The number counts for arrays only.
    pub fn extent(&self, block: LocalBlock, array: u32) -> Option<Extent> {
        self.blocks.get(&(block, array)).copied()
    }

    /// Whether variables of a class have memory somewhere. For an array class its references count.
    pub fn has(&self, class: OperandClass) -> bool {
        let block = if class.is_array() { LocalBlock::References(class) } else { LocalBlock::Variables(class) };
        self.extent(block, 0).is_some()
    }

    /// Nothing is dimensioned.
    pub fn is_empty(&self) -> bool {
        self.blocks.is_empty()
    }

    /// Whether the move buffer has memory somewhere.
    pub fn has_moves(&self) -> bool {
        self.extent(LocalBlock::Moves, 0).is_some()
    }

    pub(super) fn add(&mut self, event: &Event) {
        let EventKind::Dim(Block::Local(block, array), size) = event.kind else { return };
        let extent = Extent::of(size);
        self.blocks.entry((block, array)).and_modify(|known| *known = known.join(extent)).or_insert(extent);
    }
}
