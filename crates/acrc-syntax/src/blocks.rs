//! Which `ENDIF` closes which `IF` (guide, "Program Flow").
//!
//! Blocks are matched over a range of statements, normally the stored text of one program. `ELSE IF` in two words
//! shares the `ENDIF` of its chain, while `ELSE : IF` opens a block inside the `ELSE`. `IF` with `THEN` opens none.

use std::ops::Range;

use acrc_catalog::command;

use crate::Tree;
use crate::ast::{Separator, StatementKind};

/// The kinds of blocks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BlockKind {
    /// `IF` .. `ENDIF`
    If,
    /// `FOR` .. `NEXT`
    For,
    /// `WHILE` .. `WEND`
    While,
}

impl BlockKind {
    /// The word that opens it.
    #[must_use]
    pub const fn opener(self) -> &'static str {
        match self {
            Self::If => "IF",
            Self::For => "FOR",
            Self::While => "WHILE",
        }
    }

    /// The word that closes it.
    #[must_use]
    pub const fn closer(self) -> &'static str {
        match self {
            Self::If => "ENDIF",
            Self::For => "NEXT",
            Self::While => "WEND",
        }
    }

    /// Whether `BREAK` leaves it.
    #[must_use]
    pub const fn is_loop(self) -> bool {
        matches!(self, Self::For | Self::While)
    }
}

/// A block. Statements are given by their index in [`Tree::statements`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    /// Its kind.
    pub kind: BlockKind,
    /// The statement that opens it.
    pub opener: u32,
    /// `ELSEIF`, `ELSE IF` and `ELSE`, in order.
    pub branches: Vec<u32>,
    /// The statement that closes it.
    pub closer: Option<u32>,
    /// Number of blocks around it.
    pub depth: u32,
    /// The block around it, an index into [`Blocks::all`].
    pub parent: Option<u32>,
}

/// What is wrong with the blocks of a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BlockError {
    /// The statement that is wrong.
    pub statement: u32,
    /// What is wrong with it.
    pub kind: BlockErrorKind,
}

/// Kinds of [`BlockError`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BlockErrorKind {
    /// A block is not closed; the statement opens it.
    Unclosed(BlockKind),
    /// The statement closes or branches a block that is not open; the word is `ENDIF`, `ELSE`, ...
    Unopened(&'static str),
    /// The statement closes a block while another one, opened inside it, is still open.
    Crossed {
        /// The kind that is closed.
        closes: BlockKind,
        /// The statement that opened the inner block.
        open: u32,
        /// The kind of the inner block.
        open_kind: BlockKind,
    },
    /// A branch stands behind the `ELSE` of its chain.
    ElseAfterElse {
        /// The `ELSE`.
        first: u32,
    },
}

/// The blocks of a range of statements.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Blocks {
    first: u32,
    /// Of each statement the innermost block to which it belongs or in which it stands; [`NONE`] for none.
    owners: Vec<u32>,
    blocks: Vec<Block>,
    errors: Vec<BlockError>,
}

const NONE: u32 = u32::MAX;
/// Number of kinds of blocks.
const KINDS: usize = 3;
const ELSE: &str = "ELSE";

impl Blocks {
    /// All blocks, by their openers.
    #[must_use]
    pub fn all(&self) -> &[Block] {
        &self.blocks
    }

    /// What does not match, by statement.
    #[must_use]
    pub fn errors(&self) -> &[BlockError] {
        &self.errors
    }

    /// The block that a statement opens, branches or closes.
    #[must_use]
    pub fn block_of(&self, statement: u32) -> Option<&Block> {
        self.owner(statement).filter(|block| {
            block.opener == statement
                || block.closer == Some(statement)
                || block.branches.binary_search(&statement).is_ok()
        })
    }

    /// The innermost block in which a statement stands. Its opener, branches and closer stand in the one around it.
    #[must_use]
    pub fn enclosing(&self, statement: u32) -> Option<&Block> {
        match self.block_of(statement) {
            Some(block) => self.parent(block),
            None => self.owner(statement),
        }
    }

