//! The lines, labels and jumps of each stored text.

use std::collections::BTreeMap;
use std::ops::Range;

use acrc_diagnostics::Span;
use acrc_syntax::ast::{Argument, Line, LineNumber, StatementKind, Target};
use acrc_syntax::units::{self, Level, Section, SectionKind};

use super::{RenumberError, RenumberErrorKind, Source};

/// What is stored as one program.
#[derive(Debug, Default)]
pub(super) struct Text {
    /// Its lines, in the order of the text; lines without statements are not stored.
    pub(super) lines: Vec<StoredLine>,
    /// Its labels.
    pub(super) labels: Vec<Site<Span>>,
    /// Its jumps.
    pub(super) jumps: Vec<Site<Target>>,
    /// Statements that can't be read.
    pub(super) unreadable: Vec<Site<Span>>,
}

/// A line of a stored text.
#[derive(Clone, Copy, Debug)]
pub(super) struct StoredLine {
    pub(super) file: usize,
    pub(super) number: Option<LineNumber>,
}

/// Something and the file in which it stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Site<T> {
    pub(super) file: usize,
    pub(super) what: T,
}

impl Text {
    pub(super) fn is_numbered(&self) -> bool {
        self.lines.iter().any(|line| line.number.is_some())
    }
}

/// The stored texts of a project that have numbers.
pub(super) fn texts(files: &[Source<'_>], errors: &mut Vec<RenumberError>) -> Vec<Text> {
    let mut collector = Collector::default();
    for (file, source) in files.iter().enumerate() {
        collector.file(file, source);
    }
    collector.finish(errors)
}

#[derive(Default)]
struct Collector {
    /// Texts that are stored as a whole.
    whole: Vec<(Level, Text)>,
    /// Texts of which each line is entered by its number.
    single: BTreeMap<Level, Text>,
    /// Jumps that are entered at a prompt.
    prompts: Vec<(Level, Site<Target>)>,
    /// Numbers without a statement.
    empty: Vec<Site<LineNumber>>,
}

impl Collector {
    fn file(&mut self, file: usize, source: &Source<'_>) {
        let bare = source.tree.lines().iter().filter(|line| line.statements.is_empty()).filter_map(|line| line.number);
        self.empty.extend(bare.map(|what| Site { file, what }));
        if source.implicit_program {
            let mut text = Text::default();
            collect(&mut text, file, source, &(0..source.tree.statements().len() as u32));
            self.whole.push((source.start, text));
            return;
        }
        for Section { level, kind, statements, opener, .. } in units::split(source.tree, source.start) {
            let mut text = Text::default();
            match (kind, opener) {
                (SectionKind::Immediate, _) => {
                    collect(&mut text, file, source, &statements);
                    self.prompts.extend(text.jumps.iter().map(|jump| (level, *jump)));
                }
                (SectionKind::Stored, Some(_)) => {
                    collect(&mut text, file, source, &statements);
                    self.whole.push((level, text));
                }
                (SectionKind::Stored, None) => {
                    collect(self.single.entry(level).or_default(), file, source, &statements);
                }
            }
        }
    }

    /// Leaves the texts that have numbers, and notes what stands in the way of changing them.
    fn finish(mut self, errors: &mut Vec<RenumberError>) -> Vec<Text> {
        self.whole.retain(|(level, text)| text.is_numbered() || self.single.contains_key(level));
        if self.whole.is_empty() && self.single.is_empty() {
            return Vec::new();
        }
        let mut note = |file, span, kind| errors.push(RenumberError { file, span, kind });
        for Site { file, what: number } in self.empty {
            note(file, number.span, RenumberErrorKind::Empty { number: number.value });
        }
        for (level, Site { file, what: target }) in self.prompts {
            if self.single.contains_key(&level) || self.whole.iter().any(|(whole, _)| *whole == level) {
                note(file, target.span(), RenumberErrorKind::OutsideProgram);
            }
        }
        for (&level, text) in &self.single {
            let Some(StoredLine { file, number: Some(number) }) = text.lines.first().copied() else { continue };
            if level == Level::System {
                note(file, number.span, RenumberErrorKind::NoProgram);
            } else if self.whole.iter().any(|(whole, _)| *whole == level) {
                note(file, number.span, RenumberErrorKind::StoredTwice { level });
            }
        }
        self.whole.into_iter().map(|(_, text)| text).chain(self.single.into_values()).collect()
    }
}

/// Adds a range of statements of a file to a text.
fn collect(text: &mut Text, file: usize, source: &Source<'_>, range: &Range<u32>) {
    text.lines.extend(lines(source, range).map(|number| StoredLine { file, number }));
    for statement in source.tree.statements().get(range.start as usize..range.end as usize).unwrap_or_default() {
        match &statement.kind {
            StatementKind::Label(label) => text.labels.push(Site { file, what: label.name }),
            StatementKind::Error => text.unreadable.push(Site { file, what: statement.span }),
            StatementKind::Command(command) => {
                let targets = command.arguments.iter().filter_map(|argument| match argument {
                    Argument::Target(target) => Some(Site { file, what: *target }),
                    _ => None,
                });
                text.jumps.extend(targets);
            }
            _ => {}
        }
    }
}

/// The numbers of the lines on which a range of statements stands. A number belongs to the first statement of its line.
fn lines<'a>(source: &Source<'a>, range: &Range<u32>) -> impl Iterator<Item = Option<LineNumber>> + use<'a> {
    let range = range.clone();
    let all = source.tree.lines();
    let first = all.partition_point(|line| line.statements.end <= range.start);
    let lines = all.get(first..).unwrap_or_default().iter().take_while(move |line| line.statements.start < range.end);
    let stored = lines.filter(|line: &&Line| !line.statements.is_empty());
    stored.map(move |line| line.number.filter(|_| line.statements.start >= range.start))
}
