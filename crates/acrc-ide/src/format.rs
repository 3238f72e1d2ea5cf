//! Formatting: a file, some of its lines, and a line while it is typed.

use acrc_analysis::project::{BlockEnds, FileGlobs, FmtConfig, KeywordCase};
use acrc_analysis::query::parse;
use acrc_analysis::{Db, Project, SourceFile};
use acrc_diagnostics::{Edit, Span};
use acrc_syntax::Tree;
use acrc_syntax::blocks::Block;

use crate::place::{line_at, lines_in, section_of, slice};

/// The characters behind which [`format_typed`] may have something to do: a new line, and the last letters of `ENDIF`,
/// `WEND`, `NEXT` and `ELSE`.
pub const TYPED: [char; 9] = ['\n', 'F', 'f', 'D', 'd', 'T', 't', 'E', 'e'];

/// What `[fmt]` asks for.
pub fn format_options(config: &FmtConfig) -> acrc_fmt::Options {
    let default = acrc_fmt::Options::default();
    acrc_fmt::Options {
        keyword_case: config.keyword_case.map_or(default.keyword_case, |case| match case {
            KeywordCase::Upper => acrc_fmt::KeywordCase::Upper,
            KeywordCase::Lower => acrc_fmt::KeywordCase::Lower,
            KeywordCase::Keep => acrc_fmt::KeywordCase::Keep,
        }),
        indent: config.indent.unwrap_or(default.indent),
        block_ends: config.block_ends.map_or(default.block_ends, |place| match place {
            BlockEnds::Body => acrc_fmt::BlockEnds::Body,
            BlockEnds::Opener => acrc_fmt::BlockEnds::Opener,
        }),
        align_remarks: config.align_remarks.unwrap_or(default.align_remarks),
        align_tables: config.align_tables.unwrap_or(default.align_tables),
    }
}

/// Formats a file, as `acrc fmt` does. The edits are in the order of the text; a file that `[fmt]` excludes has none.
pub fn format_file(db: &dyn Db, project: Project, file: SourceFile) -> Vec<Edit> {
    format_range(db, project, file, Span::new(0, file.text(db).len() as u32))
}

/// Formats the lines that a part of a file touches. The file is laid out as a whole, and what changes elsewhere stays as
/// it is: a table that goes on outside of the part may be in columns only half.
pub fn format_range(db: &dyn Db, project: Project, file: SourceFile, part: Span) -> Vec<Edit> {
    let config = project.config(db);
    let exclude = FileGlobs::new(&config.fmt.exclude).unwrap_or_default();
    if !exclude.matching(config.lint.relative(file.name(db))).is_empty() {
        return Vec::new();
    }
    let text = file.text(db);
    let after = acrc_fmt::format_tree(text, parse(db, file), &format_options(&config.fmt)).text;
    let whole = whole_lines(text, parse(db, file), part);
    let mut edits = changed_lines(text, &after);
    edits.retain(|edit| {
        let begins = edit.span.start < whole.end || whole.end == text.len() as u32;
        begins && whole.start <= edit.span.start && edit.span.end <= whole.end
    });
    edits
}

/// The lines that a part of a text touches, with their line breaks.
fn whole_lines(text: &str, tree: &Tree, part: Span) -> Span {
    let lines = lines_in(tree, part);
    let start = |line: usize| tree.lines().get(line).map_or(text.len() as u32, |line| line.span.start);
    Span::new(start(lines.start), start(lines.end))
}

fn is_break(byte: u8) -> bool {
    byte == b'\n' || byte == b'\r'
}

/// The edits that make a text the formatted one. Formatting keeps the lines that hold something, in their order: each has
/// an edit of its own where it differs, and so have the blank lines before it.
fn changed_lines(before: &str, after: &str) -> Vec<Edit> {
    let (old, new) = (filled_lines(before), filled_lines(after));
    if old.len() != new.len() {
        return crate::edits::line_edits(before, after);
    }
    let mut edits = Vec::new();
    let mut change = |span: Span, new: &str| {
        if slice(before, span) != new {
            edits.push(Edit::replace(span, new));
        }
    };
    let (mut from, mut new_from) = (0, 0);
    for (line, new_line) in old.iter().zip(&new) {
        change(Span::new(from, line.start), slice(after, Span::new(new_from, new_line.start)));
        change(*line, slice(after, *new_line));
        (from, new_from) = (line.end, new_line.end);
    }
    change(Span::new(from, before.len() as u32), after.get(new_from as usize..).unwrap_or_default());
    edits
}

