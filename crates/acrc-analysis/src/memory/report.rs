//! The whole account of a project's memory, for `acrc mem`: texts are counted from the compiled image, allocations from
//! what the setup and the programs dimension.

use std::collections::BTreeMap;

use acrc_catalog::memory::SystemBlock;
use acrc_catalog::{Model, OperandClass, command};
use acrc_image::{Image, ImageError, Instruction, Node, TextCost, Unit, UnitName};
use acrc_syntax::units::Level;

use super::calls::{self, Calls};
use super::events::{Block, Event, EventKind, Size, space_of};
use super::issue::{Issue, IssueKind, Site, Space};
use super::play::ProjectMemory;
use super::query::{memory_events, memory_sites, project_memory};
use super::state::{LocalState, Slot, local_bytes};
use crate::index::Sequence;
use crate::query::{file_index, parse, symbols};
use crate::{Db, Project};

/// Where the memory of a project goes.
#[derive(Clone, Debug)]
pub struct Report {
    /// The controller.
    pub model: &'static Model,
    /// System memory, in bytes.
    pub total: u64,
    /// What is given away, programs first.
    pub system: Vec<SystemLine>,
    /// Aliases that the project defines.
    pub aliases: u64,
    /// Programs and PLC programs that have a text.
    pub programs: Vec<ProgramReport>,
    /// `DIM` and `#DEFINE` that the controller refuses, with the index of the file and the line.
    pub refused: Vec<(usize, u32, IssueKind)>,
    /// The least numbers of user parameters that constant numbers need, and whether others are computed.
    pub parameters: Parameters,
}

/// User parameters that the project uses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Parameters {
    /// One more than the highest number that is written.
    pub count: u64,
    /// Some number is computed, so that there may be more.
    pub computed: bool,
}

/// A block of system memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SystemLine {
    /// What it is.
    pub block: SystemBlock,
    /// Bytes; `None` when its `DIM` computes them or may not be reached.
    pub bytes: Option<u64>,
    /// How many parameters or aliases; bytes for everything else.
    pub count: Option<u64>,
    /// It is as the factory settings leave it.
    pub factory: bool,
}

/// What a program needs and has.
#[derive(Clone, Debug, PartialEq)]
pub struct ProgramReport {
    /// Which one.
    pub level: Level,
    /// What it has; `None` when that is computed.
    pub space: Option<Space>,
    /// Its stored text.
    pub text: TextCost,
    /// Its variables, arrays and move buffer while it runs.
    pub variables: Vec<Allocation>,
    /// How deep its subroutines call each other.
    pub calls: Calls,
    /// The parts of its text from label to label, the largest first.
    pub parts: Vec<Part>,
}

/// A block of a program's memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Allocation {
    /// What it is.
    pub block: Block,
    /// How many, and how long.
    pub size: Size,
    /// Bytes; `None` when its `DIM` computes them.
    pub bytes: Option<u64>,
    /// Its `DIM` may not be reached.
    pub conditional: bool,
}

/// A part of a text, from one label to the next.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// The label; `None` for what comes before the first.
    pub label: Option<String>,
    /// The file, and the line of the label or of the first statement.
    pub place: Option<(usize, u32)>,
    /// Its bytes.
    pub bytes: u64,
}

impl ProgramReport {
    /// Bytes of variables, arrays and move buffer, as far as they are known.
    pub fn variable_bytes(&self) -> u64 {
        self.variables.iter().filter_map(|allocation| allocation.bytes).sum()
    }

    /// Bytes of everything, at least.
    pub fn needed(&self) -> u64 {
        self.text.total() + self.variable_bytes() + self.calls.bytes()
    }

    /// The need can be larger: sizes are computed, or calls have no end.
    pub fn is_open(&self) -> bool {
        self.calls == Calls::Recursive || self.variables.iter().any(|allocation| allocation.bytes.is_none())
    }

    /// Bytes that are missing; 0 when it fits or when nothing is known of its space.
    pub fn excess(&self) -> u64 {
        self.space.map_or(0, |space| self.needed().saturating_sub(space.bytes()))
    }
}

impl Report {
    /// Something does not fit.
    pub fn is_over(&self) -> bool {
        !self.refused.is_empty() || self.programs.iter().any(|program| program.excess() > 0)
    }

    /// Bytes that are given away, as far as they are known.
    pub fn used(&self) -> u64 {
        self.system.iter().filter_map(|line| line.bytes).sum()
    }

