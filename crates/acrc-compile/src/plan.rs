//! Which statements of which files become which unit, before anything is encoded.

use std::collections::BTreeMap;
use std::ops::Range;

use acrc_catalog::command;
use acrc_diagnostics::Span;
use acrc_image::UnitName;
use acrc_syntax::ast::{Argument, Expr, ExprKind, LineNumber, Statement, StatementKind};
use acrc_syntax::units::{self, Level, Section, SectionKind};

use crate::error::{CompileError, CompileErrorKind};
use crate::project::SourceUnit;
use crate::stored::{StoredLine, StoredText};

/// A piece of a unit.
#[derive(Clone, Debug)]
pub(crate) enum Part {
    /// Statements of a file as they stand.
    Statements {
        /// The file.
        file: usize,
        /// Their range in its tree.
        range: Range<u32>,
    },
    /// A line of a stored text.
    Line(StoredLine),
    /// A change of the prompt that no file holds: a file begins at a prompt of its own.
    Switch {
        /// The file that begins.
        file: usize,
        /// Its prompt.
        level: Level,
    },
    /// A stored text takes the place of the program's text before.
    Install {
        /// Its index among the programs.
        index: usize,
        /// The file it ends in.
        file: usize,
        /// The `PROGRAM` that opened it.
        opener: Option<u32>,
    },
}

/// A stored text.
#[derive(Clone, Debug)]
pub(crate) struct Text {
    /// Whose it is.
    pub(crate) name: UnitName,
    /// Its lines.
    pub(crate) parts: Vec<Part>,
}

/// The units of a project.
#[derive(Default)]
pub(crate) struct Plan {
    /// The immediate statements.
    pub(crate) boot: Vec<Part>,
    /// The stored texts in the order in which the boot unit installs them.
    pub(crate) programs: Vec<Text>,
}

impl Plan {
    /// Sorts the statements of all files into units.
    pub(crate) fn of(files: &[SourceUnit<'_>], errors: &mut Vec<CompileError>) -> Self {
        let mut planner =
            Planner { plan: Self::default(), texts: BTreeMap::new(), changed: None, level: Level::System, errors };
        for (file, source) in files.iter().enumerate() {
            planner.file(file, source);
        }
        planner.install_changed();
        planner.plan
    }
}

struct Planner<'e> {
    plan: Plan,
    /// The stored text of each program as it stands.
    texts: BTreeMap<UnitName, StoredText>,
    /// A text that numbered lines have changed since it was installed, and the file of the latest of them.
    changed: Option<(UnitName, usize)>,
    /// The prompt.
    level: Level,
    errors: &'e mut Vec<CompileError>,
}

