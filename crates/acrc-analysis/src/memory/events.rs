//! What the statements of one file do to memory, in their order and without places, and the places apart from them.

use std::fmt;

use acrc_catalog::memory::{LocalBlock, Stream, SystemBlock};
use acrc_catalog::{CommandId, Keyword, ObjectKind, OperandClass, command};
use acrc_syntax::Tree;
use acrc_syntax::ast::{Argument, Command, Dim, Expr, ExprKind, Separator, Statement, StatementKind};
use acrc_syntax::units::{Level, SectionKind};

use super::text::{self, TextBound};
use crate::index::{FileIndex, SectionIndex, Sequence};
use crate::walk;

/// What a file does to memory.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct MemoryEvents {
    /// In the order of the text.
    pub events: Vec<Event>,
    /// Bounds of the bytes of its stored texts, by section.
    pub bounds: Vec<TextBound>,
}

/// Where the events of a file stand.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct MemorySites {
    /// The statement of each event.
    pub statements: Vec<u32>,
}

/// One thing that happens to memory.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Event {
    /// The level at which it happens.
    pub level: Level,
    /// When: as it arrives, or when the program of a section runs.
    pub sequence: Sequence,
    /// It surely happens, once, and in the order of the text: at a prompt it stands in no block, in a stored text
    /// nothing before it jumps or can be jumped to.
    pub certain: bool,
    /// What happens.
    pub kind: EventKind,
}

/// What can happen to memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EventKind {
    /// `DIM`
    Dim(Block, Size),
    /// `CLEAR` without a word behind it.
    Clear,
    /// `CLEAR MBUF`
    ClearMoves,
    /// `NEW` of one program.
    New(Level),
    /// `NEW ALL`
    NewAll,
    /// The text of a section, by its place in the file, becomes the program of the level.
    Install(u32),
    /// The numbered lines of a section are put into the text of the level.
    Lines(u32),
}

/// What a `DIM` gives memory to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Block {
    /// Something of the system.
    System(SystemBlock),
    /// Variables of a program, or its move buffer; arrays with their number.
    Local(LocalBlock, u32),
}

impl Block {
    /// The move buffer of a program.
    pub const MOVES: Self = Self::Local(LocalBlock::Moves, 0);
}

/// The numbers of a `DIM`, where they are written as numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// Bytes, or how many.
    pub count: Option<u64>,
    /// Characters of each string; 0 for everything else.
    pub length: Option<u64>,
}

impl fmt::Display for Block {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::System(block) => block.fmt(f),
            Self::Local(LocalBlock::Array(class), number) => write!(f, "{class}{number}"),
            Self::Local(block, _) => f.write_str(block.word()),
        }
    }
}

/// The space of a program. `None` for the system.
pub fn space_of(level: Level) -> Option<SystemBlock> {
    match level {
        Level::System => None,
        Level::Program(number) => Some(SystemBlock::Program(number)),
        Level::Plc(number) => Some(SystemBlock::Plc(number)),
    }
}

/// The events of a file, and where they stand.
pub(super) fn collect(tree: &Tree, index: &FileIndex) -> (MemoryEvents, MemorySites) {
    let events = MemoryEvents { events: Vec::new(), bounds: text::bounds(tree, index) };
    let mut collector = Collector { tree, events, sites: MemorySites::default() };
    for (place, section) in (0..).zip(&index.sections) {
        collector.section(place, section, index.implicit_program);
    }
    (collector.events, collector.sites)
}

struct Collector<'t> {
    tree: &'t Tree,
    events: MemoryEvents,
    sites: MemorySites,
}

impl Collector<'_> {
    fn section(&mut self, place: u32, index: &SectionIndex, implicit: bool) {
        let section = &index.section;
        let stored = section.kind == SectionKind::Stored;
        let sequence = if stored { Sequence::Stored(place) } else { Sequence::Immediate };
        let straight = if stored { straight_end(self.tree, index) } else { section.statements.end };
        let mut behind_then = false;
        for at in section.statements.clone() {
            let Some(statement) = self.tree.statements().get(at as usize) else { break };
            behind_then =
                statement.separator != Separator::Line && (behind_then || statement.separator == Separator::Then);
            if let Some(kind) = event_of(section.level, statement) {
                let certain = at < straight && !behind_then && index.blocks.enclosing(at).is_none();
                self.push(at, Event { level: section.level, sequence, certain, kind });
            }
        }
        if stored {
            let whole = section.opener.is_some() || implicit;
            let kind = if whole { EventKind::Install(place) } else { EventKind::Lines(place) };
            let site = section.opener.unwrap_or(section.statements.start);
            self.push(site, Event { level: section.level, sequence: Sequence::Immediate, certain: true, kind });
        }
    }

    fn push(&mut self, statement: u32, event: Event) {
        self.sites.statements.push(statement);
        self.events.events.push(event);
    }
}