    /// More may be given away: sizes are computed.
    pub fn is_open(&self) -> bool {
        self.system.iter().any(|line| line.bytes.is_none())
    }

    /// Bytes that are left, at most.
    pub fn free(&self) -> u64 {
        self.total.saturating_sub(self.used())
    }
}

/// The account of a project that compiles into `image`.
///
/// # Errors
/// When the image can't be read.
pub fn report(db: &dyn Db, project: Project, image: &Image) -> Result<Report, ImageError> {
    let memory = project_memory(db, project);
    let texts = Texts::collect(db, project);
    let mut programs = Vec::new();
    // A text that is entered again replaces the one before.
    let latest: BTreeMap<Level, &Unit> = image.programs.iter().filter_map(|unit| Some((level(unit)?, unit))).collect();
    for (level, unit) in latest {
        if let Some(own) = texts.of.get(&level) {
            programs.push(program_report(db, project, memory, level, unit, own)?);
        }
    }
    let model = project.model(db);
    Ok(Report {
        model,
        total: model.system_memory().into(),
        system: system_lines(memory),
        aliases: symbols(db, project).aliases.len() as u64,
        programs,
        refused: memory.issues.iter().filter_map(|(file, issue)| refused(db, project, *file, issue)).collect(),
        parameters: parameters(image)?,
    })
}

fn level(unit: &Unit) -> Option<Level> {
    match unit.name {
        UnitName::Boot => None,
        UnitName::Program(number) => Some(Level::Program(number)),
        UnitName::Plc(number) => Some(Level::Plc(number)),
    }
}

fn system_lines(memory: &ProjectMemory) -> Vec<SystemLine> {
    let line = |(block, slot): (&SystemBlock, &Slot)| SystemLine {
        block: *block,
        bytes: slot.bytes,
        count: slot.count,
        factory: slot.by.is_none(),
    };
    memory.system.iter().map(line).collect()
}

/// A finding that the controller answers with a refusal, with its line. What programs need is told elsewhere.
fn refused(db: &dyn Db, project: Project, file: u32, issue: &Issue) -> Option<(usize, u32, IssueKind)> {
    let source = *project.files(db).get(file as usize)?;
    let (tree, index) = (parse(db, source), file_index(db, source));
    let statement = match issue.site {
        Site::Event(event) => *memory_sites(db, source).statements.get(event as usize)?,
        Site::Define(define) => {
            let name = index.defines.get(define as usize)?.name;
            tree.statements().partition_point(|statement| statement.span.end < name.end) as u32
        }
        Site::Text { .. } => return None,
    };
    let tells = matches!(
        issue.kind,
        IssueKind::Redimensioned { .. }
            | IssueKind::SystemExceeded { .. }
            | IssueKind::NoReference { .. }
            | IssueKind::TooManyAliases { .. }
    );
    tells.then(|| (file as usize, tree.line_of(statement) + 1, issue.kind))
}

/// Which sections make up the text of each program at the end.
#[derive(Default)]
struct Texts {
    of: BTreeMap<Level, Vec<(usize, u32)>>,
}

impl Texts {
    fn collect(db: &dyn Db, project: Project) -> Self {
        let mut texts = Self::default();
        for (file, source) in project.files(db).iter().enumerate() {
            let events = memory_events(db, *source).events.iter();
            for event in events.filter(|event| event.sequence == Sequence::Immediate && event.certain) {
                texts.play(file, event);
            }
        }
        texts
    }

    fn play(&mut self, file: usize, event: &Event) {
        match event.kind {
            EventKind::Install(section) => {
                self.of.insert(event.level, vec![(file, section)]);
            }
            EventKind::Lines(section) => self.of.entry(event.level).or_default().push((file, section)),
            EventKind::New(level) => {
                self.of.remove(&level);
            }
            EventKind::NewAll => self.of.clear(),
            EventKind::Dim(..) | EventKind::Clear | EventKind::ClearMoves => {}
        }
    }
}

