//! The listing of an image: where the words of each statement stand, what they are, and the source beside them.
//!
//! A source line stands beside the words of its first statement; the statements behind it have rows of their own, below their place in the line.
//! Lines without a statement stand above the statement that follows them.

use std::fmt::Write as _;

use acrc_analysis::project::LoadedProject;
use acrc_image::list::{ListOptions, list_instructions};
use acrc_image::{Image, Instruction, Location, Unit};
use acrc_syntax::Tree;

/// Words in a row.
const ROW: usize = 4;
/// Columns of the words of a row.
const WORDS: usize = 9 * ROW;

/// The listing of all units.
pub(super) fn text(project: &LoadedProject, image: &Image) -> anyhow::Result<String> {
    let sources: Vec<Source<'_>> = project
        .files
        .iter()
        .map(|file| Source {
            name: file.path.as_str(),
            text: &file.source.text,
            tree: acrc_syntax::parse(&file.source.text),
        })
        .collect();
    let mut out = format!("{} for {}\n", super::title(project), image.model);
    for unit in image.units().filter(|unit| !unit.words.is_empty()) {
        out.push_str(&heading(unit));
        let mut listing = Listing { out: &mut out, image, unit, sources: &sources, file: None, line: 0 };
        listing.statements(&unit.decode()?)?;
    }
    Ok(out)
}

fn heading(unit: &Unit) -> String {
    let count = |count: usize, what: &str| format!("{count} {what}{}", if count == 1 { "" } else { "s" });
    let words = count(unit.words.len(), "word");
    let characters = match unit.strings.len() {
        0 => String::new(),
        length => format!(" and {}", count(length, "character")),
    };
    format!("\n{}: {} bytes, {words}{characters}\n", unit.name, unit.memory())
}

struct Source<'a> {
    name: &'a str,
    text: &'a str,
    tree: Tree,
}

impl Source<'_> {
    /// The part of its line that a statement stands in, the column where it begins, and whether it is the first of the line. A part goes to the
    /// next statement of the line or to its end.
    fn part(&self, location: Location) -> Option<(&str, usize, bool)> {
        let statements = self.tree.statements();
        let index = statements.partition_point(|statement| statement.span.start < location.span.start);
        let line = self.tree.lines().get(location.line.checked_sub(1)? as usize)?;
        let first = line.statements.start as usize == index;
        let start = if first { line.span.start } else { location.span.start };
        let next = statements.get(index + 1).filter(|_| index + 1 < line.statements.end as usize);
        let end = next.map_or(line.span.end, |next| next.span.start);
        let column = self.text.get(line.span.start as usize..start as usize)?.chars().count();
        Some((self.text.get(start as usize..end as usize)?.trim_end(), column, first))
    }

    /// The text of a line, from 1, when no statement stands on it.
    fn bare_line(&self, line: u32) -> Option<&str> {
        let line = self.tree.lines().get(line.checked_sub(1)? as usize)?;
        let text = self.text.get(line.span.start as usize..line.span.end as usize)?;
        line.statements.is_empty().then(|| text.trim_end())
    }
}

/// The rows of one unit.
struct Listing<'a> {
    out: &'a mut String,
    image: &'a Image,
    unit: &'a Unit,
    sources: &'a [Source<'a>],
    /// The file of the latest row, by index.
    file: Option<u32>,
    /// The latest line of it.
    line: u32,
}

impl Listing<'_> {
    fn statements(&mut self, mut instructions: &[Instruction]) -> anyhow::Result<()> {
        while let Some(first) = instructions.first() {
            let location = self.locate(first);
            // A line number has words of its own and the place of the statement behind it.
            let same = |other: &&Instruction| location.is_some() && self.locate(other) == location;
            let count = 1 + instructions.iter().skip(1).take_while(same).count();
            let (group, rest) = instructions.split_at(count);
            let end = rest.first().map_or(self.unit.words.len(), |next| next.address as usize);
            let words = self.unit.words.get(first.address as usize..end).unwrap_or_default();
            match location.and_then(|location| Some((location, self.sources.get(location.file as usize)?))) {
                Some((location, source)) => self.beside_source(location, source, first.address, words),
                None => self.without_source(group, words)?,
            }
            instructions = rest;
        }
        Ok(())
    }

    /// The place of a statement that stands in a file.
    fn locate(&self, instruction: &Instruction) -> Option<Location> {
        let location = self.unit.debug.as_ref()?.locate(instruction.address)?;
        (location.span.start < location.span.end).then_some(location)
    }

    fn beside_source(&mut self, location: Location, source: &Source<'_>, address: u32, words: &[u32]) {
        if self.file != Some(location.file) {
            self.row("", "", "", source.name);
            (self.file, self.line) = (Some(location.file), 0);
        }
        let Some((part, column, first)) = source.part(location) else { return };
        if first {
            self.bare_lines_above(location.line, source);
        }
        let number = if self.line == location.line { String::new() } else { location.line.to_string() };
        self.words(address, words, &number, &format!("{:column$}{part}", ""));
        self.line = location.line;
    }

    fn bare_lines_above(&mut self, line: u32, source: &Source<'_>) {
        let above = (self.line + 1..line).rev().take_while(|&above| source.bare_line(above).is_some()).count() as u32;
        for above in line - above..line {
            self.row("", "", &above.to_string(), source.bare_line(above).unwrap_or_default());
        }
    }

    /// What stands in no file: changes of the prompt that come with the place of a file, and texts that numbered lines have changed.
    fn without_source(&mut self, group: &[Instruction], words: &[u32]) -> anyhow::Result<()> {
        let written = list_instructions(group, &self.image.aliases, &ListOptions::default());
        let written = written.map_err(|(_, problem)| anyhow::Error::new(problem))?;
        let address = group.first().map_or(0, |first| first.address);
        self.words(address, words, "", written.trim_end());
        Ok(())
    }

    fn words(&mut self, address: u32, words: &[u32], line: &str, source: &str) {
        for (place, row) in words.chunks(ROW).enumerate() {
            let address = (address as usize + place * ROW).to_string();
            let written: Vec<String> = row.iter().map(|word| format!("{word:08X}")).collect();
            let (line, source) = if place == 0 { (line, source) } else { ("", "") };
            self.row(&address, &written.join(" "), line, source);
        }
    }

    fn row(&mut self, address: &str, words: &str, line: &str, source: &str) {
        let row = format!("{address:>6}  {words:<WORDS$} {line:>5}  {source}");
        let _ = writeln!(self.out, "{}", row.trim_end());
    }
}
