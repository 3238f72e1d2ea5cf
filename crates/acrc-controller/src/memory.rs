//! System memory: what `DIM` at the `SYS` prompt has given to programs, user parameters and aliases (guide, "Memory Allocations").

use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;

use acrc_catalog::{Model, memory};
use thiserror::Error;

use crate::error::ControllerError;
use crate::terminal::StreamName;

/// A block of system memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Block {
    /// Text and variables of a program.
    Program(u8),
    /// Text and variables of a PLC.
    Plc(u8),
    /// User parameters.
    Parameters,
    /// The alias table.
    Aliases,
    /// The buffer of a communication stream.
    Stream(StreamName),
}

impl fmt::Display for Block {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Program(number) => write!(f, "PROG{number}"),
            Self::Plc(number) => write!(f, "PLC{number}"),
            Self::Parameters => f.write_str("P"),
            Self::Aliases => f.write_str("DEF"),
            Self::Stream(stream) => stream.fmt(f),
        }
    }
}

/// A name that no block of memory has.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("`{0}` is no block of memory: they are PROGn, PLCn, P, DEF and the streams")]
pub struct UnknownBlock(String);

impl FromStr for Block {
    type Err = UnknownBlock;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        let digits = name.trim_start_matches(|character: char| character.is_ascii_uppercase());
        let block = match (name.strip_suffix(digits), digits.parse()) {
            (Some("PROG"), Ok(number)) => Self::Program(number),
            (Some("PLC"), Ok(number)) => Self::Plc(number),
            _ if name == "P" => Self::Parameters,
            _ if name == "DEF" => Self::Aliases,
            _ => Self::Stream(name.parse().map_err(|_| UnknownBlock(name.to_owned()))?),
        };
        Ok(block)
    }
}

/// The system's memory map.
#[derive(Clone, Debug)]
pub(crate) struct SystemMemory {
    total: u32,
    blocks: BTreeMap<Block, u32>,
    /// User parameters P0..; empty until `DIM P`.
    user: Vec<f64>,
}

impl SystemMemory {
    /// Factory settings: the programs 0-7 share 512K, nothing else has memory.
    pub(crate) fn new(model: &Model) -> Self {
        let programs = 0..memory::FACTORY_PROGRAMS.min(model.programs);
        let blocks = programs.map(|program| (Block::Program(program), memory::FACTORY_SHARE)).collect();
        Self { total: model.system_memory(), blocks, user: Vec::new() }
    }

    /// The map that [`SystemMemory::blocks`] and [`SystemMemory::users`] told.
    pub(crate) fn restored(model: &Model, blocks: &[(Block, u32)], user: &[f64]) -> Result<Self, ControllerError> {
        let mut memory = Self::new(model);
        memory.clear();
        for (block, bytes) in blocks {
            let (once, each) = match block {
                Block::Parameters => (memory::PARAMETERS.once, memory::PARAMETERS.each),
                Block::Aliases => (memory::ALIASES.once, memory::ALIASES.each),
                Block::Program(_) | Block::Plc(_) | Block::Stream(_) => (0, 1),
            };
            memory.dimension(*block, i64::from(bytes.saturating_sub(once) / each))?;
        }
        let fits = blocks.iter().all(|(block, bytes)| memory.size(*block) == Some(*bytes));
        if !fits || memory.user.len() != user.len() {
            let problem = format!("its blocks have no room for exactly {} user parameters", user.len());
            return Err(ControllerError::BadValue { command: "memory", problem });
        }
        memory.user.copy_from_slice(user);
        Ok(memory)
    }

    /// `CLEAR` at the system prompt.
    pub(crate) fn clear(&mut self) {
        self.blocks.clear();
        self.user.clear();
    }

    /// Gives the buffer of a stream the size of the factory again.
    pub(crate) fn clear_stream(&mut self, stream: StreamName) {
        self.blocks.remove(&Block::Stream(stream));
    }

    /// Gives a block its memory. `size` is bytes for programs, PLCs and streams, and a count for parameters and aliases.
    pub(crate) fn dimension(&mut self, block: Block, size: i64) -> Result<(), ControllerError> {
        if let Some(bytes) = self.size(block) {
            return Err(ControllerError::Redimensioned { block: block.to_string(), bytes });
        }
        let limit = if block == Block::Parameters { i64::from(memory::USER_PARAMETERS) } else { i64::from(self.total) };
        let size = u32::try_from(size).ok().filter(|size| *size > 0 && i64::from(*size) <= limit);
        let size = size.ok_or(ControllerError::DimensionRange { limit })?;
        let bytes = match block {
            Block::Parameters => memory::PARAMETERS.bytes(size.into(), 0),
            Block::Aliases => memory::ALIASES.bytes(size.into(), 0),
            Block::Program(_) | Block::Plc(_) | Block::Stream(_) => size.into(),
        };
        let bytes = u32::try_from(bytes).unwrap_or(u32::MAX);
        let free = self.free();
        if bytes > free {
            return Err(ControllerError::OutOfMemory { needed: bytes, free });
        }
        self.blocks.insert(block, bytes);
        if block == Block::Parameters {
            self.user = vec![0.0; size as usize];
        }
        Ok(())
    }

    /// Bytes of a block; `None` when it has no memory.
    pub(crate) fn size(&self, block: Block) -> Option<u32> {
        self.blocks.get(&block).copied()
    }

    /// Every block with its bytes.
    pub(crate) fn blocks(&self) -> impl Iterator<Item = (Block, u32)> {
        self.blocks.iter().map(|(block, bytes)| (*block, *bytes))
    }

    /// Size of the buffer of a stream.
    pub(crate) fn stream_bytes(&self, stream: StreamName) -> u32 {
        self.size(Block::Stream(stream)).unwrap_or(memory::FACTORY_STREAM_BYTES)
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
        assert_eq!(memory.size(Block::Program(0)), Some(65_536));
        assert_eq!(memory.size(Block::Program(7)), Some(65_536));
        assert_eq!(memory.size(Block::Program(8)), None);
        assert_eq!(memory.user(0), None);
    }

    #[test]
    fn a_block_is_dimensioned_once_until_it_is_cleared() {
        let mut memory = memory();
        assert!(matches!(
            memory.dimension(Block::Program(0), 100),
            Err(ControllerError::Redimensioned { bytes: 65_536, .. })
        ));
        memory.clear();
        memory.dimension(Block::Program(0), 8192).expect("free");
        memory.dimension(Block::Parameters, 100).expect("free");
        assert_eq!(memory.size(Block::Parameters), Some(800));
        assert_eq!((memory.user(99), memory.user(100)), (Some(0.0), None));
        memory.dimension(Block::Aliases, 50).expect("free");
        assert_eq!(memory.size(Block::Aliases), Some(2416));
    }

    #[test]
    fn sizes_outside_the_memory_are_refused() {
        let mut memory = memory();
        memory.clear();
        for size in [0, -1, 4097] {
            assert!(matches!(
                memory.dimension(Block::Parameters, size),
                Err(ControllerError::DimensionRange { limit: 4096 })
            ));
        }
        let all = i64::from(memory.free());
        assert!(memory.dimension(Block::Program(0), all + 1).is_err());
        memory.dimension(Block::Program(0), all).expect("exactly all");
        assert!(matches!(
            memory.dimension(Block::Program(1), 1),
            Err(ControllerError::OutOfMemory { needed: 1, free: 0 })
        ));
    }
}