fn program_report(
    db: &dyn Db,
    project: Project,
    memory: &ProjectMemory,
    level: Level,
    unit: &Unit,
    sections: &[(usize, u32)],
) -> Result<ProgramReport, ImageError> {
    let program = unit.decode()?;
    let text = program.iter().map(|instruction| TextCost::of(instruction.command, &instruction.items)).sum();
    let mut running = Running::new(memory.prompt.get(&level));
    for (file, section) in sections {
        if let Some(source) = project.files(db).get(*file) {
            let events = memory_events(db, *source).events.iter();
            events.filter(|event| event.sequence == Sequence::Stored(*section)).for_each(|event| running.play(event));
        }
    }
    let slot = space_of(level).and_then(|block| memory.system.get(&block));
    let space = Slot::space(slot);
    Ok(ProgramReport {
        level,
        space,
        text,
        variables: running.allocations(),
        calls: calls::of_program(&program),
        parts: parts(unit, &program),
    })
}

/// What a program has allocated when it has run, whatever way it took: the most of each block.
struct Running {
    blocks: BTreeMap<Block, (Size, bool)>,
}

impl Running {
    fn new(prompt: Option<&LocalState>) -> Self {
        let blocks = prompt.into_iter().flat_map(|state| &state.blocks);
        Self { blocks: blocks.map(|(block, size)| (*block, (*size, false))).collect() }
    }

    fn play(&mut self, event: &Event) {
        match event.kind {
            EventKind::Clear if event.certain => self.blocks.clear(),
            EventKind::ClearMoves if event.certain => {
                self.blocks.remove(&Block::MOVES);
            }
            EventKind::Dim(Block::System(_), _) => {}
            EventKind::Dim(block, size) => {
                let conditional = !event.certain;
                let known = self.blocks.entry(block).or_insert((size, conditional));
                let larger = |a: Option<u64>, b: Option<u64>| Some(a?.max(b?));
                known.0 =
                    Size { count: larger(known.0.count, size.count), length: larger(known.0.length, size.length) };
            }
            _ => {}
        }
    }

    fn allocations(self) -> Vec<Allocation> {
        let allocation =
            |(block, (size, conditional))| Allocation { block, size, bytes: local_bytes(block, size), conditional };
        self.blocks.into_iter().map(allocation).collect()
    }
}

/// The text from label to label, the largest part first.
fn parts(unit: &Unit, program: &[Instruction]) -> Vec<Part> {
    let place = |address: u32| {
        let location = unit.debug.as_ref()?.locate(address)?;
        Some((location.file as usize, location.line))
    };
    let mut parts: Vec<Part> = Vec::new();
    for instruction in program {
        let label = match instruction.items.first().map(|item| &item.node) {
            Some(Node::String { bytes, .. }) if instruction.command == command::LABEL => {
                Some(acrc_image::text::decode(bytes))
            }
            _ => None,
        };
        if label.is_some() || parts.is_empty() {
            parts.push(Part { label, place: place(instruction.address), bytes: 0 });
        }
        if let Some(part) = parts.last_mut() {
            part.bytes += TextCost::of(instruction.command, &instruction.items).total();
        }
    }
    // A stable order where two are equally large: that of the text.
    parts.sort_by_key(|part| std::cmp::Reverse(part.bytes));
    parts
}

/// The user parameters that the statements of an image name.
fn parameters(image: &Image) -> Result<Parameters, ImageError> {
    let mut found = Parameters::default();
    for unit in image.units() {
        for instruction in unit.decode()? {
            instruction.items.iter().for_each(|item| found.add(&item.node));
        }
    }
    image.aliases.iter().for_each(|alias| found.add(&alias.target));
    Ok(found)
}

impl Parameters {
    fn add(&mut self, node: &Node) {
        if let Node::Scalar { class: OperandClass::Parameter, index, .. } = node {
            match **index {
                Node::Long(number) => {
                    let user = u64::try_from(number)
                        .ok()
                        .filter(|number| *number < u64::from(acrc_catalog::memory::USER_PARAMETERS));
                    self.count = self.count.max(user.map_or(0, |number| number + 1));
                }
                _ => self.computed = true,
            }
        }
        node.children().into_iter().for_each(|child| self.add(child));
    }
}

impl Allocation {
    /// Its `DIM` without the word `DIM`: `LV(3)`, `$V(10, 80)`, `LA0(500)`.
    pub fn name(&self) -> String {
        let number = |value: Option<u64>| value.map_or_else(|| "?".to_owned(), |value| value.to_string());
        let count = number(self.size.count);
        if matches!(self.block, Block::Local(local, _) if local.has_length()) {
            format!("{}({count}, {})", self.block, number(self.size.length))
        } else {
            format!("{}({count})", self.block)
        }
    }
}