impl Planner<'_> {
    fn file(&mut self, file: usize, source: &SourceUnit<'_>) {
        self.install_changed();
        if self.level != source.start {
            self.level = source.start;
            self.plan.boot.push(Part::Switch { file, level: source.start });
        }
        let count = source.tree.statements().len() as u32;
        if source.implicit_program {
            let whole = Section {
                level: source.start,
                kind: SectionKind::Stored,
                statements: 0..count,
                opener: None,
                closer: None,
            };
            self.entered(file, source, &whole);
            return;
        }
        let sections = units::split(source.tree, source.start);
        for (section, next) in sections.iter().zip(sections.iter().skip(1).map(Some).chain([None])) {
            match (section.kind, section.opener) {
                (SectionKind::Immediate, _) => self.immediate(file, source, section),
                (SectionKind::Stored, Some(_)) => self.entered(file, source, section),
                (SectionKind::Stored, None) => self.numbered(file, source, section),
            }
            self.deletions(file, source, section, next);
        }
    }

    fn immediate(&mut self, file: usize, source: &SourceUnit<'_>, section: &Section) {
        self.install_changed();
        let range = section.statements.clone();
        for statement in statements(source, &range) {
            self.level = prompt_behind(statement).unwrap_or(self.level);
        }
        self.plan.boot.push(Part::Statements { file, range });
    }

    /// A text between `PROGRAM` and `ENDP`, or a file that is one: it replaces the text before.
    fn entered(&mut self, file: usize, source: &SourceUnit<'_>, section: &Section) {
        self.install_changed();
        let Some(name) = self.unit_name(file, source, section) else { return };
        let mut text = StoredText::default();
        for (number, statements) in lines(source, &section.statements) {
            text.enter(StoredLine { number, file, statements });
        }
        self.texts.insert(name, text);
        self.install(name, file, section.opener);
    }

    /// Lines with a number take their places in the text.
    fn numbered(&mut self, file: usize, source: &SourceUnit<'_>, section: &Section) {
        let Some(name) = self.unit_name(file, source, section) else { return };
        self.change(name, file);
        let text = self.texts.entry(name).or_default();
        for (number, statements) in lines(source, &section.statements) {
            let line = StoredLine { number, file, statements };
            match number {
                Some(number) if number <= LineNumber::MAX => text.insert(number, line),
                // A number that cannot be stored has no place either; each of them is reported when it is encoded.
                _ => text.append(line),
            }
        }
    }

    /// A number alone removes its line. Such lines have no statement, so they lie between sections or behind the last one.
    fn deletions(&mut self, file: usize, source: &SourceUnit<'_>, section: &Section, next: Option<&Section>) {
        let tree = source.tree;
        let last = section.closer.unwrap_or(section.statements.end.saturating_sub(1)).max(section.statements.start);
        let first = if section.opener.is_some() { tree.line_of(last) } else { tree.line_of(section.statements.start) };
        let end =
            next.map_or(tree.lines().len() as u32, |next| tree.line_of(next.opener.unwrap_or(next.statements.start)));
        let Some(name) = level_name(self.level) else { return };
        for line in tree.lines().get(first as usize..end as usize).unwrap_or_default() {
            if let Some(number) = line.number.filter(|_| line.statements.is_empty())
                && self.texts.contains_key(&name)
            {
                self.change(name, file);
                self.texts.entry(name).or_default().delete(number.value);
            }
        }
    }

    fn change(&mut self, name: UnitName, file: usize) {
        if self.changed.is_some_and(|(changed, _)| changed != name) {
            self.install_changed();
        }
        self.changed = Some((name, file));
    }

    fn install_changed(&mut self) {
        if let Some((name, file)) = self.changed.take() {
            self.install(name, file, None);
        }
    }

    fn install(&mut self, name: UnitName, file: usize, opener: Option<u32>) {
        let lines = self.texts.get(&name).into_iter().flat_map(StoredText::lines);
        let parts = lines.cloned().map(Part::Line).collect();
        self.plan.boot.push(Part::Install { index: self.plan.programs.len(), file, opener });
        self.plan.programs.push(Text { name, parts });
    }

    /// The program that a section belongs to.
    fn unit_name(&mut self, file: usize, source: &SourceUnit<'_>, section: &Section) -> Option<UnitName> {
        let name = level_name(section.level);
        if name.is_none() {
            let blamed = source.tree.statements().get(section.opener.unwrap_or(section.statements.start) as usize);
            let span = blamed.map_or(Span::default(), |statement| statement.span);
            self.errors.push(CompileError { file, span, kind: CompileErrorKind::NoProgram });
        }
        name
    }
}

/// The lines of a text that is stored already, in their order.
pub(crate) fn whole(file: usize, source: &SourceUnit<'_>) -> Vec<Part> {
    let lines = lines(source, &(0..source.tree.statements().len() as u32));
    lines.map(|(number, statements)| Part::Line(StoredLine { number, file, statements })).collect()
}

fn level_name(level: Level) -> Option<UnitName> {
    match level {
        Level::System => None,
        Level::Program(number) => Some(UnitName::Program(number)),
        Level::Plc(number) => Some(UnitName::Plc(number)),
    }
}

fn statements<'a>(source: &SourceUnit<'a>, range: &Range<u32>) -> &'a [Statement] {
    source.tree.statements().get(range.start as usize..range.end as usize).unwrap_or_default()
}

/// The lines on which a range of statements stands: number, and the part of the range that is on it.
fn lines<'a>(source: &SourceUnit<'a>, range: &Range<u32>) -> impl Iterator<Item = (Option<u32>, Range<u32>)> + use<'a> {
    let range = range.clone();
    let first = source.tree.line_of(range.start) as usize;
    let lines = source.tree.lines().get(first..).unwrap_or_default();
    let parts = lines.iter().take_while({
        let end = range.end;
        move |line| line.statements.start < end
    });
    parts.filter_map(move |line| {
        let part = line.statements.start.max(range.start)..line.statements.end.min(range.end);
        let number = line.number.filter(|_| part.start == line.statements.start).map(|number| number.value);
        (!part.is_empty()).then_some((number, part))
    })
}

/// The prompt behind an immediate statement that changes it.
fn prompt_behind(statement: &Statement) -> Option<Level> {
    let StatementKind::Command(command) = &statement.kind else { return None };
    let number = match command.arguments.first() {
        Some(Argument::Value(Expr { kind: ExprKind::Integer(number), .. })) => {
            Some(u8::try_from(*number).unwrap_or(u8::MAX))
        }
        _ => None,
    };
    match command.id {
        command::SYS => Some(Level::System),
        command::PROG => number.map(Level::Program),
        command::PLC => number.map(Level::Plc),
        _ => None,
    }
}
