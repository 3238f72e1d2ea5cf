//! System memory: what `DIM` at the `SYS` prompt has given to programs, user parameters and aliases (guide, "Memory Allocations").

use std::collections::{BTreeMap, BTreeSet};

use acrc_catalog::memory::SystemBlock;
use acrc_catalog::{Model, memory};

use crate::error::ControllerError;
use crate::terminal::StreamName;

/// The system's memory map.
#[derive(Clone, Debug)]
pub(crate) struct SystemMemory {
    total: u32,
    blocks: BTreeMap<SystemBlock, u32>,
    /// The spaces that hold a program.
    stored: BTreeSet<SystemBlock>,
    /// User parameters P0..; empty until `DIM P`.
    user: Vec<f64>,
}

impl SystemMemory {
    /// Factory settings: the programs 0-7 share 512K, nothing else has memory.
    pub(crate) fn new(model: &Model) -> Self {
        let programs = 0..memory::FACTORY_PROGRAMS.min(model.programs);
        let blocks = programs.map(|program| (SystemBlock::Program(program), memory::FACTORY_SHARE)).collect();
        Self { total: model.system_memory(), blocks, stored: BTreeSet::new(), user: Vec::new() }
    }

    /// The map that [`SystemMemory::blocks`] and [`SystemMemory::users`] told.
    pub(crate) fn restored(
        model: &Model,
        blocks: &[(SystemBlock, u32)],
        user: &[f64],
    ) -> Result<Self, ControllerError> {
        let mut memory = Self::new(model);
        memory.clear()?;
        for (block, bytes) in blocks {
            memory.dimension(*block, i64::from(block.size(*bytes)))?;
        }
        let fits = blocks.iter().all(|(block, bytes)| memory.size(*block) == Some(*bytes));
        if !fits || memory.user.len() != user.len() {
            let problem = format!("its blocks have no room for exactly {} user parameters", user.len());
            return Err(ControllerError::BadValue { command: "memory", problem });
        }
        memory.user.copy_from_slice(user);
        Ok(memory)
    }

    /// `CLEAR` at the system prompt. Programs have to be erased before.
    pub(crate) fn clear(&mut self) -> Result<(), ControllerError> {
        if let Some(block) = self.stored.first() {
            return Err(ControllerError::Stored { block: block.to_string() });
        }
        self.blocks.clear();
        self.user.clear();
        Ok(())
    }

    /// `CLEAR` of a block that is not a program's: it gets back to factory settings, which is nothing on top.
    pub(crate) fn free_block(&mut self, block: SystemBlock) {
        self.blocks.remove(&block);
    }

    /// Whether a block has a program.
    pub(crate) fn is_stored(&self, block: SystemBlock) -> bool {
        self.stored.contains(&block)
    }

    /// Takes note of whether a space holds a program.
    pub(crate) fn set_stored(&mut self, block: SystemBlock, stored: bool) {
        if stored {
            self.stored.insert(block);
        } else {
            self.stored.remove(&block);
        }
    }

    /// Gives a block its memory. `size` is bytes for programs, PLCs and streams, and a count for parameters and aliases.
    pub(crate) fn dimension(&mut self, block: SystemBlock, size: i64) -> Result<(), ControllerError> {
        if let Some(bytes) = self.size(block) {
            return Err(ControllerError::Redimensioned { block: block.to_string(), bytes });
        }
        let limit =
            if block == SystemBlock::Parameters { i64::from(memory::USER_PARAMETERS) } else { i64::from(self.total) };
        let size = u32::try_from(size).ok().filter(|size| *size > 0 && i64::from(*size) <= limit);
        let size = size.ok_or(ControllerError::DimensionRange { limit })?;
        let bytes = u32::try_from(block.bytes(size.into())).unwrap_or(u32::MAX);
        let free = self.free();
        if bytes > free {
            return Err(ControllerError::OutOfMemory { needed: bytes, free });
        }
        self.blocks.insert(block, bytes);
        if block == SystemBlock::Parameters {
            self.user = vec![0.0; size as usize];
        }
        Ok(())
    }