    /// The innermost loop in which a statement stands: what a `BREAK` there leaves.
    #[must_use]
    pub fn enclosing_loop(&self, statement: u32) -> Option<&Block> {
        std::iter::successors(self.enclosing(statement), |block| self.parent(block)).find(|block| block.kind.is_loop())
    }

    /// The block around a block.
    #[must_use]
    pub fn parent(&self, block: &Block) -> Option<&Block> {
        self.blocks.get(block.parent? as usize)
    }

    fn owner(&self, statement: u32) -> Option<&Block> {
        let place = statement.checked_sub(self.first)?;
        self.blocks.get(*self.owners.get(place as usize)? as usize)
    }
}

/// Matches the blocks of a range of statements. What lies beyond the last statement is ignored.
#[must_use]
pub fn match_blocks(tree: &Tree, statements: Range<u32>) -> Blocks {
    let mut matcher = Matcher::default();
    matcher.found.first = statements.start;
    for index in statements {
        let Some(part) = part_at(tree, index) else { break };
        let owner = matcher.part(index, part);
        matcher.found.owners.push(owner.unwrap_or(NONE));
    }
    matcher.finish()
}

/// What a statement does to blocks.
#[derive(Clone, Copy)]
enum Part {
    Open(BlockKind),
    Branch(&'static str),
    Close(BlockKind),
    /// It could not be read and may have been any of them.
    Unknown,
    Nothing,
}

fn part_at(tree: &Tree, index: u32) -> Option<Part> {
    let statement = tree.statements().get(index as usize)?;
    Some(match &statement.kind {
        // A `THEN` with nothing behind it is an error; it was meant to open a block.
        StatementKind::If(head) if head.then.is_none() || !has_conditional(tree, index) => Part::Open(BlockKind::If),
        StatementKind::For(_) => Part::Open(BlockKind::For),
        StatementKind::Error => Part::Unknown,
        StatementKind::Command(command) => match command.id {
            command::WHILE => Part::Open(BlockKind::While),
            command::ELSE => Part::Branch(ELSE),
            command::ELSEIF => Part::Branch("ELSEIF"),
            command::ELSE_IF => Part::Branch("ELSE IF"),
            command::ENDIF => Part::Close(BlockKind::If),
            command::NEXT => Part::Close(BlockKind::For),
            command::WEND => Part::Close(BlockKind::While),
            _ => Part::Nothing,
        },
        _ => Part::Nothing,
    })
}

fn has_conditional(tree: &Tree, index: u32) -> bool {
    let next = tree.statements().get(index as usize + 1);
    next.is_some_and(|next| next.separator == Separator::Then)
}

#[derive(Default)]
struct Matcher {
    found: Blocks,
    /// Open blocks, the innermost last.
    open: Vec<u32>,
    /// The `ELSE` of each block that has one, by the place of the block.
    otherwise: Vec<Option<u32>>,
    /// Blocks that were left by the closer of a block around them; their own closer may still come.
    crossed: Vec<u32>,
    /// How many blocks of each kind are open, and how many crossed: a closer looks only for what is there.
    open_of: [u32; KINDS],
    crossed_of: [u32; KINDS],
    /// Statements that could not be read and that may have been the missing half of a block.
    unknown: u32,
}

impl Matcher {
    /// Takes a statement and gives the block that it belongs to.
    fn part(&mut self, index: u32, part: Part) -> Option<u32> {
        match part {
            Part::Open(kind) => Some(self.open(index, kind)),
            Part::Branch(word) => self.branch(index, word),
            Part::Close(kind) => self.close(index, kind),
            Part::Unknown => {
                self.unknown += 1;
                self.open.last().copied()
            }
            Part::Nothing => self.open.last().copied(),
        }
    }