/// The first statement of a stored text behind which nothing is sure: something that jumps, ends, or is jumped to.
fn straight_end(tree: &Tree, index: &SectionIndex) -> u32 {
    const WAYS: [CommandId; 7] =
        [command::GOTO, command::GOSUB, command::RETURN, command::END, command::HALT, command::NEW, command::LRUN];
    let range = index.section.statements.clone();
    let turns = |at: &u32| match tree.statements().get(*at as usize).map(|statement| &statement.kind) {
        Some(StatementKind::Command(command)) => WAYS.contains(&command.id),
        Some(StatementKind::Label(_)) => true,
        _ => false,
    };
    let turn = range.clone().find(turns).unwrap_or(range.end);
    let entered = index.jumps.iter().filter_map(|jump| jump.to).min().unwrap_or(range.end);
    turn.min(entered)
}

fn event_of(level: Level, statement: &Statement) -> Option<EventKind> {
    match &statement.kind {
        StatementKind::Dim(dim) => dim_event(dim),
        StatementKind::Command(command) => match command.id {
            command::CLEAR if command.arguments.is_empty() => Some(EventKind::Clear),
            command::CLEAR_MBUF => Some(EventKind::ClearMoves),
            command::NEW => new_event(level, command),
            _ => None,
        },
        _ => None,
    }
}

fn new_event(level: Level, command: &Command) -> Option<EventKind> {
    match command.arguments.first() {
        None => Some(EventKind::New(level)),
        Some(Argument::Word(word)) if word.keyword == Keyword::All => Some(EventKind::NewAll),
        Some(Argument::Object(object)) => {
            let number = u8::try_from(object.index?).ok()?;
            match object.kind {
                ObjectKind::Prog => Some(EventKind::New(Level::Program(number))),
                ObjectKind::Plc => Some(EventKind::New(Level::Plc(number))),
                _ => None,
            }
        }
        _ => None,
    }
}

fn dim_event(dim: &Dim) -> Option<EventKind> {
    let block = dim_block(dim)?;
    let length = if is_text(block) { dim.sizes.get(1).and_then(whole) } else { Some(0) };
    let count = whole(dim.sizes.first()?);
    Some(EventKind::Dim(block, Size { count, length }))
}

/// What a `DIM` gives memory to. `None` for a report, and where a number in its name is no number.
fn dim_block(dim: &Dim) -> Option<Block> {
    let number = dim.index.as_ref().map(small_number);
    let numbered = || u8::try_from(number.flatten()?).ok();
    Some(match dim.id {
        command::DIM_P => Block::System(SystemBlock::Parameters),
        command::DIM_DEF => Block::System(SystemBlock::Aliases),
        command::DIM_PROG => Block::System(SystemBlock::Program(numbered()?)),
        command::DIM_PLC => Block::System(SystemBlock::Plc(numbered()?)),
        command::DIM_STREAM => Block::System(SystemBlock::Stream(Stream::Numbered(numbered()?))),
        command::DIM_COM1 => Block::System(SystemBlock::Stream(Stream::Com(1))),
        command::DIM_COM2 => Block::System(SystemBlock::Stream(Stream::Com(2))),
        command::DIM_FIFO => Block::System(SystemBlock::Stream(Stream::Fifo)),
        command::DIM_DPCB => Block::System(SystemBlock::Stream(Stream::Dpcb)),
        command::DIM_MBUF => Block::MOVES,
        _ => match (local_class(dim.id)?, number) {
            (class, Some(number)) => Block::Local(LocalBlock::Array(class), number?),
            (class, None) if class.is_array() => Block::Local(LocalBlock::References(class), 0),
            (class, None) => Block::Local(LocalBlock::Variables(class), 0),
        },
    })
}

/// Whether the second size of a `DIM` is the length of strings.
fn is_text(block: Block) -> bool {
    matches!(block, Block::Local(local, _) if local.has_length())
}

/// The class of local variables that a `DIM` is about.
pub fn local_class(id: CommandId) -> Option<OperandClass> {
    Some(match id {
        command::DIM_LV => OperandClass::Lv,
        command::DIM_SV => OperandClass::Sv,
        command::DIM_DV => OperandClass::Dv,
        command::DIM_STRING_V => OperandClass::StringV,
        command::DIM_LA => OperandClass::La,
        command::DIM_SA => OperandClass::Sa,
        command::DIM_DA => OperandClass::Da,
        command::DIM_STRING_A => OperandClass::StringA,
        _ => return None,
    })
}

fn small_number(expr: &Expr) -> Option<u32> {
    match expr.kind {
        ExprKind::Integer(number) => u32::try_from(number).ok(),
        _ => None,
    }
}

/// A size that is written as a whole number.
fn whole(expr: &Expr) -> Option<u64> {
    let value = walk::literal(expr)?;
    (value >= 0.0 && value.fract() == 0.0 && value <= 1e15).then_some(value as u64)
}
