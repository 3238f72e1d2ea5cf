//! What a rule sees while the pass goes over a file.

use std::cell::OnceCell;
use std::collections::BTreeSet;
use std::rc::Rc;

use acrc_analysis::memory::{MemorySites, MemoryView};
use acrc_analysis::{AliasFact, Environment, FileContext, FileIndex, Machine, Questions, SectionIndex, Usage};
use acrc_catalog::{Confidence, Model, OperandClass};
use acrc_diagnostics::{Diagnostic, Span};
use acrc_syntax::Tree;
use acrc_syntax::units::{Level, SectionKind};

use crate::flow::Flow;
use crate::motions::{self, Motion};

/// The file, the place of the pass in it, and the findings so far.
pub(crate) struct Context<'a> {
    file: &'a FileContext<'a>,
    section: Option<&'a SectionIndex>,
    statement: u32,
    found: Vec<Diagnostic>,
    motions: OnceCell<Vec<Motion>>,
    /// The ways through the program that was asked for last, by its first statement.
    flow: Option<(u32, Option<Rc<Flow>>)>,
    /// Levels whose missing attachments were reported.
    pub(crate) reported_levels: Vec<Level>,
    /// Variables without memory that were reported, as rules of the memory name them.
    pub(crate) reported_variables: BTreeSet<(Level, OperandClass, Option<u64>)>,
    /// A number was reported that the wizard would use, in a project without code of the wizard.
    pub(crate) reported_wizard_number: bool,
}

impl<'a> Context<'a> {
    pub(crate) fn new(file: &'a FileContext<'a>) -> Self {
        Self {
            file,
            section: None,
            statement: 0,
            found: Vec::new(),
            motions: OnceCell::new(),
            flow: None,
            reported_levels: Vec::new(),
            reported_variables: BTreeSet::new(),
            reported_wizard_number: false,
        }
    }

    /// The text of the file.
    pub(crate) fn text(&self) -> &'a str {
        self.file.text
    }

    /// The text at `span`.
    pub(crate) fn slice(&self, span: Span) -> &'a str {
        self.file.text.get(span.range()).unwrap_or_default()
    }

    pub(crate) fn tree(&self) -> &'a Tree {
        self.file.tree
    }

    pub(crate) fn index(&self) -> &'a FileIndex {
        self.file.index
    }

    pub(crate) fn environment(&self) -> &'a Environment {
        self.file.environment
    }

    /// What the project makes of its controller.
    pub(crate) fn machine(&self) -> &'a Machine {
        self.file.machine
    }

    /// What few files ask of the project.
    pub(crate) fn questions(&self) -> Questions<'a> {
        self.file.questions
    }

    /// What the project uses by number.
    pub(crate) fn usage(&self) -> &'a Usage {
        self.file.usage
    }

    /// The motion in the stored programs of the file.
    pub(crate) fn motions(&self) -> &[Motion] {
        self.motions.get_or_init(|| motions::collect(self.file))
    }

    /// The memory of the project, as far as the file uses it.
    pub(crate) fn memory(&self) -> &'a MemoryView {
        self.file.memory
    }

    /// Where the file itself gives and clears memory.
    pub(crate) fn memory_sites(&self) -> &'a MemorySites {
        self.file.memory_sites
    }

    pub(crate) fn model(&self) -> &'static Model {
        self.file.model
    }

    /// The model, when the project names one; a default model proves nothing.
    pub(crate) fn given_model(&self) -> Option<&'static Model> {
        self.file.model_is_given.then_some(self.file.model)
    }

    /// The section of the present statement; `None` for `PROGRAM` and `ENDP`, which are between sections.
    pub(crate) fn section(&self) -> Option<&'a SectionIndex> {
        self.section
    }

    /// The level of the present statement.
    pub(crate) fn level(&self) -> Level {
        self.section.map_or(Level::System, |section| section.section.level)
    }

    /// Index of the present statement.
    pub(crate) fn statement(&self) -> u32 {
        self.statement
    }

    /// The place of a statement; empty at the start of the file for one that does not exist.
    pub(crate) fn statement_span(&self, statement: u32) -> Span {
        self.file.tree.statements().get(statement as usize).map(|statement| statement.span).unwrap_or_default()
    }

    /// What is known of the alias at `span`.
    pub(crate) fn alias(&self, span: Span) -> Option<&'a AliasFact> {
        self.file.environment.alias(self.slice(span))
    }

    /// Whether a section is the whole text of a stored program, in the order in which it runs and with balanced blocks.
    /// What is typed at a prompt may go on elsewhere, and so may lines that are stored by their numbers, unless they are
    /// all that a file has of a program, in a project that shows its setup.
    pub(crate) fn is_whole_program(&self, index: &SectionIndex) -> bool {
        let section = &index.section;
        let has_no_marks = section.opener.is_none() && section.closer.is_none();
        let is_bounded = section.closer.is_some()
            || (section.opener.is_none() && self.index().implicit_program)
            || (has_no_marks && self.stores_once(section.level));
        let in_order = |pair: &[acrc_analysis::index::LineSite]| matches!(pair, [a, b] if a.number < b.number && a.statement < b.statement);
        section.kind == SectionKind::Stored
            && is_bounded
            && index.swallowed.is_none()
            && index.blocks.errors().is_empty()
            && index.lines.windows(2).all(in_order)
    }

    /// Whether the file stores text of a program in one piece only.
    fn stores_once(&self, level: Level) -> bool {
        let stores = |index: &&SectionIndex| index.section.kind == SectionKind::Stored && index.section.level == level;
        self.machine().complete && self.index().sections.iter().filter(stores).count() == 1
    }

    /// The ways through the program that a section holds; `None` if that is not a whole program.
    pub(crate) fn flow(&mut self, index: &SectionIndex) -> Option<Rc<Flow>> {
        let start = index.section.statements.start;
        if let Some((known, flow)) = &self.flow
            && *known == start
        {
            return flow.clone();
        }
        let flow = self.is_whole_program(index).then(|| Rc::new(Flow::new(self.tree(), index)));
        self.flow = Some((start, flow.clone()));
        flow
    }

    /// Adds a finding.
    pub(crate) fn report(&mut self, diagnostic: Diagnostic) {
        self.found.push(diagnostic);
    }

    /// Adds a finding that rests on a row of the catalogue: from a row of low confidence it is at most a warning.
    pub(crate) fn report_by(&mut self, confidence: Confidence, diagnostic: Diagnostic) {
        self.report(if confidence == Confidence::Low { diagnostic.unconfirmed() } else { diagnostic });
    }

    /// Moves the pass to a statement.
    pub(crate) fn enter(&mut self, section: Option<&'a SectionIndex>, statement: u32) {
        self.section = section;
        self.statement = statement;
    }

    pub(crate) fn into_findings(self) -> Vec<Diagnostic> {
        self.found
    }
}

/// A level as people say it: "program 0".
pub(crate) fn level_name(level: Level) -> String {
    match level {
        Level::System => "the SYS prompt".to_owned(),
        Level::Program(n) => format!("program {n}"),
        Level::Plc(n) => format!("PLC program {n}"),
    }
}
