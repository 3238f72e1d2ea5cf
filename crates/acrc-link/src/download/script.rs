//! A project as the lines that are typed at a controller, in the order of its files.
//!
//! What the vendor's tool sends: statements as they are written, without apostrophe comments and empty lines; the text of a
//! program between `PROGRAM` and `ENDP` (guide, "Programs and Commands"). A line is cut where the part of a unit ends or
//! where a statement stands that a download may have to leave out, so each line does one thing.

use std::ops::Range;

use acrc_analysis::project::LoadedProject;
use acrc_compile::typed_text;
use acrc_diagnostics::Span;
use acrc_image::{Image, Unit, UnitName};
use acrc_syntax::Tree;
use acrc_syntax::ast::{Line, Separator, Statement, StatementKind};
use acrc_syntax::units::{self, Level, SectionKind};

use super::immediate::{Special, Traits, level_behind};
use super::problem::Problem;

/// Characters that a line may have. No document has a limit; a virtual controller takes as many.
pub const LONGEST_LINE: usize = 1024;

/// Where a line of the source stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Index of the file in [`Script::files`].
    pub file: usize,
    /// The line, from 1.
    pub line: u32,
    /// What of it.
    pub span: Span,
}

/// What becomes of a line.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// It is executed.
    Immediate(Traits),
    /// `PROGRAM`: the text of the program begins.
    Open,
    /// It is stored, between `PROGRAM` and `ENDP`.
    Stored,
    /// `ENDP`
    Close,
    /// A line with a number outside of `PROGRAM`, which takes its place in the text.
    Numbered,
}

/// A line to be typed.
#[derive(Clone, Debug, PartialEq)]
pub struct ScriptLine {
    /// Where it comes from.
    pub place: Place,
    /// The prompt at which it is typed.
    pub level: Level,
    /// The prompt behind it.
    pub behind: Level,
    /// What is typed.
    pub text: String,
    /// What becomes of it.
    pub kind: Kind,
}

impl ScriptLine {
    /// The program whose text it is a part of.
    pub fn unit(&self) -> Option<UnitName> {
        if matches!(self.kind, Kind::Immediate(_)) { None } else { unit_at(self.level) }
    }
}

/// A file of the project.
#[derive(Clone, Debug)]
pub struct ScriptFile {
    /// Its path as it is shown.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// A project, ready to be sent.
#[derive(Clone, Debug)]
pub struct Script {
    /// Its files.
    pub files: Vec<ScriptFile>,
    /// What is typed.
    pub lines: Vec<ScriptLine>,
    /// What the controller shall have behind it.
    pub image: Image,
}

impl Script {
    /// The lines of a project that compiles.
    ///
    /// # Errors
    /// What cannot be sent, each with its place.
    pub fn of(project: &LoadedProject, image: Image) -> Result<Self, Vec<Problem>> {
        let (script, problems) = Self::read(project, image);
        if problems.is_empty() { Ok(script) } else { Err(problems) }
    }

    /// The lines of a project that compiles, also those that cannot be sent: for comparing.
    pub fn any(project: &LoadedProject, image: Image) -> Self {
        Self::read(project, image).0
    }

    fn read(project: &LoadedProject, image: Image) -> (Self, Vec<Problem>) {
        let mut writer = Writer { lines: Vec::new(), problems: Vec::new(), image: &image, level: Level::System };
        for (file, loaded) in project.files.iter().enumerate() {
            let tree = acrc_syntax::parse(&loaded.source.text);
            let source = Source { file, text: &loaded.source.text, tree: &tree };
            let start = loaded.role.start();
            if loaded.is_implicit_program(&tree) { writer.whole(&source, start) } else { writer.file(&source, start) }
        }
        let (lines, problems) = (writer.lines, writer.problems);
        let files = project.files.iter();
        let files = files.map(|file| ScriptFile { name: file.path.to_string(), text: file.source.text.clone() });
        (Self { files: files.collect(), lines, image }, problems)
    }

    /// The programs with a text, as it is at the end.
    pub fn units(&self) -> impl Iterator<Item = &Unit> {
        let programs = &self.image.programs;
        programs.iter().enumerate().filter_map(|(place, unit)| {
            let replaced = programs.iter().skip(place + 1).any(|later| later.name == unit.name);
            (!replaced).then_some(unit)
        })
    }

