//! Plays what happens to memory through all files of a project: first what is typed at the prompts, in the order of the
//! files, then each stored text as if its program was run once behind the setup.
//!
//! A size that is computed, or a statement that may not be reached, leaves the block unknown; nothing is said of it.

use std::collections::{BTreeMap, BTreeSet};

use acrc_catalog::Model;
use acrc_catalog::memory::{self, LocalBlock, SystemBlock};
use acrc_syntax::units::Level;

use super::events::{Block, Event, EventKind, MemoryEvents, Size, space_of};
use super::issue::{Issue, IssueKind, Site, Space, Spare};
use super::locals::{Extent, LocalDims};
use super::state::{LocalState, Slot, factory, forget, forget_moves, local_bytes};
use super::text::SectionBytes;
use crate::Symbols;
use crate::index::Sequence;

/// What the files of a project make of the memory.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ProjectMemory {
    /// The project takes care of memory: it gives or clears some at the `SYS` prompt. Otherwise that happens elsewhere
    /// (allocations outlive a download), and what is missing says nothing.
    pub managed: bool,
    /// All `DIM P` together; `None` when there is none.
    pub parameters: Option<Extent>,
    /// All `DIM DEF` together; `None` when there is none.
    pub aliases: Option<Extent>,
    /// What the programs dimension for themselves.
    pub locals: Vec<(Level, LocalDims)>,
    /// What does not fit, by the place of its file in the project.
    pub issues: Vec<(u32, Issue)>,
    /// `DIM` of much more than is needed, by the place of its file in the project.
    pub spare: Vec<(u32, Spare)>,
    /// System memory as the setup leaves it.
    pub(super) system: BTreeMap<SystemBlock, Slot>,
    /// Local variables as the setup leaves them.
    pub(super) prompt: BTreeMap<Level, LocalState>,
}

/// Much more is so many times as much.
const SPARE_FACTOR: u64 = 4;
/// Less than this is not worth a word, in bytes.
const SPARE_BYTES: u64 = 1024;

/// What a file brings to the play.
pub(super) struct Part<'a> {
    pub(super) events: &'a MemoryEvents,
    /// The exact bytes of its stored texts, counted when asked.
    pub(super) exact: &'a dyn Fn() -> &'a [SectionBytes],
}