    /// Bytes of a block; `None` when it has no memory.
    pub(crate) fn size(&self, block: SystemBlock) -> Option<u32> {
        self.blocks.get(&block).copied()
    }

    /// Every block with its bytes.
    pub(crate) fn blocks(&self) -> impl Iterator<Item = (SystemBlock, u32)> {
        self.blocks.iter().map(|(block, bytes)| (*block, *bytes))
    }

    /// Size of the buffer of a stream.
    pub(crate) fn stream_bytes(&self, stream: StreamName) -> u32 {
        self.size(SystemBlock::Stream(stream.into())).unwrap_or(memory::FACTORY_STREAM_BYTES)
    }

    /// The user parameters.
    pub(crate) fn users(&self) -> &[f64] {
        &self.user
    }

    /// Bytes that no block has.
    pub(crate) fn free(&self) -> u32 {
        self.total.saturating_sub(self.blocks.values().sum())
    }

    /// A user parameter.
    pub(crate) fn user(&self, number: usize) -> Option<f64> {
        self.user.get(number).copied()
    }

    /// The place of a user parameter.
    pub(crate) fn user_mut(&mut self, number: usize) -> Option<&mut f64> {
        self.user.get_mut(number)
    }

    /// How many user parameters there are.
    pub(crate) fn user_count(&self) -> usize {
        self.user.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn memory() -> SystemMemory {
        SystemMemory::new(acrc_catalog::default_model())
    }

    #[test]
    fn factory_settings_share_512k_between_eight_programs() {
        let memory = memory();
        assert_eq!(memory.size(SystemBlock::Program(0)), Some(65_536));
        assert_eq!(memory.size(SystemBlock::Program(7)), Some(65_536));
        assert_eq!(memory.size(SystemBlock::Program(8)), None);
        assert_eq!(memory.user(0), None);
    }

    #[test]
    fn a_block_is_dimensioned_once_until_it_is_cleared() {
        let mut memory = memory();
        assert!(matches!(
            memory.dimension(SystemBlock::Program(0), 100),
            Err(ControllerError::Redimensioned { bytes: 65_536, .. })
        ));
        memory.clear().expect("nothing is stored");
        memory.dimension(SystemBlock::Program(0), 8192).expect("free");
        memory.dimension(SystemBlock::Parameters, 100).expect("free");
        assert_eq!(memory.size(SystemBlock::Parameters), Some(800));
        assert_eq!((memory.user(99), memory.user(100)), (Some(0.0), None));
        memory.dimension(SystemBlock::Aliases, 50).expect("free");
        assert_eq!(memory.size(SystemBlock::Aliases), Some(2416));
    }

    #[test]
    fn a_space_with_a_program_is_not_cleared() {
        let mut memory = memory();
        memory.set_stored(SystemBlock::Program(3), true);
        assert_eq!(memory.clear(), Err(ControllerError::Stored { block: "PROG3".to_owned() }));
        memory.set_stored(SystemBlock::Program(3), false);
        assert_eq!(memory.clear(), Ok(()));
    }

    #[test]
    fn sizes_outside_the_memory_are_refused() {
        let mut memory = memory();
        memory.clear().expect("nothing is stored");
        for size in [0, -1, 4097] {
            assert!(matches!(
                memory.dimension(SystemBlock::Parameters, size),
                Err(ControllerError::DimensionRange { limit: 4096 })
            ));
        }
        let all = i64::from(memory.free());
        assert!(memory.dimension(SystemBlock::Program(0), all + 1).is_err());
        memory.dimension(SystemBlock::Program(0), all).expect("exactly all");
        assert!(matches!(
            memory.dimension(SystemBlock::Program(1), 1),
            Err(ControllerError::OutOfMemory { needed: 1, free: 0 })
        ));
    }
}