    /// Whether it has settings only, and no program.
    pub fn stores_nothing(&self) -> bool {
        self.units().all(|unit| unit.words.is_empty())
    }

    /// The program with a name.
    pub fn unit(&self, name: UnitName) -> Option<&Unit> {
        self.units().find(|unit| unit.name == name)
    }
}

/// The program that a prompt belongs to.
pub fn unit_at(level: Level) -> Option<UnitName> {
    match level {
        Level::System => None,
        Level::Program(number) => Some(UnitName::Program(number)),
        Level::Plc(number) => Some(UnitName::Plc(number)),
    }
}

/// The prompt of a program.
pub fn level_of(unit: UnitName) -> Level {
    match unit {
        UnitName::Boot => Level::System,
        UnitName::Program(number) => Level::Program(number),
        UnitName::Plc(number) => Level::Plc(number),
    }
}

struct Source<'a> {
    file: usize,
    text: &'a str,
    tree: &'a Tree,
}

impl Source<'_> {
    fn place(&self, line: usize, span: Span) -> Place {
        Place { file: self.file, line: line as u32 + 1, span }
    }

    fn statements(&self, range: &Range<u32>) -> &[Statement] {
        self.tree.statements().get(range.start as usize..range.end as usize).unwrap_or_default()
    }

    /// From the first to the last statement of a range, with the number in front of the line.
    fn span(&self, line: &Line, range: &Range<u32>) -> Span {
        let statements = self.statements(range);
        let (first, last) = (statements.first(), statements.last());
        let start = first.map_or(line.span.start, |first| first.span.start);
        let number = line.number.filter(|_| range.start == line.statements.start);
        Span::new(number.map_or(start, |number| number.span.start), last.map_or(start, |last| last.span.end))
    }
}

/// What a statement of a file is to the controller.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    Immediate,
    Open,
    Stored,
    Close,
    Numbered,
}

struct Writer<'a> {
    lines: Vec<ScriptLine>,
    problems: Vec<Problem>,
    image: &'a Image,
    /// The prompt behind what is written.
    level: Level,
}