    fn open(&mut self, opener: u32, kind: BlockKind) -> u32 {
        let place = self.found.blocks.len() as u32;
        self.found.blocks.push(Block {
            kind,
            opener,
            branches: Vec::new(),
            closer: None,
            depth: self.open.len() as u32,
            parent: self.open.last().copied(),
        });
        self.otherwise.push(None);
        self.open.push(place);
        self.open_of[kind as usize] += 1;
        place
    }

    fn branch(&mut self, index: u32, word: &'static str) -> Option<u32> {
        let innermost = self.open.last().copied();
        let block = innermost.and_then(|place| self.found.blocks.get_mut(place as usize));
        let (Some(place), Some(block)) = (innermost, block.filter(|block| block.kind == BlockKind::If)) else {
            self.unopened(index, word);
            return innermost;
        };
        block.branches.push(index);
        match self.otherwise.get_mut(place as usize) {
            Some(&mut Some(first)) => self.error(index, BlockErrorKind::ElseAfterElse { first }),
            Some(otherwise) if word == ELSE => *otherwise = Some(index),
            _ => {}
        }
        innermost
    }

    fn close(&mut self, index: u32, kind: BlockKind) -> Option<u32> {
        let innermost = self.open.last().copied();
        let Some(depth) = self.last_of(kind, self.open_of, &self.open) else {
            if let Some(depth) = self.last_of(kind, self.crossed_of, &self.crossed) {
                let left = self.crossed.split_off(depth);
                self.count(&left, |matcher, kind| matcher.crossed_of[kind] -= 1);
            } else {
                self.unopened(index, kind.closer());
            }
            return innermost;
        };
        let inner = self.open.split_off(depth + 1);
        self.count(&inner, |matcher, kind| {
            matcher.open_of[kind] -= 1;
            matcher.crossed_of[kind] += 1;
        });
        if let Some(open) = inner.last().and_then(|&place| self.found.blocks.get(place as usize)) {
            let error = BlockErrorKind::Crossed { closes: kind, open: open.opener, open_kind: open.kind };
            self.error(index, error);
        }
        self.crossed.extend(inner);
        let place = self.open.pop()?;
        self.open_of[kind as usize] -= 1;
        if let Some(block) = self.found.blocks.get_mut(place as usize) {
            block.closer = Some(index);
        }
        Some(place)
    }

    /// The place in a list of the last block of a kind, of which the list holds as many as `counts` says.
    fn last_of(&self, kind: BlockKind, counts: [u32; KINDS], list: &[u32]) -> Option<usize> {
        let is_kind = |place: &u32| self.found.blocks.get(*place as usize).is_some_and(|block| block.kind == kind);
        if counts[kind as usize] == 0 { None } else { list.iter().rposition(is_kind) }
    }

    /// Changes the counts for blocks that leave a list.
    fn count(&mut self, places: &[u32], change: fn(&mut Self, usize)) {
        for &place in places {
            if let Some(kind) = self.found.blocks.get(place as usize).map(|block| block.kind as usize) {
                change(self, kind);
            }
        }
    }

    fn unopened(&mut self, index: u32, word: &'static str) {
        match self.unknown.checked_sub(1) {
            Some(rest) => self.unknown = rest,
            None => self.error(index, BlockErrorKind::Unopened(word)),
        }
    }

    fn error(&mut self, statement: u32, kind: BlockErrorKind) {
        self.found.errors.push(BlockError { statement, kind });
    }

    fn finish(mut self) -> Blocks {
        for place in std::mem::take(&mut self.open) {
            let Some(block) = self.found.blocks.get(place as usize) else { continue };
            let (opener, kind) = (block.opener, block.kind);
            match self.unknown.checked_sub(1) {
                Some(rest) => self.unknown = rest,
                None => self.error(opener, BlockErrorKind::Unclosed(kind)),
            }
        }
        self.found.errors.sort_by_key(|error| error.statement);
        self.found
    }
}
