//! Pieces of files to units.

use std::ops::Range;

use acrc_catalog::{CommandId, command};
use acrc_diagnostics::Span;
use acrc_image::{Item, Location, Node, Separator, Unit, UnitBuilder, UnitName};
use acrc_syntax::ast::Statement;
use acrc_syntax::units::Level;
use rustc_hash::FxHashMap;

use crate::encoder::Encoder;
use crate::error::{CompileError, CompileErrorKind};
use crate::labels::LabelTable;
use crate::plan::Part;
use crate::project::SourceUnit;
use crate::scope::Tables;
use crate::statement;

/// Encodes units and collects the mistakes in them.
pub(crate) struct Assembler<'a> {
    files: &'a [SourceUnit<'a>],
    tables: Tables,
    pub(crate) errors: Vec<CompileError>,
}

impl<'a> Assembler<'a> {
    /// With the aliases of the project.
    pub(crate) fn new(files: &'a [SourceUnit<'a>], aliases: FxHashMap<String, u16>, errors: Vec<CompileError>) -> Self {
        Self { files, tables: Tables { aliases, ..Tables::default() }, errors }
    }

    /// A unit of pieces. `None` only when there are mistakes.
    pub(crate) fn unit(&mut self, name: UnitName, parts: &[Part]) -> Option<Unit> {
        let mut labels = LabelTable::default();
        for (file, range) in parts.iter().filter_map(statements_of) {
            for (_, statement) in self.statements(file, &range) {
                labels.add(file, self.files.get(file)?.text, statement, &mut self.errors);
            }
        }
        self.tables.labels = labels.numbers;
        let mut unit = UnitBuilder::new(name);
        for part in parts {
            self.part(&mut unit, part);
        }
        match unit.finish() {
            Ok(unit) => Some(unit),
            Err(error) => {
                let kind = CompileErrorKind::Unstorable(error);
                // With a mistake before, the words only lack what was mistaken.
                if self.errors.is_empty() {
                    self.errors.push(CompileError { file: 0, span: Span::default(), kind });
                }
                None
            }
        }
    }

    fn part(&mut self, unit: &mut UnitBuilder, part: &Part) {
        match part {
            Part::Statements { file, range } => self.encode(unit, *file, range, None, false),
            Part::Line(line) => self.encode(unit, line.file, &line.statements, line.number, true),
            Part::Switch { file, level } => {
                let (command, number) = match *level {
                    Level::System => (command::SYS, None),
                    Level::Program(number) => (command::PROG, Some(number)),
                    Level::Plc(number) => (command::PLC, Some(number)),
                };
                let items: Vec<Item> = number.map(|number| Node::Long(number.into()).into()).into_iter().collect();
                self.synthetic(unit, *file, None, command, &items);
            }
            Part::Install { index, file, opener } => {
                let index = Node::Long(i32::try_from(*index).unwrap_or(i32::MAX));
                self.synthetic(unit, *file, *opener, command::PROGRAM, &[index.into()]);
            }
        }
    }

    /// Encodes statements that stand together, on a line of their own or as they stand in the file.
    fn encode(&mut self, unit: &mut UnitBuilder, file: usize, range: &Range<u32>, number: Option<u32>, own_line: bool) {
        let Some(source) = self.files.get(file) else { return };
        let mut encoder = Encoder::new(source.text, &self.tables);
        let mut first = own_line.then_some(Separator::Line);
        for (index, statement) in statements(source, range) {
            if let (Some(separator), Some(number)) = (first, number) {
                let items = [encoder.line_number(number, number_span(source, index).unwrap_or(statement.span)).into()];
                if let Some(address) = encoder.push(unit, statement.span, separator, command::LINE_NUMBER, &items) {
                    unit.locate(address, location(source, file, index, statement.span));
                }
                first = Some(Separator::Blank);
            }
            let Some((command, items)) = encoder.statement(statement) else { continue };
            let separator = first.take().unwrap_or_else(|| statement::separator(statement.separator));
            if let Some(address) = encoder.push(unit, statement.span, separator, command, &items) {
                unit.locate(address, location(source, file, index, statement.span));
            }
        }
        self.errors.extend(encoder.errors.into_iter().map(|(span, kind)| CompileError { file, span, kind }));
    }

    /// Adds a command that stands on a line of its own and in no file, or in the place of another statement.
    fn synthetic(
        &mut self,
        unit: &mut UnitBuilder,
        file: usize,
        place: Option<u32>,
        command: CommandId,
        items: &[Item],
    ) {
        let Some(source) = self.files.get(file) else { return };
        let statement = place.and_then(|place| source.tree.statements().get(place as usize));
        let span = statement.map_or(Span::default(), |statement| statement.span);
        let mut encoder = Encoder::new(source.text, &self.tables);
        if let Some(address) = encoder.push(unit, span, Separator::Line, command, items) {
            unit.locate(address, location(source, file, place.unwrap_or(0), span));
        }
    }

    fn statements(&self, file: usize, range: &Range<u32>) -> Vec<(u32, &'a Statement)> {
        self.files.get(file).map(|source| statements(source, range).collect()).unwrap_or_default()
    }
}

/// The statements of a file in a range, with their indexes.
fn statements<'a>(source: &SourceUnit<'a>, range: &Range<u32>) -> impl Iterator<Item = (u32, &'a Statement)> + use<'a> {
    let statements = source.tree.statements().get(range.start as usize..range.end as usize).unwrap_or_default();
    (range.start..).zip(statements)
}

/// The number in front of the line that a statement begins.
fn number_span(source: &SourceUnit<'_>, statement: u32) -> Option<Span> {
    let line = source.tree.lines().get(source.tree.line_of(statement) as usize)?;
    line.number.map(|number| number.span)
}

/// The statements that a piece takes from a file.
fn statements_of(part: &Part) -> Option<(usize, Range<u32>)> {
    match part {
        Part::Statements { file, range } => Some((*file, range.clone())),
        Part::Line(line) => Some((line.file, line.statements.clone())),
        Part::Switch { .. } | Part::Install { .. } => None,
    }
}

fn location(source: &SourceUnit<'_>, file: usize, statement: u32, span: Span) -> Location {
    let line = source.tree.line_of(statement) + 1;
    Location { file: file as u32, span: acrc_image::Span { start: span.start, end: span.end }, line }
}
