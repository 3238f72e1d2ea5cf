//! How far lines are indented (guide, "IF/ELSE": what a listing indents).
//!
//! Only blocks that are closed count. A body that is not indented shows, as in the controller's listing, that its
//! block does not match.

use std::ops::Range;

use acrc_syntax::Tree;
use acrc_syntax::blocks::{self, Block};
use acrc_syntax::units::{self, Level, Section};

use crate::options::{BlockEnds, MAX_INDENT, Options};

/// Levels that are shown. Deeper blocks are indented like these, so that a text of nothing but openers does not grow
/// without bounds.
const MAX_LEVELS: usize = 16;

/// What a statement does to the indentation.
#[derive(Clone, Copy, Default)]
struct Step {
    opens: bool,
    closes: bool,
    branches: bool,
}

/// Follows the statements of a text and tells the indentation of each line.
pub(crate) struct Indents {
    steps: Vec<Step>,
    depth: usize,
    width: usize,
    ends: BlockEnds,
}

impl Indents {
    pub(crate) fn new(tree: &Tree, options: Options) -> Self {
        let mut steps = vec![Step::default(); tree.statements().len()];
        for range in regions(tree) {
            for block in blocks::match_blocks(tree, range).all() {
                note(&mut steps, block);
            }
        }
        Self { steps, depth: 0, width: options.indent.min(MAX_INDENT).into(), ends: options.block_ends }
    }

    /// Blanks before a line with these statements. The lines are given in order.
    pub(crate) fn next(&mut self, statements: Range<u32>) -> usize {
        let steps = self.steps.get(statements.start as usize..statements.end as usize).unwrap_or_default();
        let leaves =
            self.ends == BlockEnds::Opener && steps.first().is_some_and(|first| first.closes || first.branches);
        let levels = self.depth.saturating_sub(leaves.into()).min(MAX_LEVELS);
        for step in steps {
            self.depth = (self.depth + usize::from(step.opens)).saturating_sub(step.closes.into());
        }
        levels * self.width
    }
}

fn note(steps: &mut [Step], block: &Block) {
    let Some(closer) = block.closer else { return };
    let mut set = |statement: u32, change: fn(&mut Step)| {
        if let Some(step) = steps.get_mut(statement as usize) {
            change(step);
        }
    };
    set(block.opener, |step| step.opens = true);
    set(closer, |step| step.closes = true);
    for &branch in &block.branches {
        set(branch, |step| step.branches = true);
    }
}

/// Ranges of statements in which blocks match. Lines with numbers and lines without belong together: how a file comes
/// to the controller does not change its look.
fn regions(tree: &Tree) -> Vec<Range<u32>> {
    let mut regions: Vec<(Option<Level>, Range<u32>)> = Vec::new();
    for Section { level, statements, opener, .. } in units::split(tree, Level::System) {
        let level = opener.is_none().then_some(level);
        match regions.last_mut() {
            Some((Some(last), range)) if level == Some(*last) => range.end = statements.end,
            _ => regions.push((level, statements)),
        }
    }
    regions.into_iter().map(|(_, range)| range).collect()
}