/// The lines that hold something else than blanks, with their line breaks.
fn filled_lines(text: &str) -> Vec<Span> {
    let bytes = text.as_bytes();
    let mut lines = Vec::new();
    let mut start = 0;
    while start < bytes.len() {
        let rest = bytes.get(start..).unwrap_or_default();
        let content = rest.iter().position(|byte| is_break(*byte)).unwrap_or(rest.len());
        let ending = match rest.get(content..content + 2) {
            Some(b"\r\n") => 2,
            _ => usize::from(content < rest.len()),
        };
        let end = start + content + ending;
        if !rest.get(..content).unwrap_or_default().iter().all(|byte| matches!(byte, b' ' | b'\t' | b'\x0C')) {
            lines.push(Span::new(start as u32, end as u32));
        }
        start = end;
    }
    lines
}

/// What to do when somebody has typed a character before `offset`: behind a line break the new line is indented, behind a
/// word that closes or branches a block its line. Lines with numbers are left alone.
pub fn format_typed(db: &dyn Db, project: Project, file: SourceFile, offset: u32, typed: char) -> Vec<Edit> {
    let typist = Typist {
        db,
        file,
        text: file.text(db),
        tree: parse(db, file),
        options: format_options(&project.config(db).fmt),
    };
    let indent = if typed == '\n' { typist.new_line(offset) } else { typist.closing_word(offset) };
    indent.into_iter().filter_map(|indent| typist.indent(offset, &indent)).collect()
}

struct Typist<'a> {
    db: &'a dyn Db,
    file: SourceFile,
    text: &'a str,
    tree: &'a Tree,
    options: acrc_fmt::Options,
}

/// What a line does to the next one.
enum Step<'b> {
    Opens,
    Branches(&'b Block),
    Closes(&'b Block),
}

impl<'a> Typist<'a> {
    /// The indentation of the line that begins before `offset`, by the line with statements above it.
    fn new_line(&self, offset: u32) -> Option<String> {
        let at = line_at(self.tree, offset);
        let above = self.tree.lines().get(..at)?;
        let (line, above) = (self.tree.lines().get(at)?, above.iter().rfind(|line| !line.statements.is_empty())?);
        if line.number.is_some() || above.number.is_some() {
            return None;
        }
        let own = self.blanks(above.span.start);
        let step = above.statements.clone().rev().find_map(|statement| self.step(statement, above.statements.clone()));
        let is_body = self.options.block_ends == acrc_fmt::BlockEnds::Body;
        Some(match step {
            Some(Step::Opens) => self.deeper(own),
            Some(Step::Branches(_)) if is_body => own.to_owned(),
            Some(Step::Branches(block)) => self.deeper(self.blanks_of(block.opener)),
            Some(Step::Closes(block)) => self.blanks_of(block.opener).to_owned(),
            None => own.to_owned(),
        })
    }

    /// What a statement does to the lines below its own.
    fn step(&self, statement: u32, line: std::ops::Range<u32>) -> Option<Step<'a>> {
        let block = section_of(self.db, self.file, statement)?.blocks.block_of(statement)?;
        let is_elsewhere = |other: Option<u32>| other.is_none_or(|other| !line.contains(&other));
        if block.opener == statement {
            is_elsewhere(block.closer).then_some(Step::Opens)
        } else if block.closer == Some(statement) {
            is_elsewhere(Some(block.opener)).then_some(Step::Closes(block))
        } else {
            Some(Step::Branches(block))
        }
    }

    /// The indentation of a line that begins with a word which ends at `offset` and closes or branches a block.
    fn closing_word(&self, offset: u32) -> Option<String> {
        let line = self.tree.lines().get(line_at(self.tree, offset))?;
        let first = self.tree.statements().get(line.statements.start as usize)?;
        if line.number.is_some() || line.statements.is_empty() || first.span.end != offset {
            return None;
        }
        let blocks = &section_of(self.db, self.file, line.statements.start)?.blocks;
        let block = blocks.block_of(line.statements.start).filter(|block| block.opener != line.statements.start)?;
        let opener = self.blanks_of(block.opener);
        Some(match self.options.block_ends {
            acrc_fmt::BlockEnds::Body => self.deeper(opener),
            acrc_fmt::BlockEnds::Opener => opener.to_owned(),
        })
    }

    fn deeper(&self, blanks: &str) -> String {
        format!("{blanks}{}", " ".repeat(self.options.indent.min(acrc_fmt::MAX_INDENT).into()))
    }

    /// The blanks before the line of a statement.
    fn blanks_of(&self, statement: u32) -> &'a str {
        self.tree.statements().get(statement as usize).map_or("", |statement| self.blanks(statement.span.start))
    }

    fn blanks(&self, offset: u32) -> &'a str {
        crate::edits::indent_at(self.text, self.tree, offset)
    }

    fn indent(&self, offset: u32, indent: &str) -> Option<Edit> {
        let start = self.tree.lines().get(line_at(self.tree, offset))?.span.start;
        let old = self.blanks(offset);
        (old != indent).then(|| Edit::replace(Span::new(start, start + old.len() as u32), indent))
    }
}