/// Plays all files.
pub(super) fn play(parts: &[Part<'_>], model: &Model) -> ProjectMemory {
    let mut player = Player {
        total: u64::from(model.system_memory()),
        result: ProjectMemory { system: factory(model), ..ProjectMemory::default() },
        needs: BTreeMap::new(),
        too_large: BTreeSet::new(),
        without_reference: BTreeSet::new(),
    };
    for (file, part) in (0..).zip(parts) {
        for (place, event) in (0..).zip(&part.events.events) {
            player.note(event);
            if event.sequence == Sequence::Immediate {
                player.immediate(part, (file, place), event);
            }
        }
    }
    for (file, part) in (0..).zip(parts) {
        player.stored(file, part);
    }
    for (file, part) in (0..).zip(parts) {
        player.references(file, part);
    }
    player.compare_programs();
    if !player.result.managed {
        // Who cares for the memory elsewhere may give it there.
        player.result.issues.retain(|(_, issue)| !matches!(issue.kind, IssueKind::TooLarge { .. }));
    }
    player.result.issues.sort_by_key(|(file, issue)| (*file, issue.site));
    player.result
}

impl ProjectMemory {
    /// Bytes that a program has as the setup leaves them; `None` when it has none, or a computed number.
    pub fn space_of(&self, level: Level) -> Option<u64> {
        self.system.get(&space_of(level)?)?.bytes
    }

    /// Compares the aliases of the project with what `DIM DEF` makes room for.
    pub(super) fn count_aliases(&mut self, symbols: &Symbols) {
        let aliases = symbols.aliases.len() as u64;
        let room = match self.aliases {
            None if !self.managed || symbols.fragment => return,
            None => None,
            Some(Extent { count: None, .. }) => return,
            Some(Extent { count, .. }) => count,
        };
        if let (Some(room), Some(slot)) = (room, self.system.get(&SystemBlock::Aliases).copied())
            && slot.count == Some(room)
        {
            self.compare(SystemBlock::Aliases, slot, room, aliases, memory::ALIASES.each.into());
        }
        let first_beyond = usize::try_from(room.unwrap_or(0)).unwrap_or(usize::MAX);
        if let Some(alias) = symbols.aliases.get(first_beyond) {
            let kind = IssueKind::TooManyAliases { aliases, room };
            self.issues.push((alias.file, Issue { site: Site::Define(alias.define), kind }));
        }
    }

    /// Takes note of a block that has much more than it needs, in units of some bytes.
    fn compare(&mut self, block: SystemBlock, slot: Slot, given: u64, needed: u64, unit: u64) {
        let much = given > needed.saturating_mul(SPARE_FACTOR)
            && given.saturating_sub(needed).saturating_mul(unit) > SPARE_BYTES;
        if let Some((file, event)) = slot.by.filter(|_| much) {
            self.spare.push((file, Spare { site: Site::Event(event), block, given, needed }));
        }
    }
}

struct Player {
    /// System memory of the controller, in bytes.
    total: u64,
    result: ProjectMemory,
    /// What programs need at most; `None` where that is not known.
    needs: BTreeMap<SystemBlock, Option<u64>>,
    /// Programs of which is said that they do not fit.
    too_large: BTreeSet<Level>,
    /// Files and events of arrays of which is said that they have no reference.
    without_reference: BTreeSet<(u32, u32)>,
}

impl Player {
    fn report(&mut self, (file, event): (u32, u32), kind: IssueKind) {
        self.result.issues.push((file, Issue { site: Site::Event(event), kind }));
    }

    /// Takes note of what holds whenever the event happens.
    fn note(&mut self, event: &Event) {
        let result = &mut self.result;
        match event.kind {
            EventKind::Dim(Block::System(block), size) => {
                result.managed |= event.level == Level::System;
                let known = match block {
                    SystemBlock::Parameters => &mut result.parameters,
                    SystemBlock::Aliases => &mut result.aliases,
                    _ => return,
                };
                let extent = Extent::of(size);
                *known = Some(known.map_or(extent, |known| known.join(extent)));
            }
            EventKind::Dim(Block::Local(..), _) => match result.locals.iter_mut().find(|(at, _)| *at == event.level) {
                Some((_, dims)) => dims.add(event),
                None => {
                    let mut dims = LocalDims::default();
                    dims.add(event);
                    result.locals.push((event.level, dims));
                }
            },
            EventKind::Clear => result.managed |= event.level == Level::System,
            _ => {}
        }
    }

    fn immediate(&mut self, part: &Part<'_>, site: (u32, u32), event: &Event) {
        match (event.kind, event.level) {
            (EventKind::Dim(Block::System(block), size), Level::System) => self.dim_system(site, event, block, size),
            (EventKind::Dim(block @ Block::Local(..), size), level) if level != Level::System => {
                let mut state = self.result.prompt.remove(&level).unwrap_or_default();
                self.dim_local(&mut state, site, event.certain, block, size);
                self.result.prompt.insert(level, state);
            }
            (EventKind::Clear, Level::System) => self.clear(event.certain),
            (EventKind::NewAll, _) => self.clear_locals(event.certain),
            (EventKind::Clear, level) | (EventKind::New(level), _) => {
                forget(self.result.prompt.entry(level).or_default(), event.certain);
            }
            (EventKind::ClearMoves, level) => {
                forget_moves(self.result.prompt.entry(level).or_default(), event.certain);
            }
            (EventKind::Install(section), level) => {
                self.install(part, site.0, section, level, 0);
            }
            // What is not possible at this prompt, and lines whose place in the text is not known here.
            (EventKind::Dim(..) | EventKind::Lines(_), _) => {}
        }
    }

    fn clear(&mut self, certain: bool) {
        if certain {
            self.result.system.clear();
        } else {
            for slot in self.result.system.values_mut() {
                slot.bytes = None;
            }
        }
        self.clear_locals(certain);
    }

    fn clear_locals(&mut self, certain: bool) {
        self.result.prompt.values_mut().for_each(|state| forget(state, certain));
    }

    fn dim_system(&mut self, site: (u32, u32), event: &Event, block: SystemBlock, size: Size) {
        let stream = matches!(block, SystemBlock::Stream(_));
        match self.result.system.get(&block) {
            Some(Slot { bytes: Some(bytes), by, .. }) if event.certain && !stream => {
                let space = if by.is_some() { Space::Dim(*bytes) } else { Space::Factory(*bytes) };
                self.report(site, IssueKind::Redimensioned { block: Block::System(block), space: Some(space) });
                return;
            }
            _ => {}
        }
        let bytes = size.count.filter(|_| event.certain).map(|count| block.bytes(count));
        let others = self.result.system.iter().filter(|(other, _)| **other != block);
        let used: u64 = others.filter_map(|(_, slot)| slot.bytes).sum();
        let free = self.total.saturating_sub(used);
        if let Some(needed) = bytes.filter(|bytes| *bytes > free) {
            self.report(site, IssueKind::SystemExceeded { block, needed, free });
            return;
        }
        self.result.system.insert(block, Slot { bytes, count: size.count, by: Some(site) });
    }

    fn dim_local(&mut self, state: &mut LocalState, site: (u32, u32), certain: bool, block: Block, size: Size) {
        if !certain {
            state.unknown = true;
            return;
        }
        if !state.unknown {
            if let Block::Local(LocalBlock::Array(class), array) = block {
                let references = state.blocks.get(&Block::Local(LocalBlock::References(class), 0));
                let known = references.map(|size| size.count);
                if known.is_none_or(|count| count.is_some_and(|count| u64::from(array) >= count)) {
                    self.without_reference.insert(site);
                    self.report(site, IssueKind::NoReference { class, array, references: known.flatten() });
                    return;
                }
            }
            if let Some(size) = state.blocks.get(&block) {
                let space = local_bytes(block, *size).map(Space::Dim);
                self.report(site, IssueKind::Redimensioned { block, space });
                return;
            }
        }
        state.blocks.insert(block, size);
    }

    /// Checks that a text fits the space of its program, with variables beside it.
    fn install(&mut self, part: &Part<'_>, file: u32, section: u32, level: Level, variables: u64) -> Option<IssueKind> {
        let slot = self.result.system.get(&space_of(level)?).copied();
        let space = Slot::space(slot.as_ref())?;
        let bound = part.events.bounds.get(section as usize).map_or(0, |bound| bound.0);
        if bound.saturating_add(variables) <= space.bytes() {
            return None;
        }
        let exact = (part.exact)().get(section as usize)?;
        let (text, calls) = (exact.total(), exact.calls);
        if text + variables + calls.bytes() <= space.bytes() {
            return None;
        }
        let certain = text + variables > space.bytes();
        let kind = IssueKind::TooLarge { level, text, variables, calls, certain, space };
        if let Some(by) = slot.and_then(|slot| slot.by) {
            self.report(by, kind);
        }
        // With variables, the DIM that does not fit is the place; the text as such does.
        if let Some(statement) = exact.first_beyond(space.bytes()) {
            self.result.issues.push((file, Issue { site: Site::Text { section, statement }, kind }));
        }
        self.too_large.insert(level);
        Some(kind)
    }

    /// Runs the stored texts of a file, as far as it is sure what they do.
    fn stored(&mut self, file: u32, part: &Part<'_>) {
        let mut first = 0;
        for (at, event) in part.events.events.iter().enumerate() {
            if let EventKind::Install(section) | EventKind::Lines(section) = event.kind {
                // The events of a text lie directly before its installation.
                self.run(
                    part,
                    (file, first as u32),
                    section,
                    event,
                    part.events.events.get(first..at).unwrap_or_default(),
                );
            }
            if event.sequence == Sequence::Immediate {
                first = at + 1;
            }
        }
    }

    /// Runs one stored text once. `site` is the place of its first event.
    fn run(&mut self, part: &Part<'_>, site: (u32, u32), section: u32, install: &Event, own: &[Event]) {
        let (file, first) = site;
        let clears = own.iter().any(|event| event.kind == EventKind::Clear);
        let mut state = self.result.prompt.get(&install.level).cloned().unwrap_or_default();
        let mut last = None;
        for (place, event) in (first..).zip(own) {
            match event.kind {
                EventKind::Clear => forget(&mut state, event.certain),
                EventKind::ClearMoves => forget_moves(&mut state, event.certain),
                EventKind::Dim(block @ Block::Local(..), size) => {
                    if !clears && last.is_none() && block != Block::MOVES {
                        self.report((file, place), IssueKind::NotCleared(block));
                    }
                    last = Some(place);
                    self.dim_local(&mut state, (file, place), event.certain, block, size);
                }
                _ => {}
            }
        }
        let whole = matches!(install.kind, EventKind::Install(_));
        if let Some(last) = last.filter(|_| whole) {
            self.with_variables(part, (file, last), section, install.level, &state);
        }
        let bound = part.events.bounds.get(section as usize).filter(|_| whole);
        self.need(install.level, bound.and_then(|bound| Some(bound.0 + state.known_bytes()?)));
    }

    /// Arrays that are given elements where the order is not sure, and that no `DIM` of their program gives a reference.
    fn references(&mut self, file: u32, part: &Part<'_>) {
        for (place, event) in (0..).zip(&part.events.events) {
            let EventKind::Dim(Block::Local(LocalBlock::Array(class), array), _) = event.kind else { continue };
            if event.level == Level::System || self.without_reference.contains(&(file, place)) {
                continue;
            }
            let dims = self.result.locals.iter().find(|(level, _)| *level == event.level);
            let extent = dims.and_then(|(_, dims)| dims.extent(LocalBlock::References(class), 0));
            let references = extent.map(|extent| extent.count);
            if references.is_none_or(|count| count.is_some_and(|count| u64::from(array) >= count)) {
                self.report((file, place), IssueKind::NoReference { class, array, references: references.flatten() });
            }
        }
    }

    /// One of the texts of a program needs so many bytes at most.
    fn need(&mut self, level: Level, bytes: Option<u64>) {
        if let Some(block) = space_of(level) {
            let known = self.needs.entry(block).or_insert(Some(0));
            *known = known.zip(bytes).map(|(known, bytes)| known.max(bytes));
        }
    }

    fn compare_programs(&mut self) {
        for (block, needed) in std::mem::take(&mut self.needs) {
            if let (Some(needed), Some(slot)) = (needed, self.result.system.get(&block).copied())
                && let Some(given) = slot.bytes
            {
                self.result.compare(block, slot, given, needed, 1);
            }
        }
    }

    /// A text that fits by itself, and does not with the variables that it dimensions.
    fn with_variables(
        &mut self,
        part: &Part<'_>,
        last_dim: (u32, u32),
        section: u32,
        level: Level,
        state: &LocalState,
    ) {
        if self.too_large.contains(&level) {
            return;
        }
        if let Some(kind) = self.install(part, last_dim.0, section, level, state.bytes()) {
            self.report(last_dim, kind);
        }
    }
}