impl Writer<'_> {
    /// A file that is the text of a program, without `PROGRAM` and `ENDP`.
    fn whole(&mut self, source: &Source, start: Level) {
        self.level = start;
        self.push(source.place(0, Span::default()), "PROGRAM", Kind::Open);
        for (place, line) in source.tree.lines().iter().enumerate().filter(|(_, line)| !line.statements.is_empty()) {
            self.part(source, (place, line), &line.statements, Part::Stored);
        }
        let last = source.tree.lines().len().saturating_sub(1);
        self.push(source.place(last, Span::empty(source.text.len() as u32)), "ENDP", Kind::Close);
    }

    fn file(&mut self, source: &Source, start: Level) {
        self.level = start;
        let parts = parts(source.tree, start);
        for (place, line) in source.tree.lines().iter().enumerate() {
            if let Some(number) = line.number.filter(|_| line.statements.is_empty()) {
                // A number alone deletes its line.
                if unit_at(self.level).is_some() {
                    let text = source.text.get(number.span.range()).unwrap_or_default().to_owned();
                    self.push(source.place(place, number.span), &text, Kind::Numbered);
                }
                continue;
            }
            let mut rest = line.statements.clone();
            while let Some(&part) = parts.get(rest.start as usize).filter(|_| !rest.is_empty()) {
                let same = |index: &u32| parts.get(*index as usize) == Some(&part) && part != Part::Open;
                let end = rest.start + 1 + (rest.start + 1..rest.end).take_while(same).count() as u32;
                self.part(source, (place, line), &(rest.start..end), part);
                rest.start = end;
            }
        }
        if parts.last().is_some_and(|part| matches!(part, Part::Open | Part::Stored)) {
            let last = source.tree.lines().len().saturating_sub(1);
            self.push(source.place(last, Span::empty(source.text.len() as u32)), "ENDP", Kind::Close);
        }
    }

    fn part(&mut self, source: &Source, line: (usize, &Line), range: &Range<u32>, part: Part) {
        let kind = match part {
            Part::Immediate => return self.immediate(source, line, range),
            Part::Open => Kind::Open,
            Part::Stored => Kind::Stored,
            Part::Close => Kind::Close,
            Part::Numbered => Kind::Numbered,
        };
        let span = source.span(line.1, range);
        let text = typed_text(source.text.get(span.range()).unwrap_or_default());
        self.push(source.place(line.0, span), &text, kind);
    }

    /// Statements that are executed: those that may have to be left out on lines of their own.
    fn immediate(&mut self, source: &Source, line: (usize, &Line), range: &Range<u32>) {
        let mut rest = range.clone();
        while !rest.is_empty() {
            let end = self.together(source, &rest);
            let range = rest.start..end;
            rest.start = end;
            let span = source.span(line.1, &range);
            let place = source.place(line.0, span);
            let statements = source.statements(&range);
            for statement in statements {
                self.problems.extend(super::immediate::unsendable(place, statement));
            }
            self.problems.extend(super::immediate::open_block(place, statements));
            let traits = Traits::of(source.text, statements, self.level, self.image);
            let behind = statements.iter().fold(self.level, level_behind);
            let text = typed_text(source.text.get(span.range()).unwrap_or_default());
            self.push(place, &text, Kind::Immediate(traits));
            self.level = behind;
            if let Some(line) = self.lines.last_mut() {
                line.behind = behind;
            }
        }
    }

    /// The end of the statements from the first of a range that stay on one line.
    fn together(&mut self, source: &Source, range: &Range<u32>) -> u32 {
        let (statements, level) = (source.statements(range), self.level);
        let special = |statement: &Statement| Special::of(statement, level).is_some();
        let Some(first) = statements.first() else { return range.end };
        if special(first) {
            return range.start + 1;
        }
        let mut conditional = is_one_line_if(first);
        let mut length = source.span_length(first);
        for (place, statement) in (range.start..).zip(statements).skip(1) {
            length += 3 + source.span_length(statement);
            if !conditional && statement.separator != Separator::Then {
                // What changes the prompt ends its line too: what stands behind it is typed at another one.
                let before = statements.get((place - range.start) as usize - 1);
                let switched = before.is_some_and(|before| level_behind(self.level, before) != self.level);
                if special(statement) || switched || length > LONGEST_LINE {
                    return place;
                }
            }
            if conditional && special(statement) {
                let place = source.place(source.tree.line_of(place) as usize, statement.span);
                self.problems.push(Problem::conditional(place));
            }
            conditional |= is_one_line_if(statement);
        }
        range.end
    }

    fn push(&mut self, place: Place, text: &str, kind: Kind) {
        let characters = text.chars().count();
        if characters > LONGEST_LINE {
            self.problems.push(Problem::too_long(place, characters));
        }
        self.lines.push(ScriptLine { place, level: self.level, behind: self.level, text: text.to_owned(), kind });
    }
}

impl Source<'_> {
    fn span_length(&self, statement: &Statement) -> usize {
        self.text.get(statement.span.range()).unwrap_or_default().chars().count()
    }
}

fn is_one_line_if(statement: &Statement) -> bool {
    matches!(&statement.kind, StatementKind::If(condition) if condition.then.is_some())
}

/// What each statement of a file is.
fn parts(tree: &Tree, start: Level) -> Vec<Part> {
    let mut parts = vec![Part::Immediate; tree.statements().len()];
    for section in units::split(tree, start) {
        let part = match (section.kind, section.opener) {
            (SectionKind::Immediate, _) => Part::Immediate,
            (SectionKind::Stored, Some(_)) => Part::Stored,
            (SectionKind::Stored, None) => Part::Numbered,
        };
        let ends = [(section.opener, Part::Open), (section.closer, Part::Close)];
        let ends = ends.into_iter().filter_map(|(index, part)| Some((index?, part)));
        for (index, part) in section.statements.map(|index| (index, part)).chain(ends) {
            if let Some(place) = parts.get_mut(index as usize) {
                *place = part;
            }
        }
    }
    parts
}
