//! The `DIM` statements that give exactly what is needed.

use acrc_catalog::memory::SystemBlock;

use super::calls::Calls;
use super::events::space_of;
use super::report::{Parameters, ProgramReport, Report};

impl Report {
    /// The `DIM` statements of the system that fit exactly, each with what it leaves open.
    pub fn exact(&self) -> Vec<Exact> {
        let mut exact: Vec<Exact> = self.programs.iter().filter_map(ProgramReport::exact).collect();
        let current = |block| self.system.iter().find(|line| line.block == block).and_then(|line| line.count);
        let Parameters { count, computed } = self.parameters;
        // A computed number may be any; what the project gives now is kept then.
        let parameters = if computed { count.max(current(SystemBlock::Parameters).unwrap_or(0)) } else { count };
        let open = computed.then_some("numbers are computed");
        exact.push(Exact { block: SystemBlock::Parameters, count: parameters, open });
        exact.push(Exact { block: SystemBlock::Aliases, count: self.aliases, open: None });
        let streams = self.system.iter().filter(|line| matches!(line.block, SystemBlock::Stream(_)));
        exact.extend(streams.filter_map(|line| Some(Exact { block: line.block, count: line.count?, open: None })));
        exact.retain(|exact| exact.count > 0);
        exact
    }
}

/// A `DIM` that fits exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Exact {
    /// What it gives memory to.
    pub block: SystemBlock,
    /// Its number.
    pub count: u64,
    /// Why more may be needed.
    pub open: Option<&'static str>,
}

impl Exact {
    /// Bytes of system memory that it takes.
    pub fn bytes(&self) -> u64 {
        self.block.bytes(self.count)
    }
}

impl ProgramReport {
    fn exact(&self) -> Option<Exact> {
        let open = match self.calls {
            Calls::Recursive => Some("a subroutine calls itself: 4 bytes more for each level"),
            Calls::Depth(_) => self.is_open().then_some("and what it computes the size of"),
        };
        Some(Exact { block: space_of(self.level)?, count: self.needed(), open })
    }
}
