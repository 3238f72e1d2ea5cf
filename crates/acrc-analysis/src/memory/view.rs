//! What one file needs to know of the memory of its project.

use acrc_syntax::units::Level;

use super::issue::{Issue, Spare};
use super::locals::{Extent, LocalDims};
use super::play::ProjectMemory;

/// The memory of the project as far as one file uses it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct MemoryView {
    /// See [`ProjectMemory::managed`].
    pub managed: bool,
    /// See [`ProjectMemory::parameters`].
    pub parameters: Option<Extent>,
    /// What does not fit in this file.
    pub issues: Vec<Issue>,
    /// What has much more than it needs in this file.
    pub spare: Vec<Spare>,
    locals: Vec<(Level, LocalDims)>,
}

impl MemoryView {
    pub(super) fn new(memory: &ProjectMemory, file: u32, levels: &[Level]) -> Self {
        Self {
            managed: memory.managed,
            parameters: memory.parameters,
            issues: memory.issues.iter().filter(|(of, _)| *of == file).map(|(_, issue)| issue.clone()).collect(),
            spare: memory.spare.iter().filter(|(of, _)| *of == file).map(|(_, spare)| spare.clone()).collect(),
            locals: memory.locals.iter().filter(|(level, _)| levels.contains(level)).cloned().collect(),
        }
    }

    /// What the program of a level dimensions for itself, anywhere.
    pub fn locals(&self, level: Level) -> Option<&LocalDims> {
        self.locals.iter().find(|(at, _)| *at == level).map(|(_, dims)| dims)
    }
}
